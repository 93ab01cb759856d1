// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/outline.h"
#include "core/geometry/plane_frame.h"
#include "core/geometry/pose.h"

namespace planewright {

/// Where a plane was seen, made ready for many comparisons: the outer rings of its parts with few corners [m].
using Extent = std::vector<std::vector<Eigen::Vector3d>>;

/// Of the parts of an outline on a plane of this normal; corners nearer than `tolerance` [m] to the ring are left out.
Extent extentOf(const std::vector<Outline::Polygon>& parts, const Eigen::Vector3d& normal, double tolerance);

/// An extent moved by a pose, in coordinates of a frame on a plane.
std::vector<PlanarRing> onPlane(const Extent& extent, const Pose& pose, const PlaneFrame& frame);

/// True where two areas overlap or are at most `gap` [m] apart. Rings are counter-clockwise or clockwise.
bool meet(std::span<const PlanarRing> a, std::span<const PlanarRing> b, double gap);

/// True where a point lies inside one of the rings.
bool contains(std::span<const PlanarRing> rings, const Eigen::Vector2d& point);

}  // namespace planewright
