// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/types/angle.h"
#include "devices/nodding/nodding_source.h"
#include "tests/devices/fake_clock.h"
#include "tests/devices/nodding/still_unit.h"

namespace planewright {

/// What was asked of scripted devices, in order, and what they are to do. One thread uses it.
struct DeviceScript {
    using Time = std::chrono::nanoseconds;

    struct Call {
        std::string what;
        Time at{0};
    };

    FakeClock clock;
    std::vector<Call> calls;
    /// Called with the time whenever a device is waited for.
    std::function<void(Time)> onTime;

    LaserIdentity laser{"Hokuyo", "UTM-30LX", "1.0", "SCIP 2.0", "00000001", "UTM-30LX"};
    LaserLimits limits = utm30lx();
    Time laserStart{0};                     ///< how long it takes to start
    Time silentFrom{Time::max()};           ///< of the laser
    Time silentTo{Time::max()};             ///< until then
    std::function<bool(Time)> losesTurn;    ///< the turn of the mirror that begins then
    std::function<Result<void>()> onLaser;  ///< before each look for a scan

    std::vector<FaultRecord> laserLog;
    std::string laserTrouble;
    std::string unitTrouble;
    bool hasTimes = true;  ///< the laser's scans

    std::string unit = "RX-64, number 1, firmware 24";
    double unitHighest = degrees(180.0);
    double tolerance = degrees(0.5);
    std::function<double(double)> blocks;  ///< where the head stands that would be at a pitch [rad]
    double sag = 0.0;                      ///< how far below its goal the head comes to rest [rad]
    bool hasSamples = true;
    bool hasTorque = true;                 ///< of the unit
    std::optional<Time> startedAt;         ///< the unit, as it says
    std::function<Result<void>()> onLook;  ///< when the laser is looked after
    std::function<Result<void>()> onArm;
    std::function<Result<void>()> onRecover;
    std::function<Result<void>()> onStop;
    std::function<Result<void>()> onSample;

    double goal = 0.0;                    ///< of the last motion [rad]
    std::function<double(Time)> pitchAt;  ///< of the unit that was opened last [rad]

    void note(std::string what) { calls.push_back({std::move(what), clock.now()}); }
    int count(const std::string& what) const
    {
        return static_cast<int>(
            std::count_if(calls.begin(), calls.end(), [&](const Call& call) { return call.what == what; }));
    }
    /// The first call of a kind at or after a moment; far in the future without one.
    Time firstFrom(const std::string& what, Time from) const
    {
        for (const Call& call : calls) {
            if (call.what == what && call.at >= from)
                return call.at;
        }
        return Time::max();
    }
    void waitTo(Time moment)
    {
        if (moment > clock.now())
            clock.advance(moment - clock.now());
        if (onTime)
            onTime(clock.now());
    }
};

/// A tilt unit that goes where it is told at constant speed, and tells its angle every 5 ms.
class ScriptedUnit : public StillUnit {
public:
    explicit ScriptedUnit(DeviceScript& script) : script_(script)
    {
        script_.pitchAt = [this](std::chrono::nanoseconds at) { return pitchAt(at); };
    }
    ~ScriptedUnit() override { script_.note("unit closed"); }

    std::string identity() const override { return script_.unit; }
    double highest() const override { return script_.unitHighest; }
    double tolerance() const override { return script_.tolerance; }
    Result<void> arm(const std::stop_token& /*stop*/) override
    {
        script_.note("arm");
        Result<void> armed = script_.onArm ? script_.onArm() : Result<void>{};
        isHeld_ = isHeld_ && !armed;
        script_.hasTorque = script_.hasTorque || armed;
        return armed;
    }
    Result<void> recover(const std::stop_token& /*stop*/) override
    {
        script_.note("recover");
        return script_.onRecover ? script_.onRecover() : Result<void>{};
    }
    Result<void> moveTo(double pitch, double speed) override
    {
        script_.note("move");
        if (isHeld_)
            return fail(ErrorCode::Interrupted, "is held");
        from_ = pitchAt(script_.clock.now());
        since_ = script_.clock.now();
        goal_ = pitch - script_.sag;
        script_.goal = goal_;
        speed_ = speed;
        return {};
    }
    Result<std::optional<TiltSample>> sample(std::chrono::nanoseconds deadline,
                                             const std::stop_token& /*stop*/) override
    {
        constexpr std::chrono::milliseconds kEvery{5};
        if (script_.onSample) {
            if (const Result<void> fine = script_.onSample(); !fine)
                return tl::unexpected{fine.error()};
        }
        const auto due = (script_.clock.now() / kEvery + 1) * kEvery;
        script_.waitTo(script_.hasSamples ? std::min<std::chrono::nanoseconds>(due, deadline) : deadline);
        if (!script_.hasSamples || due > deadline)
            return std::nullopt;
        const double pitch = pitchAt(due);
        return TiltSample{due, pitch, pitch != goal_};
    }
    Result<void> stop() override
    {
        script_.note("stop");
        const Result<void> done = script_.onStop ? script_.onStop() : Result<void>{};
        if (done)
            standStill();
        return done;
    }
    Result<void> hold() override
    {
        script_.note("hold");
        standStill();
        return {};
    }

