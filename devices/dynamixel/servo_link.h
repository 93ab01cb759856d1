// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>

#include "devices/dynamixel/bus_turns.h"
#include "devices/dynamixel/control_table.h"
#include "devices/dynamixel/dynamixel_bus.h"
#include "devices/dynamixel/register_image.h"

namespace planewright {

/// How to ask. `may` is looked at when the bus is free, right before each try: nothing comes in between.
struct HowToAsk {
    bool isUrgent = false;
    int tries = 3;
    std::function<bool()> may;
    std::chrono::nanoseconds patience{0};  ///< of each try: see ServoQuestion
};

/// One servo on its bus: questions with retries, from any thread.
///
/// What the servo or the line did comes as a reply; a Result holds an error where the transport is gone (DeviceLost),
/// where the caller did not permit the question any more (Interrupted), and where the servo says that the request made
/// no sense, which is our own fault (Internal, with the packet).
class ServoLink {
public:
    struct Settings {
        std::uint8_t id = 1;
        int baud = 57'142;
        std::chrono::nanoseconds latency{0};
        bool dropEcho = false;  ///< our own bytes may come back
    };

    ServoLink(Transport& transport, const Clock& clock, const Settings& settings);

    void setProtocol(DynamixelProtocol protocol);
    DynamixelProtocol protocol() const { return protocol_; }
    void setReturnDelay(std::chrono::nanoseconds delay);

    /// Is it there? Listens to the end, since two servos may have the number.
    Result<ServoReply> ping(const HowToAsk& how = {});
    /// Reads bytes of the control table into an image of it.
    Result<ServoReply> read(ServoRegion region, RegisterImage& image, const HowToAsk& how = {});
    /// Reads the state in one round trip. After a try without an answer the next one asks for a byte more, so that an
    /// answer that comes late is not taken for the one to the next question, whose moment it would falsify.
    Result<ServoReply> readState(const ControlTable& table, RegisterImage& image, const HowToAsk& how = {});
    /// Writes bytes of the control table. `isAnswered` false: the servo is set not to answer writes.
    Result<ServoReply> write(std::uint16_t address, std::span<const std::uint8_t> bytes, bool isAnswered,
                             const HowToAsk& how = {});
    /// Restarts a servo of protocol 2.0; its answer does not matter.
    Result<void> reboot();

    /// Listens for a time.
    Result<void> pause(std::chrono::nanoseconds time, const std::stop_token& stop);

    /// Why a reply is none, and what to do.
    Error failure(const ServoReply& reply, ErrorCode code) const;

    /// "/dev/ttyUSB0: servo 1".
    std::string subject() const;
    LinkHealth health() const { return bus_.health(); }
    void restartCounts() { bus_.restartCounts(); }
    void countLate() { bus_.countLate(); }
    FaultLog& log() { return bus_.log(); }

private:
    Result<ServoReply> ask(const std::function<ServoQuestion()>& question, const HowToAsk& how);

    Settings settings_;
    DynamixelBus bus_;
    BusTurns turns_;
    DynamixelProtocol protocol_ = DynamixelProtocol::One;
    int unanswered_ = 0;  ///< changes with every question without an answer; under a turn
};

}  // namespace planewright
