// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "devices/dynamixel/packet.h"

namespace planewright {

/// One value of a servo's control table.
struct ServoRegister {
    std::uint16_t address = 0;
    std::uint8_t size = 0;  ///< bytes; 0: this table has no such value

    bool exists() const { return size != 0; }
};

/// Bytes that are read together. Never two: the answer would look like the request itself.
struct ServoRegion {
    std::uint16_t first = 0;
    std::uint16_t count = 0;
};

/// Firmware of 2.0 that first had a watchdog.
inline constexpr int kFirmwareWithWatchdog = 38;

/// Where a family of servos keeps what we need to know. Source: the manufacturer's tables.
struct ControlTable {
    ServoRegister model;
    ServoRegister firmware;
    ServoRegister returnDelay;  ///< 2 µs a unit
    ServoRegister driveMode;
    ServoRegister operatingMode;
    ServoRegister lowestGoal;
    ServoRegister highestGoal;
    ServoRegister temperatureLimit;  ///< [°C]
    ServoRegister lowestVoltage;     ///< 0.1 V a unit
    ServoRegister highestVoltage;
    ServoRegister maxTorque;    ///< what the torque limit is when the power comes
    ServoRegister returnLevel;  ///< 0: answers pings alone, 1: also reads, 2: everything
    ServoRegister shutdown;     ///< alarms that turn it off
    ServoRegister speedLimit;
    ServoRegister torqueEnable;
    ServoRegister marginClockwise;  ///< compliance margins [counts]
    ServoRegister marginCounterClockwise;
    ServoRegister goal;
    ServoRegister speed;        ///< of the way to the goal; 0 = as fast as possible
    ServoRegister torqueLimit;  ///< 0 after a shutdown
    ServoRegister hardwareError;
    ServoRegister position;
    ServoRegister presentSpeed;
    ServoRegister load;
    ServoRegister voltage;  ///< 0.1 V a unit
    ServoRegister temperature;
    ServoRegister moving;
    ServoRegister lock;        ///< of the EEPROM; only the end of the power clears it
    ServoRegister torqueMode;  ///< 1: obeys a torque and no goal
    ServoRegister watchdog;    ///< 255 after a program that used it has died: no goal is taken then; 0 = off

    std::span<const ServoRegion> settings;  ///< what does not change while it runs
    std::span<const ServoRegion> drive;     ///< torque, goal, speed, hardware error: what tells of a reset
    ServoRegion motion;                     ///< goal and speed: written at once
    ServoRegion state;                      ///< position, speed, load, voltage, temperature, moving: one round trip
};

/// A kind of servo.
struct DynamixelModel {
    DynamixelProtocol protocol = DynamixelProtocol::One;
    std::uint16_t number = 0;  ///< that it gives for its model
    std::string_view name;
    const ControlTable* table = nullptr;
    int highestCount = 0;     ///< counts go from 0 to this
    int middle = 0;           ///< count of the middle position
    double countAngle = 0.0;  ///< angle of a count [rad]
    double speedUnit = 0.0;   ///< of the speed register [rad/s]
    int mostSpeed = 0;        ///< largest value of the speed register
    int fullLoad = 0;         ///< value of the load register that stands for all that it can
};

std::span<const DynamixelModel> dynamixelModels();

/// Empty where the number is not known.
const DynamixelModel* findDynamixelModel(DynamixelProtocol protocol, std::uint16_t number);

/// "RX-24F, RX-28, RX-64, …".
std::string knownDynamixelModels();

}  // namespace planewright
