// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "core/simulation/random.h"
#include "tests/benchmarks/opponents/opponent.h"
#include "tests/benchmarks/opponents/voxel_grid.h"

namespace planewright {

/// When a search for planes takes a point in, and when it gives up.
struct ProsacSearch {
    double tolerance = 0.03;      ///< largest distance of an inlier [m]
    int iterations = 1000;        ///< most hypotheses of a plane
    std::int64_t minReturns = 0;  ///< least returns in the voxels of a plane
    bool ordered = false;         ///< `members` come best first; otherwise their order is drawn
};

/// Takes planes by PCL's ProgressiveSampleConsensus out of some voxels, the best-supported first, each refined by PCL's
/// least squares, and labels their voxels. Members that are taken leave the list.
void takeProsacPlanes(const VoxelGrid& grid, std::vector<int>& members, const ProsacSearch& search, Random& random,
                      std::vector<OpponentPlane>& planes, std::vector<int>& voxelLabels);

}  // namespace planewright
