// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/outline.h"

namespace planewright {

/// Corners of a triangle, counter-clockwise seen from +n [m].
using Triangle = std::array<Eigen::Vector3d, 3>;

/// Triangles that cover an outline's parts without their holes, and nothing else.
///
/// They meet edge to edge, so that no light shines through between them; for this, corners are added within the
/// outline's edges. `normal` is the unit normal of the outline's plane.
std::vector<Triangle> triangulate(const Outline& outline, const Eigen::Vector3d& normal);

}  // namespace planewright
