// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/servo_state.h"

#include <algorithm>

namespace planewright {

namespace {

// Without a compliance margin: half a degree, which a servo with gains reaches under load.
constexpr int kToleranceWithoutMargin = 5;

/// Values of 1.0 whose bit 10 is a direction: set = clockwise = falling counts.
int withDirectionBit(std::uint32_t value)
{
    const int magnitude = static_cast<int>(value & 0x3FF);
    return (value & 0x400) != 0 ? -magnitude : magnitude;
}

int directed(const DynamixelModel& model, const RegisterImage& image, const ServoRegister& place)
{
    return model.protocol == DynamixelProtocol::One ? withDirectionBit(image.value(place)) : image.signedValue(place);
}

int positionOf(const DynamixelModel& model, const RegisterImage& image, bool withTurns)
{
    if (model.protocol == DynamixelProtocol::One)
        return static_cast<int>(image.value(model.table->position));
    const int position = image.signedValue(model.table->position);
    const int turn = model.highestCount + 1;
    return withTurns ? position : (position % turn + turn) % turn;
}

}  // namespace

ServoState decodeState(const DynamixelModel& model, const RegisterImage& image, bool withTurns)
{
    const ControlTable& table = *model.table;
    ServoState state;
    state.position = positionOf(model, image, withTurns);
    state.speed = directed(model, image, table.presentSpeed) * model.speedUnit;
    state.load = std::clamp(double(directed(model, image, table.load)) / model.fullLoad, -1.0, 1.0);
    state.voltage = 0.1 * image.value(table.voltage);
    state.temperature = image.value(table.temperature);
    state.moving = image.value(table.moving) != 0;
    return state;
}

ServoSettings decodeSettings(const DynamixelModel& model, const RegisterImage& image)
{
    const ControlTable& table = *model.table;
    const auto number = [&image](const ServoRegister& place) { return static_cast<int>(image.value(place)); };
    ServoSettings settings;
    settings.firmware = number(table.firmware);
    settings.lowestGoal = std::clamp(number(table.lowestGoal), 0, model.highestCount);
    settings.highestGoal = std::clamp(number(table.highestGoal), 0, model.highestCount);
    settings.mostSpeed =
        table.speedLimit.exists() ? std::clamp(number(table.speedLimit), 0, model.mostSpeed) : model.mostSpeed;
    settings.returnLevel = number(table.returnLevel);
    settings.returnDelay = std::chrono::microseconds{2 * number(table.returnDelay)};
    settings.temperatureLimit = number(table.temperatureLimit);
    settings.lowestVoltage = 0.1 * number(table.lowestVoltage);
    settings.highestVoltage = 0.1 * number(table.highestVoltage);
    settings.maxTorque = number(table.maxTorque);
    const auto shutdown = static_cast<std::uint8_t>(number(table.shutdown));
    settings.shutdown = decodeHardwareError(shutdown);
    if (model.protocol == DynamixelProtocol::One)
        settings.shutdown = decodeStatusError(DynamixelProtocol::One, shutdown).alarm;
    // One count more than the margin: the position that is told is rounded, too.
    settings.tolerance = table.marginClockwise.exists()
                             ? std::max(number(table.marginClockwise), number(table.marginCounterClockwise)) + 1
                             : kToleranceWithoutMargin;
    return settings;
}

ServoDrive decodeDrive(const DynamixelModel& model, const RegisterImage& image)
{
    const ControlTable& table = *model.table;
    ServoDrive drive;
    drive.torqueOn = image.value(table.torqueEnable) != 0;
    drive.goal = image.signedValue(table.goal);
    drive.speed = static_cast<int>(image.value(table.speed));
    drive.alarm = decodeHardwareError(static_cast<std::uint8_t>(image.value(table.hardwareError)));
    drive.isShutDown =
        table.torqueLimit.exists() ? image.value(table.torqueLimit) == 0 : drive.alarm.any() && !drive.torqueOn;
    return drive;
}

}  // namespace planewright
