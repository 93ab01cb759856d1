// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace planewright {

/// A plane n·p = d as a comparison sees it, n a unit vector, d in metres.
struct ComparedPlane {
    int id = 0;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double distance = 0.0;  ///< d [m]
};

/// Most planes that a comparison takes on either side; pairs grow with the square.
inline constexpr std::size_t kMaxComparedPlanes = 16384;

/// How far two planes are apart.
struct PlaneDifference {
    double angle = 0.0;     ///< between the planes, 0 to π/2 [rad]
    double distance = 0.0;  ///< |d − d'| after turning one normal to the side of the other [m]
};

/// Angle by atan2(|n × m|, n·m), Eq. (24) without its loss of digits near zero, and difference of the distances, both
/// with the planes turned to the same side: n·p = d and −n·p = −d are one plane.
PlaneDifference differenceOf(const ComparedPlane& a, const ComparedPlane& b);

/// Mean, median (mean of the middle two) and largest of a set of errors; zeros for none.
struct ErrorSummary {
    double mean = 0.0;
    double median = 0.0;
    double max = 0.0;
};

/// Errors of matched planes.
struct PlaneErrors {
    std::size_t count = 0;  ///< matches behind the figures
    ErrorSummary angle;     ///< [rad]
    ErrorSummary distance;  ///< [m]
};

/// Sums up the differences of matched planes.
PlaneErrors summarise(const std::vector<PlaneDifference>& differences);

}  // namespace planewright
