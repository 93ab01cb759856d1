// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/check_stop.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Cholesky>

namespace planewright {

namespace {

template <class Matrix>
bool isCovariance(const Matrix& covariance)
{
    return covariance.allFinite() && covariance.isApprox(covariance.transpose(), 1e-6) &&
           covariance.llt().info() == Eigen::Success;
}

std::string problemOf(const ObservedPlane& plane)
{
    const UncertainPlane& own = plane.parameters;
    constexpr double kTolerance = 1e-6;
    if (!own.normal.allFinite() || !own.tangents.allFinite() || std::abs(own.normal.norm() - 1.0) > kTolerance)
        return "its normal is not of length 1";
    Eigen::Matrix3d axes;
    axes << own.tangents, own.normal;
    if (!(axes.transpose() * axes).isIdentity(kTolerance))
        return "its tangents are not at right angles to its normal and to each other";
    if (!std::isfinite(own.distance) || own.distance < 0.0)
        return "its distance is not a number from 0 up";
    if (!isCovariance(own.covariance))
        return "its covariance is not positive definite; planes of the preset precise have one that is";
    for (const Outline::Polygon& part : plane.parts) {
        if (!std::ranges::all_of(part.ring, [](const Eigen::Vector3d& corner) { return corner.allFinite(); }))
            return "its outline has a corner that is not a number";
    }
    return {};
}

}  // namespace

Result<void> checkStop(const Stop& stop)
{
    const std::string name = "Stop " + std::to_string(stop.id) + ": ";
    if (stop.odometry) {
        const Pose& motion = stop.odometry->pose;
        if (!motion.translation.allFinite() || !motion.rotation.coeffs().allFinite() ||
            std::abs(motion.rotation.norm() - 1.0) > 1e-6)
            return fail(ErrorCode::Unreadable, name + "its odometry is not a motion.");
        if (!isCovariance(stop.odometry->covariance))
            return fail(ErrorCode::Unreadable, name + "the covariance of its odometry is not positive definite.");
    }
    for (const ObservedPlane& plane : stop.planes) {
        if (const std::string problem = problemOf(plane); !problem.empty())
            return fail(ErrorCode::Unreadable,
                        name + "plane " + std::to_string(plane.id) + " cannot be used: " + problem + ".");
    }
    return {};
}

}  // namespace planewright
