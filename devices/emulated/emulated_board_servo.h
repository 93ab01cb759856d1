// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>

#include "devices/board/board_scale.h"
#include "devices/emulated/emulated_motor.h"

namespace planewright {

/// An RX-64 on an emulated control board: a motor that is told and asked in counts of 300/1023°.
class EmulatedBoardServo {
public:
    using Time = EmulatedMotor::Time;

    EmulatedBoardServo(const TiltMounting& mounting, double startPitch, const MotorDynamics& dynamics);

    static constexpr int kHighest = 1023;
    static constexpr int kMiddle = 512;

    /// What it measures.
    int position(Time at) const;
    /// In thousandths of all it can, positive towards higher counts.
    int load(Time at) const;
    int goal() const { return goal_; }
    bool isMoving(Time at) const { return motor_.isMoving(at); }
    /// φ of the shaft, not measured but true [rad].
    double pitch(Time at) const { return motor_.angle(at); }

    /// Counts, counts a second.
    void goTo(int goal, double speed, Time now);
    /// Comes to rest, which is its goal then.
    void brake(Time now);

    /// In thousandths; 0: limp.
    void setTorque(int torque) { torque_ = torque; }
    int torque() const { return torque_; }

    /// From now on something holds it.
    void stall(Time now);

private:
    board::Scale scale_;
    EmulatedMotor motor_;
    int goal_ = 0;
    int torque_ = 1000;
    bool isStalled_ = false;
};

}  // namespace planewright
