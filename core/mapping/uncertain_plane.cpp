// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/uncertain_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "core/geometry/tangents.h"
#include "core/types/square.h"

namespace planewright {

namespace {

/// The area of where a plane was seen [m²], and its first moment [m³]. A part is a fan of triangles.
struct SeenArea {
    double area = 0.0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();

    explicit SeenArea(const ObservedPlane& plane)
    {
        for (const Outline::Polygon& part : plane.parts) {
            for (std::size_t i = 2; i < part.ring.size(); ++i) {
                const Eigen::Vector3d& corner = part.ring[0];
                const double triangle =
                    0.5 * plane.parameters.normal.dot((part.ring[i - 1] - corner).cross(part.ring[i] - corner));
                area += triangle;
                moment += triangle / 3.0 * (corner + part.ring[i - 1] + part.ring[i]);
            }
        }
    }
};

constexpr double kLeastArea = 1e-2;  // [m²]

/// The covariance after d ← d + offset · (tangents · angles).
Eigen::Matrix3d withLever(const UncertainPlane& plane, const Eigen::Vector3d& offset)
{
    Eigen::Matrix3d lever = Eigen::Matrix3d::Identity();
    lever.bottomLeftCorner<1, 2>() = offset.transpose() * plane.tangents;
    return lever * plane.covariance * lever.transpose();
}

}  // namespace

UncertainPlane inMap(const UncertainPlane& plane, const Pose& pose)
{
    UncertainPlane moved;
    moved.normal = pose.rotation * plane.normal;
    moved.distance = plane.distance + moved.normal.dot(pose.translation);
    moved.tangents = pose.rotation.toRotationMatrix() * plane.tangents;
    moved.covariance = plane.covariance;
    moved.covariance = withLever(moved, pose.translation);
    return moved;
}

Matrix3x6d poseJacobian(const UncertainPlane& planeInMap, const Pose& pose)
{
    Matrix3x6d jacobian = Matrix3x6d::Zero();
    jacobian.topLeftCorner<2, 3>() = -planeInMap.tangents.transpose() * crossMatrix(planeInMap.normal);
    jacobian.bottomLeftCorner<1, 3>() = planeInMap.normal.cross(pose.translation).transpose();
    jacobian.bottomRightCorner<1, 3>() = planeInMap.normal.transpose();
    return jacobian;
}

UncertainPlane inMap(const UncertainPlane& plane, const Pose& pose, const Matrix6d& poseCovariance)
{
    UncertainPlane moved = inMap(plane, pose);
    const Matrix3x6d jacobian = poseJacobian(moved, pose);
    moved.covariance += jacobian * poseCovariance * jacobian.transpose();
    return moved;
}

UncertainPlane seenFrom(const UncertainPlane& plane, const Eigen::Vector3d& origin)
{
    UncertainPlane seen = plane;
    seen.distance -= plane.normal.dot(origin);
    seen.covariance = withLever(plane, -origin);
    return seen;
}

Eigen::Vector3d difference(const UncertainPlane& from, const UncertainPlane& to)
{
    const Eigen::Vector2d sines = from.tangents.transpose() * to.normal;
    const double sine = sines.norm();
    constexpr double kSmall = 1e-9;
    const double scale = sine > kSmall ? std::atan2(sine, from.normal.dot(to.normal)) / sine : 1.0;
    return {scale * sines.x(), scale * sines.y(), to.distance - from.distance};
}

Eigen::Matrix3d covarianceIn(const UncertainPlane& frame, const UncertainPlane& plane)
{
    const Eigen::Matrix3d turn = betweenTangents(plane.tangents, frame.tangents);
    return turn * plane.covariance * turn.transpose();
}

double chiSquare(const UncertainPlane& a, const UncertainPlane& b)
{
    if (a.normal.dot(b.normal) <= 0.0)
        return std::numeric_limits<double>::infinity();
    const Eigen::Vector3d apart = difference(a, b);
    const Eigen::Matrix3d covariance = a.covariance + covarianceIn(a, b);
    return apart.dot(covariance.llt().solve(apart));
}

UncertainPlane fused(const UncertainPlane& a, const UncertainPlane& b)
{
    const Eigen::Matrix3d ofB = covarianceIn(a, b);
    const Eigen::Matrix3d gain = (a.covariance + ofB).llt().solve(a.covariance).transpose();
    const Eigen::Vector3d step = gain * difference(a, b);
    UncertainPlane both = a;
    both.normal = (a.normal + a.tangents * step.head<2>()).normalized();
    both.distance += step.z();
    // Joseph's form stays symmetric and positive.
    const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity() - gain;
    both.covariance = rest * a.covariance * rest.transpose() + gain * ofB * gain.transpose();
    const UncertainPlane before = both;
    both.tangents = tangentsOf(both.normal);
    both.covariance = covarianceIn(both, before);
    return both;
}

double chiSquareLimit(int degreesOfFreedom)
{
    constexpr double kNormalLimit = 3.0902;  // 99.9 % of the standard normal distribution
    const double k = std::max(1, degreesOfFreedom);
    const double root = 1.0 - 2.0 / (9.0 * k) + kNormalLimit * std::sqrt(2.0 / (9.0 * k));
    return k * root * root * root;
}

Eigen::Vector3d middleOf(const ObservedPlane& plane)
{
    const SeenArea seen(plane);
    return seen.area > kLeastArea ? Eigen::Vector3d(seen.moment / seen.area)
                                  : Eigen::Vector3d(plane.parameters.distance * plane.parameters.normal);
}

void addFlatness(ObservedPlane& plane, double flatness)
{
    // An even spread of offsets over a length L has the slope's standard deviation √12/L times its own.
    const double slope = 12.0 * square(flatness) / std::max(SeenArea(plane).area, kLeastArea);
    UncertainPlane uneven = plane.parameters;
    uneven.covariance = Eigen::Vector3d(slope, slope, square(flatness)).asDiagonal();
    plane.parameters.covariance += withLever(uneven, middleOf(plane));
}

}  // namespace planewright
