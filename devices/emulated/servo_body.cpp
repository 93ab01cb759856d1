// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/servo_body.h"

#include <algorithm>
#include <cmath>

namespace planewright {

namespace {

using namespace std::chrono_literals;

constexpr int kRoomTemperature = 38;
constexpr int kHot = 82;
constexpr double kSinkingSpeed = 2.0;  // [rad/s]
constexpr std::uint32_t kVelocityMode = 1;
constexpr std::uint32_t kPositionMode = 3;

}  // namespace

ServoBody::ServoBody(const EmulatedServoKind& kind, std::uint8_t id, double shaft, const MotorDynamics& dynamics)
    : kind_(kind), memory_(kind), motor_(shaft, dynamics), supply_(kind.supply)
{
    memory_.set(ServoRole::Id, id);
    memory_.set(ServoRole::Goal, static_cast<std::uint32_t>(countOf(shaft)));
}

int ServoBody::countOf(double shaft) const
{
    const double count = kind_.middle + shaft / kind_.countAngle;
    return static_cast<int>(std::lround(std::clamp(count, 0.0, double(kind_.highestCount))));
}

double ServoBody::shaftOf(double count) const
{
    return (count - kind_.middle) * kind_.countAngle;
}

bool ServoBody::hasTorque() const
{
    const bool isLimited = memory_.has(ServoRole::TorqueLimit) && memory_.value(ServoRole::TorqueLimit) == 0;
    return memory_.value(ServoRole::TorqueEnable) != 0 && !isLimited;
}

/// After the power came back: the RAM is new.
void ServoBody::wakeUp(Time now)
{
    if (!wasReset_ || !hasPower(now))
        return;
    wasReset_ = false;
    memory_.powerOn();
    registered_.reset();
    isOverloaded_ = false;
    alarm_ = {};
    memory_.set(ServoRole::Goal, static_cast<std::uint32_t>(countOf(motor_.angle(now))));
}

int ServoBody::temperatureAt(Time now) const
{
    if (!hotSince_)
        return kRoomTemperature;
    // Without torque it cools by a degree a second.
    const auto cooled = std::chrono::duration_cast<std::chrono::seconds>(now - *hotSince_).count();
    return std::max<int>(kRoomTemperature, kHot - static_cast<int>(std::min<std::int64_t>(cooled, kHot)));
}

int ServoBody::loadAt(Time now) const
{
    if (!hasTorque())
        return 0;
    const double way = shaftOf(memory_.value(ServoRole::Goal)) - motor_.angle(now);
    const int sign = way < 0.0 ? -1 : 1;
    if (isStalled_ && std::abs(way) > kind_.countAngle)
        return sign * kind_.fullLoad;
    return motor_.isMoving(now) ? sign * 3 * kind_.restingLoad : kind_.restingLoad;
}

/// 1.0 has a bit for the direction, 2.0 two's complement.
std::uint32_t ServoBody::directed(int value) const
{
    if (kind_.protocol == DynamixelProtocol::Two)
        return static_cast<std::uint32_t>(value);
    return static_cast<std::uint32_t>(std::min(std::abs(value), 1023)) | (value < 0 ? 0x400U : 0U);
}

/// What it measures at a moment.
void ServoBody::refresh(Time now)
{
    memory_.set(ServoRole::Position, static_cast<std::uint32_t>(countOf(motor_.angle(now) + angleError_)));
    const int speed = static_cast<int>(std::lround(motor_.speed(now) / kind_.speedUnit));
    memory_.set(ServoRole::PresentSpeed, directed(speed));
    memory_.set(ServoRole::Load, directed(isOverloaded_ ? kind_.fullLoad : loadAt(now)));
    memory_.set(ServoRole::Voltage, static_cast<std::uint32_t>(supply_));
    memory_.set(ServoRole::Temperature, static_cast<std::uint32_t>(temperatureAt(now)));
    memory_.set(ServoRole::Moving, hasTorque() && motor_.isMoving(now) ? 1 : 0);
    memory_.set(ServoRole::Registered, registered_ ? 1 : 0);
    memory_.set(ServoRole::Tick, static_cast<std::uint32_t>(now / 1ms % 32768));
    raiseAlarms(now);
}

/// Alarms of what it measures. One of the shutdown mask turns it off, and that stays so when the alarm goes.
void ServoBody::raiseAlarms(Time now)
{
    ServoAlarm alarm;
    alarm.voltage = supply_ < static_cast<int>(memory_.value(ServoRole::LowestVoltage)) ||
                    supply_ > static_cast<int>(memory_.value(ServoRole::HighestVoltage));
    alarm.overheating = temperatureAt(now) >= static_cast<int>(memory_.value(ServoRole::TemperatureLimit));
    alarm.overload = isOverloaded_;
    const std::uint8_t bits = alarmBits(kind_.protocol, alarm);
    if (kind_.protocol == DynamixelProtocol::Two) {
        // A restart alone clears it.
        const auto all = static_cast<std::uint8_t>(memory_.value(ServoRole::HardwareError) | bits);
        memory_.set(ServoRole::HardwareError, all);
        alarm_ = decodeHardwareError(all);
    } else {
        alarm_ = alarm;
    }
    if ((bits & memory_.value(ServoRole::Shutdown)) == 0 || !hasTorque())
        return;
    memory_.set(memory_.has(ServoRole::TorqueLimit) ? ServoRole::TorqueLimit : ServoRole::TorqueEnable, 0);
    motor_.block(now);
}

/// Goes to its goal, if anything lets it.
void ServoBody::drive(Time now)
{
    const bool isWheel = memory_.has(ServoRole::OperatingMode)
                             ? memory_.value(ServoRole::OperatingMode) != kPositionMode
                             : memory_.value(ServoRole::LowestGoal) == 0 && memory_.value(ServoRole::HighestGoal) == 0;
    if (!hasTorque() || isStalled_ || isFrozen_ || isWheel) {
        motor_.block(now);
        return;
    }
    const std::uint32_t value = memory_.value(ServoRole::Speed);
    const double speed = value == 0 ? kind_.fastest : std::min(value * kind_.speedUnit, kind_.fastest);
    motor_.goTo(shaftOf(memory_.value(ServoRole::Goal)), speed, now);
}

void ServoBody::stall(Time now)
{
    isStalled_ = true;
    motor_.block(now);
}

void ServoBody::freeze(Time now)
{
    isFrozen_ = true;
    motor_.block(now);
}

void ServoBody::overload(Time now)
{
    isOverloaded_ = true;
    raiseAlarms(now);
}

void ServoBody::overheat(Time now)
{
    hotSince_ = now;
    raiseAlarms(now);
}

void ServoBody::setSupply(int tenthsOfVolt, Time now)
{
    supply_ = tenthsOfVolt;
    raiseAlarms(now);
}

void ServoBody::becomeWheel()
{
    if (memory_.has(ServoRole::OperatingMode)) {
        memory_.set(ServoRole::OperatingMode, kVelocityMode);
        return;
    }
    memory_.set(ServoRole::LowestGoal, 0);
    memory_.set(ServoRole::HighestGoal, 0);
}

void ServoBody::losePower(Time now, Time until, double shaft)
{
    powerFrom_ = until;
    wasReset_ = true;
    motor_.goTo(shaft, kSinkingSpeed, now);
}

}  // namespace planewright
