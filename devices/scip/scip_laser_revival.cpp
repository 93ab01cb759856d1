// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <utility>

#include "devices/scip/scip_laser.h"

namespace planewright {

namespace {

constexpr std::chrono::milliseconds kBackOff{500};
constexpr int kMostAttempts = 3;

}  // namespace

/// Looks whether scans still come; where not, does the next step to get them again.
Result<void> ScipLaser::keepAlive()
{
    if (revival_.isUnderWay())
        return goOn();
    if (damaged_ >= kMostDamagedScans)
        return revive(ScipRevival::Cure::None, "its scans come damaged, or with times that stand still");
    if (link_.now() >= silenceUntil()) {
        health_.log(link_.now(), "laser-silent", "no scan for 16 turns");
        return revive(ScipRevival::Cure::None, "it sends no scans any more");
    }
    return {};
}

Result<void> ScipLaser::goOn()
{
    if (const auto request = revival_.due(link_.now()))
        return link_.send(*request);
    return revival_.hasFailed() ? revive(ScipRevival::Cure::None, reason_) : Result<void>{};
}

/// Begins the next of up to three attempts since the last good scan.
Result<void> ScipLaser::revive(ScipRevival::Cure cure, const std::string& reason)
{
    reason_ = reason;
    if (attempts_ >= kMostAttempts) {
        quitUnheard();
        const std::string what = "the laser is lost (" + reason + "), and starting it again did not help";
        health_.setTrouble(what);
        health_.log(link_.now(), "laser-lost", what);
        return fail(ErrorCode::DeviceLost,
                    link_.name() + ": " + what + "; check its power and cable, then connect again");
    }
    const Time pause = attempts_++ > 0 ? kBackOff : std::chrono::milliseconds{0};
    health_.setTrouble("the laser is started again: " + reason);
    revival_.begin(cure, pause, stream_, link_.now());
    return goOn();
}

Result<void> ScipLaser::takeRevived(const ScipReply& reply)
{
    switch (revival_.take(reply, link_.now())) {
        case ScipRevival::Outcome::Waiting:
            return revival_.isWaiting() ? Result<void>{} : goOn();
        case ScipRevival::Outcome::Accepted:
            health_.setTrouble(partner_.warning);
            streamsFrom(link_.now());
            return {};
        case ScipRevival::Outcome::Refused:
            break;
    }
    const std::string status = describeScipStatus(measurement_.command, reply.status, partner_.version);
    if (scipMeaning(measurement_.command, reply.status, partner_.version).verdict == ScipVerdict::Malfunction)
        return cureInStream(status);
    return revive(ScipRevival::Cure::None, status);
}

/// A fault of the hardware while it streams, or was to stream again.
Result<void> ScipLaser::cureInStream(const std::string& status)
{
    const std::optional<ScipRevival::Cure> next = nextCure(status);
    if (next)
        return revive(*next, status);
    quitUnheard();
    return faulty(status);
}

}  // namespace planewright
