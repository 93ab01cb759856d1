// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/sources/device_access.h"
#include "core/types/angle.h"
#include "devices/clock.h"

namespace planewright {

/// A head that turns at the speed that it is told, and what a test sees of it and does to it.
struct FakeHead {
    double pitch = degrees(90.0);
    double goal = degrees(90.0);
    double speed = 0.0;
    std::chrono::nanoseconds movedAt{0};
    bool isArmed = false;
    bool isHeld = false;
    int moves = 0;
    std::atomic<int> holds{0};
    int rests = 0;
    int recoveries = 0;
    bool isBlocked = false;            ///< it does not turn
    bool isSilent = false;             ///< it tells no angle
    std::optional<Error> refusal;      ///< of the next moveTo()
    std::function<void()> whileArmed;  ///< called in arm(), at its end
    std::function<void()> onSample;
};

/// A tilt unit of 0.25° steps from 0° to 180°, 100° a second.
class FakeUnit : public TiltUnit {
public:
    FakeUnit(std::shared_ptr<FakeHead> head, const Clock& clock) : head_(std::move(head)), clock_(clock) {}

    Result<void> connect(const std::stop_token& /*stop*/) override { return {}; }
    std::string identity() const override { return "fake unit"; }
    double resolution() const override { return degrees(0.25); }
    double lowest() const override { return degrees(0.0); }
    double highest() const override { return degrees(180.0); }
    double fastest() const override { return degrees(100.0); }
    Result<void> arm(const std::stop_token& /*stop*/) override
    {
        if (head_->whileArmed)
            head_->whileArmed();
        head_->isArmed = true;
        head_->isHeld = false;
        return {};
    }
    Result<void> moveTo(double pitch, double speed) override
    {
        if (head_->isHeld || !head_->isArmed)
            return fail(ErrorCode::Interrupted, "it is held");
        if (head_->refusal)
            return tl::unexpected{*head_->refusal};
        turn();
        head_->goal = pitch;
        head_->speed = speed;
        ++head_->moves;
        return {};
    }
    double nearestPitch(double pitch) const override { return pitch; }
    /// A hundred times a second.
    Result<std::optional<TiltSample>> sample(std::chrono::nanoseconds deadline, const std::stop_token& stop) override
    {
        constexpr std::chrono::milliseconds kTick{10};
        if (head_->onSample)
            head_->onSample();
        const auto until = head_->isSilent ? deadline : std::min(deadline, clock_.now() + kTick);
        std::mutex mutex;
        std::condition_variable_any never;
        std::unique_lock lock(mutex);
        clock_.wait(lock, never, stop, until);
        if (head_->isSilent)
            return std::nullopt;
        turn();
        return TiltSample{clock_.now(), head_->pitch, head_->pitch != head_->goal && !head_->isBlocked};
    }
    Result<void> hold() override
    {
        turn();
        head_->goal = head_->pitch;
        head_->isHeld = true;
        ++head_->holds;
        return {};
    }
    Result<void> stop() override
    {
        ++head_->rests;
        const int holds = head_->holds;
        const Result<void> held = hold();
        head_->holds = holds;
        return held;
    }
    Result<void> recover(const std::stop_token& /*stop*/) override
    {
        ++head_->recoveries;
        return {};
    }
    LinkHealth health() const override { return {}; }
    MotorState motor() const override { return {}; }

private:
    void turn()
    {
        const std::chrono::duration<double> time = clock_.now() - head_->movedAt;
        head_->movedAt = clock_.now();
        if (head_->isBlocked)
            return;
        const double most = head_->speed * time.count();
        head_->pitch += std::clamp(head_->goal - head_->pitch, -most, most);
    }

    std::shared_ptr<FakeHead> head_;
    const Clock& clock_;
};

/// A laser that answers, with a wall all round.
class FakeLaser : public Laser {
public:
    explicit FakeLaser(const std::string& serial) { identity_.serial = serial; }

    Result<void> connect(const std::stop_token& /*stop*/) override { return {}; }
    const LaserIdentity& identity() const override { return identity_; }
    const LaserLimits& limits() const override { return limits_; }
    Result<void> start(const LaserBeams& beams, const std::stop_token& /*stop*/) override
    {
        beams_ = static_cast<std::size_t>(beams.count());
        return {};
    }
    Result<std::optional<LaserScan>> next(std::chrono::nanoseconds /*deadline*/,
                                          const std::stop_token& /*stop*/) override
    {
        LaserScan scan;
        scan.ranges.assign(beams_, 2000);
        return scan;
    }
    Result<void> stop() override { return {}; }
    LinkHealth health() const override { return {}; }

private:
    LaserIdentity identity_{"Hokuyo", "fake laser", "1", "SCIP 2.0", "", "UTM-30LX"};
    LaserLimits limits_{0.023, 60.0, 1440, 0, 1080, 540, std::chrono::milliseconds{25}};
    std::size_t beams_ = 0;
};

/// A machine with some USB devices, a laser and a tilt unit.
class FakeAccess : public DeviceAccess {
public:
    FakeAccess(std::shared_ptr<FakeHead> head, const Clock& clock) : head_(std::move(head)), clock_(clock) {}

    Result<std::vector<UsbDevice>> usbDevices() override
    {
        if (usbProblem)
            return tl::unexpected{*usbProblem};
        return usb;
    }
    Result<std::unique_ptr<Laser>> openLaser(const DeviceAddress& address, const std::stop_token& /*stop*/) override
    {
        return std::make_unique<FakeLaser>(address.name);
    }
    Result<std::unique_ptr<Laser>> openLaserOn(const UsbDevice& device, const std::stop_token& /*stop*/) override
    {
        ++asked;
        const auto serial = serials.find(device.port);
        if (serial == serials.end())
            return fail(ErrorCode::NoDevice, device.name() + ": does not answer");
        return std::make_unique<FakeLaser>(serial->second);
    }
    Result<std::unique_ptr<TiltUnit>> openTiltUnit(const DeviceAddress& /*address*/,
                                                   const std::stop_token& /*stop*/) override
    {
        return std::make_unique<FakeUnit>(head_, clock_);
    }

    std::vector<UsbDevice> usb;
    std::optional<Error> usbProblem;
    std::map<std::string, std::string> serials;  ///< of lasers, by port
    int asked = 0;

private:
    std::shared_ptr<FakeHead> head_;
    const Clock& clock_;
};

}  // namespace planewright
