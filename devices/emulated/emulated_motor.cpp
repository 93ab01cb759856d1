// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_motor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planewright {

namespace {

constexpr std::chrono::seconds kRemembered{5};

double secondsBetween(EmulatedMotor::Time from, EmulatedMotor::Time to)
{
    return std::chrono::duration<double>(to - from).count();
}

EmulatedMotor::Time after(EmulatedMotor::Time from, double seconds)
{
    return from + std::chrono::round<EmulatedMotor::Time>(std::chrono::duration<double>(seconds));
}

}  // namespace

EmulatedMotor::EmulatedMotor(double angle, const MotorDynamics& dynamics) : dynamics_(dynamics)
{
    pieces_.push_back({Time{0}, angle, 0.0, 0.0, 0.0});
}

/// Brakes first where it goes the wrong way or could not stop in time, then follows a trapezoid of speed.
void EmulatedMotor::goTo(double goal, double speed, Time now)
{
    const double a = dynamics_.acceleration;
    double angle0 = angle(now);
    double v = this->speed(now);
    cut(now);
    Time from = now;
    const auto run = [&](double acceleration, double seconds) {
        begin({from, angle0, v, acceleration, 0.0});
        from = after(from, seconds);
        angle0 += v * seconds + 0.5 * acceleration * seconds * seconds;
        v += acceleration * seconds;
    };

    const double stopsAt = angle0 + 0.5 * v * std::abs(v) / a;
    if (v != 0.0 && (goal - stopsAt) * v <= 0.0) {
        run(v > 0.0 ? -a : a, std::abs(v) / a);
        v = 0.0;
    }
    const double way = goal >= angle0 ? 1.0 : -1.0;
    const double distance = std::abs(goal - angle0);
    const double start = std::abs(v);
    // The speed at which acceleration and braking fill the distance, if the limit does not come first; a motor that is
    // faster than the limit slows down to it.
    const double top = std::min(speed, std::sqrt(a * distance + 0.5 * start * start));
    const double used = (std::abs(top * top - start * start) + top * top) / (2.0 * a);
    run(way * (top >= start ? a : -a), std::abs(top - start) / a);
    v = way * top;
    run(0.0, top > 0.0 ? std::max(0.0, distance - used) / top : 0.0);
    run(-way * a, top / a);
    const bool hasMoved = distance > 0.0;
    begin({from, goal, 0.0, 0.0, hasMoved ? way * dynamics_.overshoot * std::min(1.0, top * top / a / 0.02) : 0.0});
}

void EmulatedMotor::stop(Time now)
{
    const double v = speed(now);
    const double angle0 = angle(now);
    const double seconds = std::abs(v) / dynamics_.acceleration;
    const double acceleration = v > 0.0 ? -dynamics_.acceleration : dynamics_.acceleration;
    cut(now);
    begin({now, angle0, v, acceleration, 0.0});
    begin({after(now, seconds), angle0 + 0.5 * v * seconds, 0.0, 0.0, 0.0});
}

void EmulatedMotor::block(Time now)
{
    const double angle0 = angle(now);
    cut(now);
    begin({now, angle0, 0.0, 0.0, 0.0});
}

double EmulatedMotor::angle(Time at) const
{
    const Piece& piece = pieceAt(at);
    const double t = std::max(0.0, secondsBetween(piece.from, at));
    const double base = piece.angle + piece.speed * t + 0.5 * piece.acceleration * t * t;
    if (piece.swing == 0.0)
        return base;
    const double swing = std::chrono::duration<double>(dynamics_.swing).count();
    const double decay = std::chrono::duration<double>(dynamics_.decay).count();
    return base + piece.swing * std::exp(-t / decay) * std::sin(2.0 * std::numbers::pi * t / swing);
}

double EmulatedMotor::speed(Time at) const
{
    const Piece& piece = pieceAt(at);
    return piece.speed + piece.acceleration * std::max(0.0, secondsBetween(piece.from, at));
}

bool EmulatedMotor::isMoving(Time at) const
{
    // Not by whether a piece follows: one that stands may be followed by a later command.
    const Piece& piece = pieceAt(at);
    return piece.speed != 0.0 || piece.acceleration != 0.0;
}

const EmulatedMotor::Piece& EmulatedMotor::pieceAt(Time at) const
{
    const auto later =
        std::upper_bound(pieces_.begin(), pieces_.end(), at, [](Time t, const Piece& piece) { return t < piece.from; });
    return later == pieces_.begin() ? *later : *std::prev(later);
}

void EmulatedMotor::begin(const Piece& piece)
{
    // A piece that takes no time is followed by another at the same moment.
    if (!pieces_.empty() && pieces_.back().from == piece.from)
        pieces_.pop_back();
    pieces_.push_back(piece);
}

void EmulatedMotor::cut(Time now)
{
    while (pieces_.size() > 1 && pieces_.back().from > now)
        pieces_.pop_back();
    while (pieces_.size() > 1 && pieces_[1].from < now - kRemembered)
        pieces_.pop_front();
}

}  // namespace planewright
