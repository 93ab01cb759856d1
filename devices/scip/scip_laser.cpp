// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_laser.h"

#include <utility>
#include <variant>

#include "devices/scip/scip_time.h"

namespace planewright {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kReply{500};
constexpr int kScansAfterQuit = 3;

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
        if (Result<void> stopped = this->stop(); !stopped)
            return stopped;
    }
    measurement_ = {"MD", first, last, 0, 0, 0};
    hasReset_ = false;
    clock_.restart();
    lastMilliseconds_.reset();
    lastEnd_.reset();
    if (partner_.able.timeMode) {
        if (Result<void> compared = compareScipClocks(link_, partner_.version, clock_, progress_, stop); !compared)
            return compared;
    }
    if (Result<void> on = switchOn(stop); !on)
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
            if (Result<void> reset = resetOnce(describeScipStatus(kScipLaserOn, on->status, partner_.version), stop);
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
        if (Result<void> reset = resetOnce(status, stop); !reset)
            return reset;
        if (Result<void> on = switchOn(stop); !on)
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

Result<void> ScipLaser::stop()
{
    if (std::exchange(stream_, {}).empty())
        return {};
    for (int time = 0; time < 2; ++time) {
        if (Result<void> sent = link_.send(kScipQuit); !sent)
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
