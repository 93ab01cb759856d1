// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/slice_taker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace planewright {

namespace {

using Seconds = std::chrono::duration<double>;

/// A unit that does not move for this long while it should is stuck. Its driver sees that sooner, tells it once more,
/// and knows more about it: this is for units that say nothing.
constexpr std::chrono::milliseconds kStuckAfter{800};
/// A slow head needs time even for the counts that tell of its way.
constexpr double kCountsOfWay = 9.0;
/// No more than angles are remembered.
constexpr std::chrono::milliseconds kStuckAtLast{2500};
constexpr int kSamplesOfRest = 3;
constexpr int kMostSuspects = 2;
/// A sweep begins and ends this much outside of its slices, so that the head has its speed within them.
constexpr double kLeadIn = degrees(2.0);
constexpr Seconds kLeadInTime{0.06};
/// A motor's speed is true to some percent only: after a while the head may be off its planned way by this share of it.
constexpr double kSpeedError = 0.05;
/// The first turn of a sweep is the next slice's up to this share of a step before the slice after it: a head that is a
/// little fast passes more than a step in a turn.
constexpr double kFirstSlack = 0.2;
/// A slice that is on its way is waited for so long, beside what the way takes.
constexpr std::chrono::seconds kSlicePatience{1};
/// Where limits leave no room to gain speed before the first slices, these have less of it.
constexpr int kSlicesToGainSpeed = 3;

}  // namespace

SliceTaker::SliceTaker(const ScanPlan& plan, const FittedPlan& fitted, const LaserLimits& laser, Head head)
    : plan_(plan),
      fitted_(fitted),
      head_(std::move(head)),
      sliceTime_(fitted.turnsPerSlice * laser.period),
      maker_({fitted.firstBearing, fitted.bearingStep, plan.mode == ScanPlan::Mode::Continuous, head_.resolution})
{
    plan_.pitchStep = fitted.pitchStep;
}

double SliceTaker::within(double pitch) const
{
    return std::clamp(pitch, head_.lowest, head_.highest);
}

double SliceTaker::leadIn() const
{
    return isSweep() ? std::max(kLeadIn, fitted_.sweepSpeed * kLeadInTime.count()) : 0.0;
}

SliceTaker::Aim SliceTaker::start() const
{
    return {within(plan_.pitch(next_) - direction() * leadIn()), std::min(plan_.travelSpeed, head_.fastest)};
}

SliceTaker::Time SliceTaker::patience() const
{
    const double way = std::abs(plan_.pitchStep) + leadIn();
    const Seconds most{2.0 * way / goal().speed};
    return kSlicePatience + plan_.settle + std::chrono::round<Time>(most);
}

SliceTaker::Aim SliceTaker::goal() const
{
    if (!isSweep())
        return {within(plan_.pitch(next_)), std::min(plan_.travelSpeed, head_.fastest)};
    const double last = plan_.pitch(plan_.slices - 1);
    const double beyond = 2.0 * std::abs(plan_.pitchStep) + kLeadIn + kSpeedError * std::abs(last - plan_.pitch(next_));
    return {within(last + direction() * beyond), fitted_.sweepSpeed};
}

void SliceTaker::aimed(Time now)
{
    aimedAt_ = now;
    anchor_.reset();
}

void SliceTaker::resume()
{
    resumed_ = true;
    mustGoBack_ = false;
    suspects_ = 0;
}

Result<std::optional<ScanSlice>> SliceTaker::take(LaserScan scan, const TiltTrack& track)
{
    // Where the head was at a moment that is not known, nobody knows.
    if (isDone() || scan.timeSuspect || scan.first < aimedAt_)
        return std::nullopt;
    std::optional<ScanSlice> slice =
        isSweep() ? takeSwept(std::move(scan), track) : takeResting(std::move(scan), track);
    if (!slice)
        return std::nullopt;
    suspects_ = slice->angleSuspect ? suspects_ + 1 : 0;
    if (suspects_ >= kMostSuspects)
        return fail(ErrorCode::NeedsOperator, head_.name +
                                                  ": the head does not move as it was told; look whether something "
                                                  "blocks it, and whether the laser is fixed to it");
    lost_ += slice->step - next_;
    next_ = slice->step + 1;
    returnsHere_ = 0;
    slice->retaken = std::exchange(resumed_, false);
    return slice;
}

