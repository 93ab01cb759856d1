// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "core/geometry/tangents.h"
#include "core/params/parameters.h"

namespace planewright {

/// An end point of a line segment with its covariance, as plane fitting sees it.
struct EndPoint {
    Eigen::Vector3d position;    ///< p [m]
    Eigen::Matrix3d covariance;  ///< C, Eq. (15) [m²]
};

/// 1/σ² of an end point's distance to a plane of this unit normal, with the flatness of real walls added to C.
///
/// For the cost `ml` 1/(n'Cn): the squared Mahalanobis distance of the point to the plane, whose expectation is 1. For
/// `foot` n'C⁻¹n of the printed Eq. (16), which takes the perpendicular foot for the nearest point and is never
/// smaller.
double endPointWeight(const Eigen::Vector3d& normal, const EndPoint& point, const PlaneParameters& parameters);

/// Share of an end point in the normal equations of Eq. (19) and (20), in (tangent angle 1, tangent angle 2, d).
///
/// Three parameters instead of the four of Eq. (20): there J'J is always singular, since H does not change when n and d
/// grow together.
struct EndPointEquations {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< J'J
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();     ///< J'H
    double cost = 0.0;                                      ///< H'H
};

/// Adds an end point's share for the plane (n, d).
void addEquations(const Eigen::Vector3d& normal, double distance, const Eigen::Matrix<double, 3, 2>& tangents,
                  const EndPoint& point, const PlaneParameters& parameters, EndPointEquations& sum);

}  // namespace planewright
