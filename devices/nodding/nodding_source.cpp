// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/nodding_source.h"

#include <cmath>
#include <utility>

namespace planewright {

namespace {

using Seconds = std::chrono::duration<double>;

/// How often a held unit is asked where it is: its own watchdog wants to hear of somebody.
constexpr std::chrono::milliseconds kPauseTick{50};
constexpr int kMostAttempts = 2;
/// Without a slice for so long something is wrong with the links that neither driver has found.
constexpr std::chrono::seconds kMostSilence{5};

/// A motion that was refused since somebody has stopped it is no fault.
Result<void> unlessHeld(Result<void> moved)
{
    if (!moved && moved.error().code == ErrorCode::Interrupted)
        return {};
    return moved;
}

}  // namespace

Result<std::unique_ptr<NoddingSource>> NoddingSource::open(NoddingDevices devices, const ScanPlan& plan,
                                                           const Clock& clock, const std::stop_token& stop)
{
    std::unique_ptr<NoddingSource> scanner{new NoddingSource(std::move(devices), plan, clock)};
    if (const Result<void> opened = scanner->devices_.open(stop); !opened)
        return tl::unexpected{opened.error()};
    if (const Result<void> fitted = scanner->fit(); !fitted)
        return tl::unexpected{fitted.error()};
    return scanner;
}

NoddingSource::NoddingSource(NoddingDevices devices, const ScanPlan& plan, const Clock& clock)
    : devices_(std::move(devices), clock), plan_(plan), clock_(clock)
{
}

Result<void> NoddingSource::fit()
{
    const LaserLimits& limits = devices_.laser().limits();
    const LaserIdentity& identity = devices_.laser().identity();
    const Result<FittedPlan> fitted = fitPlan(plan_, limits, devices_.unit());
    if (!fitted)
        return tl::unexpected{fitted.error()};
    fitted_ = *fitted;

    description_.scanner = identity.model.empty() ? identity.product : identity.model;
    description_.firstBearing = fitted_.firstBearing;
    description_.bearingStep = fitted_.bearingStep;
    description_.beams = fitted_.beams;
    description_.rangeMin = limits.rangeMin;
    description_.rangeMax = limits.rangeMax;
    description_.pitchAxisOffset = plan_.pitchAxisOffset;
    description_.extra = {
        {"laser", identity.product + ", number " + identity.serial + ", firmware " + identity.firmware},
        {"tilt_unit", devices_.unit().identity()},
        {"scan_mode", plan_.mode == ScanPlan::Mode::Continuous ? "continuous" : "step and stare"}};
    return {};
}

Result<void> NoddingSource::begin(const std::stop_token& stop)
{
    {
        const std::scoped_lock lock{mutex_};
        paused_ = false;
        motionStopped_ = false;
    }
    isReady_ = false;
    attempts_ = 0;
    if (const Result<void> opened = devices_.open(stop); !opened)
        return fault(opened.error());
    TiltUnit& unit = devices_.unit();
    taker_ = SliceTaker(plan_, fitted_, devices_.laser().limits(),
                        {unit.identity(), unit.lowest(), unit.highest(), unit.resolution(), unit.fastest()});
    if (const Result<void> ready = getReady(stop); !ready)
        return fault(ready.error());
    return {};
}

Result<void> NoddingSource::getReady(const std::stop_token& stop)
{
    if (const Result<void> opened = devices_.open(stop); !opened)
        return opened;
    if (const Result<void> armed = arm(stop); !armed)
        return armed;
    if (const Result<void> started = devices_.startLaser(fitted_.steps, stop); !started)
        return started;
    devices_.forget();
    isAimed_ = false;
    if (const Result<void> travelled = travelTo(taker_.start(), stop); !travelled)
        return travelled;
    isReady_ = !stop.stop_requested() && !isPaused();
    return {};
}

/// A stop of motion that comes while it is armed must hold all the same: it is looked for again before anything moves.
Result<void> NoddingSource::arm(const std::stop_token& stop)
{
    if (const Result<void> armed = devices_.unit().arm(stop); !armed)
        return armed;
    return isPaused() ? devices_.hold() : Result<void>{};
}

Result<void> NoddingSource::travelTo(const SliceTaker::Aim& start, const std::stop_token& stop)
{
    if (isPaused())
        return {};
    if (const Result<void> moved = unlessHeld(devices_.unit().moveTo(start.pitch, start.speed)); !moved)
        return moved;
    const Time from = clock_.now();
    std::optional<Time> until;
    while (!stop.stop_requested() && !isPaused()) {
        if (const Result<void> heard = devices_.hear(stop); !heard)
            return heard;
        while (devices_.takeScan()) {
        }
        const TiltTrack& track = devices_.track();
        if (taker_.restsSince(start.pitch, track))
            return {};
        if (!until && !track.isEmpty()) {
            const Seconds most{3.0 * std::abs(track.last().pitch - start.pitch) / start.speed + 0.5};
            until = from + std::chrono::round<Time>(most);
        }
        if (until && clock_.now() > *until)
            return fail(ErrorCode::DeviceLost, devices_.unit().identity() +
                                                   ": the head does not reach the angle at which the scan begins; look "
                                                   "whether something blocks it, and whether its power is on");
    }
    return devices_.hold();
}

/// Sends the unit to where it has to go now.
Result<void> NoddingSource::aim()
{
    const SliceTaker::Aim goal = taker_.goal();
    const Result<void> moved = devices_.unit().moveTo(goal.pitch, goal.speed);
    if (!moved)
        return unlessHeld(moved);
    taker_.aimed(clock_.now());
    isAimed_ = true;
    heardAt_ = clock_.now();
    return {};
}

Result<std::optional<ScanSlice>> NoddingSource::next(const std::stop_token& stop)
{
    while (!taker_.isDone() && !stop.stop_requested()) {
        Result<void> done;
        // A pause that is over already has held the head all the same.
        if (pauses() != seenPauses_) {
            seenPauses_ = pauses();
            isReady_ = false;
        } else if (isPaused()) {
            waitWhilePaused(stop);
        } else if (!isReady_) {
            done = getReady(stop);
        } else if (!isAimed_) {
            done = aim();
        } else if (done = devices_.hear(stop); done) {
            Result<std::optional<ScanSlice>> slice = takeSlice();
            if (slice && *slice)
                return slice;
            if (!slice)
                done = tl::unexpected{slice.error()};
            else if (isReady_)
                done = watchMotion();
        }
        if (!done)
            return fault(done.error());
    }
    devices_.stopLaser();  // nobody listens any more
    return std::nullopt;
}

/// The first slice that the scans heard so far give.
Result<std::optional<ScanSlice>> NoddingSource::takeSlice()
{
    while (std::optional<LaserScan> scan = devices_.takeScan()) {
        Result<std::optional<ScanSlice>> slice = taker_.take(std::move(*scan), devices_.track());
        if (!slice)
            return slice;
        if (taker_.mustGoBack()) {
            taker_.resume();
            isReady_ = false;
            return std::nullopt;
        }
        if (!*slice)
            continue;
        largestSkew_ = taker_.largestSkew().count();
        heardAt_ = clock_.now();
        attempts_ = 0;
        // The head goes on while this slice is worked on.
        if (taker_.aimsForEach() && !taker_.isDone()) {
            if (const Result<void> aimed = aim(); !aimed)
                return tl::unexpected{aimed.error()};
        }
        return slice;
    }
    return std::nullopt;
}

/// Errors (DeviceLost): the head does not get where it should. One at rest may have missed a command: it is told twice.
Result<void> NoddingSource::watchMotion()
{
    if (clock_.now() - heardAt_ > kMostSilence)
        return fail(ErrorCode::DeviceLost,
                    name() +
                        ": no slice that can be used has come for 5 s; look at the cables, and at "
                        "what the devices say of themselves");
    if (taker_.getsOn(devices_.track(), clock_.now()))
        return {};
    if (taker_.aimsForEach() && ++attempts_ < kMostAttempts)
        return aim();
    return fail(ErrorCode::DeviceLost, devices_.unit().identity() +
                                           ": the head has not moved for 0.3 s; look whether "
                                           "something blocks it, and whether its power is on");
}

/// While it waits, the unit is asked where it is, and what the laser sends is passed over.
void NoddingSource::waitWhilePaused(const std::stop_token& stop)
{
    for (;;) {
        bool stopsLaser = false;
        {
            std::unique_lock lock{mutex_};
            if (!paused_ || stop.stop_requested())
                return;
            clock_.wait(lock, asked_, stop, clock_.now() + kPauseTick);
            stopsLaser = motionStopped_;
        }
        if (stopsLaser)
            devices_.stopLaser();
        // What fails here fails again, and is told, when the scan goes on.
        if (devices_.isOpen())
            static_cast<void>(devices_.hear(stop));
        devices_.forget();
    }
}

bool NoddingSource::isPaused() const
{
    const std::scoped_lock lock{mutex_};
    return paused_;
}

int NoddingSource::pauses() const
{
    const std::scoped_lock lock{mutex_};
    return pauses_;
}

/// Holds the head. A device that is gone is opened anew when the scan goes on.
tl::unexpected<Error> NoddingSource::fault(Error error)
{
    static_cast<void>(devices_.stop());
    if (error.code == ErrorCode::DeviceLost)
        devices_.close();
    devices_.forget();
    isReady_ = false;
    attempts_ = 0;
    taker_.resume();
    return tl::unexpected{std::move(error)};
}

Result<void> NoddingSource::pause()
{
    {
        const std::scoped_lock lock{mutex_};
        paused_ = true;
        ++pauses_;
        asked_.notify_all();
    }
    return devices_.hold();
}

Result<void> NoddingSource::resume()
{
    const std::scoped_lock lock{mutex_};
    paused_ = false;
    motionStopped_ = false;
    asked_.notify_all();
    return {};
}

Result<void> NoddingSource::stopMotion()
{
    {
        const std::scoped_lock lock{mutex_};
        motionStopped_ = true;
    }
    return pause();
}

NoddingHealth NoddingSource::deviceHealth() const
{
    return {devices_.laserHealth(), devices_.tiltHealth(), devices_.motor(), Time{largestSkew_}};
}

std::vector<HealthFact> NoddingSource::health() const
{
    return factsOf(deviceHealth());
}

}  // namespace planewright
