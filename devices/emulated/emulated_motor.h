// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <deque>

namespace planewright {

/// How a motor moves.
struct MotorDynamics {
    double acceleration = 60.0;           ///< up and down [rad/s²]
    double overshoot = 0.003;             ///< it swings about its goal by this after a full stop [rad]
    std::chrono::milliseconds swing{20};  ///< period of that
    std::chrono::milliseconds decay{8};   ///< time in which that falls to 1/e
};

/// The angle of a motor's shaft as a function of time. Remembers some seconds, since a laser tells of a turn when it is
/// over. Times never go back between commands.
class EmulatedMotor {
public:
    using Time = std::chrono::nanoseconds;

    explicit EmulatedMotor(double angle, const MotorDynamics& dynamics = {});

    /// Goes to an angle [rad] from where it is, at most at a speed [rad/s], which must be positive.
    void goTo(double goal, double speed, Time now);
    /// Comes to rest as fast as it can.
    void stop(Time now);
    /// Turns freely or is held by something: it stands where it is until the next goTo().
    void block(Time now);

    /// Angle at a moment [rad]; before what it remembers, the oldest that it does.
    double angle(Time at) const;
    /// Speed at a moment, without the swinging [rad/s].
    double speed(Time at) const;
    /// True until it has reached its goal, swinging not counted.
    bool isMoving(Time at) const;

private:
    /// Constant acceleration from a moment on.
    struct Piece {
        Time from;
        double angle;
        double speed;
        double acceleration;
        double swing;  ///< overshoot that begins here [rad]
    };
    const Piece& pieceAt(Time at) const;
    void begin(const Piece& piece);
    /// Drops what comes later than a moment, and what is older than is remembered.
    void cut(Time now);

    MotorDynamics dynamics_;
    std::deque<Piece> pieces_;
};

}  // namespace planewright
