// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/nodding_source.h"

#include <cmath>
#include <utility>

namespace planewright {

namespace {

/// How often a held unit is asked where it is.
constexpr std::chrono::milliseconds kPauseTick{50};
/// A driver that neither gives a scan nor an error for so long has not found what is wrong.
constexpr std::chrono::seconds kFirstScan{5};

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
    taker_ = newTaker();

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

/// Nothing that a stop or a hold has ended early is an error.
Result<void> NoddingSource::begin(const std::stop_token& stop)
{
    {
        const std::scoped_lock lock{mutex_};
        paused_ = false;
        seenPauses_ = pauses_;
    }
    if (isMotionStopped() && stop.stop_requested())
        return {};
    if (isMotionStopped())
        return fail(ErrorCode::NeedsOperator, name() + ": motion was stopped; release it before a scan begins");
    isNew_ = true;
    isReady_ = false;
    attempts_ = 0;
    silences_ = 0;
    const Result<void> ready = getReady(stop);
    if (!ready && ready.error().code == ErrorCode::Interrupted && (stop.stop_requested() || isHeld()))
        return {};
    if (!ready)
        return fault(ready.error());
    return {};
}

SliceTaker NoddingSource::newTaker()
{
    const TiltUnit& unit = devices_.unit();
    return {plan_,
            fitted_,
            devices_.laser().limits(),
            {unit.identity(), unit.lowest(), unit.highest(), unit.resolution(), unit.fastest(), unit.tolerance()}};
}

/// The laser comes first: a unit that is armed has to be heard of at short intervals, and a laser that is slow to start
/// leaves no time for that.
Result<void> NoddingSource::getReady(const std::stop_token& stop)
{
    if (const Result<void> opened = devices_.open(stop); !opened)
        return opened;
    if (std::exchange(isNew_, false)) {
        taker_ = newTaker();
        slicesLost_ = 0;
    }
    if (const Result<void> started = devices_.startLaser(fitted_.steps, stop); !started)
        return started;
    devices_.forget();
    isAimed_ = false;
    if (const Result<void> scanned = awaitScan(stop); !scanned)
        return scanned;
    if (const Result<void> armed = arm(stop); !armed)
        return armed;
    if (const Result<void> home = mustGoHome_ ? travelHome(stop) : Result<void>{}; !home)
        return home;
    if (const Result<void> travelled = travelTo(taker_.start(), stop); !travelled)
        return travelled;
    isReady_ = !stop.stop_requested() && !isHeld();
    if (isReady_)
        static_cast<void>(takePermission());  // it was for what is over now
    return {};
}

/// Nothing moves for a laser that sends nothing.
Result<void> NoddingSource::awaitScan(const std::stop_token& stop)
{
    const Time until = clock_.now() + kFirstScan;
    while (!devices_.lastScanAt() && !stop.stop_requested() && !isHeld()) {
        const Result<void> heard = isArmed_ ? devices_.hear(stop) : devices_.hearLaser(stop);
        if (!heard)
            return heard;
        if (clock_.now() > until)
            return fail(ErrorCode::DeviceLost, name() + ": the laser sends no scans; look at its cable and its supply");
    }
    return {};
}

/// Sends the unit to where it has to go now.
Result<void> NoddingSource::aim()
{
    const SliceTaker::Aim goal = taker_.goal();
    if (const Result<void> moved = devices_.unit().moveTo(goal.pitch, goal.speed); !moved)
        return moved;
    taker_.aimed(clock_.now());
    isAimed_ = true;
    heardAt_ = clock_.now();
    return {};
}

Result<std::optional<ScanSlice>> NoddingSource::next(const std::stop_token& stop)
{
    while (!taker_.isDone() && !stop.stop_requested()) {
        Result<std::optional<ScanSlice>> slice = goOn(stop);
        if (slice && *slice)
            return slice;
        if (slice)
            continue;
        if (slice.error().code != ErrorCode::Interrupted || !(stop.stop_requested() || isHeld()))
            return fault(slice.error());
        isReady_ = false;  // somebody was quicker: it goes on from there
    }
    slicesLost_ = taker_.lost();
    isReady_ = false;
    devices_.stopLaser();  // nobody listens any more
    return std::nullopt;
}

Result<std::optional<ScanSlice>> NoddingSource::goOn(const std::stop_token& stop)
{
    Result<void> done;
    // A pause that is over already has to bring the head to rest all the same.
    if (pauses() != seenPauses_) {
        seenPauses_ = pauses();
        done = rest();
    } else if (isHeld()) {
        done = waitWhileHeld(stop);
    } else if (!isReady_) {
        done = getReady(stop);
    } else if (!isAimed_) {
        done = aim();
    } else if (done = devices_.hear(stop); done) {
        Result<std::optional<ScanSlice>> slice = takeSlice();
        if (!slice || *slice)
            return slice;
        if (isReady_)
            done = watchMotion();
    }
    if (!done)
        return tl::unexpected{done.error()};
    return std::nullopt;
}

/// The first slice that the scans heard so far give.
Result<std::optional<ScanSlice>> NoddingSource::takeSlice()
{
    while (std::optional<LaserScan> scan = devices_.takeScan()) {
        Result<std::optional<ScanSlice>> slice = taker_.take(std::move(*scan), devices_.track());
        if (!slice)
            return tryAgain(slice.error());
        if (taker_.mustGoBack()) {
            taker_.resume();
            isReady_ = false;
            return std::nullopt;
        }
        if (!*slice)
            continue;
        largestSkew_ = taker_.largestSkew().count();
        slicesLost_ = taker_.lost();
        heardAt_ = clock_.now();
        attempts_ = (*slice)->angleSuspect ? attempts_ : 0;
        silences_ = 0;
        // The head goes on while this slice is worked on.
        if (taker_.aimsForEach() && !taker_.isDone()) {
            if (const Result<void> aimed = aim(); !aimed && aimed.error().code != ErrorCode::Interrupted)
                return tl::unexpected{aimed.error()};
        }
        return slice;
    }
    return std::nullopt;
}

/// While it waits, the devices are listened to, and opened anew where one was lost; what the laser sends is passed
/// over. Errors: those of the devices.
Result<void> NoddingSource::waitWhileHeld(const std::stop_token& stop)
{
    {
        std::unique_lock lock{mutex_};
        clock_.wait(lock, asked_, stop, clock_.now() + kPauseTick);
    }
    if (isMotionStopped())
        devices_.stopLaser();
    Result<void> done = devices_.open(stop);
    if (done)
        done = devices_.hear(stop);
    devices_.forget();
    return done;
}

/// The head comes to rest; before anything else it has to be armed. One that was stopped in an emergency is left alone.
Result<void> NoddingSource::rest()
{
    isArmed_ = false;
    isReady_ = false;
    return isMotionStopped() ? Result<void>{} : devices_.stop();
}

Result<void> NoddingSource::end()
{
    const Result<void> rested = rest();
    devices_.stopLaser();
    return rested;
}

/// The head comes to rest, and the laser falls silent. A device that is gone is opened anew when the scan goes on.
tl::unexpected<Error> NoddingSource::fault(Error error)
{
    static_cast<void>(rest());
    static_cast<void>(takePermission());
    if (error.code == ErrorCode::DeviceLost)
        devices_.close();
    devices_.stopLaser();
    devices_.forget();
    attempts_ = 0;
    silences_ = 0;
    taker_.resume();
    return tl::unexpected{std::move(error)};
}

}  // namespace planewright
