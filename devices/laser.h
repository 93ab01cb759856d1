// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/types/error.h"
#include "devices/fault_log.h"

namespace planewright {

/// Who a laser scanner says it is.
struct LaserIdentity {
    std::string vendor;
    std::string product;
    std::string firmware;
    std::string protocol;
    std::string serial;  ///< the only name that is its own
    std::string model;
};

/// What a laser scanner can see, as it says itself.
struct LaserLimits {
    double rangeMin = 0.0;               ///< nearest range that counts [m]
    double rangeMax = 0.0;               ///< farthest range that counts [m]
    int stepsPerTurn = 0;                ///< ARES
    int firstStep = 0;                   ///< AMIN
    int lastStep = 0;                    ///< AMAX
    int frontStep = 0;                   ///< AFRT: the step that looks straight ahead
    std::chrono::nanoseconds period{0};  ///< one turn of the mirror

    /// Bearing θ of a step [rad]: straight ahead is π/2, counter-clockwise.
    double bearing(int step) const;
    /// Angle between neighbouring steps [rad].
    double bearingStep() const;
    /// The step whose bearing is nearest to θ [rad].
    int nearestStep(double bearing) const;
};

/// Which beams of a turn a scan has.
///
/// Neighbouring steps may be joined into clusters, of which the laser sends one range, its least: fewer beams, for
/// slow lines and coarse scans.
struct LaserBeams {
    int first = 0;    ///< step
    int last = 0;     ///< step, counted; later than the first
    int cluster = 1;  ///< steps that are joined, 1 to kMostJoinedSteps; the last cluster may have fewer

    static constexpr int kMostJoinedSteps = 99;

    /// Ranges of a scan: ⌈(last − first + 1) / cluster⌉.
    int count() const { return (last - first) / cluster + 1; }
    /// Bearing θ of the first range: the middle of its cluster [rad].
    double firstBearing(const LaserLimits& limits) const
    {
        return limits.bearing(first) + 0.5 * (cluster - 1) * limits.bearingStep();
    }
    /// From range to range [rad]. Where the last cluster has fewer steps, its middle lies a little nearer than this.
    double bearingStep(const LaserLimits& limits) const { return cluster * limits.bearingStep(); }
};

/// One turn's beams.
struct LaserScan {
    std::chrono::nanoseconds first{0};    ///< moment of the first beam, host clock
    std::chrono::nanoseconds last{0};     ///< moment of the last beam, host clock
    std::chrono::nanoseconds arrived{0};  ///< when the last byte had come, host clock
    std::vector<std::uint32_t> ranges;    ///< [mm]; 0 = no return
    /// What was sent for each beam, codes among it, where hardly any beam came back; else empty. The ranges alone would
    /// not tell a covered window from open sky or from a table of codes that is another model's.
    std::vector<std::uint32_t> codes;
    bool timeSuspect = false;  ///< the laser's clock was set anew, or its scans did not come in time
};

/// What a device panel shows of a link: counters since connect.
struct LinkHealth {
    double rate = 0.0;           ///< complete scans (or answers) a second, over the last second
    std::uint64_t good = 0;      ///< complete scans or answers
    std::uint64_t lost = 0;      ///< that should have come and did not
    std::uint64_t corrupt = 0;   ///< that came damaged and were thrown away
    std::uint64_t late = 0;      ///< that came later than a period after they were due
    std::uint64_t overruns = 0;  ///< how often its adapter lost bytes, since they were not fetched in time
    FaultCounts faults;          ///< by their codes
    std::string trouble;         ///< empty, or a line about what is wrong now
};

/// A scanner of one line. One thread calls it; health() and takeLog() may be called by any.
class Laser {
public:
    virtual ~Laser() = default;

    /// Brings it from any state to one in which it answers, and asks who it is.
    ///
    /// Errors (NoDevice): nothing answers, or not what was expected; DeviceLost: unplugged meanwhile. A stop
    /// ends it early with Interrupted.
    virtual Result<void> connect(const std::stop_token& stop) = 0;

    virtual const LaserIdentity& identity() const = 0;
    virtual const LaserLimits& limits() const = 0;

    /// Scans without end from now on. After an error or a stop (Interrupted) it does not scan.
    virtual Result<void> start(const LaserBeams& beams, const std::stop_token& stop) = 0;
    /// Steps `first` to `last`, both counted, each with its own range.
    Result<void> start(int first, int last, const std::stop_token& stop)
    {
        return start(LaserBeams{first, last}, stop);
    }

    /// The next complete scan that came undamaged; empty where there is none before the deadline or a stop. Damaged
    /// ones are counted and left out. It comes back half a second after the deadline at most.
    ///
    /// Errors: DeviceLost where it is gone or silent beyond its own attempts to start it again.
    virtual Result<std::optional<LaserScan>> next(std::chrono::nanoseconds deadline, const std::stop_token& stop) = 0;

    /// Ends scanning and waits until it is silent.
    virtual Result<void> stop() = 0;

    /// While it does not scan: notices whether its link is still there, and throws away what comes. Asks nothing of it;
    /// does not wait. Errors: DeviceLost.
    virtual Result<void> lookAfter() { return {}; }

    virtual LinkHealth health() const = 0;

    /// Its faults since this was last called, the latest FaultLog::kMostRecords at most, oldest first.
    virtual std::vector<FaultRecord> takeLog() { return {}; }
};

}  // namespace planewright
