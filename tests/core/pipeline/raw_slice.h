// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "core/geometry/sensor_model.h"
#include "core/types/scan_slice.h"

namespace planewright {

/// Where a beam of a slice hit something, in the slice's own plane.
inline Eigen::Vector2d pointOf(const ScanSlice& slice, int beam)
{
    const auto at = static_cast<std::size_t>(beam);
    return slice.ranges[at] * Eigen::Vector2d{std::cos(slice.bearing(at)), std::sin(slice.bearing(at))};
}

/// The echoes of a slice from one beam to another.
inline std::vector<Eigen::Vector2d> pointsOf(const ScanSlice& slice, const SensorModel& sensor, int firstBeam,
                                             int lastBeam)
{
    std::vector<Eigen::Vector2d> points;
    for (int beam = firstBeam; beam <= lastBeam; ++beam) {
        if (sensor.hasEcho(slice.ranges[static_cast<std::size_t>(beam)]))
            points.push_back(pointOf(slice, beam));
    }
    return points;
}

/// The line of least squares through the echoes of a slice from one beam to another.
struct RawLine {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    Eigen::Vector2d normal = Eigen::Vector2d::UnitY();
    double count = 0.0;
    double along = 0.0;   ///< Σ t²
    double across = 0.0;  ///< Σ of squared distances from it

    RawLine(const ScanSlice& slice, const SensorModel& sensor, int firstBeam, int lastBeam)
        : RawLine(pointsOf(slice, sensor, firstBeam, lastBeam))
    {
    }
    explicit RawLine(const std::vector<Eigen::Vector2d>& points)
    {
        count = static_cast<double>(points.size());
        for (const Eigen::Vector2d& point : points)
            middle += point / count;
        Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
        for (const Eigen::Vector2d& point : points)
            scatter += (point - middle) * (point - middle).transpose();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(scatter);
        normal = axes.eigenvectors().col(0);
        along = axes.eigenvalues()[1];
        for (const Eigen::Vector2d& point : points)
            across += std::pow(distanceOf(point), 2);
    }

    double distanceOf(const Eigen::Vector2d& point) const { return std::abs(normal.dot(point - middle)); }
};

/// Variance across a line of a point by the noise of its range and its bearing.
inline double varianceAcross(const Eigen::Vector2d& normal, const Eigen::Vector2d& point, const NoiseParameters& noise)
{
    const Eigen::Vector2d aside{-point.y(), point.x()};
    return std::pow(normal.dot(point.normalized()), 2) * noise.rangeVariance(point.norm()) +
           std::pow(normal.dot(aside) * noise.bearing, 2);
}

}  // namespace planewright
