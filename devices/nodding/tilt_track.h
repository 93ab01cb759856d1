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
    /// True where the last sample is about as old as a sample is when it comes; nobody knows what happened after an
    /// older one.
    bool isFresh(Time now) const;

    /// Angle at a moment [rad], on the straight line between the samples about it. Empty outside of the samples, and
    /// where the nearer of the two is farther away than `reach`: what happened between them nobody knows.
    std::optional<double> pitchAt(Time moment, Time reach) const;

    /// A head that turns at constant speed.
    struct Line {
        Time at{0};             ///< a moment
        double pitch = 0.0;     ///< then [rad]
        double speed = 0.0;     ///< [rad/s]
        double residual = 0.0;  ///< farthest of a sample from it [rad]
        double pitchAt(Time moment) const;
    };
    /// The line of least squares through the samples from a moment on: what a unit's counts round off is averaged.
    /// Empty for fewer than three samples.
    std::optional<Line> lineSince(Time from) const;

    /// How far the nearer of the two samples about a moment is from it; zero outside of them.
    Time skewAt(Time moment) const;

    /// Mean of the samples from one moment to another [rad]; empty where there is none.
    std::optional<double> meanPitch(Time from, Time to) const;

    /// Since when the head rests: the first sample from which on all are within `play` of the last one [rad]. Empty
    /// where these are fewer than `least`.
    std::optional<Time> restsSince(double play, int least) const;

private:
    using Place = std::deque<TiltSample>::const_iterator;
    Place firstFrom(Time moment) const;

    std::deque<TiltSample> samples_;
};

}  // namespace planewright
