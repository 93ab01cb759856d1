// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <optional>

#include "core/types/scan_slice.h"
#include "devices/laser.h"
#include "devices/nodding/tilt_track.h"

namespace planewright {

/// Farthest in time that a measured angle may be from a beam that it is used for: at 47° a second that is 0.23°, the
/// smallest step of most tilt units.
inline constexpr std::chrono::milliseconds kLargestSkew{5};

/// Makes slices of what a laser and a tilt unit have measured.
class SliceMaker {
public:
    using Time = std::chrono::nanoseconds;

    /// What is the same in all slices of a scan.
    struct Geometry {
        double firstBearing = 0.0;  ///< [rad]
        double bearingStep = 0.0;   ///< [rad]
        bool continuous = false;    ///< the head nods on during a slice
        double resolution = 0.0;    ///< smallest step of the measured angle [rad]
    };

    SliceMaker() = default;
    explicit SliceMaker(const Geometry& geometry) : geometry_(geometry) {}

    /// True when angles to both sides of all of a scan's beams are there, or will not come any more.
    static bool isDue(const LaserScan& scan, const TiltTrack& track);

    /// The slice of a scan, with the angles that the track has at its beams. Empty where it has none near enough: a
    /// slice is never made up. In a sweep, while the head keeps its speed, they lie on a line through the samples about
    /// the slice, which is finer than a count of the unit. Times count from that of the first slice.
    std::optional<ScanSlice> make(LaserScan scan, const TiltTrack& track, int step, double commanded);

    /// Largest distance in time between a beam and an angle that was used for it.
    Time largestSkew() const { return largestSkew_; }

private:
    Geometry geometry_;
    std::optional<Time> begin_;  ///< of the first slice
    Time largestSkew_{0};
    std::chrono::microseconds lastTime_{0};
};

}  // namespace planewright
