// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

#include "core/types/line_segment.h"
#include "core/types/plane.h"
#include "core/types/sensor_noise.h"

namespace planewright {

/// By how much a point moves for a turn of the head about x.
inline Eigen::Vector3d turned(const Eigen::Vector3d& v)
{
    return {0.0, -v.z(), v.y()};
}

/// 1 less the squared cosine between a plane's normal and that of a segment's slice, which holds ray and line.
inline double steepnessOf(const LineSegment& s, const Eigen::Vector3d& normal)
{
    const Eigen::Vector3d ofSlice = (s.moments.mean - s.viewpoint).cross(s.direction).normalized();
    return 1.0 - std::pow(normal.dot(ofSlice), 2);
}

/// Whether a segment's points are farther apart across the rays than ranges stray: otherwise noise directs its line.
inline bool isDirected(const LineSegment& s, const SensorNoise& noise)
{
    const Eigen::Vector3d ray = s.moments.mean - s.viewpoint;
    const double across = s.length() * ray.cross(s.direction).norm();
    const double variance = std::pow(noise.rangeConstant, 2) + ray.squaredNorm() * std::pow(noise.rangeProportional, 2);
    return across * across >= 4.0 * variance * ray.squaredNorm();
}

/// Sine of the angle at which the ray to a segment's middle meets a plane.
inline double incidenceOf(const LineSegment& s, const Eigen::Vector3d& normal)
{
    return std::abs(normal.dot((s.moments.mean - s.viewpoint).normalized()));
}

/// The likeliest plane of some segments: tangent angles, d and the pitch error of every slice, all found together by
/// Gauss-Newton on the full equations of what was measured; ranges may be off together by a floor.
struct LikeliestPlane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double distance = 0.0;
    Eigen::Matrix<double, 3, 2> tangents = Eigen::Matrix<double, 3, 2>::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (2 tangent angles, d)
    double chi = 0.0;
    std::size_t segments = 0;

    LikeliestPlane(const std::vector<const LineSegment*>& all, double pitch, double floor) : segments(all.size())
    {
        begin(all);
        std::map<int, Eigen::Index> column;
        for (const LineSegment* s : all)
            column.emplace(s->id.step, 3 + static_cast<Eigen::Index>(column.size()));
        const auto slices = static_cast<Eigen::Index>(column.size());
        const auto measured = 2 * static_cast<Eigen::Index>(all.size());
        Eigen::VectorXd pitches = Eigen::VectorXd::Zero(slices);
        Eigen::MatrixXd derivatives(measured + slices, 3 + slices);
        Eigen::VectorXd residuals(measured + slices);
        for (int round = 0; round < 30; ++round) {
            const Eigen::Vector3d first = normal.unitOrthogonal();
            tangents << first, normal.cross(first);
            derivatives.setZero();
            for (std::size_t i = 0; i < all.size(); ++i) {
                const LineSegment& s = *all[i];
                const Eigen::Index of = column.at(s.id.step);
                const auto row = 2 * static_cast<Eigen::Index>(i);
                const double steepness = steepnessOf(s, normal);
                const double place = std::sqrt(steepness * s.placeSigma * s.placeSigma + floor * floor);
                const double slope =
                    std::sqrt(steepness * s.directionSigma * s.directionSigma + 16.0 * std::pow(floor / s.length(), 2));
                const Eigen::Vector3d p = s.moments.mean;
                const double error = pitches[of - 3];
                residuals[row] = (normal.dot(p) - distance + error * normal.dot(turned(p))) / place;
                residuals[row + 1] = (normal.dot(s.direction) + error * normal.dot(turned(s.direction))) / slope;
                derivatives.block<1, 2>(row, 0) = (tangents.transpose() * p).transpose() / place;
                derivatives(row, 2) = -1.0 / place;
                derivatives(row, of) = normal.dot(turned(p)) / place;
                derivatives.block<1, 2>(row + 1, 0) = (tangents.transpose() * s.direction).transpose() / slope;
                derivatives(row + 1, of) = normal.dot(turned(s.direction)) / slope;
            }
            for (Eigen::Index k = 0; k < slices; ++k) {
                residuals[measured + k] = pitches[k] / pitch;
                derivatives(measured + k, 3 + k) = 1.0 / pitch;
            }
            const Eigen::VectorXd step = -derivatives.colPivHouseholderQr().solve(residuals);
            chi = (residuals + derivatives * step).squaredNorm();
            normal = (normal + tangents * step.head<2>()).normalized();
            distance += step[2];
            pitches += step.tail(slices);
            if (step.head<3>().norm() < 1e-9)
                break;
        }
        const Eigen::MatrixXd information = derivatives.transpose() * derivatives;
        covariance = information.inverse().topLeftCorner<3, 3>();
    }

