// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/segments/slice_points.h"
#include "core/types/angle.h"

namespace planewright {

/// A straight wall in the plane of a slice, from end to end [m].
struct DrawnWall {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
};

/// A slice of level tilt without any return, from one bearing on.
inline ScanSlice emptySlice(double firstBearing, double bearingStep, int beams)
{
    ScanSlice slice;
    slice.tilt = degrees(90.0);
    slice.firstBearing = firstBearing;
    slice.bearingStep = bearingStep;
    slice.ranges.assign(static_cast<std::size_t>(beams), 0.0);
    return slice;
}

inline double crossed(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Gives every beam of a slice the exact range of the nearest wall that it meets; 0 where it meets none.
inline ScanSlice drawn(ScanSlice slice, const std::vector<DrawnWall>& walls)
{
    for (std::size_t beam = 0; beam < slice.ranges.size(); ++beam) {
        const Eigen::Vector2d ray{std::cos(slice.bearing(beam)), std::sin(slice.bearing(beam))};
        double nearest = 0.0;
        for (const auto& [from, to] : walls) {
            // from + t·(to − from) = ρ·ray, solved by crossing with one side and with the other.
            const Eigen::Vector2d along = to - from;
            const double spread = crossed(ray, along);
            const double range = crossed(from, along) / spread;
            const double t = crossed(from, ray) / spread;
            if (t > -1e-12 && t < 1.0 + 1e-12 && range > 0.0 && (nearest == 0.0 || range < nearest))
                nearest = range;
        }
        slice.ranges[beam] = nearest;
    }
    return slice;
}

/// The points of a slice for a scanner from 0.1 m to 30 m.
inline SlicePoints pointsOf(const ScanSlice& slice, const NoiseParameters& noise = {})
{
    SlicePoints points;
    points.take(slice, SensorModel{0.05, 0.1, 30.0}, noise);
    return points;
}

/// Noise of a scanner that measures ranges to millimetres, far below every tolerance of these tests.
inline constexpr NoiseParameters kFineNoise{0.001, 0.0, 0.0, 0.0};

/// Distance of a point to the endless line of a wall [m].
inline double distanceTo(const DrawnWall& wall, const Eigen::Vector2d& point)
{
    return std::abs(crossed((wall.to - wall.from).normalized(), point - wall.from));
}

/// True where every echo of a run lies on one of the walls.
inline bool liesOnOne(const std::vector<DrawnWall>& walls, const SlicePoints& points, const PointRun& run,
                      double tolerance)
{
    for (const DrawnWall& wall : walls) {
        bool all = true;
        for (int beam = run.first; beam <= run.last; ++beam)
            all = all && (!points.hasEcho(beam) || distanceTo(wall, points[beam]) < tolerance);
        if (all)
            return true;
    }
    return false;
}

/// A draw from 0 to 1, without 1.
inline double uniform(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// A standard normal draw (Box and Muller).
inline double normal(std::mt19937_64& random)
{
    return std::sqrt(-2.0 * std::log(1.0 - uniform(random))) * std::cos(2.0 * std::numbers::pi * uniform(random));
}

/// The same slice with range noise [m] on every echo.
inline ScanSlice noisy(ScanSlice slice, double sigma, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    for (double& range : slice.ranges)
        range += range > 0.0 ? sigma * normal(random) : 0.0;
    return slice;
}

/// Walls from corner to corner round the scanner, seen from bearing 0 on: each spans 8° to 20° and turns by 30° at
/// least at its corners.
inline std::vector<DrawnWall> randomWalls(int count, std::mt19937_64& random)
{
    constexpr double kLeastTurn = degrees(30.0);
    std::vector<Eigen::Vector2d> corners{{3.0, 0.0}};
    double bearing = 0.0;
    while (static_cast<int>(corners.size()) <= count) {
        const double next = bearing + degrees(8.0 + 12.0 * uniform(random));
        const double range = 2.0 + 2.0 * uniform(random);
        const Eigen::Vector2d corner{range * std::cos(next), range * std::sin(next)};
        if (corners.size() > 1) {
            const Eigen::Vector2d before = (corners.back() - corners[corners.size() - 2]).normalized();
            const Eigen::Vector2d after = (corner - corners.back()).normalized();
            if (std::abs(std::atan2(crossed(before, after), before.dot(after))) < kLeastTurn)
                continue;
        }
        corners.push_back(corner);
        bearing = next;
    }
    std::vector<DrawnWall> walls;
    for (std::size_t i = 1; i < corners.size(); ++i)
        walls.push_back({corners[i - 1], corners[i]});
    return walls;
}

}  // namespace planewright
