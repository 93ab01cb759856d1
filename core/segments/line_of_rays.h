// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>

namespace planewright {

/// A point in the slice's own plane, the laser at its origin [m].
struct SlicePoint {
    double u = 0.0;
    double v = 0.0;
};

/// A straight line in the slice's own plane, and the stretch of it between the rays of its points.
struct LineOfRays {
    double normalU = 0.0, normalV = 1.0;  ///< unit vector, away from the laser
    double distance = 0.0;                ///< of the laser from the line [m]
    double u = 0.0, v = 0.0;      ///< mean of the points, each moved along the line to where its ray meets it [m]
    double from = 0.0, to = 0.0;  ///< where the first and the last ray meet the line, from its foot [m]
    double place = 0.0;           ///< where the rays meet it on average, from its foot [m]
    double along = 0.0;           ///< Σ of squared distances of these places from that [m²]
    double across = 0.0;          ///< Σ of squared distances of the points from their mean across the line [m²]

    /// Along the line: places count in this direction.
    double directionU() const { return -normalV; }
    double directionV() const { return normalU; }
};

/// The line through at least three points by least squares of their inverse ranges; nothing where it does not meet all
/// of their rays.
///
/// On a straight line 1/ρ is linear in cosine and sine of the bearing, which are exact, while noise is in the range
/// alone. So noise turns the line to neither side, however few the points are and however shallow the line: total least
/// squares takes it for as large along the line as across, and turns the lines of all slices the same way.
std::optional<LineOfRays> lineOfRays(std::span<const SlicePoint> points);

}  // namespace planewright
