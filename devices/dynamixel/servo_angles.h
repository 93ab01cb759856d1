// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "devices/dynamixel/control_table.h"
#include "devices/tilt_unit.h"

namespace planewright {

/// Between counts of a servo and pitch φ of what it carries:
///
///   φ = zeroPitch + sign · scale · (counts − middle) · angle of a count
class ServoAngles {
public:
    ServoAngles() = default;
    /// Counts from `lowestGoal` to `highestGoal` are those that the servo allows; `mostSpeed` is the largest value of
    /// its speed register.
    ServoAngles(const DynamixelModel& model, const TiltMounting& mounting, int lowestGoal, int highestGoal,
                int mostSpeed);

    double pitch(double counts) const;
    double counts(double pitch) const;

    /// φ of one count [rad].
    double resolution() const;

    /// Counts that both the servo and the mounting allow; empty where lowest is above highest.
    int lowestCount() const { return lowest_; }
    int highestCount() const { return highest_; }
    bool isEmpty() const { return lowest_ > highest_; }
    /// The nearest count that is allowed.
    int nearestCount(double pitch) const;

    /// Limits of φ [rad]: those of the mounting, or of the servo where they are narrower.
    double lowestPitch() const;
    double highestPitch() const;
    bool allows(double pitch) const;

    /// Largest speed of φ [rad/s].
    double fastest() const;
    /// The value of the speed register for a speed of φ: never faster than wanted, and never 0, which means no limit.
    int speedValue(double speed) const;
    /// Speed of φ that a value stands for [rad/s].
    double speedOf(int value) const;

private:
    DynamixelModel model_;
    TiltMounting mounting_;
    int lowestGoal_ = 0;
    int highestGoal_ = 0;
    int mostSpeed_ = 1;
    int lowest_ = 0;
    int highest_ = 0;
};

}  // namespace planewright
