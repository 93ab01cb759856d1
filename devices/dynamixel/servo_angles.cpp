// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/servo_angles.h"

#include <algorithm>
#include <cmath>

namespace planewright {

namespace {

// Limits are often whole counts, which do not come out whole of the arithmetic.
constexpr double kCountSlack = 1e-6;
constexpr double kPitchSlack = 1e-9;

}  // namespace

ServoAngles::ServoAngles(const DynamixelModel& model, const TiltMounting& mounting, int lowestGoal, int highestGoal,
                         int mostSpeed)
    : model_(model), mounting_(mounting), lowestGoal_(lowestGoal), highestGoal_(highestGoal), mostSpeed_(mostSpeed)
{
    const auto [lower, upper] = std::minmax({counts(mounting.lowest), counts(mounting.highest)});
    // Clamped before they become whole: limits may be infinite.
    lowest_ = static_cast<int>(std::clamp(std::ceil(lower - kCountSlack), double(lowestGoal), highestGoal + 1.0));
    highest_ = static_cast<int>(std::clamp(std::floor(upper + kCountSlack), lowestGoal - 1.0, double(highestGoal)));
}

double ServoAngles::pitch(double counts) const
{
    return mounting_.zeroPitch + mounting_.sign * mounting_.scale * (counts - model_.middle) * model_.countAngle;
}

double ServoAngles::counts(double pitch) const
{
    return model_.middle + mounting_.sign * (pitch - mounting_.zeroPitch) / (mounting_.scale * model_.countAngle);
}

double ServoAngles::resolution() const
{
    return mounting_.scale * model_.countAngle;
}

int ServoAngles::nearestCount(double pitch) const
{
    if (isEmpty())
        return lowest_;
    const double wanted = std::clamp(counts(pitch), double(lowest_), double(highest_));
    return static_cast<int>(std::lround(wanted));
}

double ServoAngles::lowestPitch() const
{
    return std::max(mounting_.lowest, std::min(pitch(lowestGoal_), pitch(highestGoal_)));
}

double ServoAngles::highestPitch() const
{
    return std::min(mounting_.highest, std::max(pitch(lowestGoal_), pitch(highestGoal_)));
}

bool ServoAngles::allows(double pitch) const
{
    return !isEmpty() && pitch >= lowestPitch() - kPitchSlack && pitch <= highestPitch() + kPitchSlack;
}

double ServoAngles::fastest() const
{
    return std::min(mounting_.fastest, speedOf(mostSpeed_));
}

int ServoAngles::speedValue(double speed) const
{
    const double value = std::floor(speed / speedOf(1) + kCountSlack);
    return static_cast<int>(std::clamp(value, 1.0, double(std::max(mostSpeed_, 1))));
}

double ServoAngles::speedOf(int value) const
{
    return value * model_.speedUnit * mounting_.scale;
}

}  // namespace planewright
