// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/voxel_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace planewright {

namespace {

/// Coordinates of a cube in one number: 21 bits each.
std::uint64_t keyOf(const Eigen::Vector3d& point, double edge)
{
    constexpr std::int64_t kMiddle = std::int64_t{1} << 20;
    std::uint64_t key = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto place = static_cast<std::int64_t>(std::floor(point[axis] / edge)) + kMiddle;
        key = (key << 21U) | static_cast<std::uint64_t>(place & ((std::int64_t{1} << 21) - 1));
    }
    return key;
}

}  // namespace

VoxelGrid voxelGridOf(const std::vector<Eigen::Vector3d>& points, double edge)
{
    constexpr std::uint64_t kEmpty = ~std::uint64_t{0};
    const std::size_t size = std::bit_ceil(2 * points.size() + 1);
    std::vector<std::uint64_t> keys(size, kEmpty);
    std::vector<int> voxels(size, -1);
    VoxelGrid grid;
    grid.voxelOf.reserve(points.size());
    for (const Eigen::Vector3d& point : points) {
        const std::uint64_t key = keyOf(point, edge);
        std::size_t slot = (key * 0x9e3779b97f4a7c15U) >> 20U & (size - 1);  // Fibonacci hashing, linear probing
        while (keys[slot] != kEmpty && keys[slot] != key)
            slot = (slot + 1) & (size - 1);
        if (keys[slot] == kEmpty) {
            keys[slot] = key;
            voxels[slot] = static_cast<int>(grid.means.size());
            grid.means.emplace_back(0.0, 0.0, 0.0);
            grid.counts.push_back(0);
        }
        const int voxel = voxels[slot];
        grid.means[static_cast<std::size_t>(voxel)] += point;
        ++grid.counts[static_cast<std::size_t>(voxel)];
        grid.voxelOf.push_back(voxel);
    }
    for (std::size_t v = 0; v < grid.means.size(); ++v)
        grid.means[v] /= grid.counts[v];
    return grid;
}

VoxelGrid reduced(const PointScan& scan, const ReductionParameters& parameters)
{
    if (parameters.bearing <= 0.0)
        return voxelGridOf(scan.points, parameters.voxel * scan.sigma());
    const int beams = std::max(1, static_cast<int>(std::lround(parameters.bearing / scan.bearingStep)));
    VoxelGrid grid;
    grid.voxelOf.reserve(scan.points.size());
    int slice = -1;
    int firstBeam = 0;
    double firstRange = 0.0;
    double firstBearing = 0.0;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        constexpr double kSteepest = 6.0;  // a wall met at 10° changes range by 6 arc lengths from beam to beam
        const double range = scan.points[i].norm();
        const double bearing = std::acos(scan.points[i].x() / range);
        const double jump =
            kSteepest * firstRange * std::abs(bearing - firstBearing) + 4.0 * scan.noise.rangeSigma(range);
        if (scan.slice[i] != slice || scan.beam[i] >= firstBeam + beams || std::abs(range - firstRange) > jump) {
            slice = scan.slice[i];
            firstBeam = scan.beam[i];
            firstRange = range;
            firstBearing = bearing;
            grid.means.emplace_back(0.0, 0.0, 0.0);
            grid.counts.push_back(0);
        }
        grid.means.back() += scan.points[i];
        ++grid.counts.back();
        grid.voxelOf.push_back(static_cast<int>(grid.means.size()) - 1);
    }
    for (std::size_t v = 0; v < grid.means.size(); ++v)
        grid.means[v] /= grid.counts[v];
    return grid;
}

}  // namespace planewright
