// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_board_servo.h"

#include <algorithm>
#include <cmath>

namespace planewright {

namespace {

/// Holding the laser, and moving it.
constexpr int kHoldingLoad = 60;
constexpr int kMovingLoad = 250;

}  // namespace

EmulatedBoardServo::EmulatedBoardServo(const TiltMounting& mounting, double startPitch, const MotorDynamics& dynamics)
    : scale_(mounting), motor_(startPitch, dynamics)
{
    goal_ = position(Time{0});
}

int EmulatedBoardServo::position(Time at) const
{
    const double counts = std::clamp(scale_.counts(motor_.angle(at)), 0.0, 1.0 * kHighest);
    return static_cast<int>(std::lround(counts));
}

int EmulatedBoardServo::load(Time at) const
{
    if (torque_ == 0)
        return 0;
    const double speed = motor_.speed(at) * (scale_.pitch(1) - scale_.pitch(0));
    return speed > 0.0 ? kMovingLoad : speed < 0.0 ? -kMovingLoad : kHoldingLoad;
}

void EmulatedBoardServo::goTo(int goal, double speed, Time now)
{
    goal_ = goal;
    if (!isStalled_ && torque_ > 0)
        motor_.goTo(scale_.pitch(goal), speed * scale_.step(), now);
}

void EmulatedBoardServo::brake(Time now)
{
    motor_.stop(now);
    goal_ = position(now + std::chrono::seconds{1});
}

void EmulatedBoardServo::stall(Time now)
{
    isStalled_ = true;
    motor_.block(now);
}

}  // namespace planewright
