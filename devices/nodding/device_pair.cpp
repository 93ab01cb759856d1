// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/device_pair.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <locale>
#include <sstream>
#include <utility>

namespace planewright {

namespace {

constexpr std::chrono::milliseconds kSampleWait{100};
/// Scans that wait for their angles: five seconds of a quick laser.
constexpr std::size_t kMostScans = 200;

bool isSame(double a, double b)
{
    return std::abs(a - b) < 1e-9;
}

bool isSame(const LaserLimits& a, const LaserLimits& b)
{
    return a.stepsPerTurn == b.stepsPerTurn && a.firstStep == b.firstStep && a.lastStep == b.lastStep &&
           a.frontStep == b.frontStep && a.period == b.period && isSame(a.rangeMin, b.rangeMin) &&
           isSame(a.rangeMax, b.rangeMax);
}

/// "steps 0 to 1080 of 1440, front 540, 0.023 to 60 m, 25 ms a turn".
std::string textOf(const LaserLimits& limits)
{
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << "steps " << limits.firstStep << " to " << limits.lastStep << " of " << limits.stepsPerTurn << ", front "
         << limits.frontStep << ", " << limits.rangeMin << " to " << limits.rangeMax << " m, "
         << std::chrono::duration<double, std::milli>(limits.period).count() << " ms a turn";
    return text.str();
}

tl::unexpected<Error> changed(const std::string& device, const std::string& now, const std::string& before)
{
    return fail(ErrorCode::NeedsOperator, device + ": " + now + " answers where the scan was begun with " + before +
                                              "; connect that one again, or finish this scan and connect anew");
}

}  // namespace

DevicePair::DevicePair(NoddingDevices devices, const Clock& clock) : devices_(std::move(devices)), clock_(clock) {}

/// Where that fails there is nobody left to tell.
DevicePair::~DevicePair()
{
    static_cast<void>(stop());
    stopLaser();
}

Result<void> DevicePair::open(const std::stop_token& stop)
{
    if (!laser_) {
        Result<std::unique_ptr<Laser>> laser = devices_.openLaser(stop);
        if (!laser)
            return tl::unexpected{laser.error()};
        if (const Result<void> same = checkSame(**laser); !same)
            return same;
        if (!firstLaser_)
            firstLaser_ = LaserKind{(*laser)->identity(), (*laser)->limits()};
        const std::scoped_lock lock{mutex_};
        laser_ = std::move(*laser);
    }
    if (!unit_) {
        Result<std::unique_ptr<TiltUnit>> unit = devices_.openTiltUnit(stop);
        if (!unit)
            return tl::unexpected{unit.error()};
        if (const Result<void> same = checkSame(**unit); !same)
            return same;
        if (!firstUnit_)
            firstUnit_ = UnitKind{(*unit)->identity(), (*unit)->lowest(), (*unit)->highest(), (*unit)->resolution()};
        const std::scoped_lock lock{mutex_};
        unit_ = std::move(*unit);
    }
    return {};
}

/// Errors (NeedsOperator): slices of this one would not be like those of the first.
Result<void> DevicePair::checkSame(const Laser& laser) const
{
    if (!firstLaser_)
        return {};
    const LaserIdentity& now = laser.identity();
    const LaserIdentity& before = firstLaser_->identity;
    if (now.serial != before.serial)
        return changed("laser", "number " + now.serial, "number " + before.serial);
    if (now.model != before.model || now.product != before.product)
        return changed("laser", now.product + " (" + now.model + ")", before.product + " (" + before.model + ")");
    if (!isSame(laser.limits(), firstLaser_->limits))
        return changed("laser", "one with " + textOf(laser.limits()), textOf(firstLaser_->limits));
    return {};
}

Result<void> DevicePair::checkSame(const TiltUnit& unit) const
{
    if (!firstUnit_)
        return {};
    if (unit.identity() != firstUnit_->identity)
        return changed("tilt unit", unit.identity(), firstUnit_->identity);
    if (!isSame(unit.lowest(), firstUnit_->lowest) || !isSame(unit.highest(), firstUnit_->highest) ||
        !isSame(unit.resolution(), firstUnit_->resolution))
        return changed("tilt unit", unit.identity() + " with other limits", "other ones");
    return {};
}

Result<void> DevicePair::startLaser(const LaserBeams& beams, const std::stop_token& stop)
{
    if (isScanning_)
        return {};
    {
        const std::scoped_lock lock{mutex_};
        trouble_.clear();
    }
    const Result<void> started = laser_->start(beams, stop);
    isScanning_ = started.has_value();
    laserFailed_ = !started;
    lastScanAt_.reset();
    return started;
}

void DevicePair::stopLaser()
{
    if (std::exchange(isScanning_, false) && laser_)
        static_cast<void>(laser_->stop());
}

Result<void> DevicePair::hear(const std::stop_token& stop)
{
    laserFailed_ = false;
    const auto sample = unit_->sample(clock_.now() + kSampleWait, stop);
    if (!sample)
        return tl::unexpected{sample.error()};
    if (*sample)
        track_.add(**sample);
    return takeScans(clock_.now(), stop);
}

Result<void> DevicePair::hearLaser(const std::stop_token& stop)
{
    return takeScans(clock_.now() + kSampleWait, stop);
}

/// The first by a moment, and what else is there.
Result<void> DevicePair::takeScans(Time deadline, const std::stop_token& stop)
{
    for (Time until = deadline; isScanning_; until = clock_.now()) {
        Result<std::optional<LaserScan>> scan = laser_->next(until, stop);
        laserFailed_ = !scan;
        if (!scan)
            return tl::unexpected{scan.error()};
        if (!*scan)
            break;
        lastScanAt_ = clock_.now();
        scans_.push_back(std::move(**scan));
        if (scans_.size() > kMostScans)
            scans_.pop_front();
    }
    return {};
}

std::optional<LaserScan> DevicePair::takeScan()
{
    if (scans_.empty() || track_.isEmpty() || track_.last().at < scans_.front().last)
        return std::nullopt;
    LaserScan scan = std::move(scans_.front());
    scans_.pop_front();
    return scan;
}

void DevicePair::forget()
{
    track_.clear();
    scans_.clear();
    lastScanAt_.reset();
}

void DevicePair::lookAfter(const std::stop_token& stop)
{
    const Result<void> looked = look(stop);
    if (stop.stop_requested())
        return;
    if (!looked && looked.error().code == ErrorCode::DeviceLost)
        close();
    const std::scoped_lock lock{mutex_};
    trouble_ = looked ? std::string{} : looked.error().message;
}

/// What the unit has said since it was looked after last is passed over, up to an angle of now.
Result<void> DevicePair::look(const std::stop_token& stop)
{
    if (const Result<void> opened = open(stop); !opened)
        return opened;
    laserFailed_ = false;
    const Time begun = clock_.now();
    Result<std::optional<TiltSample>> sample;
    do {
        sample = unit_->sample(begun + kSampleWait, stop);
        if (!sample)
            return tl::unexpected{sample.error()};
    } while (*sample && (*sample)->at < begun && clock_.now() < begun + kSampleWait);
    const Result<void> there = isScanning_ ? Result<void>{} : laser_->lookAfter();
    laserFailed_ = !there;
    return there;
}

std::string DevicePair::trouble() const
{
    const std::scoped_lock lock{mutex_};
    return trouble_;
}

void DevicePair::close()
{
    isScanning_ = false;
    forget();
    std::shared_ptr<Laser> laser;  // closed when the mutex is free again: that may take a while
    std::shared_ptr<TiltUnit> unit;
    const bool keepsUnit = std::exchange(laserFailed_, false);
    const std::scoped_lock lock{mutex_};
    keepLogs();
    laser.swap(laser_);
    if (!keepsUnit)
        unit.swap(unit_);
}

Result<void> DevicePair::stop()
{
    const std::shared_ptr<TiltUnit> unit = sharedUnit();
    return unit ? unit->stop() : Result<void>{};
}

Result<void> DevicePair::hold()
{
    const std::shared_ptr<TiltUnit> unit = sharedUnit();
    return unit ? unit->hold() : Result<void>{};
}

LinkHealth DevicePair::laserHealth() const
{
    const std::shared_ptr<Laser> laser = sharedLaser();
    return laser ? laser->health() : LinkHealth{};
}

LinkHealth DevicePair::tiltHealth() const
{
    const std::shared_ptr<TiltUnit> unit = sharedUnit();
    return unit ? unit->health() : LinkHealth{};
}

/// Takes the records of both devices; the oldest of too many are forgotten. Under the mutex.
void DevicePair::keepLogs()
{
    constexpr std::size_t kMost = 2 * FaultLog::kMostRecords;
    const auto keep = [this](std::vector<FaultRecord> log) { std::ranges::move(log, std::back_inserter(records_)); };
    if (laser_)
        keep(laser_->takeLog());
    if (unit_)
        keep(unit_->takeLog());
    if (devices_.takeLog)
        keep(devices_.takeLog());
    std::ranges::stable_sort(records_, {}, &FaultRecord::at);
    if (records_.size() > kMost)
        records_.erase(records_.begin(), records_.end() - kMost);
}

std::vector<FaultRecord> DevicePair::takeLog()
{
    const std::scoped_lock lock{mutex_};
    keepLogs();
    return std::exchange(records_, {});
}

MotorState DevicePair::motor() const
{
    const std::shared_ptr<TiltUnit> unit = sharedUnit();
    return unit ? unit->motor() : MotorState{};
}

std::shared_ptr<Laser> DevicePair::sharedLaser() const
{
    const std::scoped_lock lock{mutex_};
    return laser_;
}

std::shared_ptr<TiltUnit> DevicePair::sharedUnit() const
{
    const std::scoped_lock lock{mutex_};
    return unit_;
}

}  // namespace planewright
