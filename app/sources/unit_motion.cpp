// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/unit_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/types/angle_text.h"

namespace planewright {

namespace {

using Time = std::chrono::nanoseconds;
using Seconds = std::chrono::duration<double>;

/// A unit that tells no angle for so long is not asked any more.
constexpr std::chrono::seconds kMostSilence{1};

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
    return travel(pitch, speed, [&] { return unit_->moveTo(pitch, speed); });
}

Result<double> UnitMotion::goHome()
{
    if (const Result<void> armed = arm(); !armed)
        return tl::unexpected{armed.error()};
    if (const Result<void> moved = travel(unit_->home(), unit_->homeSpeed(), [&] { return unit_->goHome(); }); !moved)
        return tl::unexpected{moved.error()};
    const Result<double> there = position();
    if (const Result<void> rested = rest(); !rested)
        return tl::unexpected{rested.error()};
    return there;
}

Result<void> UnitMotion::travel(double pitch, double speed, const std::function<Result<void>()>& begin)
{
    const Result<void> arrived = travelUnheld(pitch, speed, begin);
    if (!arrived)
        static_cast<void>(hold());
    return arrived;
}

Result<void> UnitMotion::travelUnheld(double pitch, double speed, const std::function<Result<void>()>& begin)
{
    const Result<double> begun = position();
    if (!begun)
        return tl::unexpected{begun.error()};
    if (const Result<void> sent = begin(); !sent)
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
            return fail(ErrorCode::DeviceLost, unit_->identity() + ": the head does not get to " +
                                                   degreesText(goal, 1) + " but stands at " +
                                                   degreesText(now->pitch, 1) +
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

}  // namespace planewright
