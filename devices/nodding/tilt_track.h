// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <deque>
#include <optional>

#include "devices/tilt_unit.h"

namespace planewright {

/// The measured angle of a tilt unit over the last seconds.
class TiltTrack {
public:
    using Time = std::chrono::nanoseconds;

    /// A sample that is not later than the one before is left out: two clocks may disagree by a little.
    void add(const TiltSample& sample);
    void clear() { samples_.clear(); }

    bool isEmpty() const { return samples_.empty(); }
    const TiltSample& last() const { return samples_.back(); }

    /// Angle at a moment [rad], on the straight line between the samples about it. Empty outside of the samples, and
    /// where the nearer of the two is farther away than `reach`: what happened between them nobody knows.
    std::optional<double> pitchAt(Time moment, Time reach) const;

    /// How far the nearer of the two samples about a moment is from it; zero outside of them.
    Time skewAt(Time moment) const;

    /// Mean of the samples from one moment to another [rad]; empty where there is none.
    std::optional<double> meanPitch(Time from, Time to) const;

    /// True where samples from `from` on, one before it counted, to the last one at or behind `to` lie within
    /// `tolerance` [rad] of a pitch, and none says that it moves. False where they do not reach as far.
    bool isAt(double pitch, double tolerance, Time from, Time to) const;

    /// Since when every sample has been within `tolerance` of a pitch without moving; empty where the last is not, or
    /// fewer than `least` are.
    std::optional<Time> restsSince(double pitch, double tolerance, int least) const;

private:
    using Place = std::deque<TiltSample>::const_iterator;
    Place firstFrom(Time moment) const;

    std::deque<TiltSample> samples_;
};

}  // namespace planewright
