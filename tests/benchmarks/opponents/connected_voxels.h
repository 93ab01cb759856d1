// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <Eigen/Core>

namespace planewright {

/// Splits points, given by their places in `points`, into groups whose members can be reached in steps of at most `gap`
/// [m] along each axis, rounded up to cubes of that edge; largest group first.
std::vector<std::vector<int>> connectedGroups(const std::vector<Eigen::Vector3d>& points,
                                              const std::vector<int>& members, double gap);

}  // namespace planewright
