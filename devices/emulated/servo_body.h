// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <optional>

#include "devices/dynamixel/packet.h"
#include "devices/dynamixel/status_error.h"
#include "devices/emulated/emulated_motor.h"
#include "devices/emulated/servo_kind.h"
#include "devices/emulated/servo_memory.h"

namespace planewright {

/// One emulated servo without its bus: control table, motor, alarms. A function of the moments that it is told; they
/// never go back.
class ServoBody {
public:
    using Time = std::chrono::nanoseconds;

    /// `shaft`: angle from the middle position [rad], towards growing counts.
    ServoBody(const EmulatedServoKind& kind, std::uint8_t id, double shaft, const MotorDynamics& dynamics);

    std::uint8_t id() const { return static_cast<std::uint8_t>(memory_.value(ServoRole::Id)); }
    /// Pause before it answers.
    Time returnDelay() const { return std::chrono::microseconds{2 * memory_.value(ServoRole::ReturnDelay)}; }
    double shaft(Time at) const { return motor_.angle(at); }
    ServoMemory& memory() { return memory_; }

    /// Does what a request asks for, and its answer where it gives one. A request to all is done and not answered.
    std::optional<DynamixelStatus> handle(const DynamixelPacket& request, Time now);
    /// Its answer to a read from several; none without power.
    std::optional<DynamixelStatus> readFor(std::uint16_t first, std::uint16_t count, Time now);
    /// Its part of a write to several.
    void writeFor(std::uint16_t first, std::span<const std::uint8_t> bytes, Time now);

    // What can go wrong with it.
    void stall(Time now);
    void freeze(Time now);
    void overload(Time now);
    void overheat(Time now);
    void setSupply(int tenthsOfVolt, Time now);
    void becomeWheel();
    /// No power for a while; the shaft sinks to an angle meanwhile.
    void losePower(Time now, Time until, double shaft);
    void tellWrongAngles(double byAngle) { angleError_ = byAngle; }

private:
    bool hasPower(Time now) const { return now >= powerFrom_; }
    void wakeUp(Time now);
    void refresh(Time now);
    void raiseAlarms(Time now);
    void drive(Time now);
    int countOf(double shaft) const;
    double shaftOf(double count) const;
    int loadAt(Time now) const;
    int temperatureAt(Time now) const;
    bool hasTorque() const;
    std::uint32_t directed(int value) const;

    std::uint8_t ping(DynamixelStatus& status);
    std::uint8_t write(std::uint16_t first, std::span<const std::uint8_t> bytes, Time now);
    std::uint8_t reboot(Time now);
    std::uint8_t perform(const DynamixelPacket& request, DynamixelStatus& status, Time now);
    std::uint8_t errorOf(ServoMemory::Refusal refusal) const;
    std::uint8_t unknownInstruction() const;
    bool answers(const DynamixelPacket& request) const;
    std::uint8_t alarmByte() const;

    const EmulatedServoKind& kind_;
    ServoMemory memory_;
    EmulatedMotor motor_;
    ServoAlarm alarm_;
    std::optional<DynamixelPacket> registered_;
    int supply_;
    double angleError_ = 0.0;
    bool isStalled_ = false;
    bool isFrozen_ = false;
    bool isOverloaded_ = false;
    std::optional<Time> hotSince_;
    Time powerFrom_{0};
    bool wasReset_ = false;  ///< comes back with its RAM as new
};

}  // namespace planewright
