// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "devices/scip/scip_event.h"

namespace planewright {

/// One attempt to get scans from a laser again whose stream has failed: which request is due when, and what its replies
/// mean. It never waits and talks to nobody, so that whoever asks for scans is held up by none of it.
///
/// A laser that says that it is faulty may be reset first, or started anew; then QT, twice where it is not answered,
/// and the stream's own request.
class ScipRevival {
public:
    using Time = std::chrono::nanoseconds;

    /// What is done before the stream is asked for.
    enum class Cure { None, Reset, Reboot };

    /// Begins after a pause. `stream`: the request that scans answer.
    void begin(Cure cure, Time pause, std::string stream, Time now);
    /// Forgets it.
    void end() { stage_ = Stage::Idle; }
    bool isUnderWay() const { return stage_ != Stage::Idle; }
    /// A reply is awaited, or the end of a pause: due() has nothing before wakesAt().
    bool isWaiting() const { return isWaiting_; }

    /// What has to be sent now; empty where it is to be waited, or it has failed.
    std::optional<std::string_view> due(Time now);
    /// When due() has to be asked again.
    Time wakesAt() const { return until_; }
    /// True where the stream's request was not answered, or the laser has not started; it is over then.
    bool hasFailed() const { return stage_ == Stage::Failed; }

    /// What came of a reply.
    enum class Outcome {
        Waiting,   ///< it goes on
        Accepted,  ///< scans come from now on; it is over
        Refused,   ///< the stream's request was answered with another status than 00; it is over
    };
    Outcome take(const ScipReply& reply, Time now);

private:
    enum class Stage { Idle, Pause, Reset, Reboot, Boot, Quit, Stream, Failed };

    std::string_view request() const;
    Time patience() const;
    void enter(Stage stage);
    void pause(Time time, Time now);
    void giveUpWaiting(Time now);
    void count(int tries, Stage next);

    Stage stage_ = Stage::Idle;
    Stage afterPause_ = Stage::Quit;
    std::string stream_;
    int asked_ = 0;           ///< times that the request of this stage was sent
    bool isWaiting_ = false;  ///< for its reply, or for the end of a pause
    Time until_{0};
    Time bootUntil_{0};
};

}  // namespace planewright
