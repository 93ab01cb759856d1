// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_laser.h"

#include <utility>
#include <variant>

#include "devices/scip/scip_time.h"

namespace planewright {

namespace {

using std::chrono::milliseconds;

constexpr int kScansAfterQuit = 3;
/// Of one that talks though it was told to be quiet, at a time.
constexpr int kMostPassedOver = 100;

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
    revival_.end();
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

Result<void> ScipLaser::start(const LaserBeams& beams, const std::stop_token& stop)
{
    const LaserLimits& limits = partner_.limits;
    if (beams.first < limits.firstStep || beams.last > limits.lastStep || beams.first >= beams.last)
        return fail(ErrorCode::Usage, link_.name() + ": steps " + std::to_string(beams.first) + " to " +
                                          std::to_string(beams.last) + " are not among the laser's, " +
                                          std::to_string(limits.firstStep) + " to " + std::to_string(limits.lastStep));
    if (beams.cluster < 1 || beams.cluster > LaserBeams::kMostJoinedSteps)
        return fail(ErrorCode::Usage, link_.name() + ": " + std::to_string(beams.cluster) +
                                          " steps cannot be joined to one range; a laser joins 1 to " +
                                          std::to_string(LaserBeams::kMostJoinedSteps));
    if (!stream_.empty()) {
        if (Result<void> stopped = this->stop(); !stopped)
            return stopped;
    }
    beams_ = beams;
    measurement_ = {"MD", beams.first, beams.last, beams.cluster == 1 ? 0 : beams.cluster, 0, 0};
    cures_ = 0;
    isBlind_ = false;
    Result<void> begun = beginScanning(stop);
    if (!begun)
        quitUnheard();
    return begun;
}

Result<void> ScipLaser::beginScanning(const std::stop_token& stop)
{
    lastMilliseconds_.reset();
    lastEnd_.reset();
    clock_.restart();
    if (partner_.able.timeMode) {
        if (Result<void> compared = compareScipClocks(link_, partner_.version, clock_, progress_, stop); !compared)
            return compared;
    }
    if (Result<void> on = switchOn(stop); !on)
        return on;
    attempts_ = 0;
    return beginStream(stop);
}

/// BM. A laser that says that it is faulty is asked again after each cure.
Result<void> ScipLaser::switchOn(const std::stop_token& stop)
{
    for (;;) {
        const Result<ScipReply> on = askScipPatiently(link_, kScipLaserOn, partner_.version, progress_, stop);
        if (!on)
            return tl::unexpected{on.error()};
        const std::string status = describeScipStatus(kScipLaserOn, on->status, partner_.version);
        switch (scipMeaning(kScipLaserOn, on->status, partner_.version).verdict) {
            case ScipVerdict::Good:
            case ScipVerdict::AlreadySo:
                return {};
            case ScipVerdict::Malfunction:
                if (Result<void> cured = cure(status, stop); !cured)
                    return cured;
                break;
            default:
                return fail(ErrorCode::NoDevice, link_.name() + ": the laser does not switch on (" + status +
                                                     "); switch its power off and on, then connect again");
        }
    }
}

Result<void> ScipLaser::beginStream(const std::stop_token& stop)
{
    const std::string request = scipRequest(measurement_);
    for (;;) {
        const Result<ScipReply> accepted = askScipPatiently(link_, request, partner_.version, progress_, stop);
        if (!accepted)
            return tl::unexpected{accepted.error()};
        const ScipMeaning meaning = scipMeaning(measurement_.command, accepted->status, partner_.version);
        const std::string status = describeScipStatus(measurement_.command, accepted->status, partner_.version);
        if (meaning.verdict == ScipVerdict::Good)
            break;
        if (meaning.verdict != ScipVerdict::Malfunction)
            return fail(ErrorCode::NoDevice, link_.name() + ": the laser does not scan (" + status +
                                                 "); switch its power off and on, then connect again");
        if (Result<void> cured = cure(status, stop); !cured)
            return cured;
        if (Result<void> on = switchOn(stop); !on)
            return on;
    }
    stream_ = request;
    streamsFrom(link_.now());
    return {};
}

void ScipLaser::streamsFrom(Time now)
{
    damaged_ = 0;
    lastScan_ = now;
    clock_.expectPromptScan();
}

/// A fault of the hardware while nothing streams: cured by a reset, by a start anew, or by a person.
Result<void> ScipLaser::cure(const std::string& status, const std::stop_token& stop)
{
    const std::optional<ScipRevival::Cure> next = nextCure(status);
    if (!next)
        return faulty(status);
    return *next == ScipRevival::Cure::Reboot ? restartScip(link_, progress_, stop) : resetScip(link_, stop);
}

/// Each once since the start; empty where all have been tried.
std::optional<ScipRevival::Cure> ScipLaser::nextCure(const std::string& status)
{
    health_.setTrouble(status);
    health_.log(link_.now(), "laser-malfunction", status);
    const int tried = cures_++;
    if (tried == 0)
        return ScipRevival::Cure::Reset;
    return tried == 1 && partner_.able.reboot ? std::optional{ScipRevival::Cure::Reboot} : std::nullopt;
}

tl::unexpected<Error> ScipLaser::faulty(const std::string& status)
{
    return fail(ErrorCode::NeedsOperator, link_.name() + ": the laser is faulty (" + status +
                                              "); switch its power off and on, then connect again");
}

/// Tells a laser to be quiet that may stream though nobody listens any more.
void ScipLaser::quitUnheard()
{
    stream_.clear();
    revival_.end();
    (void)link_.send(kScipQuit);
}

Result<void> ScipLaser::lookAfter()
{
    for (int i = 0; i < kMostPassedOver && stream_.empty(); ++i) {
        const auto arrival = link_.next(link_.now(), {});
        if (!arrival)
            return tl::unexpected{arrival.error()};
        if (!*arrival)
            break;
    }
    return {};
}

LinkHealth ScipLaser::health() const
{
    LinkHealth health = health_.read(link_.now());
    const TransportHealth transport = link_.transportHealth();
    health.overruns = transport.overruns;
    if (health.trouble.empty())
        health.trouble = transport.trouble;
    return health;
}

Result<void> ScipLaser::stop()
{
    revival_.end();
    if (std::exchange(stream_, {}).empty())
        return {};
    for (int time = 0; time < 2; ++time) {
        if (Result<void> sent = link_.send(kScipQuit); !sent)
            return sent;
        const Time deadline = link_.now() + kScipReply;
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
