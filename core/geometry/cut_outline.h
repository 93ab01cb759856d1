// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/outline.h"

namespace planewright {

/// A straight piece of a plan, seen from above [m].
struct PlanLine {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
};

/// Where an outline crosses a height z [m]: a piece for each stretch in which it is there, holes left out. None where
/// it lies above, below, or level. `normal` is that of the outline's plane.
std::vector<PlanLine> cutAtHeight(const Outline& outline, const Eigen::Vector3d& normal, double height);

}  // namespace planewright
