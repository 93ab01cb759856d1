// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/randomized_hough.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "tests/benchmarks/opponents/ball_accumulator.h"
#include "tests/benchmarks/opponents/connected_voxels.h"
#include "tests/benchmarks/opponents/neighbour_picker.h"

namespace planewright {

namespace {

OpponentPlane leastSquares(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& members)
{
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const int member : members)
        mean += points[static_cast<std::size_t>(member)] / static_cast<double>(members.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const int member : members) {
        const Eigen::Vector3d p = points[static_cast<std::size_t>(member)] - mean;
        scatter += p * p.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    const Eigen::Vector3d normal = solver.eigenvectors().col(0);
    return {normal, normal.dot(mean)};
}

std::vector<int> within(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& candidates,
                        const OpponentPlane& plane, double tolerance)
{
    std::vector<int> near;
    for (const int i : candidates) {
        if (std::abs(plane.normal.dot(points[static_cast<std::size_t>(i)]) - plane.distance) < tolerance)
            near.push_back(i);
    }
    return near;
}

}  // namespace

OpponentResult RandomizedHough::extract(const PointScan& scan) const
{
    constexpr int kDrawsPerVote = 200;  // so many draws a vote needed for a plane, and the next candidate is a miss
    const VoxelGrid grid = reduced(scan, parameters_.reduction);
    const double sigma = placeSigma(scan);
    const double tolerance = parameters_.toleranceSigmas * sigma;
    double farthest = 0.0;
    for (const Eigen::Vector3d& mean : grid.means)
        farthest = std::max(farthest, mean.norm());
    const auto minReturns =
        static_cast<std::int64_t>(parameters_.finish.support * static_cast<double>(scan.minReturns));

    NeighbourPicker picker(grid.means, parameters_.maxDistance * scan.spacing());
    BallAccumulator accumulator(parameters_.cellAngle, parameters_.cellSigmas * sigma, farthest);
    Random random(1);
    OpponentResult result;
    std::vector<int> voxelLabels(grid.means.size(), -1);
    int misses = 0;
    int draws = 0;
    while (misses < parameters_.misses && picker.left().size() >= 3) {
        if (++draws > kDrawsPerVote * parameters_.votes) {
            ++misses;
            draws = 0;
            accumulator.clear();
        }
        const auto drawn = picker.draw(random);
        if (!drawn)
            continue;
        const Eigen::Vector3d& a = grid.means[static_cast<std::size_t>((*drawn)[0])];
        const Eigen::Vector3d& b = grid.means[static_cast<std::size_t>((*drawn)[1])];
        const Eigen::Vector3d& c = grid.means[static_cast<std::size_t>((*drawn)[2])];
        Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
        if (normal.dot(a) < 0.0)
            normal = -normal;
        const BallAccumulator::Cell* cell = accumulator.vote(normal, normal.dot(a));
        if (cell == nullptr || cell->votes < parameters_.votes)
            continue;

        draws = 0;
        OpponentPlane plane{cell->normals.normalized(), cell->distances / cell->votes};
        accumulator.clear();
        std::vector<int> members = within(grid.means, picker.left(), plane, 2.0 * tolerance);
        for (int iteration = 0; iteration < 2 && members.size() >= 3; ++iteration) {
            if (parameters_.gap > 0.0)
                members = connectedGroups(grid.means, members, parameters_.gap * scan.spacing()).front();
            plane = leastSquares(grid.means, members);
            members = within(grid.means, picker.left(), plane, tolerance);
        }
        if (parameters_.gap > 0.0 && !members.empty())
            members = connectedGroups(grid.means, members, parameters_.gap * scan.spacing()).front();
        std::int64_t returns = 0;
        for (const int member : members)
            returns += grid.counts[static_cast<std::size_t>(member)];
        if (returns < minReturns) {
            ++misses;
            continue;
        }
        misses = 0;
        for (const int member : members)
            voxelLabels[static_cast<std::size_t>(member)] = static_cast<int>(result.planes.size());
        result.planes.push_back(plane);
        picker.remove(members);
    }
    result.labels = pointLabels(grid, voxelLabels);
    finishPlanes(scan, parameters_.finish, result);
    return result;
}

}  // namespace planewright
