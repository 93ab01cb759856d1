// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/connected_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "tests/benchmarks/opponents/voxel_grid.h"

namespace planewright {

namespace {

int rootOf(std::vector<int>& parent, int x)
{
    while (parent[static_cast<std::size_t>(x)] != x) {
        int& up = parent[static_cast<std::size_t>(x)];
        up = parent[static_cast<std::size_t>(up)];
        x = up;
    }
    return x;
}

}  // namespace

std::vector<std::vector<int>> connectedGroups(const std::vector<Eigen::Vector3d>& points,
                                              const std::vector<int>& members, double gap)
{
    std::vector<Eigen::Vector3d> own;
    own.reserve(members.size());
    for (const int member : members)
        own.push_back(points[static_cast<std::size_t>(member)]);
    const VoxelGrid cubes = voxelGridOf(own, gap);

    // Cubes as integer triples in order; a neighbour is found by bisection.
    using Cube = std::array<int, 3>;
    std::vector<std::pair<Cube, int>> sorted;
    sorted.reserve(cubes.means.size());
    std::vector<char> seen(cubes.means.size(), 0);
    for (std::size_t i = 0; i < own.size(); ++i) {
        const auto cube = static_cast<std::size_t>(cubes.voxelOf[i]);
        if (seen[cube] != 0)
            continue;
        seen[cube] = 1;
        Cube place{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            place[axis] = static_cast<int>(std::floor(own[i][static_cast<Eigen::Index>(axis)] / gap));
        sorted.emplace_back(place, cubes.voxelOf[i]);
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<int> parent(cubes.means.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (const auto& [place, cube] : sorted) {
        for (int neighbour = 14; neighbour < 27; ++neighbour) {  // the half of the 26 neighbours that comes later
            const Cube other{place[0] + neighbour / 9 - 1, place[1] + neighbour / 3 % 3 - 1,
                             place[2] + neighbour % 3 - 1};
            const auto found = std::lower_bound(sorted.begin(), sorted.end(), std::pair{other, -1});
            if (found != sorted.end() && found->first == other)
                parent[static_cast<std::size_t>(rootOf(parent, found->second))] = rootOf(parent, cube);
        }
    }

    std::vector<std::vector<int>> byRoot(cubes.means.size());
    for (std::size_t i = 0; i < own.size(); ++i)
        byRoot[static_cast<std::size_t>(rootOf(parent, cubes.voxelOf[i]))].push_back(members[i]);
    std::erase_if(byRoot, [](const std::vector<int>& group) { return group.empty(); });
    std::stable_sort(byRoot.begin(), byRoot.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return byRoot;
}

}  // namespace planewright
