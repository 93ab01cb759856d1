// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/clock_sync.h"

#include <algorithm>
#include <cmath>

namespace planewright::board {

namespace {

using namespace std::chrono_literals;

constexpr ClockSync::Time kSlot = 500ms;
constexpr std::size_t kSlots = 20;
/// A line is believed for so long after its last quick heartbeat.
constexpr ClockSync::Time kRemembered = 60s;
/// Round trips up to this much above one and a half of the smallest still count.
constexpr ClockSync::Time kSlack = 200us;
/// A line through less than this would turn the round trip's uncertainty into a wrong drift.
constexpr ClockSync::Time kShortestSpan = 2s;
/// More than any resonator that USB works with.
constexpr double kLargestDrift = 0.01;
constexpr std::chrono::microseconds kLongestStray = 10min;
/// Beyond this a stamp is no time since a start, and sums of nanoseconds would overflow.
constexpr std::chrono::microseconds kLatest = std::chrono::hours{24 * 365 * 100};

}  // namespace

bool ClockSync::add(const HeartbeatStamps& s)
{
    if (s.boardReceived < 0us || s.boardSent > kLatest || s.boardSent < s.boardReceived || s.hostReceived < s.hostSent)
        return false;
    const Time roundTrip = (s.hostReceived - s.hostSent) - (s.boardSent - s.boardReceived);
    if (roundTrip < Time{0})
        return false;
    const Time board = (Time{s.boardReceived} + Time{s.boardSent}) / 2;
    const Time host = s.hostSent + (s.hostReceived - s.hostSent) / 2;
    const Sample sample{board, host - board, roundTrip, s.hostReceived};

    if (best_.empty() || best_.back().at / kSlot != sample.at / kSlot)
        best_.push_back(sample);
    else if (sample.roundTrip <= best_.back().roundTrip)
        best_.back() = sample;
    forget(sample.at);
    fit();
    return true;
}

std::optional<ClockSync::Time> ClockSync::toHost(std::uint64_t boardUs) const
{
    if (best_.empty() || boardUs > static_cast<std::uint64_t>(kLatest.count()))
        return std::nullopt;
    const Time board = std::chrono::microseconds{static_cast<std::int64_t>(boardUs)};
    if (std::chrono::abs(board - best_.back().board) > kLongestStray)
        return std::nullopt;
    const double sinceReference = static_cast<double>((board - reference_).count());
    return board + offset_ + Time{std::llround(slope_ * sinceReference)};
}

ClockSync::Time ClockSync::roundTrip() const
{
    Time smallest = Time::max();
    for (const Sample& sample : best_)
        smallest = std::min(smallest, sample.roundTrip);
    return smallest;
}

double ClockSync::drift() const
{
    return -slope_ / (1.0 + slope_);
}

void ClockSync::restart()
{
    best_.clear();
    slope_ = 0.0;
}

/// The longest round trip that still counts.
ClockSync::Time ClockSync::slowest() const
{
    return roundTrip() * 3 / 2 + kSlack;
}

/// Makes room: slow ones go first, and all others once the last of them is old.
void ClockSync::forget(Time now)
{
    const Time limit = slowest();
    const auto isQuick = [&](const Sample& sample) { return sample.roundTrip <= limit; };
    const auto newestQuick = std::find_if(best_.rbegin(), best_.rend(), isQuick);
    if (now - newestQuick->at > kRemembered)
        std::erase_if(best_, isQuick);
    if (best_.size() <= kSlots)
        return;
    const auto slow = std::find_if_not(best_.begin(), best_.end(), isQuick);
    best_.erase(slow == best_.end() ? best_.begin() : slow);
}

void ClockSync::fit()
{
    const Time limit = slowest();
    std::deque<Sample> quick;
    std::copy_if(best_.begin(), best_.end(), std::back_inserter(quick),
                 [&](const Sample& sample) { return sample.roundTrip <= limit; });
    const Sample& quickest = *std::min_element(
        quick.begin(), quick.end(), [](const Sample& a, const Sample& b) { return a.roundTrip < b.roundTrip; });
    reference_ = quickest.board;
    offset_ = quickest.offset;
    slope_ = 0.0;
    if (quick.back().board - quick.front().board < kShortestSpan)
        return;

    double meanX = 0.0;
    double meanY = 0.0;
    const auto n = static_cast<double>(quick.size());
    const auto x = [&](const Sample& sample) { return static_cast<double>((sample.board - reference_).count()); };
    const auto y = [&](const Sample& sample) { return static_cast<double>((sample.offset - quickest.offset).count()); };
    for (const Sample& sample : quick) {
        meanX += x(sample) / n;
        meanY += y(sample) / n;
    }
    double xx = 0.0;
    double xy = 0.0;
    for (const Sample& sample : quick) {
        xx += (x(sample) - meanX) * (x(sample) - meanX);
        xy += (x(sample) - meanX) * (y(sample) - meanY);
    }
    slope_ = std::clamp(xy / xx, -kLargestDrift, kLargestDrift);
    offset_ += Time{std::llround(meanY - slope_ * meanX)};
}

}  // namespace planewright::board
