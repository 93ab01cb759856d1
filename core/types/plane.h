// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/types/line_segment.h"

namespace planewright {

/// Number of a plane: from 0, stable during a scan, never reused.
using PlaneId = int;
inline constexpr PlaneId kNoPlane = -1;

/// Number of a direction cluster: from 0, never reused.
using ClusterId = int;
inline constexpr ClusterId kNoCluster = -1;

/// Where a plane came from.
struct Lineage {
    enum class Kind { Fitted, Merged, Split };
    Kind kind = Kind::Fitted;
    std::vector<PlaneId> parents;  ///< the planes merged, or the one split; empty if fitted from segments
};

/// A plane Π: n·p = d with |n| = 1 and d ≥ 0, and what supports it. Frame and units as LineSegment.
struct Plane {
    PlaneId id = kNoPlane;
    std::uint64_t revision = 0;  ///< rises with every change of this plane
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double distance = 0.0;      ///< d [m]
    double fittingError = 0.0;  ///< E: mean squared Mahalanobis distance of the end points
    double rms = 0.0;           ///< distance of all its points to the plane, root mean square [m]
    Eigen::Matrix3d covariance =
        Eigen::Matrix3d::Zero();  ///< of (tangent angle 1, tangent angle 2, d) [rad², rad·m, m²]
    Eigen::Matrix<double, 3, 2> tangents = Eigen::Matrix<double, 3, 2>::Zero();  ///< n ← n + tangents · angles
    std::vector<SegmentId> segments;  ///< its line segments, in order of step and index
    int points = 0;                   ///< scan points of these segments
    int bornStep = 0;                 ///< step at which it was made
    int changedStep = 0;              ///< step at which it changed last
    Lineage lineage;
};

/// Turns (n, d) round where needed so that d ≥ 0; with d = 0 the first nonzero of nz, ny, nx is positive.
void makeCanonical(Eigen::Vector3d& normal, double& distance);

/// A set of unassigned line segments of like direction, C of section 4.2.
struct DirectionCluster {
    ClusterId id = kNoCluster;
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< moving average of its segments' directions
    std::vector<SegmentId> segments;                       ///< in the order in which they joined
};

}  // namespace planewright
