// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "tests/benchmarks/opponents/opponent.h"
#include "tests/benchmarks/opponents/voxel_grid.h"

namespace planewright {

/// How the pieces that an extractor finds become planes.
struct FinishParameters {
    double support = 1.0;      ///< least returns of a plane, in smallest planes worth finding
    double mergeAngle = 0.1;   ///< largest angle between the normals of planes that are one [rad]
    double mergeSigmas = 2.0;  ///< and largest distance of either's centroid from the other, in standard deviations at
                               ///< the median range; 0 = none are merged
};

/// Fits every plane to its points by least squares, merges coplanar ones, and fits once more: this time, and in the
/// labels, without the points farther off than four standard deviations of their noise. Planes that are left
/// too small, or are seen by fewer than three slices, go.
void finishPlanes(const PointScan& scan, const FinishParameters& parameters, OpponentResult& result);

/// Gives points without a plane that of a neighbour (up to eight beams aside, one slice up or down) which explains them
/// best, within three standard deviations: the same as the product does for its own labels.
void completeLabels(const PointScan& scan, OpponentResult& result);

/// The labels of the points of labelled voxels.
std::vector<int> pointLabels(const VoxelGrid& grid, const std::vector<int>& voxelLabels);

/// Standard deviation of a point off its plane at the median range [m], by range and pitch noise.
double placeSigma(const PointScan& scan);

}  // namespace planewright
