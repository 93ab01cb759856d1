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

/// One turn's beams.
struct LaserScan {
    std::chrono::nanoseconds first{0};    ///< moment of the first beam, host clock
    std::chrono::nanoseconds last{0};     ///< moment of the last beam, host clock
    std::chrono::nanoseconds arrived{0};  ///< when the last byte had come, host clock
    std::vector<std::uint32_t> ranges;    ///< [mm]; 0 = no return
    bool timeSuspect = false;             ///< the laser's clock was set anew, or its scans did not come in time
};

/// What a device panel shows of a link: counters since connect.
struct LinkHealth {
    double rate = 0.0;          ///< complete scans (or answers) a second, over the last second
    std::uint64_t good = 0;     ///< complete scans or answers
    std::uint64_t lost = 0;     ///< that should have come and did not
    std::uint64_t corrupt = 0;  ///< that came damaged and were thrown away
    std::uint64_t late = 0;     ///< that came later than a period after they were due
    std::string trouble;        ///< empty, or a line about what is wrong now
};

/// A scanner of one line. One thread calls it; health() may be called by any.
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

    /// Scans without end from now on, steps `first` to `last`, both counted.
    virtual Result<void> start(int first, int last, const std::stop_token& stop) = 0;

    /// The next complete scan that came undamaged; empty where there is none before the deadline or a stop. Damaged
    /// ones are counted and left out.
    ///
    /// Errors: DeviceLost where it is gone or silent beyond its own attempts to start it again.
    virtual Result<std::optional<LaserScan>> next(std::chrono::nanoseconds deadline, const std::stop_token& stop) = 0;

    /// Ends scanning and waits until it is silent.
    virtual Result<void> stop() = 0;

    virtual LinkHealth health() const = 0;
};

}  // namespace planewright
