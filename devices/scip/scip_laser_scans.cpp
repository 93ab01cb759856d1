// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <variant>

#include "devices/scip/scip_encoding.h"
#include "devices/scip/scip_laser.h"

namespace planewright {

namespace {

/// What a laser is given to check itself, before its silence counts.
constexpr std::chrono::seconds kVerifying{5};
constexpr int kMostRepeats = 2;
/// Of a hundred beams, fewer returns than this many tell of a covered window.
constexpr std::size_t kFewPercent = 5;
constexpr std::string_view kBlind = "almost no beam comes back";
/// Of the codes that came instead of ranges, the most frequent ones are named.
constexpr int kCodesTold = 4;

}  // namespace

Result<std::optional<LaserScan>> ScipLaser::next(Time deadline, const std::stop_token& stop)
{
    while (!stream_.empty()) {
        const Time wakesAt = revival_.isUnderWay() ? revival_.wakesAt() : silenceUntil();
        const auto arrival = link_.next(std::min(deadline, wakesAt), stop);
        if (!arrival)
            return tl::unexpected{arrival.error()};
        if (*arrival) {
            Result<std::optional<LaserScan>> scan = take(**arrival);
            if (!scan || *scan)
                return scan;
        }
        // What has come in time counts, however late it is fetched.
        if (!*arrival || (*arrival)->at >= wakesAt || damaged_ >= kMostDamagedScans) {
            if (Result<void> alive = keepAlive(); !alive)
                return tl::unexpected{alive.error()};
        }
        if (stop.stop_requested() || link_.now() >= deadline)
            return std::nullopt;
    }
    return std::nullopt;
}

Result<std::optional<LaserScan>> ScipLaser::take(const ScipArrival& arrival)
{
    if (const auto* const reply = std::get_if<ScipReply>(&arrival.event)) {
        const Result<void> taken = revival_.isUnderWay() ? takeRevived(*reply) : take(*reply);
        return taken ? Result<std::optional<LaserScan>>{std::nullopt} : tl::unexpected{taken.error()};
    }
    if (revival_.isUnderWay())
        return std::nullopt;  // of the stream that has failed
    if (const auto* const frame = std::get_if<ScipFrame>(&arrival.event))
        return take(*frame, arrival.at);
    const ScipDamage& damage = std::get<ScipDamage>(arrival.event);
    countDamage(codeOf(damage.kind), describe(damage.kind), damage.bytes);
    return std::nullopt;
}

void ScipLaser::countDamage(std::string_view code, std::string text, std::string_view bytes)
{
    ++damaged_;
    health_.countCorrupt();
    health_.log(link_.now(), code, std::move(text), bytes);
}

/// A scan as it is handed out; empty where it is not what was asked for.
std::optional<LaserScan> ScipLaser::take(const ScipFrame& frame, Time arrived)
{
    if (frame.echo != stream_) {
        countDamage("laser-echo", "a scan that answers another request", frame.echo);
        return std::nullopt;
    }
    const LaserLimits& limits = partner_.limits;
    // Twice the step: the middle of a cluster may lie between two.
    const auto afterStep0 = [&](int step) { return limits.period * step / (2 * limits.stepsPerTurn); };
    const ScipClock::Scan timed = clock_.addScan(frame.stamp, arrived, afterStep0(2 * beams_.last), limits.period);
    if (timed.repeats > 0) {
        countDamage("laser-stuck-time", "a scan with the time of the one before", toScip(frame.stamp, 4));
        if (timed.repeats >= kMostRepeats)
            damaged_ = kMostDamagedScans;
        return std::nullopt;
    }

    LaserScan scan;
    const int middleOfFirst = 2 * beams_.first + beams_.cluster - 1;
    scan.first = timed.start + afterStep0(middleOfFirst);
    scan.last = timed.start + afterStep0(middleOfFirst + 2 * beams_.cluster * (beams_.count() - 1));
    scan.arrived = arrived;
    scan.timeSuspect = !timed.isKnown || timed.isBehind || (lastEnd_ && scan.first < *lastEnd_);
    const std::size_t returns = takeRanges(frame, scan);

    countLost(timed);
    health_.countGood(arrived, timed.isLate);
    const bool wasBlind = std::exchange(isBlind_, 100 * returns < kFewPercent * frame.ranges.size());
    if (isBlind_)
        scan.codes = frame.ranges;
    if (isBlind_ && !wasBlind)
        tellOfBlindness(frame, arrived);
    health_.setTrouble(isBlind_ ? std::string{kBlind} + ": is the window covered?" : partner_.warning);
    lastEnd_ = scan.last;
    lastScan_ = arrived;
    damaged_ = 0;
    attempts_ = 0;
    return scan;
}

/// Gives how many of the beams have a range.
std::size_t ScipLaser::takeRanges(const ScipFrame& frame, LaserScan& scan) const
{
    std::size_t returns = 0;
    scan.ranges.reserve(frame.ranges.size());
    for (const std::uint32_t raw : frame.ranges) {
        const std::optional<std::uint32_t> range = ranges_->rangeOf(raw);
        scan.ranges.push_back(range.value_or(0));
        returns += range ? 1 : 0;
    }
    return returns;
}

/// Which codes came instead of ranges: they tell a covered window from open sky, and from a table of another model.
void ScipLaser::tellOfBlindness(const ScipFrame& frame, Time arrived)
{
    std::map<std::uint32_t, int> counts;
    for (const std::uint32_t raw : frame.ranges)
        ++counts[raw];
    std::string text{kBlind};
    std::string separator = ": ";
    for (int told = 0; told < kCodesTold && !counts.empty(); ++told) {
        const auto most = std::max_element(counts.begin(), counts.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        text += std::exchange(separator, ", ") + std::to_string(most->second) + " times " + std::to_string(most->first);
        counts.erase(most);
    }
    std::string sent;
    for (const std::uint32_t raw : frame.ranges)
        sent += toScip(raw, 3);
    health_.log(arrived, "laser-blind", std::move(text), sent);
}

/// Turns since the scan before, but for those that came damaged.
void ScipLaser::countLost(const ScipClock::Scan& timed)
{
    if (lastMilliseconds_ && !timed.isNewEpoch) {
        const auto turns = std::llround(static_cast<double>(timed.milliseconds - *lastMilliseconds_) /
                                        std::chrono::duration<double, std::milli>(partner_.limits.period).count());
        health_.countLost(static_cast<std::uint64_t>(std::max<std::int64_t>(0, turns - 1 - damaged_)));
    }
    lastMilliseconds_ = timed.milliseconds;
}

/// A status in the middle of a stream.
Result<void> ScipLaser::take(const ScipReply& reply)
{
    if (reply.echo != stream_)
        return {};
    const ScipMeaning meaning = scipMeaning(measurement_.command, reply.status, partner_.version);
    const std::string status = describeScipStatus(measurement_.command, reply.status, partner_.version);
    switch (meaning.verdict) {
        case ScipVerdict::Verifying:
            health_.setTrouble(status);
            health_.log(link_.now(), "laser-verifying", status);
            lastScan_ = link_.now() + kVerifying;
            return {};
        case ScipVerdict::Malfunction:
            return cureInStream(status);
        default:
            return {};
    }
}

}  // namespace planewright
