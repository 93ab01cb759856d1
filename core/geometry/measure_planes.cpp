// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/measure_planes.h"

#include <cmath>

#include <Eigen/Geometry>

#include "core/types/angle.h"

namespace planewright {

double distanceTo(const Plane& plane, const Eigen::Vector3d& point)
{
    return plane.normal.dot(point) - plane.distance;
}

PlanePair measurePlanes(const Plane& first, const Eigen::Vector3d& firstMiddle, const Plane& second,
                        const Eigen::Vector3d& secondMiddle)
{
    constexpr double kParallel = degrees(5.0);
    PlanePair pair;
    pair.angle = std::atan2(first.normal.cross(second.normal).norm(), std::abs(first.normal.dot(second.normal)));
    if (pair.angle <= kParallel)
        pair.distance = 0.5 * (std::abs(distanceTo(second, firstMiddle)) + std::abs(distanceTo(first, secondMiddle)));
    return pair;
}

}  // namespace planewright
