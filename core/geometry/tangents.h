// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace planewright {

/// Two tangent vectors of a unit normal, orthonormal with it: n ← n + B·angles stays a unit vector to first order.
inline Eigen::Matrix<double, 3, 2> tangentsOf(const Eigen::Vector3d& normal)
{
    // The axis least along the normal gives the best conditioned first tangent.
    Eigen::Index least = 0;
    normal.cwiseAbs().minCoeff(&least);
    Eigen::Matrix<double, 3, 2> tangents;
    tangents.col(0) = normal.cross(Eigen::Vector3d::Unit(least)).normalized();
    tangents.col(1) = normal.cross(tangents.col(0));
    return tangents;
}

/// What leads from a plane's parameters, angles about two tangents and d, to those about the tangents of another plane
/// of nearly the same normal.
inline Eigen::Matrix3d betweenTangents(const Eigen::Matrix<double, 3, 2>& from, const Eigen::Matrix<double, 3, 2>& to)
{
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<2, 2>() = to.transpose() * from;
    return turn;
}

}  // namespace planewright
