// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "tests/benchmarks/opponents/point_scan.h"

namespace planewright {

/// Points reduced to one mean per occupied voxel.
struct VoxelGrid {
    std::vector<Eigen::Vector3d> means;  ///< [m], in the order in which the points first touch their voxel
    std::vector<int> counts;             ///< points of each voxel
    std::vector<int> voxelOf;            ///< voxel of each point
};

/// The voxel grid filter with cubes of this edge [m].
VoxelGrid voxelGridOf(const std::vector<Eigen::Vector3d>& points, double edge);

/// How a scan is reduced before planes are looked for.
struct ReductionParameters {
    double voxel = 7.0;    ///< edge of cubes, in standard deviations of a range at the median range
    double bearing = 0.0;  ///< or the neighbouring beams of a slice within this angle make a voxel, whose size then
                           ///< grows with range [rad]; 0 = cubes
};

/// The scan's voxels.
VoxelGrid reduced(const PointScan& scan, const ReductionParameters& parameters);

}  // namespace planewright
