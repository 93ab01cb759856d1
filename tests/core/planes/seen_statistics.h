// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "core/planes/plane_estimate.h"
#include "core/simulation/random.h"
#include "core/types/angle.h"

namespace planewright {

/// The scanner of these tests: 721 beams from right to left, a quarter of a degree apart; beam 360 looks ahead.
inline const SensorModel kSensor{0.05, 0.1, 30.0};
inline constexpr int kBeams = 721;
inline constexpr double kBearingStep = degrees(0.25);

/// A surface n·p = d [m], and the beams that meet it.
struct Surface {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitY();
    double distance = 4.0;
    int firstBeam = 320;
    int lastBeam = 400;
};

/// The line a·u + b·v = c in which a slice cuts a plane.
struct Trace {
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;

    Eigen::Vector2d direction() const { return Eigen::Vector2d{b, -a}.normalized(); }
    /// Where the ray of a bearing [rad] meets it.
    Eigen::Vector2d pointAt(double bearing) const
    {
        const Eigen::Vector2d ray{std::cos(bearing), std::sin(bearing)};
        return c / (a * ray.x() + b * ray.y()) * ray;
    }
};

inline Trace traceOf(const Eigen::Vector3d& normal, double distance, const SliceFrame& frame)
{
    return {normal.x(), normal.dot(frame.ahead), distance - normal.dot(frame.origin)};
}

/// The points of a surface in a slice at this tilt: (u, v) of every beam, exact.
inline std::vector<Eigen::Vector2d> pointsOf(const Surface& surface, double tilt)
{
    const Trace trace = traceOf(surface.normal, surface.distance, frameOf(tilt, kSensor));
    std::vector<Eigen::Vector2d> points;
    for (int beam = surface.firstBeam; beam <= surface.lastBeam; ++beam)
        points.push_back(trace.pointAt(kBearingStep * beam));
    return points;
}

/// The statistics of neighbouring points: their line of total least squares, with the weight of its middle for all.
inline SegmentStatistics statisticsOf(const std::vector<Eigen::Vector2d>& points, int firstBeam,
                                      const NoiseParameters& noise)
{
    const auto count = static_cast<double>(points.size());
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : points)
        mean += point / count;
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const Eigen::Vector2d& point : points)
        scatter += (point - mean) * (point - mean).transpose() / count;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(scatter);
    Eigen::Vector2d along = axes.eigenvectors().col(1);
    if (along.dot(points.back() - points.front()) < 0.0)
        along = -along;
    const Eigen::Vector2d across{-along.y(), along.x()};
    const double straight = std::pow(across.dot(mean.normalized()), 2);
    const double variance = straight * noise.rangeVariance(mean.norm()) +
                            (1.0 - straight) * mean.squaredNorm() * noise.bearing * noise.bearing;

    SegmentStatistics s;
    s.firstBeam = firstBeam;
    s.lastBeam = firstBeam + static_cast<int>(points.size()) - 1;
    s.points = static_cast<int>(points.size());
    s.u = mean.x();
    s.v = mean.y();
    s.directionU = along.x();
    s.directionV = along.y();
    s.start = along.dot(points.front() - mean);
    s.end = along.dot(points.back() - mean);
    s.thickness = across.dot(scatter * across);
    s.spread = along.dot(scatter * along);
    s.offsetInformation = count / variance;
    s.slopeInformation = count * s.spread / variance;
    s.chi = count * s.thickness / variance;
    return s;
}

/// A surface as a slice at this tilt sees it, exact.
inline SegmentStatistics seen(const Surface& surface, double tilt, const NoiseParameters& noise)
{
    return statisticsOf(pointsOf(surface, tilt), surface.firstBeam, noise);
}

/// Moves a segment across its line [m] and turns it [rad].
inline void disturb(SegmentStatistics& segment, double offset, double turn)
{
    segment.u -= offset * segment.directionV;
    segment.v += offset * segment.directionU;
    const double u = segment.directionU - turn * segment.directionV;
    const double v = segment.directionV + turn * segment.directionU;
    const double length = std::hypot(u, v);
    segment.directionU = u / length;
    segment.directionV = v / length;
}

/// Disturbs a segment as much as it says of itself.
inline void disturb(SegmentStatistics& segment, Random& random)
{
    const Random::Pair pair = random.normalPair();
    disturb(segment, pair.first / std::sqrt(segment.offsetInformation),
            pair.second / std::sqrt(segment.slopeInformation));
}

}  // namespace planewright