/// The slice that a turn of the mirror belongs to: turns are counted by time, so that a lost one leaves a gap.
std::optional<int> SliceTaker::stepOf(const LaserScan& scan, const TiltTrack& track)
{
    if (!anchor_) {
        const std::optional<double> pitch = track.pitchAt(scan.first, kLargestSkew);
        const double steps = pitch ? (*pitch - plan_.pitch(next_)) / plan_.pitchStep : -1.0;
        if (steps < -0.5)
            return std::nullopt;
        const int missed = std::max(0, static_cast<int>(std::floor(steps + kFirstSlack)));
        anchor_ = Anchor{scan.first, next_ + missed};
    }
    const double slices = Seconds(scan.first - anchor_->first) / Seconds(sliceTime_);
    const double nearest = std::round(slices);
    // Of several turns a slice, one is the slice's.
    if (std::abs(slices - nearest) * fitted_.turnsPerSlice >= 0.5)
        return std::nullopt;
    return anchor_->slice + static_cast<int>(nearest);
}

std::optional<ScanSlice> SliceTaker::takeSwept(LaserScan scan, const TiltTrack& track)
{
    const std::optional<int> step = stepOf(scan, track);
    if (!step || *step < next_)
        return std::nullopt;
    if (*step > next_ && mayGoBack()) {
        ++returns_;
        ++returnsHere_;
        mustGoBack_ = true;
        return std::nullopt;
    }
    if (*step >= plan_.slices) {
        lost_ += plan_.slices - next_;
        next_ = plan_.slices;
        return std::nullopt;
    }
    const Time duration = scan.last - scan.first;
    std::optional<ScanSlice> slice = maker_.make(std::move(scan), track, *step, plan_.pitch(*step));
    if (slice)
        slice->angleSuspect = !isAsTold(*slice, duration);
    return slice;
}

/// True where a slice of a sweep lies near its planned angle, and the head moved at about the planned speed meanwhile.
bool SliceTaker::isAsTold(const ScanSlice& slice, Time duration) const
{
    const int swept = slice.step - anchor_->slice;
    if (std::abs(slice.tilt - plan_.pitch(slice.step)) > std::abs(plan_.pitchStep) * (1.0 + kSpeedError * swept))
        return false;
    const double speed = direction() * (slice.tiltEnd.value_or(slice.tilt) - slice.tilt) / Seconds(duration).count();
    const bool isSlow = speed < 0.5 * fitted_.sweepSpeed && swept >= kSlicesToGainSpeed;
    return !isSlow && speed <= 1.5 * fitted_.sweepSpeed;
}

std::optional<ScanSlice> SliceTaker::takeResting(LaserScan scan, const TiltTrack& track)
{
    const auto since = restsSince(goal().pitch, track);
    if (!since || scan.first < *since + plan_.settle)
        return std::nullopt;
    return maker_.make(std::move(scan), track, next_, plan_.pitch(next_));
}

/// A head that swings or creeps by one count about where it stands rests.
std::optional<SliceTaker::Time> SliceTaker::restsSince(double pitch, const TiltTrack& track) const
{
    if (track.isEmpty() || std::abs(track.last().pitch - pitch) > tolerance())
        return std::nullopt;
    return track.restsSince(1.01 * head_.resolution, kSamplesOfRest);
}

SliceTaker::Time SliceTaker::stuckAfter() const
{
    const Seconds counts{kCountsOfWay * head_.resolution / goal().speed};
    return std::clamp<Time>(std::chrono::round<Time>(counts), kStuckAfter, kStuckAtLast);
}

bool SliceTaker::getsOn(const TiltTrack& track, Time now) const
{
    if (isDone() || !track.isFresh(now))
        return true;
    const Time from = track.last().at - stuckAfter();
    const std::optional<double> before = from < aimedAt_ ? std::nullopt : track.pitchAt(from, stuckAfter());
    if (!before)
        return true;
    const double pitch = track.last().pitch;
    const double least = 0.5 * head_.resolution + 0.25 * fitted_.sweepSpeed * Seconds(stuckAfter()).count();
    const double left =
        isSweep() ? direction() * (within(plan_.pitch(plan_.slices - 1)) - pitch) : std::abs(goal().pitch - pitch);
    return std::abs(pitch - *before) >= least || left <= tolerance();
}

}  // namespace planewright
