// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "devices/dynamixel/packet.h"

namespace planewright {

/// What a value of a servo's control table means to its emulation.
enum class ServoRole {
    None,
    Id,
    ReturnDelay,
    LowestGoal,
    HighestGoal,
    TemperatureLimit,
    LowestVoltage,
    HighestVoltage,
    MaxTorque,
    ReturnLevel,
    Shutdown,
    OperatingMode,
    TorqueEnable,
    Goal,
    Speed,
    TorqueLimit,
    HardwareError,
    Position,
    PresentSpeed,
    Load,
    Voltage,
    Temperature,
    Registered,
    Moving,
    Lock,
    Tick,
    Watchdog,
};

/// One value of a control table, as the manufacturer's page has it.
struct ServoRule {
    std::uint16_t address = 0;
    std::uint8_t size = 0;
    bool isWritable = false;
    std::int64_t lowest = 0;  ///< what may be written
    std::int64_t highest = 0;
    std::uint32_t initial = 0;  ///< from the factory, or when the power comes
    ServoRole role = ServoRole::None;
};

/// A kind of servo that can be emulated. Written down apart from the driver's tables, so that a mistake in one of them
/// shows.
struct EmulatedServoKind {
    std::uint16_t model = 0;
    std::string_view name;
    DynamixelProtocol protocol = DynamixelProtocol::One;
    std::span<const ServoRule> rules;
    std::uint16_t firstRam = 0;  ///< address from which on values go with the power
    std::uint16_t end = 0;       ///< behind the last address
    int highestCount = 0;
    int middle = 0;
    double countAngle = 0.0;  ///< [rad]
    double speedUnit = 0.0;   ///< [rad/s]
    double fastest = 0.0;     ///< without a load [rad/s]
    int supply = 0;           ///< 0.1 V
    int fullLoad = 0;
    int restingLoad = 0;  ///< what it takes to hold the laser
};

std::span<const EmulatedServoKind> emulatedServoKinds();

/// Empty where it cannot be emulated.
const EmulatedServoKind* findEmulatedServoKind(std::uint16_t model);

/// "RX-64 (64), AX-12 (12), …".
std::string knownEmulatedServoKinds();

}  // namespace planewright
