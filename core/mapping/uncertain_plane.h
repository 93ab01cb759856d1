// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "core/mapping/stop.h"

namespace planewright {

using Matrix3x6d = Eigen::Matrix<double, 3, 6>;

/// A stop's plane in the map's frame, the pose taken as known: n ← R n, d ← d + R n · t. The tangents turn with it.
UncertainPlane inMap(const UncertainPlane& plane, const Pose& pose);

/// What an error of the pose changes of that plane: its tangent angles and d of `inMap`.
Matrix3x6d poseJacobian(const UncertainPlane& planeInMap, const Pose& pose);

/// The same with the pose's covariance added.
UncertainPlane inMap(const UncertainPlane& plane, const Pose& pose, const Matrix6d& poseCovariance);

/// The parameters as seen from another point: d ← d − n·origin, with their covariance. Far from the frame's origin the
/// angle and d of a plane are known together or not at all; at the plane itself they are nearly independent.
UncertainPlane seenFrom(const UncertainPlane& plane, const Eigen::Vector3d& origin);

/// What leads from one plane to another: angles about the tangents of the first [rad], and d [m].
Eigen::Vector3d difference(const UncertainPlane& from, const UncertainPlane& to);

/// The covariance of a plane's parameters in the tangents of another of nearly the same normal.
Eigen::Matrix3d covarianceIn(const UncertainPlane& frame, const UncertainPlane& plane);

/// Squared Mahalanobis distance of two planes whose errors are independent: 3 is expected of one plane seen twice.
/// Infinite where the normals are farther apart than a right angle: these are two sides.
double chiSquare(const UncertainPlane& a, const UncertainPlane& b);

/// The plane that both tell of, by maximum likelihood; in tangents of its own.
UncertainPlane fused(const UncertainPlane& a, const UncertainPlane& b);

/// The limit below which 99.9 % of all chi-square values of that many degrees of freedom lie (Wilson and Hilferty
/// 1931; within 2 %).
double chiSquareLimit(int degreesOfFreedom);

/// The middle of where a plane was seen, by area; the foot of the frame's origin where it has no outline. Angles and
/// the distance from there are nearly independent, however badly the angles are known.
Eigen::Vector3d middleOf(const ObservedPlane& plane);

/// Adds what a surface is uneven by [m] to a plane's covariance: as an offset, and as a slope over its extent.
void addFlatness(ObservedPlane& plane, double flatness);

}  // namespace planewright
