// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>

#include "devices/dynamixel/control_table.h"
#include "devices/dynamixel/register_image.h"
#include "devices/dynamixel/status_error.h"

namespace planewright {

/// What a servo measures, of one round trip.
struct ServoState {
    int position = 0;          ///< [counts]
    double speed = 0.0;        ///< positive with growing counts [rad/s]
    double load = 0.0;         ///< of the most it can, positive with growing counts
    double voltage = 0.0;      ///< [V]
    double temperature = 0.0;  ///< [°C]
    bool moving = false;       ///< 0 also before a motion begins and where it is stuck
};

/// What a servo was set to when it was asked; none of it is ever written by us.
struct ServoSettings {
    int firmware = 0;
    int lowestGoal = 0;  ///< [counts]
    int highestGoal = 0;
    int mostSpeed = 0;  ///< largest value of the speed register that it obeys
    int returnLevel = 2;
    std::chrono::nanoseconds returnDelay{0};
    double temperatureLimit = 0.0;  ///< [°C]
    double lowestVoltage = 0.0;     ///< [V]
    double highestVoltage = 0.0;
    int maxTorque = 0;    ///< what the torque limit is to be; 0 where the table has none
    ServoAlarm shutdown;  ///< alarms that turn it off
    int tolerance = 0;    ///< counts within which it takes a goal for reached
};

/// What holds until the power goes, and is written by us or by an alarm.
struct ServoDrive {
    bool torqueOn = false;
    bool isShutDown = false;  ///< an alarm has turned it off
    ServoAlarm alarm;         ///< 2.0: from the hardware error register
    int goal = 0;             ///< [counts]
    int speed = 0;            ///< value of the speed register
};

/// Decodes the regions `state`, `settings` and `drive` of the model's table. In 2.0 a position counts turns while the
/// torque is off: `withTurns` false leaves the place within one turn.
ServoState decodeState(const DynamixelModel& model, const RegisterImage& image, bool withTurns);
ServoSettings decodeSettings(const DynamixelModel& model, const RegisterImage& image);
ServoDrive decodeDrive(const DynamixelModel& model, const RegisterImage& image);

}  // namespace planewright
