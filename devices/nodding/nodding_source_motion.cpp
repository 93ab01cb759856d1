// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// How the head is armed and brought to where a scan begins, or home.

#include <cmath>
#include <utility>

#include "devices/nodding/nodding_source.h"

namespace planewright {

namespace {

using Seconds = std::chrono::duration<double>;

/// A driver that neither gives an angle nor an error for so long has not found what is wrong.
constexpr std::chrono::seconds kFirstAngle{2};
/// A head that creeps home looks like one at rest for a moment.
constexpr std::chrono::milliseconds kRestAtHome{100};

/// Whether a unit has started since the moment at which it had started when it was armed: its clock may be wrong by 1
/// %, and its answer late.
bool hasStartedAnew(std::chrono::nanoseconds before, std::chrono::nanoseconds now, std::chrono::nanoseconds clock)
{
    constexpr std::chrono::milliseconds kLate{200};
    return now - before > (clock - before) / 100 + kLate;
}

}  // namespace

/// A stop of motion that comes while it is armed must hold all the same: it is looked for again before anything moves.
Result<void> NoddingSource::arm(const std::stop_token& stop)
{
    if (isArmed_ || isHeld() || stop.stop_requested())
        return {};
    if (const Result<void> powered = mindPower(); !powered)
        return powered;
    TiltUnit& unit = devices_.unit();
    Result<void> armed = unit.arm(stop);
    if (!armed && armed.error().code == ErrorCode::NeedsOperator && takePermission()) {
        if (const Result<void> recovered = unit.recover(stop); !recovered)
            return recovered;
        armed = unit.arm(stop);
    }
    if (!armed)
        return armed;
    isArmed_ = true;
    hasHeld_ = true;
    startedAt_ = unit.startedAt();
    return isHeld() ? rest() : Result<void>{};
}

/// A motor that held, and has no torque now, was without power, and so was a unit that has started anew: the head may
/// have sunk, and somebody may have his hands at it.
Result<void> NoddingSource::mindPower()
{
    const TiltUnit& unit = devices_.unit();
    const std::optional<Time> startedAt = unit.startedAt();
    const bool isAnew = startedAt_ && startedAt && hasStartedAnew(*startedAt_, *startedAt, clock_.now());
    if (!hasHeld_ || (unit.holdsItself() && !isAnew))
        return {};
    mustGoHome_ = true;
    if (hasPermission())
        return {};
    const std::string what = isAnew
                                 ? ": it has lost its power, or was reset: the head may have sunk"
                                 : ": it has lost its power: it does not hold the head any more, which may have sunk";
    return fail(ErrorCode::NeedsOperator, unit.identity() + what +
                                              ". Check its supply and keep your hands away; the head then goes to "
                                              "level first, slowly");
}

Result<void> NoddingSource::travelHome(const std::stop_token& stop)
{
    if (isHeld() || stop.stop_requested())
        return {};
    TiltUnit& unit = devices_.unit();
    if (const Result<void> moved = unit.goHome(); !moved)
        return moved;
    const Result<void> arrived = arrive({unit.nearestPitch(unit.home()), unit.homeSpeed()}, kRestAtHome, stop);
    mustGoHome_ = mustGoHome_ && (!arrived || isHeld() || stop.stop_requested());
    return arrived;
}

Result<void> NoddingSource::travelTo(const SliceTaker::Aim& start, const std::stop_token& stop)
{
    if (isHeld() || stop.stop_requested())
        return {};
    if (const Result<void> moved = devices_.unit().moveTo(start.pitch, start.speed); !moved)
        return moved;
    return arrive(start, Time{0}, stop);
}

/// Waits for the head to rest where it was sent, and for so long. Where somebody is quicker it comes to rest elsewhere.
Result<void> NoddingSource::arrive(const SliceTaker::Aim& there, Time resting, const std::stop_token& stop)
{
    const Time from = clock_.now();
    Time until = from + kFirstAngle;
    for (bool isHeard = false; !stop.stop_requested() && !isHeld();) {
        if (const Result<void> heard = devices_.hear(stop); !heard)
            return heard;
        while (devices_.takeScan()) {
        }
        const TiltTrack& track = devices_.track();
        if (const auto since = taker_.restsSince(there.pitch, track); since && track.last().at >= *since + resting)
            return {};
        if (!isHeard && !track.isEmpty()) {
            isHeard = true;
            const Seconds most{3.0 * std::abs(track.last().pitch - there.pitch) / there.speed + 0.5};
            until = from + std::chrono::round<Time>(most);
        }
        if (clock_.now() <= until)
            continue;
        const std::string unit = devices_.unit().identity();
        return isHeard ? fail(ErrorCode::NeedsOperator,
                              unit +
                                  ": the head does not reach the angle that it was sent to; look whether "
                                  "something blocks it, and whether its power is on")
                       : fail(ErrorCode::DeviceLost,
                              unit +
                                  ": no angle that can be used has come for 2 s; look at its cable, and at what "
                                  "else the machine is busy with");
    }
    return rest();
}

void NoddingSource::lookAfter(const std::stop_token& stop)
{
    devices_.lookAfter(stop);
}

Result<std::optional<double>> NoddingSource::goHome(const std::stop_token& stop)
{
    if (isMotionStopped())
        return fail(ErrorCode::NeedsOperator,
                    name() + ": motion was stopped; release it before the head goes to level");
    {
        const std::scoped_lock lock{mutex_};
        paused_ = false;
        seenPauses_ = pauses_;
    }
    Result<std::optional<double>> home = comeHome(stop);
    if (!home)
        return fault(home.error());
    static_cast<void>(takePermission());
    return home;
}

Result<std::optional<double>> NoddingSource::comeHome(const std::stop_token& stop)
{
    Result<void> done = devices_.open(stop);
    if (done)
        done = arm(stop);
    devices_.forget();
    if (done)
        done = travelHome(stop);
    const bool isThere = done && !isHeld() && !stop.stop_requested();
    const double there = isThere ? devices_.track().last().pitch : 0.0;
    if (const Result<void> rested = rest(); done)
        done = rested;
    if (!done)
        return tl::unexpected{done.error()};
    if (!isThere)
        return fail(ErrorCode::Interrupted, name() + ": stopped on the way to level; the head is held where it is");
    return there;
}

}  // namespace planewright
