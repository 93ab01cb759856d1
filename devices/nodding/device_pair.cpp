// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/device_pair.h"

#include <utility>

namespace planewright {

namespace {

constexpr std::chrono::milliseconds kSampleWait{100};

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
        const std::string& serial = (*laser)->identity().serial;
        if (!serial_.empty() && serial != serial_)
            return fail(ErrorCode::NoDevice, "laser: number " + serial +
                                                 " answers where the scan was begun with number " + serial_ +
                                                 "; connect that one, or finish this scan");
        serial_ = serial;
        const std::scoped_lock lock{mutex_};
        laser_ = std::move(*laser);
    }
    if (!unit_) {
        Result<std::unique_ptr<TiltUnit>> unit = devices_.openTiltUnit(stop);
        if (!unit)
            return tl::unexpected{unit.error()};
        const std::scoped_lock lock{mutex_};
        unit_ = std::move(*unit);
    }
    return {};
}

Result<void> DevicePair::startLaser(const LaserBeams& beams, const std::stop_token& stop)
{
    if (isScanning_)
        return {};
    const Result<void> started = laser_->start(beams, stop);
    isScanning_ = started.has_value();
    return started;
}

void DevicePair::stopLaser()
{
    if (std::exchange(isScanning_, false) && laser_)
        static_cast<void>(laser_->stop());
}

Result<void> DevicePair::hear(const std::stop_token& stop)
{
    const auto sample = unit_->sample(clock_.now() + kSampleWait, stop);
    if (!sample)
        return tl::unexpected{sample.error()};
    if (*sample)
        track_.add(**sample);
    while (isScanning_) {
        Result<std::optional<LaserScan>> scan = laser_->next(clock_.now(), stop);
        laserFailed_ = !scan;
        if (!scan)
            return tl::unexpected{scan.error()};
        if (!*scan)
            break;
        scans_.push_back(std::move(**scan));
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
}

void DevicePair::close()
{
    isScanning_ = false;
    forget();
    std::shared_ptr<Laser> laser;  // closed when the mutex is free again: that may take a while
    std::shared_ptr<TiltUnit> unit;
    const bool keepsUnit = std::exchange(laserFailed_, false);
    const std::scoped_lock lock{mutex_};
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
