// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace planewright {

namespace {

EndPointEquations equationsOf(const Eigen::Vector3d& normal, double distance,
                              const Eigen::Matrix<double, 3, 2>& tangents, std::span<const EndPoint> points,
                              const PlaneParameters& parameters)
{
    EndPointEquations sum;
    for (const EndPoint& point : points)
        addEquations(normal, distance, tangents, point, parameters, sum);
    return sum;
}

}  // namespace

Eigen::Matrix3d covarianceOf(const PlaneFit& fit)
{
    const Eigen::Matrix3d covariance = fit.information.inverse();
    return covariance.allFinite() ? covariance : Eigen::Matrix3d::Zero();
}

double largestNormalVariance(const Eigen::Matrix3d& covariance)
{
    // Larger eigenvalue of the 2 × 2 block of the tangent angles.
    const double half = 0.5 * (covariance(0, 0) - covariance(1, 1));
    return 0.5 * (covariance(0, 0) + covariance(1, 1)) + std::hypot(half, covariance(0, 1));
}

void WeightedSums::add(const Eigen::Vector3d& point, double w)
{
    weight += w;
    first += w * point;
    second += (w * point) * point.transpose();
    ++points;
}

WeightedSums& WeightedSums::operator+=(const WeightedSums& other)
{
    weight += other.weight;
    first += other.first;
    second += other.second;
    points += other.points;
    return *this;
}

double WeightedSums::meanError(const Eigen::Vector3d& normal, double distance) const
{
    const double sum = normal.dot(second * normal) - 2.0 * distance * normal.dot(first) + distance * distance * weight;
    return points == 0 ? 0.0 : std::max(0.0, sum) / points;
}

namespace {

/// Eigenvector of the smallest eigenvalue of a symmetric matrix.
///
/// The closed formula loses half of the digits where the smallest is nearly zero, as on any plane; two steps of
/// Rayleigh iteration bring them back. The adjugate stands in for the inverse, which does not exist where the step is
/// exact.
Eigen::Vector3d smallestDirection(const Eigen::Matrix3d& matrix)
{
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
    eigen.computeDirect(matrix);
    Eigen::Vector3d direction = eigen.eigenvectors().col(0);
    for (int step = 0; step < 2; ++step) {
        Eigen::Matrix3d shifted = matrix;
        shifted.diagonal().array() -= direction.dot(matrix * direction);
        Eigen::Matrix3d adjugate;
        adjugate << shifted.row(1).cross(shifted.row(2)), shifted.row(2).cross(shifted.row(0)),
            shifted.row(0).cross(shifted.row(1));
        const Eigen::Vector3d next = adjugate * direction;
        const double length = next.norm();
        if (!(length > 0.0))
            break;
        direction = next / length;
    }
    return direction;
}

}  // namespace

PlaneFit fitPlane(const WeightedSums& sums, const Eigen::Vector3d& side)
{
    const Eigen::Vector3d centroid = sums.first / sums.weight;
    const Eigen::Matrix3d scatter = sums.second - sums.first * centroid.transpose();

    PlaneFit fit;
    fit.normal = smallestDirection(scatter);
    if (fit.normal.dot(side) < 0.0)
        fit.normal = -fit.normal;
    fit.distance = fit.normal.dot(centroid);
    fit.tangents = tangentsOf(fit.normal);
    fit.error = sums.meanError(fit.normal, fit.distance);
    const Eigen::Vector2d mixed = -fit.tangents.transpose() * sums.first;
    fit.information.topLeftCorner<2, 2>() = fit.tangents.transpose() * sums.second * fit.tangents;
    fit.information.topRightCorner<2, 1>() = mixed;
    fit.information.bottomLeftCorner<1, 2>() = mixed.transpose();
    fit.information(2, 2) = sums.weight;
    return fit;
}

PlaneFit refinePlane(const PlaneFit& start, std::span<const EndPoint> points, const PlaneParameters& parameters)
{
    PlaneFit fit = start;
    fit.iterations = 0;
    fit.tangents = tangentsOf(fit.normal);
    EndPointEquations equations = equationsOf(fit.normal, fit.distance, fit.tangents, points, parameters);
    double damping = 1e-6;
    while (fit.iterations < parameters.refineIterations) {
        ++fit.iterations;
        Eigen::Matrix3d damped = equations.information;
        damped.diagonal() *= 1.0 + damping;
        const Eigen::Vector3d step = -damped.ldlt().solve(equations.gradient);
        if (!step.allFinite())
            break;
        const Eigen::Vector3d normal = (fit.normal + fit.tangents * step.head<2>()).normalized();
        const double distance = fit.distance + step[2];
        const Eigen::Matrix<double, 3, 2> tangents = tangentsOf(normal);
        const EndPointEquations next = equationsOf(normal, distance, tangents, points, parameters);
        const double decrease = equations.cost - next.cost;
        if (decrease < 0.0) {
            damping *= 100.0;
            if (step.norm() < 1e-12 || damping > 1e12)
                break;
            continue;
        }
        fit.normal = normal;
        fit.distance = distance;
        fit.tangents = tangents;
        const double before = equations.cost;
        equations = next;
        damping = std::max(damping / 100.0, 1e-12);
        if (decrease <= parameters.refineTolerance * before || step.norm() < 1e-10)
            break;
    }
    fit.information = equations.information;
    fit.error = points.empty() ? 0.0 : equations.cost / static_cast<double>(points.size());
    return fit;
}

}  // namespace planewright
