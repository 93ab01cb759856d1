// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/motion_watch.h"

#include <algorithm>
#include <cmath>

namespace planewright {

namespace {

constexpr int kAnswersAtGoal = 3;
constexpr std::chrono::milliseconds kNoProgress{300};
constexpr std::chrono::milliseconds kReserve{500};
// A slow motion needs time even for the counts that tell of it.
constexpr double kCountsOfProgress = 3.0;

MotionWatch::Time seconds(double s)
{
    return std::chrono::round<MotionWatch::Time>(std::chrono::duration<double>(s));
}

}  // namespace

MotionWatch::MotionWatch(double from, double goal, double speed, double tolerance, Time begun)
    : goal_(goal), speed_(speed), tolerance_(tolerance)
{
    restart(from, begun);
}

void MotionWatch::restart(double position, Time at)
{
    nearest_ = std::abs(position - goal_);
    nearestAt_ = at;
    latest_ = at + seconds(3.0 * nearest_ / speed_) + kReserve;
    there_ = 0;
}

MotionWatch::Verdict MotionWatch::look(double position, bool isMoving, Time at)
{
    const double distance = std::abs(position - goal_);
    const bool isThere = distance <= tolerance_;
    if (!isThere && there_ == kAnswersAtGoal)
        restart(position, at);
    there_ = isThere && !isMoving ? std::min(there_ + 1, kAnswersAtGoal) : 0;
    if (there_ == kAnswersAtGoal)
        return Verdict::Arrived;
    if (distance < nearest_ || isThere) {
        nearest_ = distance;
        nearestAt_ = at;
    }
    if (isThere && !isMoving)
        return Verdict::OnItsWay;
    const Time patience = std::max<Time>(kNoProgress, seconds(kCountsOfProgress / speed_));
    return at - nearestAt_ > patience || at > latest_ ? Verdict::Stuck : Verdict::OnItsWay;
}

}  // namespace planewright
