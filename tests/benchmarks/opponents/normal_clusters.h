// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <Eigen/Core>

namespace planewright {

/// Groups unit vectors by direction: the densest direction first, all within `angle` [rad] of it, and so on with the
/// rest. Opposite vectors are different; zero vectors belong to no group, nor do groups below `minSize`.
std::vector<std::vector<int>> clustersOfNormals(const std::vector<Eigen::Vector3d>& normals, double angle,
                                                std::size_t minSize);

}  // namespace planewright
