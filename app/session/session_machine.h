// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/types/error.h"

namespace planewright {

/// What a session is doing, as the window's state chip says it.
enum class SessionState {
    Empty,       ///< no scan
    Connecting,  ///< a scanner or a file is being opened
    Ready,       ///< a scanner is there
    Homing,      ///< it moves to where the scan begins, or to level
    Scanning,    ///< it takes slices
    Paused,      ///< a scan or a replay holds
    Finishing,   ///< no more slices come; those that came are being worked in
    Review,      ///< the scan is complete, or as much of it as there will be
    Replaying,   ///< a recording, or the scan once more, is being worked in
    Fault,       ///< the scanner failed; somebody decides how to go on
    ReadOnly,    ///< as Review, of a file that cannot be changed
};
inline constexpr std::size_t kSessionStates = 11;
inline constexpr std::array<std::string_view, kSessionStates> kSessionStateNames{
    "empty",     "connecting", "ready",     "homing", "scanning", "paused",
    "finishing", "review",     "replaying", "fault",  "read-only"};
constexpr std::string_view name(SessionState state)
{
    return kSessionStateNames[static_cast<std::size_t>(state)];
}

/// What somebody may ask of a session.
enum class SessionRequest {
    Open,
    Cancel,  ///< what is being opened, or extracted once more
    Start,
    GoHome,  ///< the head goes to level
    Pause,
    Continue,
    Step,
    Finish,
    Retry,
    StopMotion,
    Release,  ///< what was stopped may move again
    SetParameters,
    SetSpeed,
    Rerun,
    GoToStep,
    Close,
};
inline constexpr std::size_t kSessionRequests = 16;

/// What the world does to a session.
enum class SessionHappening {
    Connected,         ///< a scanner is there
    Loaded,            ///< a recording has been read
    LoadedReadOnly,    ///< the same, of a file that cannot be changed
    LoadingFailed,     ///< a file could not be opened
    ConnectingFailed,  ///< a scanner could not be opened
    Begun,             ///< the scanner stands where the scan begins
    Home,              ///< the head is at level, or will not get there
    SourceFailed,      ///< the source cannot go on
    SourceEnded,       ///< the source gives no more slices
    CaughtUp,          ///< all that came is worked in, and its recording closed
    CaughtUpEmpty,     ///< the same, where nothing came
    LetGo,             ///< the scanner has been closed; what was scanned with it stays
};
inline constexpr std::size_t kSessionHappenings = 12;

/// Which state follows which: no thread, no clock, nothing but the rules.
class SessionMachine {
public:
    SessionState state() const { return state_; }

    /// Goes where the request leads. Errors (Usage) say why it is refused now and what to do; the state stays. Stopping
    /// motion and closing are never refused.
    Result<void> request(SessionRequest request);

    /// Why it would be refused; empty where it would not.
    std::string_view refusal(SessionRequest request) const;

    /// Goes where it leads; what cannot happen in this state, as news of a scan that was closed, changes nothing.
    void happen(SessionHappening happening);

    /// True where a recording may be open: it is closed on the way out of these states.
    bool mayRecord() const;

    /// True where something may be moving.
    bool mayMove() const;

    /// True where slices are there, or come.
    bool hasScan() const;

    /// True where the source is a scanner.
    bool isLive() const { return live_; }

    /// True while the head goes to level.
    bool goesHome() const { return goesHome_; }

    /// True where a scanner is there and no scan runs.
    bool isIdle() const;

    /// True from stopping motion on, in every state, until it is released: opening another scanner does not release it.
    bool isMotionStopped() const { return motionStopped_; }

private:
    void enter(SessionRequest request);
    SessionState resting() const;
    void startOver();
    bool is(SessionState state) const { return state_ == state; }

    SessionState state_ = SessionState::Empty;
    SessionState before_ = SessionState::Empty;  ///< where a failure to open leads back to
    bool live_ = false;                          ///< the source is a scanner
    bool letGo_ = false;                         ///< in Review: the scanner that the scan was taken with is closed
    bool readOnly_ = false;                      ///< the file that was loaded cannot be changed
    bool begun_ = false;                         ///< the scanner has come to where the scan begins
    bool rerunning_ = false;                     ///< what is worked in are the slices that were there
    bool goesHome_ = false;                      ///< in Homing: to level, and back to homeFrom_ then
    SessionState homeFrom_ = SessionState::Ready;
    bool scans_ = false;  ///< in Fault: a scan failed, not the opening
    bool motionStopped_ = false;
};

}  // namespace planewright
