// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geometry/pose.h"
#include "core/geometry/tangents.h"
#include "core/mapping/uncertain_plane.h"
#include "core/types/square.h"

namespace planewright {

/// A plane n·p = d known to these standard deviations [rad, m], its errors independent.
inline UncertainPlane planeKnownTo(const Eigen::Vector3d& normal, double distance, double angle, double offset)
{
    UncertainPlane plane;
    plane.normal = normal.normalized();
    plane.distance = distance;
    plane.tangents = tangentsOf(plane.normal);
    plane.covariance = Eigen::Vector3d(square(angle), square(angle), square(offset)).asDiagonal();
    return plane;
}

/// The plane by its four numbers, for comparison.
inline Eigen::Vector4d numbersOf(const UncertainPlane& plane)
{
    return {plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.distance};
}

/// A plane with its three parameters changed.
inline UncertainPlane changedBy(const UncertainPlane& plane, const Eigen::Vector3d& change)
{
    UncertainPlane changed = plane;
    changed.normal = (plane.normal + plane.tangents * change.head<2>()).normalized();
    changed.distance += change.z();
    changed.tangents = tangentsOf(changed.normal);
    changed.covariance = covarianceIn(changed, plane);
    return changed;
}

inline Pose poseAt(const Eigen::Vector3d& place, const Eigen::Vector3d& turn)
{
    return {rotationAbout(turn), place};
}

}  // namespace planewright
