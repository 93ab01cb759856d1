// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/prosac_only.h"

#include <numeric>

#include "tests/benchmarks/opponents/prosac_planes.h"

namespace planewright {

OpponentResult ProsacOnly::extract(const PointScan& scan) const
{
    const VoxelGrid grid = reduced(scan, parameters_.reduction);
    std::vector<int> members(grid.means.size());
    std::iota(members.begin(), members.end(), 0);
    std::vector<int> voxelLabels(grid.means.size(), -1);
    const auto minReturns =
        static_cast<std::int64_t>(parameters_.finish.support * static_cast<double>(scan.minReturns));
    const ProsacSearch search{parameters_.toleranceSigmas * placeSigma(scan), parameters_.iterations, minReturns,
                              false};
    Random random(1);
    OpponentResult result;
    takeProsacPlanes(grid, members, search, random, result.planes, voxelLabels);
    result.labels = pointLabels(grid, voxelLabels);
    finishPlanes(scan, parameters_.finish, result);
    return result;
}

}  // namespace planewright
