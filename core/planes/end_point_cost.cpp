// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/end_point_cost.h"

#include <cmath>

#include <Eigen/LU>

namespace planewright {

namespace {

/// Variance by which real walls stray from a plane [m²]; it also keeps C regular on the pitch axis, where Eq. (15) is
/// singular.
double flatnessVariance(const PlaneParameters& parameters)
{
    return parameters.flatness * parameters.flatness + 1e-12;
}

Eigen::Matrix3d withFlatness(const Eigen::Matrix3d& covariance, const PlaneParameters& parameters)
{
    return covariance + flatnessVariance(parameters) * Eigen::Matrix3d::Identity();
}

}  // namespace

double endPointWeight(const Eigen::Vector3d& normal, const EndPoint& point, const PlaneParameters& parameters)
{
    if (parameters.cost == PlaneCost::Foot)
        return normal.dot(withFlatness(point.covariance, parameters).inverse() * normal);
    return 1.0 / (normal.dot(point.covariance * normal) + flatnessVariance(parameters));
}

void addEquations(const Eigen::Vector3d& normal, double distance, const Eigen::Matrix<double, 3, 2>& tangents,
                  const EndPoint& point, const PlaneParameters& parameters, EndPointEquations& sum)
{
    const double residual = normal.dot(point.position) - distance;
    if (parameters.cost == PlaneCost::Foot) {
        // H = C^(-1/2) r n; along the tangents dH/dn = C^(-1/2) (n p' + r I), and dH/dd = −C^(-1/2) n.
        const Eigen::Matrix3d inverse = withFlatness(point.covariance, parameters).inverse();
        Eigen::Matrix3d foot;
        foot.leftCols<2>() = normal * (point.position.transpose() * tangents) + residual * tangents;
        foot.col(2) = -normal;
        sum.information += foot.transpose() * inverse * foot;
        sum.gradient += foot.transpose() * (inverse * normal) * residual;
        sum.cost += residual * residual * normal.dot(inverse * normal);
        return;
    }
    // H = r/s with s² = n'Cn; dH/dn = p/s − r Cn/s³, dH/dd = −1/s. Rows are kept without 1/s, and weighed by 1/s².
    const Eigen::Vector3d across = point.covariance * normal + flatnessVariance(parameters) * normal;
    const double weight = 1.0 / normal.dot(across);
    Eigen::Vector3d row;
    row.head<2>() = tangents.transpose() * (point.position - (residual * weight) * across);
    row[2] = -1.0;
    const Eigen::Vector3d weighted = weight * row;
    sum.information += weighted * row.transpose();
    sum.gradient += residual * weighted;
    sum.cost += weight * residual * residual;
}

}  // namespace planewright