    double normalVariance() const
    {
        return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance.topLeftCorner<2, 2>()).eigenvalues()[1];
    }

    /// Mean squared residual: two numbers a segment, less three of the plane.
    double meanError() const { return chi / std::max(1.0, 2.0 * static_cast<double>(segments) - 3.0); }

private:
    /// The plane of least squares through the ends.
    void begin(const std::vector<const LineSegment*>& all)
    {
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (const LineSegment* s : all)
            mean += (s->start + s->end) / (2.0 * static_cast<double>(all.size()));
        Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
        for (const LineSegment* s : all) {
            for (const Eigen::Vector3d& end : {s->start, s->end})
                scatter += (end - mean) * (end - mean).transpose();
        }
        normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
        distance = normal.dot(mean);
    }
};

/// Covariance of (tangent angle 1, tangent angle 2, d) by the noise alone: what is shown grows with the scatter.
inline Eigen::Matrix3d ownCovariance(const Plane& plane)
{
    return plane.covariance / std::max(1.0, plane.fittingError);
}

/// A segment against a plane, from what snapshots show: χ² of its distance and its slope with the covariance of both,
/// by the noise of its points, the slice's pitch, the plane, and a floor of what ranges may be off together.
struct JoinTwin {
    double chi = 0.0;
    bool directed = true;  ///< noise does not direct the line
    double ofPlane = 0.0;  ///< share of the distance's variance that is the plane's

    JoinTwin(const LineSegment& s, const Plane& plane, const SensorNoise& noise, double floor)
    {
        const Eigen::Vector3d& n = plane.normal;
        const Eigen::Vector3d p = s.moments.mean;
        const Eigen::Vector3d along = -s.direction;
        const double length = s.length();
        const double steepness = steepnessOf(s, n);

        Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
        covariance(0, 0) = steepness * (s.placeSigma * s.placeSigma + floor * floor);
        covariance(1, 1) = steepness * (s.directionSigma * s.directionSigma + 16.0 * floor * floor / (length * length));
        const Eigen::Vector2d byPitch{n.dot(turned(p)), n.dot(turned(along))};
        covariance += noise.pitch * noise.pitch * byPitch * byPitch.transpose();
        Eigen::Matrix<double, 2, 3> byPlane;
        byPlane << (plane.tangents.transpose() * p).transpose(), -1.0, (plane.tangents.transpose() * along).transpose(),
            0.0;
        const Eigen::Matrix2d own = byPlane * ownCovariance(plane) * byPlane.transpose();
        covariance += own;
        ofPlane = own(0, 0) / covariance(0, 0);
        const Eigen::Vector2d residual{n.dot(p) - plane.distance, n.dot(along)};
        chi = residual.dot(covariance.inverse() * residual);

        directed = isDirected(s, noise);
    }
};

/// χ² of a segment's distance from a plane and its slope, without what is unsure of the plane.
template <class AnyPlane>
double residualChi(const LineSegment& s, const AnyPlane& plane, double pitch, double floor)
{
    const Eigen::Vector3d& n = plane.normal;
    const Eigen::Vector2d residual{n.dot(s.moments.mean) - plane.distance, n.dot(s.direction)};
    const Eigen::Vector2d byPitch{n.dot(turned(s.moments.mean)), n.dot(turned(s.direction))};
    Eigen::Matrix2d covariance = pitch * pitch * byPitch * byPitch.transpose();
    const double steepness = steepnessOf(s, n);
    covariance(0, 0) += steepness * (s.placeSigma * s.placeSigma + floor * floor);
    covariance(1, 1) += steepness * (s.directionSigma * s.directionSigma + 16.0 * std::pow(floor / s.length(), 2));
    return residual.dot(covariance.inverse() * residual);
}

/// χ² of two planes being one, with a floor over an extent of a metre, in a frame of this function's own. A plane has
/// normal, distance, tangents, and a covariance of its own, without what its scatter adds.
template <class A, class B>
double mergeChi(const A& a, const Eigen::Matrix3d& covarianceOfA, const B& b, const Eigen::Matrix3d& covarianceOfB,
                double floor)
{
    const double side = a.normal.dot(b.normal) < 0.0 ? -1.0 : 1.0;
    const Eigen::Vector3d first = a.normal.unitOrthogonal();
    Eigen::Matrix<double, 3, 2> frame;
    frame << first, a.normal.cross(first);
    const auto inFrame = [&](const auto& plane, const Eigen::Matrix3d& covariance) {
        Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
        turn.topLeftCorner<2, 2>() = frame.transpose() * plane.tangents;
        return Eigen::Matrix3d{turn * covariance * turn.transpose()};
    };
    Eigen::Matrix3d covariance = inFrame(a, covarianceOfA) + inFrame(b, covarianceOfB);
    covariance.diagonal().array() += floor * floor;
    Eigen::Vector3d apart;
    apart << frame.transpose() * (side * b.normal - a.normal), side * b.distance - a.distance;
    return apart.dot(covariance.inverse() * apart);
}

}  // namespace planewright
