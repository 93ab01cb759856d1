// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "devices/scip/scip_laser.h"

namespace planewright {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kReply{500};
constexpr milliseconds kBackOff{500};
/// What a laser is given to check itself, before its silence counts.
constexpr std::chrono::seconds kVerifying{5};
constexpr int kMostDamaged = 5;
constexpr int kMostRepeats = 2;
constexpr int kMostAttempts = 3;
/// Of a hundred beams, fewer returns than this many tell of a covered window.
constexpr std::size_t kFewPercent = 5;

}  // namespace

Result<std::optional<LaserScan>> ScipLaser::next(Time deadline, const std::stop_token& stop)
{
    while (!stream_.empty()) {
        auto arrival = link_.next(std::min(deadline, silenceUntil()), stop);
        if (!arrival)
            return tl::unexpected{arrival.error()};
        Result<void> kept;
        if (!*arrival) {
            if (stop.stop_requested())
                return std::nullopt;
        } else if (const auto* const frame = std::get_if<ScipFrame>(&(*arrival)->event)) {
            if (std::optional<LaserScan> scan = take(*frame, (*arrival)->at))
                return scan;
        } else if (const auto* const reply = std::get_if<ScipReply>(&(*arrival)->event)) {
            kept = take(*reply, stop);
        } else {
            countDamage();
        }
        if (kept && damaged_ >= kMostDamaged)
            kept = recover("its scans come damaged, or with times that stand still", stop);
        else if (kept && link_.now() >= silenceUntil())
            kept = recover("it sends no scans any more", stop);
        if (!kept)
            return tl::unexpected{kept.error()};
        if (link_.now() >= deadline)
            return std::nullopt;
    }
    return std::nullopt;
}

void ScipLaser::countDamage()
{
    ++damaged_;
    health_.countCorrupt();
}

/// A scan as it is handed out; empty where it is not what was asked for.
std::optional<LaserScan> ScipLaser::take(const ScipFrame& frame, Time arrived)
{
    if (frame.echo != stream_) {
        countDamage();
        return std::nullopt;
    }
    const LaserLimits& limits = partner_.limits;
    const auto afterStep0 = [&](int step) { return limits.period * step / limits.stepsPerTurn; };
    const ScipClock::Scan timed = clock_.addScan(frame.stamp, arrived, afterStep0(measurement_.last), limits.period);
    if (timed.repeats > 0) {
        countDamage();
        if (timed.repeats >= kMostRepeats)
            damaged_ = kMostDamaged;
        return std::nullopt;
    }

    LaserScan scan;
    scan.first = timed.start + afterStep0(measurement_.first);
    scan.last = timed.start + afterStep0(measurement_.last);
    scan.arrived = arrived;
    scan.timeSuspect = !timed.isKnown || timed.isBehind || (lastEnd_ && scan.first < *lastEnd_);
    const std::size_t returns = takeRanges(frame, scan);

    countLost(timed);
    health_.countGood(arrived, timed.isLate);
    const bool isBlind = 100 * returns < kFewPercent * frame.ranges.size();
    health_.setTrouble(isBlind ? "almost no beam comes back: is the window covered?" : partner_.warning);
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
Result<void> ScipLaser::take(const ScipReply& reply, const std::stop_token& stop)
{
    if (reply.echo != stream_)
        return {};
    const ScipMeaning meaning = scipMeaning(measurement_.command, reply.status, partner_.version);
    const std::string status = describeScipStatus(measurement_.command, reply.status, partner_.version);
    switch (meaning.verdict) {
        case ScipVerdict::Verifying:
            health_.setTrouble(status);
            lastScan_ = link_.now() + kVerifying;
            return {};
        case ScipVerdict::Malfunction:
            if (Result<void> reset = resetOnce(status, stop); !reset)
                return reset;
            return recover(status, stop);
        default:
            return {};
    }
}

/// Starts the stream again, up to three times since the last good scan.
Result<void> ScipLaser::recover(const std::string& reason, const std::stop_token& stop)
{
    while (attempts_ < kMostAttempts && !stop.stop_requested()) {
        if (attempts_++ > 0) {
            if (const auto waited = link_.discard(kBackOff, kBackOff, stop); !waited)
                return tl::unexpected{waited.error()};
        }
        const Result<bool> again = tryAgain(stop);
        if (!again)
            return tl::unexpected{again.error()};
        if (*again)
            return {};
    }
    if (stop.stop_requested())
        return {};
    stream_.clear();
    return fail(ErrorCode::DeviceLost, link_.name() + ": the laser is lost (" + reason +
                                           "), and starting it again did not help; check its power and cable, then "
                                           "connect again");
}

/// QT and the request again.
Result<bool> ScipLaser::tryAgain(const std::stop_token& stop)
{
    for (int time = 0; time < 2; ++time) {
        const auto quit = link_.ask(kScipQuit, kReply, stop);
        if (!quit)
            return tl::unexpected{quit.error()};
        if (*quit)
            break;
    }
    const auto begun = link_.ask(stream_, kReply, stop);
    if (!begun)
        return tl::unexpected{begun.error()};
    if (!*begun || (*begun)->status != "00")
        return false;
    damaged_ = 0;
    lastScan_ = link_.now();
    clock_.expectPromptScan();
    return true;
}

}  // namespace planewright
