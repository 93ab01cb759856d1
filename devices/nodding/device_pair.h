// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "devices/clock.h"
#include "devices/laser.h"
#include "devices/nodding/tilt_track.h"
#include "devices/tilt_unit.h"

namespace planewright {

/// How the devices of a nodding scanner are opened, the first time and after each time that one was lost: found, opened
/// and connected.
struct NoddingDevices {
    std::function<Result<std::unique_ptr<Laser>>(const std::stop_token&)> openLaser;
    std::function<Result<std::unique_ptr<TiltUnit>>(const std::stop_token&)> openTiltUnit;
    /// What went wrong beside the devices since it was last asked; may be empty. Any thread.
    std::function<std::vector<FaultRecord>()> takeLog = {};
};

/// A laser and a tilt unit, and what both have said lately. One thread calls it; hold() and the health functions may be
/// called by any.
class DevicePair {
public:
    using Time = std::chrono::nanoseconds;

    DevicePair(NoddingDevices devices, const Clock& clock);
    /// Stops the unit and ends the laser's stream.
    ~DevicePair();
    DevicePair(const DevicePair&) = delete;
    DevicePair& operator=(const DevicePair&) = delete;

    /// Opens what is not open. Errors: those of the devices; NeedsOperator where another device answers than the first
    /// time, or one that has changed, with what is different.
    Result<void> open(const std::stop_token& stop);
    bool isOpen() const { return laser_ && unit_; }
    Laser& laser() { return *laser_; }
    TiltUnit& unit() { return *unit_; }

    /// The laser streams these steps from now on, if it does not yet.
    Result<void> startLaser(const LaserBeams& beams, const std::stop_token& stop);
    void stopLaser();
    /// When the last scan was heard; empty since startLaser() or forget().
    std::optional<Time> lastScanAt() const { return lastScanAt_; }

    /// Waits for the next angle, and takes the scans that have come meanwhile. Of scans that nobody takes the oldest
    /// are thrown away.
    Result<void> hear(const std::stop_token& stop);
    /// Waits for a scan alone, for a short time: the unit need not be able to say anything. Not while it is armed.
    Result<void> hearLaser(const std::stop_token& stop);
    const TiltTrack& track() const { return track_; }
    /// The oldest scan heard, once angles to both sides of all of its beams are there.
    std::optional<LaserScan> takeScan();
    /// Forgets what was heard.
    void forget();

    /// Between scans: asks the unit how it is and looks whether the laser is still there, in less than a tenth of a
    /// second, and opens anew what was lost. Moves nothing; the laser is asked nothing. What is wrong is told by
    /// trouble(), until it is over.
    void lookAfter(const std::stop_token& stop);
    /// Empty, or what was wrong when they were looked after last.
    std::string trouble() const;

    /// Closes what has failed, as far as that is known, or else both: open() begins anew with it.
    void close();

    /// Brings the unit to rest in order. Nothing to do where none is open.
    Result<void> stop();
    /// Stops motion within one round trip. Nothing to do where no unit is open.
    Result<void> hold();
    LinkHealth laserHealth() const;
    LinkHealth tiltHealth() const;
    /// What went wrong with both since this was last asked, oldest first, also with one that was closed since.
    std::vector<FaultRecord> takeLog();
    MotorState motor() const;

private:
    /// What a laser or a unit is, for a scan that goes on with it.
    struct LaserKind {
        LaserIdentity identity;
        LaserLimits limits;
    };
    struct UnitKind {
        std::string identity;
        double lowest = 0.0;
        double highest = 0.0;
        double resolution = 0.0;
    };

    Result<void> look(const std::stop_token& stop);
    Result<void> takeScans(Time deadline, const std::stop_token& stop);
    Result<void> checkSame(const Laser& laser) const;
    Result<void> checkSame(const TiltUnit& unit) const;
    std::shared_ptr<Laser> sharedLaser() const;
    std::shared_ptr<TiltUnit> sharedUnit() const;
    void keepLogs();

    NoddingDevices devices_;
    const Clock& clock_;
    mutable std::mutex mutex_;  ///< of the two pointers, records and trouble, where other threads read them
    std::shared_ptr<Laser> laser_;
    std::shared_ptr<TiltUnit> unit_;
    std::vector<FaultRecord> records_;  ///< that nobody has taken, of devices that were closed
    std::string trouble_;               ///< between scans
    std::optional<LaserKind> firstLaser_;
    std::optional<UnitKind> firstUnit_;
    bool isScanning_ = false;
    bool laserFailed_ = false;  ///< rather than the unit
    TiltTrack track_;
    std::deque<LaserScan> scans_;
    std::optional<Time> lastScanAt_;
};

}  // namespace planewright
