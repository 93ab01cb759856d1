// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/plane_frame.h"

namespace planewright {

/// A rectangle by its sides.
struct RectangleSides {
    Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< of the first side, unit length
    double along = 0.0;                                    ///< first side [m]
    double across = 0.0;                                   ///< second side [m]
};

/// The convex hull of points, counter-clockwise, without points on its sides. Points on one line give their two ends.
PlanarRing convexHull(PlanarRing points);

/// The rectangle of least area around a convex hull, by rotating calipers; of equal areas the one with the least
/// perimeter.
RectangleSides minimumRectangle(const PlanarRing& hull);

}  // namespace planewright
