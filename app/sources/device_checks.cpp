// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/device_checks.h"

#include <algorithm>
#include <cmath>

#include "app/sources/device_opener.h"
#include "core/types/angle.h"
#include "devices/nodding/scan_plan.h"
#include "devices/transport/usb_error.h"

namespace planewright {

namespace {

/// One test; what a check finds is what the next needs.
class DeviceTest {
public:
    DeviceTest(const std::string& laser, const NoddingSetup& setup, const Clock& clock, const std::stop_token& stop)
        : laserAddress_(laser), setup_(setup), clock_(clock), stop_(stop), opener_(clock, {{}, setup.progress})
    {
    }

    Result<std::string> run(std::size_t check)
    {
        switch (check) {
            case 0:
                return mayOpen();
            case 1:
                return laserAnswers();
            case 2:
                return unitAnswers();
            case 3:
                return planFits();
            case 4:
                return oneSlice();
            default:
                return moveAndBack();
        }
    }

private:
    /// USB devices that this user may not open; other links tell when they are opened.
    Result<std::string> mayOpen()
    {
        for (const std::string& text : {laserAddress_, setup_.tiltUnit}) {
            const auto address = parseDeviceAddress(text);
            if (!address)
                return tl::unexpected{address.error()};
            (address->unit == DeviceAddress::Unit::Laser ? laserAt_ : unitAt_) = *address;
        }
        const std::vector<UsbDevice> devices = opener_.usbDevices();
        const bool isDenied = std::any_of(devices.begin(), devices.end(),
                                          [](const UsbDevice& device) { return device.access == UsbAccess::Denied; });
        if (isDenied)
            return fail(ErrorCode::NoDevice, "you may not use the devices yet; once, run: " + usbPermissionCommand());
        return std::string{};
    }

    Result<std::string> laserAnswers()
    {
        Result<std::unique_ptr<Laser>> laser = opener_.openLaser(laserAt_, stop_);
        if (!laser)
            return tl::unexpected{laser.error()};
        laser_ = std::move(*laser);
        return laser_->identity().product + ", number " + laser_->identity().serial;
    }

    Result<std::string> unitAnswers()
    {
        Result<std::unique_ptr<TiltUnit>> unit = opener_.openTiltUnit(unitAt_, stop_);
        if (!unit)
            return tl::unexpected{unit.error()};
        unit_ = std::move(*unit);
        return unit_->identity();
    }

    Result<std::string> planFits()
    {
        const Result<FittedPlan> fitted = fitPlan(setup_.plan, laser_->limits(), *unit_);
        if (!fitted)
            return tl::unexpected{fitted.error()};
        fitted_ = *fitted;
        return std::to_string(setup_.plan.slices) + " slices of " + std::to_string(fitted_.beams) + " beams";
    }

    Result<std::string> oneSlice()
    {
        constexpr std::chrono::seconds kMost{2};
        if (const Result<void> started = laser_->start(fitted_.steps, stop_); !started)
            return tl::unexpected{started.error()};
        const auto scan = laser_->next(clock_.now() + kMost, stop_);
        const Result<void> stopped = laser_->stop();
        if (!scan)
            return tl::unexpected{scan.error()};
        if (!*scan)
            return fail(ErrorCode::NoDevice, "no slice came within 2 s; look whether the laser's mirror turns");
        if (!stopped)
            return tl::unexpected{stopped.error()};
        const auto returns =
            std::count_if((*scan)->ranges.begin(), (*scan)->ranges.end(), [](auto r) { return r > 0; });
        return std::to_string(returns) + " of " + std::to_string((*scan)->ranges.size()) + " beams came back";
    }

    Result<std::string> moveAndBack()
    {
        if (const Result<void> armed = unit_->arm(stop_); !armed)
            return tl::unexpected{armed.error()};
        const auto begun = waitFor([](const TiltSample& /*sample*/) { return true; });
        if (!begun)
            return tl::unexpected{begun.error()};
        const double way = *begun + kMove <= unit_->highest() ? kMove : -kMove;
        for (const double goal : {*begun + way, *begun}) {
            if (const Result<void> moved = unit_->moveTo(goal, kSpeed); !moved)
                return tl::unexpected{moved.error()};
            const auto arrived = waitFor([&](const TiltSample& sample) {
                return !sample.moving && std::abs(sample.pitch - goal) <= 2.5 * unit_->resolution();
            });
            if (!arrived) {
                static_cast<void>(unit_->hold());
                return tl::unexpected{arrived.error()};
            }
        }
        if (const Result<void> held = unit_->hold(); !held)
            return tl::unexpected{held.error()};
        return std::string{};
    }

    /// The angle of the first sample that is as it should be.
    template <class IsIt>
    Result<double> waitFor(IsIt isIt)
    {
        constexpr std::chrono::seconds kMost{3};
        const auto until = clock_.now() + kMost;
        while (clock_.now() < until && !stop_.stop_requested()) {
            const auto sample = unit_->sample(until, stop_);
            if (!sample)
                return tl::unexpected{sample.error()};
            if (*sample && isIt(**sample))
                return (*sample)->pitch;
        }
        return fail(ErrorCode::NoDevice, "the head did not get there within 3 s; look whether something blocks it");
    }

    static constexpr double kMove = degrees(5.0);
    static constexpr double kSpeed = degrees(20.0);  // [rad/s]: slow enough to be stopped by hand

    const std::string& laserAddress_;
    const NoddingSetup& setup_;
    const Clock& clock_;
    std::stop_token stop_;
    DeviceOpener opener_;
    DeviceAddress laserAt_;
    DeviceAddress unitAt_;
    std::unique_ptr<Laser> laser_;
    std::unique_ptr<TiltUnit> unit_;
    FittedPlan fitted_;
};

}  // namespace

void checkDevices(const std::string& laser, const NoddingSetup& setup, const Clock& clock,
                  const DeviceCheckProgress& progress, const std::stop_token& stop)
{
    DeviceTest test(laser, setup, clock, stop);
    for (std::size_t check = 0; check < kDeviceChecks.size() && !stop.stop_requested(); ++check) {
        progress(check, std::nullopt);
        const Result<std::string> result = test.run(check);
        progress(check, result);
        if (!result)
            return;
    }
}

}  // namespace planewright
