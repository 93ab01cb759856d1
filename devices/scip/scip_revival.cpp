// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_revival.h"

#include <utility>

#include "devices/scip/scip_patience.h"
#include "devices/scip/scip_request.h"

namespace planewright {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kResetReply{2'000};
constexpr milliseconds kRebootReply{300};  ///< RB counts only where it comes twice within a second
constexpr milliseconds kAfterReset{150};
constexpr int kRequests = 2;

}  // namespace

void ScipRevival::begin(Cure cure, Time pause, std::string stream, Time now)
{
    stream_ = std::move(stream);
    afterPause_ = cure == Cure::Reset ? Stage::Reset : cure == Cure::Reboot ? Stage::Reboot : Stage::Quit;
    this->pause(pause, now);
}

std::optional<std::string_view> ScipRevival::due(Time now)
{
    if (isWaiting_ && now >= until_)
        giveUpWaiting(now);
    if (stage_ == Stage::Idle || stage_ == Stage::Failed || isWaiting_)
        return std::nullopt;
    if (stage_ == Stage::Boot && asked_ == 0)
        bootUntil_ = now + kScipBootTime;
    ++asked_;
    isWaiting_ = true;
    until_ = now + patience();
    return request();
}

ScipRevival::Outcome ScipRevival::take(const ScipReply& reply, Time now)
{
    if (!isWaiting_ || stage_ == Stage::Pause || reply.echo != request())
        return Outcome::Waiting;
    switch (stage_) {
        case Stage::Reset:
            afterPause_ = Stage::Quit;
            pause(kAfterReset, now);
            return Outcome::Waiting;
        case Stage::Reboot:
            count(kRequests, Stage::Boot);
            return Outcome::Waiting;
        case Stage::Boot:  // what is not ready says so, and is asked again when its time is over
            if (reply.status == "00")
                enter(Stage::Stream);
            return Outcome::Waiting;
        case Stage::Quit:
            enter(Stage::Stream);
            return Outcome::Waiting;
        default:
            end();
            return reply.status == "00" ? Outcome::Accepted : Outcome::Refused;
    }
}

/// No reply has come in time, or a pause is over.
void ScipRevival::giveUpWaiting(Time now)
{
    switch (stage_) {
        case Stage::Pause:
            return enter(afterPause_);
        case Stage::Reset:
            return enter(Stage::Quit);
        case Stage::Reboot:  // some obey and never answer
            return count(kRequests, Stage::Boot);
        case Stage::Boot:
            isWaiting_ = false;
            if (now >= bootUntil_)
                stage_ = Stage::Failed;
            return;
        case Stage::Quit:
            return count(kRequests, Stage::Stream);
        default:
            return enter(Stage::Failed);
    }
}

/// The same request again, or the next stage.
void ScipRevival::count(int tries, Stage next)
{
    isWaiting_ = false;
    if (asked_ >= tries)
        enter(next);
}

void ScipRevival::enter(Stage stage)
{
    stage_ = stage;
    asked_ = 0;
    isWaiting_ = false;
}

void ScipRevival::pause(Time time, Time now)
{
    enter(Stage::Pause);
    isWaiting_ = true;
    until_ = now + time;
}

std::string_view ScipRevival::request() const
{
    switch (stage_) {
        case Stage::Reset:
            return kScipReset;
        case Stage::Reboot:
            return kScipReboot;
        case Stage::Boot:
        case Stage::Quit:
            return kScipQuit;
        default:
            return stream_;
    }
}

ScipRevival::Time ScipRevival::patience() const
{
    switch (stage_) {
        case Stage::Reset:
            return kResetReply;
        case Stage::Reboot:
            return kRebootReply;
        default:
            return kScipReply;
    }
}

}  // namespace planewright
