// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_laser.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/simulation/random.h"
#include "devices/emulated/emulated_laser_faults.h"
#include "devices/emulated/emulated_laser_scan.h"
#include "devices/scip/scip_stamps.h"

namespace planewright {

namespace {

constexpr double kBytesPerSecond = 1.5e6;
constexpr std::chrono::seconds kBoot{3};
constexpr std::chrono::milliseconds kDelay{200};
/// What a link keeps for a reader.
constexpr std::chrono::seconds kKept{10};
/// A request longer than this is cut: none has a use for more.
constexpr std::size_t kLongestRequest = 128;
/// From which on the clock runs to its end with laser-wrap, before the turns of the step.
constexpr std::chrono::seconds kBeforeWrap{3};
constexpr std::string_view kHardwareFault = "70";
constexpr std::string_view kVerifies = "21";
constexpr std::string_view kGoesOn = "98";
/// Scans that are left out while it checks itself.
constexpr int kVerifiedScans = 40;

EmulatedLaser::Time onTheWay(std::size_t bytes)
{
    return std::chrono::round<EmulatedLaser::Time>(
        std::chrono::duration<double>(static_cast<double>(bytes) / kBytesPerSecond));
}

}  // namespace

Result<std::shared_ptr<EmulatedLaser>> EmulatedLaser::make(std::shared_ptr<const EmulatedView> view,
                                                           std::function<double(Time)> pitch,
                                                           const EmulatedLaserOptions& options)
{
    for (const FaultAt& fault : options.faults) {
        if (const Result<void> known = checkLaserFault(fault); !known)
            return tl::unexpected{known.error()};
    }
    return std::shared_ptr<EmulatedLaser>(new EmulatedLaser{std::move(view), std::move(pitch), options});
}

EmulatedLaser::EmulatedLaser(std::shared_ptr<const EmulatedView> view, std::function<double(Time)> pitch,
                             const EmulatedLaserOptions& options)
    : view_(std::move(view)), pitch_(std::move(pitch)), options_(options), limits_(options.model.limits())
{
    for (const FaultAt& fault : options.faults)
        faults_.push_back({fault.kind, fault.step, false});
}

void EmulatedLaser::receive(std::span<const std::uint8_t> bytes, Time now)
{
    advance(now);
    if (now < silentUntil_) {
        line_.clear();
        return;
    }
    for (const std::uint8_t byte : bytes) {
        const char c = static_cast<char>(byte);
        if (c != '\n' && c != '\r') {
            if (line_.size() < kLongestRequest)
                line_ += c;
        } else if (!line_.empty()) {
            answer(std::exchange(line_, {}), now);
        }
    }
}

std::vector<EmulatedOutput> EmulatedLaser::takeOutput(Time now)
{
    advance(now);
    std::vector<EmulatedOutput> outputs;
    while (!pending_.empty() && pending_.front().at <= now) {
        if (!unpluggedAt_ || pending_.front().at <= *unpluggedAt_)
            outputs.push_back(std::move(pending_.front()));
        pending_.pop_front();
    }
    return outputs;
}

std::optional<EmulatedLaser::Time> EmulatedLaser::nextOutput() const
{
    std::optional<Time> next;
    const auto mayBe = [&](Time moment) { next = next ? std::min(*next, moment) : moment; };
    if (!pending_.empty())
        mayBe(pending_.front().at);
    if (stream_)
        mayBe(momentOf(stream_->next, stream_->measurement.last));
    if (unpluggedAt_)
        mayBe(*unpluggedAt_);
    return next;
}

bool EmulatedLaser::isConnected(Time now)
{
    advance(now);
    return !unpluggedAt_ || now < *unpluggedAt_;
}

/// Reports every turn whose last beam is measured by now.
void EmulatedLaser::advance(Time now)
{
    if (!poweredAt_)
        powerOn(now);
    if (unpluggedAt_ && *unpluggedAt_ <= now)
        return;
    // Whoever has not read for so long has missed what was sent: no link keeps it.
    if (stream_ && startOf(stream_->next) < now - kKept)
        stream_->next = turnFrom(now - kKept);
    while (stream_ && momentOf(stream_->next, stream_->measurement.last) <= now)
        report(stream_->next);
}

void EmulatedLaser::powerOn(Time now)
{
    poweredAt_ = now;
    lineFreeAt_ = now;
    isOn_ = options_.model.isOnAtPowerOn;
    Time shown = options_.uptime;
    for (const Fault& fault : faults_) {
        if (fault.kind == "laser-wrap")
            shown = std::chrono::milliseconds{kScipClockRange} - kBeforeWrap - fault.step * limits_.period;
    }
    clockZero_ = now - shown;
    if (strikes("laser-unplug", 0))
        unpluggedAt_ = now;
    if (strikes("laser-boot", 0))
        silentUntil_ = now + kBoot;
    isBroken_ = strikes("laser-malfunction", 0);
    changeIdentity(0);
    isInTimeMode_ = hasAtConnect("laser-time-mode");
    speaksScip1_ = hasAtConnect("laser-scip1");
    if (hasAtConnect("laser-prestream"))
        beginStream({"MD", limits_.firstStep, limits_.lastStep, 0, 0, 0}, {}, now);
}

/// What it says of itself when it is asked; a stream that runs goes on.
void EmulatedLaser::changeIdentity(int number)
{
    if (strikes("laser-limits", number)) {
        const int tenDegrees = limits_.stepsPerTurn / 36;
        limits_.firstStep += tenDegrees;
        limits_.lastStep -= tenDegrees;
    }
    isOtherModel_ = isOtherModel_ || strikes("laser-model", number);
}

void EmulatedLaser::reboot(Time now)
{
    stream_.reset();
    std::erase_if(pending_, [&](const EmulatedOutput& output) { return output.at > now; });
    stuckStamp_.reset();
    isOn_ = options_.model.isOnAtPowerOn;
    isInTimeMode_ = false;
    clockZero_ = now;
    silentUntil_ = now + kBoot;
    lineFreeAt_ = now;
}

/// Puts bytes on the line, behind those that are on it.
void EmulatedLaser::send(std::string bytes, Time ready)
{
    lineFreeAt_ = std::max(lineFreeAt_, ready) + onTheWay(bytes.size());
    pending_.push_back({lineFreeAt_, {bytes.begin(), bytes.end()}});
}

/// True once for every fault of a kind whose step has come, and for no two of them at once.
bool EmulatedLaser::strikes(std::string_view kind, int number)
{
    for (Fault& fault : faults_) {
        if (fault.kind == kind && !fault.isOver && fault.step <= number)
            return fault.isOver = true;
    }
    return false;
}

bool EmulatedLaser::hasAtConnect(std::string_view kind) const
{
    return std::any_of(faults_.begin(), faults_.end(), [&](const Fault& fault) { return fault.kind == kind; });
}

/// A turn of a stream is measured: sends it, or does what a fault does in its place.
void EmulatedLaser::report(std::int64_t turn)
{
    const int number = numberOf(turn);
    const Time measured = momentOf(turn, stream_->measurement.last);
    const std::string echo = scipRequest(stream_->measurement) + stream_->tag;
    stream_->next += 1 + stream_->measurement.interval;

    if (strikes("laser-boot", number))
        return reboot(measured);
    if (strikes("laser-silent", number))
        return stream_.reset();
    isBroken_ = isBroken_ || strikes("laser-malfunction", number);
    if (isFaulty() || simulatedFault_ == 3 || simulatedFault_ == 5) {
        simulatedFault_ = isBroken_ ? simulatedFault_ : 2;
        send(laserReply(echo, kHardwareFault), measured);
        return stream_.reset();
    }
    if (simulatedFault_ == 4) {
        simulatedFault_ = 0;
        verifyingLeft_ = kVerifiedScans;
        return send(laserReply(echo, kVerifies), measured);
    }
    if (verifyingLeft_ > 0) {
        if (--verifyingLeft_ == 0)
            send(laserReply(echo, kGoesOn), measured);
        return;
    }
    sendScan(turn, number);
}

void EmulatedLaser::sendScan(std::int64_t turn, int number)
{
    if (strikes("laser-reset", number))
        clockZero_ = startOf(turn);
    isBlind_ = isBlind_ || strikes("laser-blind", number);
    changeIdentity(number);
    if (strikes("laser-stuck-time", number))
        stuckStamp_ = stampAt(startOf(turn));

    ScipMeasurement& measurement = stream_->measurement;
    const bool isCounted = stream_->left > 0;
    if (isCounted)
        measurement.count = --stream_->left;
    const std::string echo = scipRequest(measurement) + stream_->tag;
    std::vector<std::uint32_t> codes = beams(measurement, turn);
    if (strikes("laser-count", number))
        codes.resize(codes.size() -
                     std::min<std::size_t>(codes.size(), static_cast<std::size_t>(std::max(1, measurement.cluster))));
    std::string bytes =
        laserScan(echo, "99", measurement, stuckStamp_.value_or(stampAt(startOf(turn))), codes, options_.model);
    Time ready = momentOf(turn, measurement.last);
    Random random(options_.seed, static_cast<std::uint64_t>(number));
    for (const LaserFaultKind& kind : laserFaultKinds()) {
        if (kind.strikes == LaserFaultKind::Strikes::Bytes && strikes(kind.name, number))
            bytes = damageScan(kind.name, std::move(bytes), condition(kScipState, ready), random);
    }
    if (strikes("laser-delay", number))
        ready += kDelay;
    if (strikes("laser-unplug", number)) {
        bytes.resize(bytes.size() / 2);
        unpluggedAt_ = std::max(lineFreeAt_, ready) + onTheWay(bytes.size());
    }
    send(std::move(bytes), ready);
    if (isCounted && stream_->left == 0) {
        stream_.reset();
        isOn_ = false;
    }
}

/// What is sent for each beam of a turn.
std::vector<std::uint32_t> EmulatedLaser::beams(const ScipMeasurement& measurement, std::int64_t turn) const
{
    EmulatedView::Sweep sweep;
    sweep.firstPitch = pitch_(momentOf(turn, measurement.first));
    sweep.lastPitch = pitch_(momentOf(turn, measurement.last));
    sweep.firstBearing = limits_.bearing(measurement.first);
    sweep.bearingStep = limits_.bearingStep();
    sweep.beams = measurement.last - measurement.first + 1;
    sweep.rangeMin = limits_.rangeMin;
    sweep.rangeMax = options_.model.reach;
    std::vector<std::uint32_t> codes;
    if (isBlind_)
        codes.assign(static_cast<std::size_t>(sweep.beams), options_.model.blind);
    else
        codes = view_->ranges(sweep, numberOf(turn));
    for (std::uint32_t& code : codes)
        code = isBlind_ ? code : laserCode(code, options_.model);
    return codes;
}

EmulatedLaser::Time EmulatedLaser::momentOf(std::int64_t turn, int step) const
{
    return startOf(turn) + limits_.period * step / limits_.stepsPerTurn;
}

/// The first turn that begins at a moment or after it.
std::int64_t EmulatedLaser::turnFrom(Time moment) const
{
    const std::int64_t period = limits_.period.count();
    const std::int64_t since = (moment - options_.phase).count();
    return since / period + (since % period > 0 ? 1 : 0);
}

int EmulatedLaser::numberOf(std::int64_t turn) const
{
    return firstTurn_ ? static_cast<int>(std::max<std::int64_t>(0, turn - *firstTurn_)) : 0;
}

std::uint32_t EmulatedLaser::stampAt(Time moment) const
{
    const double since = std::chrono::duration<double, std::milli>(moment - clockZero_).count();
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(since * (1.0 + options_.clockDrift))) &
                                      (kScipClockRange - 1));
}

}  // namespace planewright
