// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/prosac_normal.h"

#include <algorithm>

#include "tests/benchmarks/opponents/connected_voxels.h"
#include "tests/benchmarks/opponents/normal_clusters.h"
#include "tests/benchmarks/opponents/prosac_planes.h"
#include "tests/benchmarks/opponents/voxel_normals.h"

namespace planewright {

OpponentResult ProsacNormal::extract(const PointScan& scan) const
{
    constexpr std::size_t kSmallestCluster = 8;  // voxels
    const VoxelGrid grid = reduced(scan, parameters_.reduction);
    const PointNormals normals = normalsOf(grid.means, parameters_.neighbours);
    const auto minReturns =
        static_cast<std::int64_t>(parameters_.finish.support * static_cast<double>(scan.minReturns));
    const ProsacSearch search{parameters_.toleranceSigmas * placeSigma(scan), parameters_.iterations, minReturns, true};
    std::vector<int> voxelLabels(grid.means.size(), -1);
    Random random(1);
    OpponentResult result;
    for (std::vector<int>& cluster : clustersOfNormals(normals.normals, parameters_.clusterAngle, kSmallestCluster)) {
        std::vector<std::vector<int>> groups;
        if (parameters_.gap > 0.0)
            groups = connectedGroups(grid.means, cluster, parameters_.gap * scan.spacing());
        else
            groups.push_back(std::move(cluster));
        for (std::vector<int>& group : groups) {
            std::stable_sort(group.begin(), group.end(), [&](int a, int b) {
                return normals.curvature[static_cast<std::size_t>(a)] < normals.curvature[static_cast<std::size_t>(b)];
            });
            takeProsacPlanes(grid, group, search, random, result.planes, voxelLabels);
        }
    }
    result.labels = pointLabels(grid, voxelLabels);
    finishPlanes(scan, parameters_.finish, result);
    return result;
}

}  // namespace planewright
