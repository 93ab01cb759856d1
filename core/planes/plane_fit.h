// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>

#include <Eigen/Core>

#include "core/planes/end_point_cost.h"

namespace planewright {

/// A plane n·p = d with its uncertainty, without what supports it.
struct PlaneFit {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double distance = 0.0;                                                       ///< [m]
    Eigen::Matrix<double, 3, 2> tangents = Eigen::Matrix<double, 3, 2>::Zero();  ///< B at this normal
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();                       ///< J'J in (2 tangent angles, d)
    double error = 0.0;                                                          ///< E of Eq. (16)
    int iterations = 0;                                                          ///< used by the refinement
};

/// Covariance of (2 tangent angles, d): the inverse of the information; zero where that is singular.
Eigen::Matrix3d covarianceOf(const PlaneFit& fit);

/// Largest variance of a plane's normal [rad²], of its covariance.
double largestNormalVariance(const Eigen::Matrix3d& covariance);

/// Weighted sums over points, enough to fit a plane to them: they add up and take away.
struct WeightedSums {
    double weight = 0.0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();   ///< Σ w p
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< Σ w p p'
    int points = 0;

    void add(const Eigen::Vector3d& point, double w);
    WeightedSums& operator+=(const WeightedSums& other);

    /// Σ w (n·p − d)² / points.
    double meanError(const Eigen::Vector3d& normal, double distance) const;
};

/// The plane of least squares through weighted points, Eq. (13): smallest eigenvector of the scatter about the
/// centroid.
///
/// The paper takes the last column of V of the four-column system, which minimises Σ r²/(1 + d²); centring first is
/// right. `information` is that of the same weights. The normal keeps the side of `side`.
PlaneFit fitPlane(const WeightedSums& sums, const Eigen::Vector3d& side);

/// Refines a plane by its end points' uncertainty (section 4.3.3, Eq. (16) to (20), Table VI).
///
/// Damped Gauss-Newton in two tangent angles and d; ends on a small relative decrease of E, a small step, or i_max. The
/// error returned is the true one at the result.
PlaneFit refinePlane(const PlaneFit& start, std::span<const EndPoint> points, const PlaneParameters& parameters);

}  // namespace planewright
