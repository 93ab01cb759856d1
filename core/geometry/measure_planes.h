// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/types/plane.h"

namespace planewright {

/// How far a point is from a plane [m]: positive beyond it, seen from the sensor.
double distanceTo(const Plane& plane, const Eigen::Vector3d& point);

/// How two planes lie to each other.
struct PlanePair {
    double angle = 0.0;              ///< between them, 0 to π/2 [rad]
    std::optional<double> distance;  ///< of planes that are parallel within 5° [m]
};

/// Measures two planes at the middle of each: the distance is the mean of that of one's middle from the other.
PlanePair measurePlanes(const Plane& first, const Eigen::Vector3d& firstMiddle, const Plane& second,
                        const Eigen::Vector3d& secondMiddle);

}  // namespace planewright
