// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/types/error.h"
#include "core/types/recording.h"
#include "devices/fault_log.h"

namespace planewright {

/// Something that a source says of how it is: a rate, a temperature.
struct HealthFact {
    std::string name;
    std::string value;
    bool isTrouble = false;
    std::string brief{};  ///< what a single line about the source shows of it; empty: nothing
};

/// Where slices come from: a scanner, a simulated one, or a recording. All code above sees no more of them than this.
///
/// begin(), next(), end(), lookAfter() and goHome() are called by one thread at a time; everything else may be called
/// by any thread while that one waits, and returns at once (stopMotion: within one round trip to the device). A source
/// outlives none of these calls.
class ScanSource {
public:
    virtual ~ScanSource() = default;

    /// What is said once about its scans; the same as long as the source lives.
    virtual const ScanDescription& description() const = 0;

    /// Slices of a whole scan, where that is known.
    virtual std::optional<int> plannedSlices() const = 0;

    /// True where it measures now, so that what is not recorded is lost; false for a recording.
    virtual bool isLive() const = 0;

    /// What people call it: "Simulated corridor", "lobby.csv.gz".
    virtual std::string name() const = 0;

    /// Goes to where a scan begins; next() then gives its first slice. May be called again for the next scan. Comes
    /// back early, without an error, where a stop is asked for.
    virtual Result<void> begin(const std::stop_token& stop) = 0;

    /// Waits for the next slice. Empty after the last one, and where a stop is asked for. After an error it may be
    /// called again: it then tries to go on where the scan was. Unasked only after DeviceLost or NoDevice: the links
    /// may heal, but for NeedsOperator a person has to see to something first, and to call release().
    virtual Result<std::optional<ScanSlice>> next(const std::stop_token& stop) = 0;

    /// The scan is over, whole or not: what moves comes to rest in order.
    virtual Result<void> end() { return {}; }

    /// Between scans, about twice a second: looks how its devices are, for health(), and opens anew what was lost.
    /// Moves nothing, asks nothing that a scan would have to wait for, and comes back soon after a stop. Called by the
    /// thread that would call begin().
    virtual void lookAfter(const std::stop_token& /*stop*/) {}

    /// Between scans: brings the head to level, slowly, and to rest there; back when it is there, with the angle [rad];
    /// empty where nothing moves. Called as begin(). Errors: as of begin(); Interrupted: a stop, or stopMotion().
    virtual Result<std::optional<double>> goHome(const std::stop_token& /*stop*/) { return std::nullopt; }

    /// Holds the scan where it is, and lets it go on. Pausing what is paused changes nothing.
    virtual Result<void> pause() = 0;
    virtual Result<void> resume() = 0;

    /// Gives one slice more of a scan that is paused. Errors (Usage): a source that cannot.
    virtual Result<void> step() { return fail(ErrorCode::Usage, name() + ": this source takes no single steps"); }

    /// How many times faster than it was measured; 1 is real time, 0 as fast as possible. Errors (Usage): a source
    /// whose pace is its own, or a speed that isReplaySpeed refuses.
    virtual Result<void> setSpeed(double /*speed*/)
    {
        return fail(ErrorCode::Usage, name() + ": a scanner has the speed that it has");
    }

    /// How it is now, for a panel; nothing of a source that is no device. Any thread.
    virtual std::vector<HealthFact> health() const { return {}; }

    /// What went wrong with its devices since this was last asked, oldest first, the latest of each device at most. Any
    /// thread.
    virtual std::vector<FaultRecord> takeLog() { return {}; }

    /// Stops whatever moves, at once, in every state. Nothing moves then before release(): begin() and resume() give
    /// an error (NeedsOperator). A recording has nothing that moves.
    virtual Result<void> stopMotion() { return {}; }

    /// A person allows motion again, after stopMotion(), or after seeing to what a device has stopped for. A scan that
    /// was under way stays paused. Moves nothing; never to be called unasked.
    virtual void release() {}
};

}  // namespace planewright
