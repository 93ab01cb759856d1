// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <chrono>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/types/angle.h"
#include "core/types/error.h"
#include "devices/laser.h"

namespace planewright {

/// How a tilt unit is mounted, and what it may do: values of a calibration, never guessed.
struct TiltMounting {
    double zeroPitch = 0.0;  ///< pitch φ at the unit's middle position [rad]
    double sign = 1.0;       ///< +1 or −1: whether φ grows with the unit's counts
    double scale = 1.0;      ///< true angle over the one that the counts stand for
    double lowest = 0.0;     ///< soft limits of φ [rad]
    double highest = 0.0;
    double fastest = 0.0;  ///< speed limit [rad/s]
};

/// Where a tilt unit was, measured.
struct TiltSample {
    std::chrono::nanoseconds at{0};  ///< moment of the measurement, host clock
    double pitch = 0.0;              ///< φ [rad]
    bool moving = false;
    std::chrono::nanoseconds uncertainty{0};  ///< how far `at` may be off; samples that may be off by more than 5 ms
                                              ///< are not given while it moves
};

/// What a device panel shows of a motor.
struct MotorState {
    double load = 0.0;                  ///< of the most it can, −1 to 1
    double voltage = 0.0;               ///< [V]
    std::optional<double> temperature;  ///< [°C]
    std::string trouble;                ///< empty, or a line about what is wrong now
};

/// What tilts the laser. One thread calls it, except hold(), holdsItself(), health(), takeLog() and motor(), which
/// any thread may call at any time.
class TiltUnit {
public:
    virtual ~TiltUnit() = default;

    /// Finds it and looks whether it may be moved; moves nothing.
    ///
    /// Errors (NoDevice): nothing answers, or what answers must not be moved (wheel mode, two units of the same
    /// number), with what to do; Interrupted: a stop.
    virtual Result<void> connect(const std::stop_token& stop) = 0;

    /// "RX-64, number 1, firmware 24".
    virtual std::string identity() const = 0;

    /// The smallest step of φ [rad].
    virtual double resolution() const = 0;
    /// φ that it can and may take [rad].
    virtual double lowest() const = 0;
    virtual double highest() const = 0;
    /// The largest speed that it may have [rad/s].
    virtual double fastest() const = 0;
    /// Speeds that it has are whole multiples of this, which is the least of them [rad/s]; 0 where it has any.
    virtual double speedStep() const { return 0.0; }
    /// How far from where it was sent it may stand and count as there [rad].
    virtual double tolerance() const { return 2.0 * resolution(); }

    /// Allows motion: nothing moves before. Takes back a hold().
    ///
    /// Errors (NeedsOperator): it has stopped by itself, or by its button for emergencies: a person has to see to the
    /// cause, and then to ask for recover().
    virtual Result<void> arm(const std::stop_token& stop) = 0;

    /// Releases a unit that has stopped by itself or in an emergency, after a person has seen to the cause: never to be
    /// called unasked. Moves nothing, and arm() is still needed. Where there is nothing to release it does nothing.
    ///
    /// Errors (NeedsOperator): the cause is still there; DeviceLost; Interrupted: a stop.
    virtual Result<void> recover(const std::stop_token& /*stop*/) { return {}; }

    /// Begins to go to φ [rad] at a speed [rad/s]; returns when the unit has accepted. Errors (Usage): beyond a limit;
    /// DeviceLost: no answer, or the unit reports a fault (Error's text names it); Interrupted: held.
    virtual Result<void> moveTo(double pitch, double speed) = 0;

    /// Begins to go home: level, φ = 90°, or as near to that as it may, slowly enough to be stopped by hand. Errors:
    /// those of moveTo().
    virtual Result<void> goHome() { return moveTo(home(), homeSpeed()); }
    /// φ of home [rad], and the speed on the way there [rad/s].
    double home() const { return std::clamp(degrees(90.0), lowest(), highest()); }
    double homeSpeed() const { return std::min(degrees(20.0), fastest()); }

    /// φ that it really goes to for a wanted one: the nearest of its steps [rad].
    virtual double nearestPitch(double pitch) const = 0;

    /// The next measured angle: one round trip, or the next that the unit sends by itself. Empty at the deadline.
    virtual Result<std::optional<TiltSample>> sample(std::chrono::nanoseconds deadline,
                                                     const std::stop_token& stop) = 0;

    /// Comes to rest in order and holds; refuses every motion until arm(). Not for emergencies.
    virtual Result<void> stop() { return hold(); }

    /// Stops where it is and holds; refuses every motion until arm(). Within one round trip.
    virtual Result<void> hold() = 0;

    /// False where its motor has no torque, as far as it last said: it may be turned by hand, or have sunk.
    virtual bool holdsItself() const { return true; }

    /// When it started, host clock, by what it said when it was connected or armed last; empty where it does not say.
    /// For the thread of connect() and arm().
    virtual std::optional<std::chrono::nanoseconds> startedAt() const { return std::nullopt; }

    virtual LinkHealth health() const = 0;
    /// Its faults since this was last called, the latest FaultLog::kMostRecords at most, oldest first.
    virtual std::vector<FaultRecord> takeLog() { return {}; }
    virtual MotorState motor() const = 0;
};

}  // namespace planewright
