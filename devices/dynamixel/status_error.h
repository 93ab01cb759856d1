// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "devices/dynamixel/packet.h"

namespace planewright {

/// What a servo says is wrong with itself.
struct ServoAlarm {
    bool voltage = false;
    bool overheating = false;
    bool overload = false;
    bool encoder = false;  ///< 2.0 only
    bool shock = false;    ///< electrical; 2.0 only

    bool any() const { return voltage || overheating || overload || encoder || shock; }
    /// "overload, overheating".
    std::string text() const;

    bool operator==(const ServoAlarm&) const = default;
};

/// What a servo says is wrong with a request.
enum class RequestFault {
    None,
    Damaged,  ///< its check was wrong: the line, not us
    Refused,  ///< we have asked for what must not be asked for
};

/// The error byte of an answer: what concerns the servo, and what concerns the request.
struct StatusError {
    ServoAlarm alarm;       ///< 1.0 only
    bool hasAlarm = false;  ///< the servo has an alarm; 2.0 tells which in its hardware error register
    RequestFault request = RequestFault::None;
    std::string_view refusal;  ///< why the request was refused or damaged; empty without
};

/// 1.0: bits 0, 2 and 5 are about the servo; 1, 3, 4 and 6 about the request. 2.0: bit 7 is about the servo, the number
/// in the rest about the request.
StatusError decodeStatusError(DynamixelProtocol protocol, std::uint8_t error);

/// Hardware error register of protocol 2.0, which is also the form of its shutdown register.
ServoAlarm decodeHardwareError(std::uint8_t bits);

/// The error byte of 1.0, or the hardware error register of 2.0, that tells of an alarm.
std::uint8_t alarmBits(DynamixelProtocol protocol, const ServoAlarm& alarm);

}  // namespace planewright
