// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/neighbour_picker.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>

#include "tests/benchmarks/opponents/voxel_grid.h"

namespace planewright {

NeighbourPicker::NeighbourPicker(const std::vector<Eigen::Vector3d>& points, double maxDistance)
    : points_(points), maxDistance_(maxDistance), left_(points.size())
{
    std::iota(left_.begin(), left_.end(), 0);
    const VoxelGrid grid = voxelGridOf(points, maxDistance);
    cubeOf_ = grid.voxelOf;
    cubes_.resize(grid.means.size());
    std::map<std::array<int, 3>, int> places;
    const auto placeOf = [&](const Eigen::Vector3d& point) {
        std::array<int, 3> place{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            place[axis] = static_cast<int>(std::floor(point[static_cast<Eigen::Index>(axis)] / maxDistance));
        return place;
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        cubes_[static_cast<std::size_t>(cubeOf_[i])].push_back(static_cast<int>(i));
        places.emplace(placeOf(points[i]), cubeOf_[i]);
    }
    neighbourCubes_.resize(cubes_.size());
    for (const auto& [place, cube] : places) {
        for (int n = 0; n < 27; ++n) {
            const auto found = places.find({place[0] + n / 9 - 1, place[1] + n / 3 % 3 - 1, place[2] + n % 3 - 1});
            if (found != places.end())
                neighbourCubes_[static_cast<std::size_t>(cube)].push_back(found->second);
        }
    }
}

std::optional<std::array<int, 3>> NeighbourPicker::draw(Random& random) const
{
    constexpr int kTries = 12;
    const auto oneOf = [&](const std::vector<int>& list) {
        return list[static_cast<std::size_t>(random.integer(0, static_cast<int>(list.size()) - 1))];
    };
    std::array<int, 3> drawn{oneOf(left_), -1, -1};
    const Eigen::Vector3d& first = points_[static_cast<std::size_t>(drawn[0])];
    const std::vector<int>& around =
        neighbourCubes_[static_cast<std::size_t>(cubeOf_[static_cast<std::size_t>(drawn[0])])];
    std::size_t count = 1;
    for (int attempt = 0; attempt < kTries && count < 3; ++attempt) {
        const std::vector<int>& cube = cubes_[static_cast<std::size_t>(oneOf(around))];
        if (cube.empty())
            continue;
        const int other = oneOf(cube);
        if (other == drawn[0] || other == drawn[1])
            continue;
        const Eigen::Vector3d side = points_[static_cast<std::size_t>(other)] - first;
        if (side.norm() > maxDistance_ || side.norm() < 0.2 * maxDistance_)
            continue;
        if (count == 2) {
            // A thin triangle says nothing of the plane's direction.
            const Eigen::Vector3d before = points_[static_cast<std::size_t>(drawn[1])] - first;
            if (before.cross(side).norm() < 0.5 * before.norm() * side.norm())
                continue;
        }
        drawn[count++] = other;
    }
    if (count < 3)
        return std::nullopt;
    return drawn;
}

void NeighbourPicker::remove(const std::vector<int>& members)
{
    std::vector<char> gone(points_.size(), 0);
    std::vector<int> touched;
    for (const int member : members) {
        gone[static_cast<std::size_t>(member)] = 1;
        touched.push_back(cubeOf_[static_cast<std::size_t>(member)]);
    }
    const auto isGone = [&](int point) { return gone[static_cast<std::size_t>(point)] != 0; };
    std::erase_if(left_, isGone);
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const int cube : touched)
        std::erase_if(cubes_[static_cast<std::size_t>(cube)], isGone);
}

}  // namespace planewright
