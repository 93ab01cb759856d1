// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_clock.h"

#include <algorithm>
#include <utility>

namespace planewright {

namespace {

/// By which an answer may be wrong: one of its milliseconds, and half of the way there and back.
constexpr ScipClock::Time kAnswerError = std::chrono::milliseconds{5};

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
    asked_.reset();
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
}

ScipClock::Scan ScipClock::addScan(std::uint32_t stamp, Time arrived, Time end, Time period)
{
    const ScipTime laser = stamps_.take(stamp, arrived);
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
    scan.isLate = delay - offset() - way_.value_or(Time{0}) > period;
    scan.repeats = laser.repeats;
    scan.milliseconds = laser.milliseconds;
    return scan;
}

void ScipClock::addArrival(Time arrived, Time delay)
{
    while (!least_.empty() && least_.back().delay >= delay)
        least_.pop_back();
    least_.push_back({arrived, delay});
    while (least_.front().arrived < arrived - kWindow)
        least_.pop_front();
    // No scan comes before it was measured: such a laser tells another time than it stamps.
    if (asked_ && delay < *asked_ - kAnswerError) {
        asked_.reset();
        way_.reset();
    }
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
