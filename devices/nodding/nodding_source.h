// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "devices/clock.h"
#include "devices/nodding/device_pair.h"
#include "devices/nodding/health_facts.h"
#include "devices/nodding/scan_plan.h"
#include "devices/nodding/slice_taker.h"
#include "devices/scan_source.h"

namespace planewright {

/// A laser on a tilt unit: two devices become one source of slices with measured angles (section 3.2, Fig. 2).
///
/// Slices have the angle that was measured, never the one that was asked for. Nothing moves before begin(), and
/// whatever goes wrong brings the unit to rest: next() gives the error, and the next call of it tries to go on at the
/// missing slice. What a unit has stopped for by itself, or by its button for emergencies, is cleared by the first
/// begin(), next() or goHome() after release() alone. So is the loss of a unit's power, whatever came between: the
/// head then goes home, slowly, before it goes anywhere else.
class NoddingSource : public ScanSource {
public:
    /// Opens both devices and fits the plan to them; moves nothing. Errors: those of the devices; Usage for a plan that
    /// they cannot carry out; Interrupted.
    static Result<std::unique_ptr<NoddingSource>> open(NoddingDevices devices, const ScanPlan& plan, const Clock& clock,
                                                       const std::stop_token& stop);

    const ScanDescription& description() const override { return description_; }
    std::optional<int> plannedSlices() const override { return plan_.slices; }
    bool isLive() const override { return true; }
    std::string name() const override { return description_.scanner; }
    const FittedPlan& fittedPlan() const { return fitted_; }

    Result<void> begin(const std::stop_token& stop) override;
    Result<std::optional<ScanSlice>> next(const std::stop_token& stop) override;
    Result<void> end() override;
    void lookAfter(const std::stop_token& stop) override;
    Result<std::optional<double>> goHome(const std::stop_token& stop) override;
    /// The head comes to rest with the call of next() that is under way, or the next one; where that fails it gives the
    /// error.
    Result<void> pause() override;
    Result<void> resume() override;
    Result<void> stopMotion() override;
    void release() override;

    std::vector<HealthFact> health() const override;
    std::vector<FaultRecord> takeLog() override { return devices_.takeLog(); }
    NoddingHealth deviceHealth() const;

private:
    using Time = std::chrono::nanoseconds;

    NoddingSource(NoddingDevices devices, const ScanPlan& plan, const Clock& clock);

    Result<void> fit();
    SliceTaker newTaker();
    /// From any state to one in which the next slice can be taken: devices open, laser scanning, head where it begins.
    Result<void> getReady(const std::stop_token& stop);
    Result<void> awaitScan(const std::stop_token& stop);
    Result<void> arm(const std::stop_token& stop);
    Result<void> mindPower();
    Result<void> travelTo(const SliceTaker::Aim& start, const std::stop_token& stop);
    Result<void> travelHome(const std::stop_token& stop);
    Result<void> arrive(const SliceTaker::Aim& there, Time resting, const std::stop_token& stop);
    Result<std::optional<double>> comeHome(const std::stop_token& stop);
    Result<void> aim();
    /// One thing that has to be done before the next slice, or the slice.
    Result<std::optional<ScanSlice>> goOn(const std::stop_token& stop);
    Result<std::optional<ScanSlice>> takeSlice();
    Result<void> watchMotion();
    Result<std::optional<ScanSlice>> tryAgain(const Error& error);
    tl::unexpected<Error> blocked(const std::string& what);
    tl::unexpected<Error> noAngles(Time since);
    tl::unexpected<Error> noSlices(Time since);
    Result<void> waitWhileHeld(const std::stop_token& stop);
    Result<void> rest();
    bool isHeld() const;
    bool isMotionStopped() const;
    bool takePermission();
    bool hasPermission() const;
    int pauses() const;
    tl::unexpected<Error> fault(Error error);

    DevicePair devices_;
    ScanPlan plan_;
    FittedPlan fitted_;
    const Clock& clock_;
    ScanDescription description_;

    mutable std::mutex mutex_;  ///< of what is asked for
    std::condition_variable_any asked_;
    bool paused_ = false;
    int pauses_ = 0;
    bool motionStopped_ = false;  ///< until release()
    bool mayRecover_ = false;     ///< somebody has seen to what stopped the unit

    // The acquisition thread's own.
    SliceTaker taker_;
    bool isNew_ = true;              ///< taker_ is to be made
    bool isArmed_ = false;           ///< and not told to rest since
    bool hasHeld_ = false;           ///< it has been armed before
    std::optional<Time> startedAt_;  ///< the unit, as it said when it was armed
    bool mustGoHome_ = false;        ///< it has lost its power since then
    bool isReady_ = false;           ///< the head is where the next slice begins, and the laser scans
    bool isAimed_ = false;           ///< the unit has been told to go on from there
    int seenPauses_ = 0;
    Time heardAt_{0};   ///< the last slice, or when it began
    int attempts_ = 0;  ///< to reach the angle of the next slice
    int silences_ = 0;  ///< of the laser since the last slice
    std::atomic<Time::rep> largestSkew_{0};
    std::atomic<int> slicesLost_{0};
};

}  // namespace planewright