    LinkHealth health() const override
    {
        LinkHealth health;
        health.trouble = script_.unitTrouble;
        return health;
    }
    bool holdsItself() const override { return script_.hasTorque; }
    std::optional<std::chrono::nanoseconds> startedAt() const override { return script_.startedAt; }

    double pitchAt(std::chrono::nanoseconds at) const
    {
        const double way = speed_ * std::chrono::duration<double>(at - since_).count();
        const double pitch = std::abs(goal_ - from_) <= way ? goal_ : from_ + std::copysign(way, goal_ - from_);
        return script_.blocks ? script_.blocks(pitch) : pitch;
    }

private:
    void standStill()
    {
        goal_ = from_ = pitchAt(script_.clock.now());
        isHeld_ = true;
    }

    DeviceScript& script_;
    double from_ = degrees(90.0);
    double goal_ = degrees(90.0);
    double speed_ = 0.0;
    std::chrono::nanoseconds since_{0};
    bool isHeld_ = true;
};

/// A laser whose turns begin every 25 ms; half of each is scanned, and arrives 2 ms later.
class ScriptedLaser : public Laser {
public:
    using Time = std::chrono::nanoseconds;

    explicit ScriptedLaser(DeviceScript& script) : script_(script), identity_(script.laser), limits_(script.limits) {}
    ~ScriptedLaser() override { script_.note("laser closed"); }

    Result<void> connect(const std::stop_token& /*stop*/) override { return {}; }
    const LaserIdentity& identity() const override { return identity_; }
    const LaserLimits& limits() const override { return limits_; }
    Result<void> start(const LaserBeams& /*beams*/, const std::stop_token& /*stop*/) override
    {
        script_.note("laser start");
        script_.waitTo(script_.clock.now() + script_.laserStart);
        next_ = (script_.clock.now() / kTurn + 1) * kTurn;
        return {};
    }
    Result<std::optional<LaserScan>> next(Time deadline, const std::stop_token& /*stop*/) override
    {
        if (script_.onLaser) {
            if (const Result<void> fine = script_.onLaser(); !fine)
                return tl::unexpected{fine.error()};
        }
        for (;; next_ += kTurn) {
            const Time arrives = next_ + kScan + kOnTheWay;
            if (arrives > deadline) {
                script_.waitTo(deadline);
                return std::nullopt;
            }
            const bool isSilent = next_ >= script_.silentFrom && next_ < script_.silentTo;
            if (isSilent || (script_.losesTurn && script_.losesTurn(next_)))
                continue;
            script_.waitTo(arrives);
            LaserScan scan;
            scan.first = next_;
            scan.last = next_ + kScan;
            scan.arrived = arrives;
            scan.ranges.assign(721, 2500);
            scan.timeSuspect = !script_.hasTimes;
            next_ += kTurn;
            return scan;
        }
    }
    Result<void> stop() override
    {
        script_.note("laser stop");
        return {};
    }
    Result<void> lookAfter() override { return script_.onLook ? script_.onLook() : Result<void>{}; }
    LinkHealth health() const override
    {
        LinkHealth health;
        health.trouble = script_.laserTrouble;
        return health;
    }
    std::vector<FaultRecord> takeLog() override { return std::exchange(script_.laserLog, {}); }

private:
    static constexpr std::chrono::microseconds kTurn{25'000};
    static constexpr std::chrono::microseconds kScan{12'500};
    static constexpr std::chrono::microseconds kOnTheWay{2'000};

    DeviceScript& script_;
    LaserIdentity identity_;
    LaserLimits limits_;
    Time next_{0};
};

inline NoddingDevices scriptedDevices(DeviceScript& script)
{
    return {[&script](const std::stop_token& /*stop*/) -> Result<std::unique_ptr<Laser>> {
                return std::make_unique<ScriptedLaser>(script);
            },
            [&script](const std::stop_token& /*stop*/) -> Result<std::unique_ptr<TiltUnit>> {
                return std::make_unique<ScriptedUnit>(script);
            }};
}

}  // namespace planewright
