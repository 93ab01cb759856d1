// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/simulation/random.h"

namespace planewright {

/// Draws points that are near to one another, among points that become fewer.
class NeighbourPicker {
public:
    /// Points of one draw are at most `maxDistance` [m] from the first of them.
    NeighbourPicker(const std::vector<Eigen::Vector3d>& points, double maxDistance);

    /// Three different points that span a triangle, or none where the first has no such neighbours.
    std::optional<std::array<int, 3>> draw(Random& random) const;

    /// Takes points out.
    void remove(const std::vector<int>& members);

    /// Those that are left.
    const std::vector<int>& left() const { return left_; }

private:
    const std::vector<Eigen::Vector3d>& points_;
    double maxDistance_;
    std::vector<int> left_;
    std::vector<std::vector<int>> cubes_;           // the points left in each cube of that edge
    std::vector<int> cubeOf_;                       // of each point
    std::vector<std::vector<int>> neighbourCubes_;  // of each cube: those around it, and itself
};

}  // namespace planewright
