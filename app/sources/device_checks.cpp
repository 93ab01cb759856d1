// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/device_checks.h"

#include <algorithm>

#include "app/sources/device_permission.h"
#include "app/sources/unit_motion.h"
#include "core/types/angle.h"
#include "devices/nodding/scan_plan.h"

namespace planewright {

namespace {

/// One test; what a check finds is what the next needs.
class DeviceTest {
public:
    DeviceTest(DeviceAccess& devices, const std::string& laser, const NoddingSetup& setup, const Clock& clock,
               const std::stop_token& stop)
        : devices_(devices), laserAddress_(laser), setup_(setup), clock_(clock), stop_(stop)
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
    /// Looks at the two that were chosen; other devices are nobody's trouble.
    Result<std::string> mayOpen()
    {
        for (const std::string& text : {laserAddress_, setup_.tiltUnit}) {
            const auto address = parseDeviceAddress(text);
            if (!address)
                return tl::unexpected{address.error()};
            (address->unit == DeviceAddress::Unit::Laser ? laserAt_ : unitAt_) = *address;
            if (const auto hindrance = hindranceOf(*address, devices_))
                return fail(ErrorCode::NoDevice, hindrance->problem);
        }
        return std::string{};
    }

    Result<std::string> laserAnswers()
    {
        Result<std::unique_ptr<Laser>> laser = devices_.openLaser(laserAt_, stop_);
        if (!laser)
            return tl::unexpected{laser.error()};
        laser_ = std::move(*laser);
        return laser_->identity().product + ", number " + laser_->identity().serial;
    }

    Result<std::string> unitAnswers()
    {
        Result<std::unique_ptr<TiltUnit>> unit = devices_.openTiltUnit(unitAt_, stop_);
        if (!unit)
            return tl::unexpected{unit.error()};
        motion_.emplace(std::move(*unit), clock_, stop_);
        return motion_->unit().identity();
    }

    Result<std::string> planFits()
    {
        const Result<FittedPlan> fitted = fitPlan(setup_.plan, laser_->limits(), motion_->unit());
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
        if (!*scan && stop_.stop_requested())
            return fail(ErrorCode::Interrupted, "the test was stopped");
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
        if (const Result<void> armed = motion_->arm(); !armed)
            return tl::unexpected{armed.error()};
        const Result<double> begun = motion_->position();
        if (!begun)
            return tl::unexpected{begun.error()};
        const double way = *begun + kMove <= motion_->unit().highest() ? kMove : -kMove;
        for (const double goal : {*begun + way, *begun}) {
            if (const Result<void> moved = motion_->moveTo(goal, kSpeed); !moved)
                return tl::unexpected{moved.error()};
        }
        if (const Result<void> rested = motion_->rest(); !rested)
            return tl::unexpected{rested.error()};
        return std::string{};
    }

    static constexpr double kMove = degrees(5.0);
    static constexpr double kSpeed = degrees(20.0);  // [rad/s]: slow enough to be stopped by hand

    DeviceAccess& devices_;
    const std::string& laserAddress_;
    const NoddingSetup& setup_;
    const Clock& clock_;
    std::stop_token stop_;
    DeviceAddress laserAt_;
    DeviceAddress unitAt_;
    std::unique_ptr<Laser> laser_;
    std::optional<UnitMotion> motion_;
    FittedPlan fitted_;
};

}  // namespace

void checkDevices(DeviceAccess& devices, const std::string& laser, const NoddingSetup& setup, const Clock& clock,
                  const DeviceCheckProgress& progress, const std::stop_token& stop)
{
    DeviceTest test(devices, laser, setup, clock, stop);
    for (std::size_t check = 0; check < kDeviceChecks.size() && !stop.stop_requested(); ++check) {
        progress(check, std::nullopt);
        const Result<std::string> result = test.run(check);
        progress(check, result);
        if (!result)
            return;
    }
}

}  // namespace planewright
