// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "core/params/parameters.h"
#include "core/types/recording.h"

namespace planewright {

/// A scan point of a plane, as it was measured.
struct SeenPoint {
    double range = 0.0;  ///< [m]
    double sine = 0.0;   ///< of its bearing
    double cosine = 0.0;
    double sweep = 0.0;  ///< share of the sweep that had passed: 0 at the first beam, 1 at the last
};

/// The points of one line segment: [first, end).
struct SeenSegment {
    std::size_t plane = 0;  ///< place of its plane
    std::size_t first = 0;
    std::size_t end = 0;
};

/// A slice and its segments: [first, end).
struct SeenSlice {
    double tilt = 0.0;  ///< pitch at the first beam [rad]
    double turn = 0.0;  ///< from there to the last beam [rad]
    double rate = 0.0;  ///< from a slice to the next [rad]
    std::size_t first = 0;
    std::size_t end = 0;
};

/// A plane as the extraction left it.
struct SeenPlane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double distance = 0.0;  ///< [m]
    int points = 0;
};

/// The planes of a scan that are seen well enough to calibrate by, with their points.
struct SeenPlanes {
    std::vector<SeenPlane> planes;  ///< the largest first
    std::vector<SeenSlice> slices;
    std::vector<SeenSegment> segments;
    std::vector<SeenPoint> points;
    double leverArm = 0.0;  ///< d_l [m]
    NoiseParameters noise;  ///< with what the extraction has found
};

/// Extracts the planes of a recording and keeps those that are seen well: by many returns from several slices, not at a
/// shallow angle, flat. At most the 64 with most returns.
SeenPlanes planesSeen(const Recording& recording, const Parameters& parameters);

}  // namespace planewright
