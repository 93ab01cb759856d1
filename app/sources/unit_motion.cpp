// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/unit_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/types/angle.h"

namespace planewright {

namespace {

using Time = std::chrono::nanoseconds;
using Seconds = std::chrono::duration<double>;

/// A unit that tells no angle for so long is not asked any more.
constexpr std::chrono::seconds kMostSilence{1};
constexpr double kLevel = degrees(90.0);
constexpr double kSlowly = degrees(20.0);  // [rad/s]: slow enough to be stopped by hand

std::string inDegrees(double angle)
{
    const auto tenths = std::lround(toDegrees(angle) * 10.0);
    return (tenths < 0 ? "-" : "") + std::to_string(std::abs(tenths) / 10) + "." +
           std::to_string(std::abs(tenths) % 10) + "°";
}

}  // namespace

UnitMotion::UnitMotion(std::unique_ptr<TiltUnit> unit, const Clock& clock, std::stop_token stop)
    : unit_(std::move(unit)),
      clock_(clock),
      stop_(std::move(stop)),
      onStop_(stop_, [this] { static_cast<void>(hold()); })
{
}

UnitMotion::~UnitMotion()
{
    if (mayMove_)
        static_cast<void>(rest());
}

tl::unexpected<Error> UnitMotion::stopped() const
{
    return fail(ErrorCode::Interrupted, unit_->identity() + ": motion was stopped; the head is held where it is");
}

/// A stop that comes while it is armed must hold all the same.
Result<void> UnitMotion::arm()
{
    if (stop_.stop_requested())
        return stopped();
    const Result<void> armed = unit_->arm(stop_);
    mayMove_ = true;
    if (!stop_.stop_requested())
        return armed;
    static_cast<void>(hold());
    return stopped();
}

Result<TiltSample> UnitMotion::sample(Time until)
{
    while (!stop_.stop_requested()) {
        const auto sample = unit_->sample(until, stop_);
        if (!sample)
            return stop_.stop_requested() ? stopped() : tl::unexpected{sample.error()};
        if (*sample)
            return **sample;
        if (clock_.now() >= until)
            return fail(ErrorCode::DeviceLost,
                        unit_->identity() + " has not told its angle for a second; look at its cable and power");
    }
    return stopped();
}

Result<double> UnitMotion::position()
{
    const Result<TiltSample> now = sample(clock_.now() + kMostSilence);
    if (!now)
        return tl::unexpected{now.error()};
    return now->pitch;
}

Result<void> UnitMotion::moveTo(double pitch, double speed)
{
    const Result<void> moved = moveUnheld(pitch, speed);
    if (!moved)
        static_cast<void>(hold());
    return moved;
}

Result<void> UnitMotion::moveUnheld(double pitch, double speed)
{
    const Result<double> begun = position();
    if (!begun)
        return tl::unexpected{begun.error()};
    if (const Result<void> sent = unit_->moveTo(pitch, speed); !sent)
        return stop_.stop_requested() ? stopped() : sent;
    const double goal = unit_->nearestPitch(pitch);
    const Seconds most{3.0 * std::abs(goal - *begun) / std::min(speed, unit_->fastest()) + 1.0};
    const Time until = clock_.now() + std::chrono::round<Time>(most);
    for (;;) {
        const Result<TiltSample> now = sample(clock_.now() + kMostSilence);
        if (!now)
            return tl::unexpected{now.error()};
        if (!now->moving && std::abs(now->pitch - goal) <= unit_->tolerance() + 0.5 * unit_->resolution())
            return {};
        if (clock_.now() >= until)
            return fail(ErrorCode::DeviceLost, unit_->identity() + ": the head does not get to " + inDegrees(goal) +
                                                   " but stands at " + inDegrees(now->pitch) +
                                                   "; look whether something blocks it, and whether its power is on");
    }
}

Result<void> UnitMotion::hold()
{
    const Result<void> held = unit_->hold();
    if (held)
        mayMove_ = false;
    return held;
}

Result<void> UnitMotion::rest()
{
    const Result<void> rested = stop_.stop_requested() ? unit_->hold() : unit_->stop();
    if (rested)
        mayMove_ = false;
    return rested;
}

Result<std::string> release(TiltUnit& unit, const std::stop_token& stop)
{
    if (const Result<void> released = unit.recover(stop); !released)
        return tl::unexpected{released.error()};
    const std::string trouble = unit.motor().trouble;
    return unit.identity() + " is released" + (trouble.empty() ? "" : "; it says: " + trouble);
}

Result<double> bringToLevel(UnitMotion& motion)
{
    if (const Result<void> armed = motion.arm(); !armed)
        return tl::unexpected{armed.error()};
    const TiltUnit& unit = motion.unit();
    const double level = std::clamp(kLevel, unit.lowest(), unit.highest());
    if (const Result<void> moved = motion.moveTo(level, std::min(kSlowly, unit.fastest())); !moved)
        return tl::unexpected{moved.error()};
    const Result<double> there = motion.position();
    if (const Result<void> rested = motion.rest(); !rested)
        return tl::unexpected{rested.error()};
    return there;
}

}  // namespace planewright
