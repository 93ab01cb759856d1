// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "devices/board/board_tilt.h"
#include "devices/dynamixel/dynamixel_tilt.h"
#include "devices/emulated/emulated_link.h"
#include "devices/emulated/emulated_rig.h"
#include "devices/nodding/nodding_source.h"
#include "devices/scip/scip_laser.h"
#include "tests/devices/fake_clock.h"

namespace planewright {

/// An emulated rig, its drivers and a clock that jumps: a nodding scanner whose hours take no time.
class EmulatedScanner {
public:
    explicit EmulatedScanner(const EmulatedRigSetup& setup) : setup_(setup), rig_(EmulatedRig::make(setup).value()) {}

    FakeClock& clock() { return clock_; }
    EmulatedRig& rig() { return *rig_; }

    /// What the host knows of how the unit is mounted: limits apart, what the rig is.
    TiltMounting mounting() const
    {
        TiltMounting mounting = setup_.mounting;
        mounting.lowest = degrees(0.0);
        mounting.highest = degrees(180.0);
        mounting.fastest = degrees(120.0);
        return mounting;
    }

    NoddingDevices devices()
    {
        return {[this](const std::stop_token& stop) { return openLaser(stop); },
                [this](const std::stop_token& stop) { return openTiltUnit(stop); }};
    }

    Result<std::unique_ptr<NoddingSource>> open(const ScanPlan& plan)
    {
        return NoddingSource::open(devices(), plan, clock_, {});
    }

    /// What is put between a device and its driver; empty: nothing.
    using Wrap = std::function<std::unique_ptr<Transport>(std::unique_ptr<Transport>)>;
    Wrap wrapLaser;
    Wrap wrapTilt;
    int lasersOpened = 0;
    int unitsOpened = 0;

private:
    template <class Driver, class Base>
    static Result<std::unique_ptr<Base>> connected(std::unique_ptr<Driver> driver, const std::stop_token& stop)
    {
        const Result<void> done = driver->connect(stop);
        if (!done)
            return tl::unexpected{done.error()};
        return std::unique_ptr<Base>(std::move(driver));
    }

    std::unique_ptr<Transport> wrapped(std::shared_ptr<EmulatedDevice> device, const char* name, const Wrap& wrap)
    {
        std::unique_ptr<Transport> link =
            std::make_unique<EmulatedLink>(std::move(device), rig_->mutex(), clock_, name);
        return wrap ? wrap(std::move(link)) : std::move(link);
    }

    Result<std::unique_ptr<Laser>> openLaser(const std::stop_token& stop)
    {
        ++lasersOpened;
        auto link = wrapped(rig_->laser(), "laser", wrapLaser);
        return connected<ScipLaser, Laser>(std::make_unique<ScipLaser>(std::move(link), clock_), stop);
    }

    Result<std::unique_ptr<TiltUnit>> openTiltUnit(const std::stop_token& stop)
    {
        ++unitsOpened;
        auto link = wrapped(rig_->tilt(), "tilt unit", wrapTilt);
        if (setup_.tilt == EmulatedRigSetup::Tilt::Board) {
            BoardTiltOptions options;
            options.mounting = mounting();
            return connected<BoardTilt, TiltUnit>(std::make_unique<BoardTilt>(std::move(link), clock_, options), stop);
        }
        DynamixelOptions options;
        options.mounting = mounting();
        options.baud = setup_.baud;
        return connected<DynamixelTilt, TiltUnit>(std::make_unique<DynamixelTilt>(std::move(link), clock_, options),
                                                  stop);
    }

    EmulatedRigSetup setup_;
    FakeClock clock_;
    std::unique_ptr<EmulatedRig> rig_;
};

}  // namespace planewright
