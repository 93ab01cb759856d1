// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/session_machine.h"

#include <string>
#include <utility>

namespace planewright {

namespace {

constexpr std::string_view kBusy = "A scan is running. Finish it or close it first.";
constexpr std::string_view kConnecting = "Something is being opened. Wait for it, or cancel.";
constexpr std::string_view kNoScan = "There is no scan yet. Open a recording, or connect a scanner and start.";
constexpr std::string_view kNoScanner = "No scanner is connected. Connect one, or open a recording.";
constexpr std::string_view kNotRunning = "No scan is running. Start one first.";
constexpr std::string_view kFinishing = "The last slices are being worked in. Wait until that is done.";
constexpr std::string_view kRerunning = "The scan is being extracted once more. Wait for that, or cancel it.";
constexpr std::string_view kFault = "The scanner has failed. Try again, or finish with what there is.";
constexpr std::string_view kMotionStopped = "Motion was stopped. Release it first.";
constexpr std::string_view kReadOnly = "The file was opened read-only. Save a copy and open that.";

}  // namespace

std::string_view SessionMachine::refusal(SessionRequest request) const
{
    using State = SessionState;
    using Request = SessionRequest;
    switch (request) {
        case Request::StopMotion:
        case Request::Close:
            return {};

        case Request::Open:
            if (is(State::Connecting))
                return kConnecting;
            if (is(State::Empty) || is(State::Ready) || is(State::Review) || is(State::ReadOnly) ||
                (is(State::Fault) && !scans_))
                return {};
            return is(State::Finishing) ? kFinishing : kBusy;

        case Request::Cancel:
            if (is(State::Connecting) || is(State::Replaying))
                return {};
            return "Nothing is being opened or extracted that could be cancelled.";

        case Request::Start:
            if (motionStopped_ && live_ && (is(State::Ready) || is(State::Review)))
                return kMotionStopped;
            if (letGo_ && is(State::Review))
                return kNoScanner;
            if (is(State::Ready) || is(State::Review) || is(State::ReadOnly))
                return {};
            if (is(State::Empty))
                return kNoScanner;
            if (is(State::Connecting))
                return kConnecting;
            if (is(State::Paused))
                return "The scan is paused. Continue or finish it.";
            if (is(State::Finishing))
                return kFinishing;
            return is(State::Fault) ? kFault : kBusy;

        case Request::GoHome:
            if (isIdle() && !goesHome_)
                return motionStopped_ ? kMotionStopped : std::string_view{};
            if (is(State::Homing))
                return "The head is moving already.";
            return live_ && mayRecord() ? kBusy : "No scanner is connected. Connect one first.";

        case Request::Pause:
            if (rerunning_)
                return kRerunning;
            if (is(State::Scanning) || is(State::Replaying))
                return {};
            return is(State::Paused) ? "The scan is paused already." : kNotRunning;

        case Request::Continue:
        case Request::Step:
            if (is(State::Paused))
                return {};
            return is(State::Scanning) || is(State::Replaying) ? "The scan is not paused. Pause it first."
                                                               : kNotRunning;

        case Request::Finish:
            if (rerunning_)
                return kRerunning;
            if (is(State::Scanning) || is(State::Paused) || is(State::Replaying) || is(State::Fault))
                return {};
            if (is(State::Homing))
                return "The scanner is moving. Stop motion ends that.";
            return is(State::Finishing) ? kFinishing : kNotRunning;

        case Request::Retry:
            if (!is(State::Fault))
                return "Nothing has failed that could be tried again.";
            return motionStopped_ ? kMotionStopped : std::string_view{};

        case Request::Release:
            return motionStopped_ ? std::string_view{} : "Motion is not stopped.";

        case Request::SetParameters:
            if (rerunning_)
                return kRerunning;
            if (is(State::Connecting))
                return kConnecting;
            if (is(State::Finishing))
                return kFinishing;
            return is(State::ReadOnly) ? kReadOnly : std::string_view{};

        case Request::SetSpeed:
            if (is(State::Empty))
                return kNoScan;
            if (is(State::Connecting))
                return kConnecting;
            if (is(State::Finishing))
                return kFinishing;
            if (letGo_)
                return kNoScanner;
            return is(State::Fault) ? kFault : std::string_view{};

        case Request::Rerun:
            if (is(State::Review))
                return {};
            if (is(State::ReadOnly))
                return kReadOnly;
            if (is(State::Empty) || is(State::Ready))
                return kNoScan;
            if (is(State::Connecting))
                return kConnecting;
            if (is(State::Finishing))
                return kFinishing;
            return kBusy;

        case Request::GoToStep:
            return hasScan() ? std::string_view{} : kNoScan;
    }
    return {};
}

Result<void> SessionMachine::request(SessionRequest request)
{
    if (const std::string_view why = refusal(request); !why.empty())
        return fail(ErrorCode::Usage, std::string{why});
    enter(request);
    return {};
}

/// Follows a request that is not refused.
void SessionMachine::enter(SessionRequest request)
{
    using State = SessionState;
    switch (request) {
        case SessionRequest::Open:
            before_ = is(State::Fault) ? State::Empty : state_;
            state_ = State::Connecting;
            break;
        case SessionRequest::Cancel:
            state_ = is(State::Connecting) ? before_ : State::Finishing;
            break;
        case SessionRequest::Start:
            begun_ = false;
            state_ = live_ ? State::Homing : State::Replaying;
            break;
        case SessionRequest::GoHome:
            goesHome_ = true;
            homeFrom_ = state_;
            state_ = State::Homing;
            break;
        case SessionRequest::Rerun:
            rerunning_ = true;
            state_ = State::Replaying;
            break;
        case SessionRequest::Pause:
            state_ = State::Paused;
            break;
        case SessionRequest::Continue:
            state_ = live_ ? State::Scanning : State::Replaying;
            break;
        case SessionRequest::Finish:
            state_ = is(State::Fault) && !scans_ ? State::Empty : State::Finishing;
            break;
        case SessionRequest::Retry:
            if (!scans_)
                state_ = State::Connecting;
            else if (live_)
                state_ = begun_ ? State::Scanning : State::Homing;
            else
                state_ = State::Replaying;
            break;
        case SessionRequest::StopMotion:
            motionStopped_ = true;
            if (is(State::Connecting))
                state_ = before_;
            else if (std::exchange(goesHome_, false))
                state_ = homeFrom_;
            else if (is(State::Homing) || is(State::Scanning) || (is(State::Paused) && live_))
                state_ = State::Finishing;
            break;
        case SessionRequest::Release:
            motionStopped_ = false;
            break;
        case SessionRequest::Close:
            startOver();
            break;
        case SessionRequest::Step:
        case SessionRequest::SetParameters:
        case SessionRequest::SetSpeed:
        case SessionRequest::GoToStep:
            break;
    }
}

/// Where a scan that is over comes to rest.
/// As new, but for what only release() ends.
void SessionMachine::startOver()
{
    const bool motionStopped = motionStopped_;
    *this = {};
    motionStopped_ = motionStopped;
}

SessionState SessionMachine::resting() const
{
    return readOnly_ ? SessionState::ReadOnly : SessionState::Review;
}

void SessionMachine::happen(SessionHappening happening)
{
    using State = SessionState;
    const bool isUnderWay = (is(State::Homing) && !goesHome_) || is(State::Scanning) || is(State::Paused) ||
                            is(State::Replaying) || (is(State::Fault) && scans_);
    switch (happening) {
        case SessionHappening::Connected:
        case SessionHappening::Loaded:
        case SessionHappening::LoadedReadOnly:
            if (!is(State::Connecting))
                break;
            live_ = happening == SessionHappening::Connected;
            readOnly_ = happening == SessionHappening::LoadedReadOnly;
            letGo_ = false;
            begun_ = false;
            scans_ = false;
            state_ = live_ ? State::Ready : State::Replaying;
            break;
        case SessionHappening::LoadingFailed:
            if (is(State::Connecting))
                state_ = before_;
            break;
        case SessionHappening::ConnectingFailed:
            if (!is(State::Connecting))
                break;
            startOver();
            state_ = State::Fault;
            break;
        case SessionHappening::Begun:
            begun_ = true;
            if (is(State::Homing) && !goesHome_)
                state_ = State::Scanning;
            break;
        case SessionHappening::Home:
            if (std::exchange(goesHome_, false))
                state_ = homeFrom_;
            break;
        case SessionHappening::SourceFailed:
            if (!isUnderWay)
                break;
            scans_ = true;
            state_ = State::Fault;
            break;
        case SessionHappening::SourceEnded:
            if (isUnderWay)
                state_ = State::Finishing;
            break;
        case SessionHappening::CaughtUp:
        case SessionHappening::CaughtUpEmpty:
            if (!is(State::Finishing) && !isUnderWay)
                break;
            rerunning_ = false;
            state_ = happening == SessionHappening::CaughtUpEmpty && live_ ? State::Ready : resting();
            break;
        case SessionHappening::LetGo:
            if (!isIdle() || goesHome_)
                break;
            live_ = false;
            letGo_ = is(State::Review);
            if (is(State::Ready))
                state_ = State::Empty;
            break;
    }
}

bool SessionMachine::mayRecord() const
{
    using State = SessionState;
    return live_ && !rerunning_ &&
           ((is(State::Homing) && !goesHome_) || is(State::Scanning) || is(State::Paused) || is(State::Finishing) ||
            (is(State::Fault) && scans_));
}

bool SessionMachine::mayMove() const
{
    return mayRecord() || goesHome_;
}

bool SessionMachine::isIdle() const
{
    return live_ && (is(SessionState::Ready) || is(SessionState::Review) || goesHome_);
}

bool SessionMachine::hasScan() const
{
    using State = SessionState;
    return is(State::Scanning) || is(State::Paused) || is(State::Finishing) || is(State::Review) ||
           is(State::Replaying) || is(State::ReadOnly) || (is(State::Fault) && scans_) ||
           (goesHome_ && homeFrom_ == State::Review);
}

}  // namespace planewright
