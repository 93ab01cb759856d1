// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/control_table.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr double revolutionsPerMinute(double rpm)
{
    return rpm * 2.0 * std::numbers::pi / 60.0;
}

constexpr std::array<ServoRegion, 2> kSettingsOne{{{0, 19}, {47, 1}}};
constexpr std::array<ServoRegion, 3> kSettingsOneWithTorqueMode{{{0, 19}, {47, 1}, {70, 1}}};
constexpr std::array<ServoRegion, 1> kDriveOne{{{24, 12}}};
// Only what every table of 2.0 defines: a servo may refuse to read what it has not.
constexpr std::array<ServoRegion, 4> kSettingsTwo{{{0, 14}, {31, 5}, {44, 12}, {63, 1}}};
constexpr std::array<ServoRegion, 3> kDriveTwo{{{64, 1}, {68, 3}, {112, 8}}};

/// RX and AX: two compliance margins, 300° over 1023 counts.
constexpr ControlTable tableOne()
{
    ControlTable table;
    table.model = {0, 2};
    table.firmware = {2, 1};
    table.returnDelay = {5, 1};
    table.lowestGoal = {6, 2};
    table.highestGoal = {8, 2};
    table.temperatureLimit = {11, 1};
    table.lowestVoltage = {12, 1};
    table.highestVoltage = {13, 1};
    table.maxTorque = {14, 2};
    table.returnLevel = {16, 1};
    table.shutdown = {18, 1};
    table.torqueEnable = {24, 1};
    table.marginClockwise = {26, 1};
    table.marginCounterClockwise = {27, 1};
    table.goal = {30, 2};
    table.speed = {32, 2};
    table.torqueLimit = {34, 2};
    table.position = {36, 2};
    table.presentSpeed = {38, 2};
    table.load = {40, 2};
    table.voltage = {42, 1};
    table.temperature = {43, 1};
    table.moving = {46, 1};
    table.lock = {47, 1};
    table.settings = kSettingsOne;
    table.drive = kDriveOne;
    table.motion = {30, 4};
    table.state = {36, 11};
    return table;
}

/// MX with the firmware of protocol 1.0: gains stand where RX and AX have their margins.
constexpr ControlTable tableOneMx(bool hasTorqueMode)
{
    ControlTable table = tableOne();
    table.marginClockwise = {};
    table.marginCounterClockwise = {};
    if (hasTorqueMode) {
        table.torqueMode = {70, 1};
        table.settings = kSettingsOneWithTorqueMode;
    }
    return table;
}

/// X series, and MX with the firmware of protocol 2.0.
constexpr ControlTable tableTwo()
{
    ControlTable table;
    table.model = {0, 2};
    table.firmware = {6, 1};
    table.returnDelay = {9, 1};
    table.driveMode = {10, 1};
    table.operatingMode = {11, 1};
    table.temperatureLimit = {31, 1};
    table.highestVoltage = {32, 2};
    table.lowestVoltage = {34, 2};
    table.speedLimit = {44, 4};
    table.highestGoal = {48, 4};
    table.lowestGoal = {52, 4};
    table.shutdown = {63, 1};
    table.torqueEnable = {64, 1};
    table.returnLevel = {68, 1};
    table.hardwareError = {70, 1};
    table.watchdog = {98, 1};
    table.speed = {112, 4};
    table.goal = {116, 4};
    table.moving = {122, 1};
    table.load = {126, 2};
    table.presentSpeed = {128, 4};
    table.position = {132, 4};
    table.voltage = {144, 2};
    table.temperature = {146, 1};
    table.settings = kSettingsTwo;
    table.drive = kDriveTwo;
    table.motion = {112, 8};
    table.state = {122, 25};
    return table;
}

constexpr ControlTable kTableOne = tableOne();
constexpr ControlTable kTableOneMx28 = tableOneMx(false);
constexpr ControlTable kTableOneMx = tableOneMx(true);
constexpr ControlTable kTableTwo = tableTwo();

constexpr DynamixelModel rx(std::uint16_t number, std::string_view name)
{
    return {DynamixelProtocol::One,      number, name, &kTableOne, 1023, 512, degrees(300.0) / 1023.0,
            revolutionsPerMinute(0.111), 1023,   1023};
}

constexpr DynamixelModel mx(std::uint16_t number, std::string_view name, const ControlTable& table)
{
    return {DynamixelProtocol::One,      number, name, &table, 4095, 2048, degrees(360.0) / 4096.0,
            revolutionsPerMinute(0.114), 1023,   1023};
}

/// `fullLoad`: 1000 where the servo tells its load in 0.1 %, its current limit where it tells a current.
constexpr DynamixelModel two(std::uint16_t number, std::string_view name, int fullLoad)
{
    return {DynamixelProtocol::Two,      number, name,    &kTableTwo, 4095, 2048, degrees(360.0) / 4096.0,
            revolutionsPerMinute(0.229), 32767,  fullLoad};
}

constexpr auto kModels = std::to_array<DynamixelModel>({
    rx(12, "AX-12"),
    rx(18, "AX-18"),
    rx(24, "RX-24F"),
    rx(28, "RX-28"),
    rx(64, "RX-64"),
    mx(29, "MX-28", kTableOneMx28),
    mx(310, "MX-64", kTableOneMx),
    mx(320, "MX-106", kTableOneMx),
    two(30, "MX-28(2.0)", 1000),
    two(311, "MX-64(2.0)", 1941),
    two(321, "MX-106(2.0)", 2047),
    two(1060, "XL430-W250", 1000),
    two(1020, "XM430-W350", 1193),
    two(1030, "XM430-W210", 1193),
    two(1120, "XM540-W270", 2047),
    two(1130, "XM540-W150", 2047),
    two(1000, "XH430-W350", 648),
    two(1010, "XH430-W210", 648),
    two(1040, "XH430-V350", 689),
    two(1050, "XH430-V210", 689),
});

}  // namespace

std::span<const DynamixelModel> dynamixelModels()
{
    return kModels;
}

const DynamixelModel* findDynamixelModel(DynamixelProtocol protocol, std::uint16_t number)
{
    const auto found = std::find_if(kModels.begin(), kModels.end(), [&](const DynamixelModel& model) {
        return model.protocol == protocol && model.number == number;
    });
    return found == kModels.end() ? nullptr : &*found;
}

std::string knownDynamixelModels()
{
    std::string text;
    for (const DynamixelModel& model : kModels)
        text += (text.empty() ? "" : ", ") + std::string{model.name};
    return text;
}

}  // namespace planewright
