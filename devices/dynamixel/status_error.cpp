// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/status_error.h"

#include <array>
#include <utility>

namespace planewright {

namespace {

constexpr std::uint8_t bit(int number)
{
    return static_cast<std::uint8_t>(1U << number);
}

StatusError decodeOne(std::uint8_t error)
{
    StatusError decoded;
    decoded.alarm.voltage = (error & bit(0)) != 0;
    decoded.alarm.overheating = (error & bit(2)) != 0;
    decoded.alarm.overload = (error & bit(5)) != 0;
    decoded.hasAlarm = decoded.alarm.any();
    // What is wrong with the content counts more than a check that is wrong as well.
    constexpr auto kRefusals = std::to_array<std::pair<std::uint8_t, std::string_view>>(
        {{bit(1), "goal beyond the angle limits"}, {bit(3), "value out of range"}, {bit(6), "unknown instruction"}});
    for (const auto& [mask, refusal] : kRefusals) {
        if ((error & mask) != 0 && decoded.request == RequestFault::None) {
            decoded.request = RequestFault::Refused;
            decoded.refusal = refusal;
        }
    }
    if ((error & bit(4)) != 0 && decoded.request == RequestFault::None) {
        decoded.request = RequestFault::Damaged;
        decoded.refusal = "wrong checksum";
    }
    return decoded;
}

StatusError decodeTwo(std::uint8_t error)
{
    constexpr auto kRefusals =
        std::to_array<std::string_view>({"", "request failed", "unknown instruction", "wrong CRC", "value out of range",
                                         "wrong length", "value beyond a limit", "no access"});
    constexpr std::uint8_t kCrc = 3;
    StatusError decoded;
    decoded.hasAlarm = (error & bit(7)) != 0;
    const std::uint8_t number = error & 0x7F;
    if (number != 0) {
        decoded.request = number == kCrc ? RequestFault::Damaged : RequestFault::Refused;
        decoded.refusal = number < kRefusals.size() ? kRefusals[number] : "unknown error number";
    }
    return decoded;
}

}  // namespace

std::string ServoAlarm::text() const
{
    std::string text;
    const auto add = [&text](bool isSet, std::string_view name) {
        if (isSet)
            text += (text.empty() ? "" : ", ") + std::string{name};
    };
    add(overload, "overload");
    add(overheating, "overheating");
    add(voltage, "supply voltage out of range");
    add(encoder, "encoder fault");
    add(shock, "electrical shock");
    return text;
}

StatusError decodeStatusError(DynamixelProtocol protocol, std::uint8_t error)
{
    return protocol == DynamixelProtocol::One ? decodeOne(error) : decodeTwo(error);
}

ServoAlarm decodeHardwareError(std::uint8_t bits)
{
    ServoAlarm alarm;
    alarm.voltage = (bits & bit(0)) != 0;
    alarm.overheating = (bits & bit(2)) != 0;
    alarm.encoder = (bits & bit(3)) != 0;
    alarm.shock = (bits & bit(4)) != 0;
    alarm.overload = (bits & bit(5)) != 0;
    return alarm;
}

std::uint8_t alarmBits(DynamixelProtocol protocol, const ServoAlarm& alarm)
{
    int bits = (alarm.voltage ? bit(0) : 0) | (alarm.overheating ? bit(2) : 0) | (alarm.overload ? bit(5) : 0);
    if (protocol == DynamixelProtocol::Two)
        bits |= (alarm.encoder ? bit(3) : 0) | (alarm.shock ? bit(4) : 0);
    return static_cast<std::uint8_t>(bits);
}

}  // namespace planewright
