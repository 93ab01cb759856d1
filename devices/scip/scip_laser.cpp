// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_laser.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "devices/scip/scip_time.h"

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
constexpr int kScansAfterQuit = 3;
/// Of a hundred beams, fewer returns than this many tell of a covered window.
constexpr std::size_t kFewPercent = 5;

}  // namespace

ScipLaser::ScipLaser(std::unique_ptr<Transport> transport, const Clock& clock, ScipProgress progress)
    : link_(std::move(transport), clock), progress_(std::move(progress))
{
}

ScipLaser::~ScipLaser()
{
    if (!stream_.empty())
        (void)ScipLaser::stop();
    link_.close();
}

Result<void> ScipLaser::connect(const std::stop_token& stop)
{
    stream_.clear();
    health_.restart();
    health_.setTrouble({});
    Result<ScipPartner> partner = connectScip(link_, progress_, stop);
    if (!partner)
        return tl::unexpected{partner.error()};
    partner_ = std::move(*partner);
    ranges_.emplace(partner_.identity.model, partner_.limits);
    health_.setTrouble(partner_.warning);
    return {};
}

Result<void> ScipLaser::start(int first, int last, const std::stop_token& stop)
{
    const LaserLimits& limits = partner_.limits;
    if (first < limits.firstStep || last > limits.lastStep || first >= last)
        return fail(ErrorCode::Usage, link_.name() + ": steps " + std::to_string(first) + " to " +
                                          std::to_string(last) + " are not among the laser's, " +
                                          std::to_string(limits.firstStep) + " to " + std::to_string(limits.lastStep));
    if (!stream_.empty()) {
        if (const Result<void> stopped = this->stop(); !stopped)
            return stopped;
    }
    measurement_ = {"MD", first, last, 0, 0, 0};
    hasReset_ = false;
    clock_.restart();
    lastMilliseconds_.reset();
    lastEnd_.reset();
    if (partner_.able.timeMode) {
        if (const Result<void> compared = compareScipClocks(link_, partner_.version, clock_, progress_, stop);
            !compared)
            return compared;
    }
    if (const Result<void> on = switchOn(stop); !on)
        return on;
    attempts_ = 0;
    return beginStream(stop);
}

/// BM. A laser that says that it is faulty is asked again after a reset, once.
Result<void> ScipLaser::switchOn(const std::stop_token& stop)
{
    const Result<ScipReply> on = askScipPatiently(link_, kScipLaserOn, partner_.version, progress_, stop);
    if (!on)
        return tl::unexpected{on.error()};
    switch (scipMeaning(kScipLaserOn, on->status, partner_.version).verdict) {
        case ScipVerdict::Good:
        case ScipVerdict::AlreadySo:
            return {};
        case ScipVerdict::Malfunction:
            if (const Result<void> reset =
                    resetOnce(describeScipStatus(kScipLaserOn, on->status, partner_.version), stop);
                !reset)
                return reset;
            return switchOn(stop);
        default:
            return fail(ErrorCode::NoDevice, link_.name() + ": the laser does not switch on (" +
                                                 describeScipStatus(kScipLaserOn, on->status, partner_.version) +
                                                 "); switch its power off and on, then connect again");
    }
}

Result<void> ScipLaser::beginStream(const std::stop_token& stop)
{
    const std::string request = scipRequest(measurement_);
    const Result<ScipReply> accepted = askScipPatiently(link_, request, partner_.version, progress_, stop);
    if (!accepted)
        return tl::unexpected{accepted.error()};
    const ScipMeaning meaning = scipMeaning(measurement_.command, accepted->status, partner_.version);
    const std::string status = describeScipStatus(measurement_.command, accepted->status, partner_.version);
    if (meaning.verdict == ScipVerdict::Malfunction) {
        if (const Result<void> reset = resetOnce(status, stop); !reset)
            return reset;
        if (const Result<void> on = switchOn(stop); !on)
            return on;
        return beginStream(stop);
    }
    if (meaning.verdict != ScipVerdict::Good)
        return fail(ErrorCode::NoDevice, link_.name() + ": the laser does not scan (" + status +
                                             "); switch its power off and on, then connect again");
    stream_ = request;
    damaged_ = 0;
    lastScan_ = link_.now();
    clock_.expectPromptScan();
    return {};
}

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
        } else if (auto* const frame = std::get_if<ScipFrame>(&(*arrival)->event)) {
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
std::optional<LaserScan> ScipLaser::take(ScipFrame& frame, Time arrived)
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
    scan.ranges.reserve(frame.ranges.size());
    std::size_t valid = 0;
    for (const std::uint32_t raw : frame.ranges) {
        const std::optional<std::uint32_t> range = ranges_->rangeOf(raw);
        scan.ranges.push_back(range.value_or(0));
        valid += range ? 1 : 0;
    }

    if (lastMilliseconds_ && !timed.isNewEpoch) {
        const auto periods = std::llround(static_cast<double>(timed.milliseconds - *lastMilliseconds_) /
                                          std::chrono::duration<double, std::milli>(limits.period).count());
        health_.countLost(static_cast<std::uint64_t>(std::max<std::int64_t>(0, periods - 1 - damaged_)));
    }
    health_.countGood(arrived, timed.isLate);
    watchReturns(valid, frame.ranges.size());
    lastMilliseconds_ = timed.milliseconds;
    lastEnd_ = scan.last;
    lastScan_ = arrived;
    damaged_ = 0;
    attempts_ = 0;
    return scan;
}

void ScipLaser::watchReturns(std::size_t valid, std::size_t all)
{
    const bool isBlind = 100 * valid < kFewPercent * all;
    health_.setTrouble(isBlind ? "almost no beam comes back: is the window covered?" : partner_.warning);
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
            return {};
        case ScipVerdict::Malfunction:
            if (const Result<void> reset = resetOnce(status, stop); !reset)
                return reset;
            return recover(status, stop);
        default:
            return {};
    }
}

/// A fault of the hardware: cured by a reset, or by a person.
Result<void> ScipLaser::resetOnce(const std::string& status, const std::stop_token& stop)
{
    health_.setTrouble(status);
    if (std::exchange(hasReset_, true)) {
        const bool wasScanning = !std::exchange(stream_, {}).empty();
        return fail(
            wasScanning ? ErrorCode::DeviceLost : ErrorCode::NoDevice,
            link_.name() + ": the laser is faulty (" + status + "); switch its power off and on, then connect again");
    }
    return resetScip(link_, stop);
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

Result<void> ScipLaser::stop()
{
    if (std::exchange(stream_, {}).empty())
        return {};
    for (int time = 0; time < 2; ++time) {
        if (const Result<void> sent = link_.send(kScipQuit); !sent)
            return sent;
        const Time deadline = link_.now() + kReply;
        for (int scans = 0; scans < kScansAfterQuit && link_.now() < deadline;) {
            const auto arrival = link_.next(deadline, {});
            if (!arrival)
                return tl::unexpected{arrival.error()};
            if (!*arrival)
                break;
            const auto* const reply = std::get_if<ScipReply>(&(*arrival)->event);
            if (reply != nullptr && reply->echo == kScipQuit)
                return {};
            scans += std::holds_alternative<ScipFrame>((*arrival)->event) ? 1 : 0;
        }
    }
    return fail(ErrorCode::DeviceLost, link_.name() +
                                           ": the laser does not say that it has stopped; switch its power "
                                           "off and on before it is used again");
}

}  // namespace planewright
