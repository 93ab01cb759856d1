// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_clock.h"

#include <algorithm>
#include <utility>

namespace planewright {

namespace {

/// By which an answer may be wrong, one of its milliseconds and half of the way there and back; and the way of scans
/// quicker than it ever was.
constexpr ScipClock::Time kTooSoon = std::chrono::milliseconds{5};

/// A clock of whole milliseconds reads half of one too little on average.
ScipClock::Time middleOf(std::int64_t milliseconds)
{
    return std::chrono::milliseconds{milliseconds} + std::chrono::microseconds{500};
}

}  // namespace

void ScipClock::restart()
{
    stamps_.forget();
    least_.clear();
    arrivals_ = 0;
    behind_ = 0;
    asked_.reset();
    isDoubtful_ = false;
}

void ScipClock::addAnswer(std::uint32_t stamp, Time asked, Time answered)
{
    const ScipTime laser = stamps_.take(stamp, answered);
    if (laser.epoch != std::exchange(epoch_, laser.epoch))
        asked_.reset();
    if (asked_ && answered - asked >= quickest_)
        return;
    quickest_ = answered - asked;
    asked_ = asked + quickest_ / 2 - middleOf(laser.milliseconds);
    isDoubtful_ = quickest_ > kSlowestAnswer;
}

ScipClock::Scan ScipClock::addScan(std::uint32_t stamp, Time arrived, Time end, Time period)
{
    const ScipTime laser = stamps_.take(stamp, arrived, std::exchange(isPrompt_, false));
    if (laser.epoch != std::exchange(epoch_, laser.epoch)) {
        least_.clear();
        arrivals_ = 0;
        asked_.reset();
    }
    const Time start = middleOf(laser.milliseconds);
    const Time delay = arrived - (start + end);
    if (laser.repeats == 0)
        addArrival(arrived, delay);

    Scan scan;
    scan.start = start + offset();
    scan.isNewEpoch = laser.isNewEpoch;
    scan.isKnown = !isDoubtful_ && (asked_ || arrivals_ >= kKnown);
    const Time excess = delay - offset() - way_.value_or(Time{0});
    scan.isLate = excess > period;
    scan.isBehind = excess > period * 4 / 5;
    behind_ = scan.isBehind ? behind_ + 1 : 0;
    scan.repeats = laser.repeats;
    scan.milliseconds = laser.milliseconds;
    return scan;
}

void ScipClock::addArrival(Time arrived, Time delay)
{
    // No scan comes before it was measured, nor much sooner than the quickest of many: where one does, the clocks do
    // not stand to each other as they did, or the answers were of another clock than the stamps.
    const bool isTooSoon =
        asked_ ? delay < *asked_ - kTooSoon : !least_.empty() && delay < least_.front().delay - kTooSoon;
    if (isTooSoon || behind_ >= kKnown) {
        // Scans that all come late from some moment on: either the laser's clock was set, or the link holds them back.
        isDoubtful_ = !isTooSoon;
        least_.clear();
        arrivals_ = 0;
        behind_ = 0;
        if (asked_)
            way_.reset();
        asked_.reset();
    }
    while (!least_.empty() && least_.back().delay >= delay)
        least_.pop_back();
    least_.push_back({arrived, delay});
    while (least_.front().arrived < arrived - kWindow)
        least_.pop_front();
    if (++arrivals_ == kSettled && asked_) {
        way_ = std::max(Time{0}, least_.front().delay - *asked_);
        asked_.reset();
    }
}

/// Host minus laser.
ScipClock::Time ScipClock::offset() const
{
    if (asked_)
        return *asked_;
    return (least_.empty() ? Time{0} : least_.front().delay) - way_.value_or(Time{0});
}

}  // namespace planewright
