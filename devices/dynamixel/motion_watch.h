// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>

namespace planewright {

/// Whether a servo arrives where it was sent, from its positions alone.
///
/// Arrived is a servo within the tolerance of its goal, and not moving, in three answers after one another: its moving
/// flag alone is 0 also before it starts and where it is stuck. It is stuck where it comes no nearer for 300 ms, or is
/// not there after three times the time that the way takes and 500 ms.
class MotionWatch {
public:
    using Time = std::chrono::nanoseconds;

    /// A motion from a position [counts] to a goal at a speed [counts/s], begun at a moment.
    MotionWatch(double from, double goal, double speed, double tolerance, Time begun);

    enum class Verdict { OnItsWay, Arrived, Stuck };
    /// The next answer, measured at a moment. May be called on after a verdict: a servo that is pushed away from its
    /// goal is on its way again.
    Verdict look(double position, bool isMoving, Time at);

private:
    void restart(double position, Time at);

    double goal_;
    double speed_;
    double tolerance_;
    double nearest_ = 0.0;  ///< distance to the goal so far [counts]
    Time nearestAt_{0};
    Time latest_{0};  ///< when it has to have arrived
    int there_ = 0;   ///< answers after one another at the goal
};

}  // namespace planewright
