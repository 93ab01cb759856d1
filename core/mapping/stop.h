// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/outline.h"
#include "core/geometry/pose.h"
#include "core/types/plane.h"

namespace planewright {

/// A plane n·p = d by its parameters and how well they are known, in a frame that the context names.
///
/// n points away from the side that is seen: the two faces of a wall have opposite normals, and are two planes.
struct UncertainPlane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double distance = 0.0;  ///< d of either sign [m]
    /// Of (tangent angle 1, tangent angle 2, d) [rad², rad·m, m²].
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 2> tangents = Eigen::Matrix<double, 3, 2>::Zero();  ///< n ← n + tangents · angles
};

/// A plane as one stop saw it, in the stop's frame; d ≥ 0, so that n points away from the scanner.
struct ObservedPlane {
    PlaneId id = kNoPlane;  ///< its number in the stop's own extraction
    UncertainPlane parameters;
    std::vector<Outline::Polygon> parts;  ///< where it was seen, in the stop's frame [m]
};

/// Of a plane that an extraction has found, and its outline.
ObservedPlane observedPlane(const Plane& plane, const Outline& outline);

/// A place where the scanner stood, with what it saw there. A map is one of a floor: its stops are all on it.
struct Stop {
    int id = 0;                      ///< the caller's own number for it
    std::optional<Motion> odometry;  ///< from the stop before it; empty where nothing is known of the way
    std::vector<ObservedPlane> planes;
};

}  // namespace planewright
