// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "core/geometry/cloud_scan.h"

namespace planewright {

/// The axis that the planes of all slices go through, and what each slice looks like about it.
struct PitchAxis {
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
    std::vector<Eigen::Vector3d> ahead;  ///< of each slice: in its plane, at a right angle to the axis, where most of
                                         ///< its points are; zero where it has none off the axis
};

/// The common axis by least squares over the directions of all points: the sum of their squared distances from planes
/// through it, one for each slice, on the unit sphere. An axis within 1e-5 rad of one of the frame's is that one. The
/// direction is the one about which bearings rise in the order of the points. Nothing where all slices lie in one
/// plane, so that any axis in it would do.
std::optional<PitchAxis> fitPitchAxis(const std::vector<CloudSlice>& slices);

}  // namespace planewright
