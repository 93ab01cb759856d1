// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "core/types/error.h"
#include "core/types/scan_slice.h"
#include "devices/laser.h"
#include "devices/nodding/scan_plan.h"
#include "devices/nodding/slice_maker.h"
#include "devices/nodding/tilt_track.h"

namespace planewright {

/// Decides where the head has to go, and which turns of the mirror become which slices. It talks to no device.
class SliceTaker {
public:
    using Time = std::chrono::nanoseconds;

    /// What the tilt unit can do.
    struct Head {
        std::string name;         ///< as messages begin with it
        double lowest = 0.0;      ///< [rad]
        double highest = 0.0;     ///< [rad]
        double resolution = 0.0;  ///< [rad]
        double fastest = 0.0;     ///< [rad/s]
        double tolerance = 0.0;   ///< of arriving [rad]
    };

    /// Where to go, and how fast at most.
    struct Aim {
        double pitch = 0.0;  ///< [rad]
        double speed = 0.0;  ///< [rad/s]
    };

    SliceTaker() = default;
    SliceTaker(const ScanPlan& plan, const FittedPlan& fitted, const LaserLimits& laser, Head head);

    /// Slice to be taken next, and whether there is one.
    int next() const { return next_; }
    bool isDone() const { return next_ >= plan_.slices; }
    /// Since when the head rests near an angle [rad]; empty where it does not.
    std::optional<Time> restsSince(double pitch, const TiltTrack& track) const;
    Time largestSkew() const { return maker_.largestSkew(); }
    /// Slices that were passed over for good: the head has gone back for them in vain, or too often already.
    int lost() const { return lost_; }
    /// From going to goal() on, the first slice or the next one comes within this time unless something is wrong.
    Time patience() const;

    /// Where the head has to be before the next slice, and how fast it may travel there: where a sweep begins it has
    /// room to gain speed, as far as limits allow.
    Aim start() const;
    /// Where it then has to go: to the angle of the next slice, or through those of all that are left.
    Aim goal() const;
    /// The head was told to go to goal() at this moment. What is measured before is none of these slices.
    void aimed(Time now);
    /// True where goal() is another after a slice than before.
    bool aimsForEach() const { return plan_.mode == ScanPlan::Mode::StepAndStare; }

    /// The slice of a turn of the mirror; empty where the turn is none of the plan's slices, its time is suspect, or no
    /// angle is near enough in time. A slice whose angle is not as the head was told is marked; after the second in a
    /// row that is an error (NeedsOperator).
    Result<std::optional<ScanSlice>> take(LaserScan scan, const TiltTrack& track);
    /// The next slice is taken after a fault.
    void resume();

    /// True where slices of a sweep were passed over, for which the head has to go back: resume() then. Slices come in
    /// the order of their numbers, so it goes back before it takes the next.
    bool mustGoBack() const { return mustGoBack_; }

    /// False where the head was measured to stand still for stuckAfter() though it is not where it should be. Angles
    /// that do not come say nothing about that.
    bool getsOn(const TiltTrack& track, Time now) const;
    Time stuckAfter() const;

private:
    static constexpr int kMostReturns = 20;
    static constexpr int kMostReturnsToASlice = 2;

    bool isSweep() const { return plan_.mode == ScanPlan::Mode::Continuous; }
    double direction() const { return plan_.pitchStep < 0.0 ? -1.0 : 1.0; }
    double within(double pitch) const;
    double leadIn() const;
    bool mayGoBack() const { return returns_ < kMostReturns && returnsHere_ < kMostReturnsToASlice; }
    /// Farthest from a planned angle that counts as there [rad]: the unit is sent to its step that is nearest to it.
    double tolerance() const { return head_.tolerance + 0.5 * head_.resolution; }
    std::optional<int> stepOf(const LaserScan& scan, const TiltTrack& track);
    std::optional<ScanSlice> takeSwept(LaserScan scan, const TiltTrack& track);
    std::optional<ScanSlice> takeResting(LaserScan scan, const TiltTrack& track);
    bool isAsTold(const ScanSlice& slice, Time duration) const;

    ScanPlan plan_;
    FittedPlan fitted_;
    Head head_;
    Time sliceTime_{0};  ///< of a sweep
    SliceMaker maker_;
    int next_ = 0;
    Time aimedAt_{0};
    struct Anchor {
        Time first;
        int slice;
    };
    std::optional<Anchor> anchor_;  ///< the first slice of this sweep
    int suspects_ = 0;              ///< in a row
    bool resumed_ = false;
    bool mustGoBack_ = false;
    int returns_ = 0;      ///< how often it has gone back
    int returnsHere_ = 0;  ///< since the last slice
    int lost_ = 0;
};

}  // namespace planewright
