// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// How the head is armed and brought to where a scan begins, or home, and what is done where it does not get on.

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/types/angle_text.h"
#include "devices/nodding/nodding_source.h"

namespace planewright {

namespace {

using Seconds = std::chrono::duration<double>;

/// A driver that neither gives an angle nor an error for so long has not found what is wrong.
constexpr std::chrono::seconds kFirstAngle{2};
/// A head that creeps home looks like one at rest for a moment.
constexpr std::chrono::milliseconds kRestAtHome{100};

/// How often the head is sent to a slice: it may have missed a command, or was held for a moment.
constexpr int kMostAttempts = 2;
/// The head does not go on while the laser sends nothing for so many turns of its mirror.
constexpr int kMostSilentTurns = 10;
constexpr int kMostSilences = 3;
/// Nor while its angle is not known: what it passes over meanwhile is lost. A driver that knows why says so sooner.
constexpr std::chrono::milliseconds kMostTimeWithoutAngle{500};
/// A driver tells a head that does not move once more after 300 ms, and knows after 300 ms more that it is stuck.
constexpr Seconds kLateArrival{1.0};

/// ": what a device says of itself", or what to look at where it says nothing.
std::string because(const std::string& trouble, const char* otherwise)
{
    return trouble.empty() ? std::string{"; "} + otherwise : ": " + trouble;
}

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
            const Seconds most{3.0 * std::abs(track.last().pitch - there.pitch) / there.speed};
            until = from + std::chrono::round<Time>(most + kLateArrival);
        }
        if (clock_.now() <= until)
            continue;
        if (track.isFresh(clock_.now()))
            return blocked("the head does not reach the angle that it was sent to");
        return noAngles(track.isEmpty() ? from : track.last().at);
    }
    return rest();
}

/// Errors (NeedsOperator): the head does not get where it should, and one at rest was told twice, since it may have
/// missed a command; DeviceLost: nothing that can be used comes.
Result<void> NoddingSource::watchMotion()
{
    const Time now = clock_.now();
    const Time silent = now - devices_.lastScanAt().value_or(heardAt_);
    if (silent > kMostSilentTurns * devices_.laser().limits().period && ++silences_ <= kMostSilences)
        return rest();
    if (silences_ > kMostSilences)
        return fail(ErrorCode::DeviceLost,
                    name() + ": no scan that can be used has come for a while" +
                        because(devices_.laserHealth().trouble, "look at its cable, and at what it says of itself"));
    const TiltTrack& track = devices_.track();
    const Time known = track.isEmpty() ? heardAt_ : std::max(heardAt_, track.last().at);
    if (now - known > kMostTimeWithoutAngle)
        return noAngles(known);
    if (now - heardAt_ > taker_.patience())
        return noSlices(now - heardAt_);
    if (taker_.getsOn(track, now))
        return {};
    if (taker_.aimsForEach() && ++attempts_ < kMostAttempts)
        return aim();
    return blocked("the head has not moved for " + fixedText(Seconds(taker_.stuckAfter()).count(), 1) + " s");
}

/// A head that was not where a sweep should have brought it is sent to the missing slice once more: something may have
/// held it for a moment. Gives no slice, or the error.
Result<std::optional<ScanSlice>> NoddingSource::tryAgain(const Error& error)
{
    if (error.code != ErrorCode::NeedsOperator || taker_.aimsForEach() || ++attempts_ >= kMostAttempts)
        return tl::unexpected{Error{error.code, error.message + " (" + motorText(devices_.motor()) + ")"}};
    taker_.resume();
    isReady_ = false;
    return std::nullopt;
}

/// The head stands where it should not, with what its motor says.
tl::unexpected<Error> NoddingSource::blocked(const std::string& what)
{
    return fail(ErrorCode::NeedsOperator, devices_.unit().identity() + ": " + what + " (" +
                                              motorText(devices_.motor()) +
                                              "); look whether something blocks it, and whether its power is on");
}

/// Angles and scans come, and give no slice: of the device that says of itself why.
tl::unexpected<Error> NoddingSource::noSlices(Time since)
{
    const std::string ofUnit = devices_.tiltHealth().trouble;
    const std::string trouble = ofUnit.empty() ? devices_.laserHealth().trouble : ofUnit;
    return fail(ErrorCode::DeviceLost,
                (ofUnit.empty() ? name() : devices_.unit().identity()) + ": no slice that can be used has come for " +
                    fixedText(Seconds(since).count(), 1) + " s" +
                    because(trouble, "look at the cables, and at what the devices say of themselves"));
}

/// Where the head is, nobody knows: no standstill, and no block.
tl::unexpected<Error> NoddingSource::noAngles(Time since)
{
    return fail(ErrorCode::DeviceLost, devices_.unit().identity() + ": no angle that can be used has come for " +
                                           fixedText(Seconds(clock_.now() - since).count(), 1) + " s" +
                                           because(devices_.tiltHealth().trouble,
                                                   "look at its cable, and at what else the machine is busy with"));
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
