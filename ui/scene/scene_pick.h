// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/geometry/picking.h"
#include "ui/scene/map_scene.h"

namespace planewright {

/// What a line of sight meets first.
struct Picked {
    Eigen::Vector3d place;     ///< where [m]
    PlaneId plane = kNoPlane;  ///< the plane it is of; none for a point or a segment of none
    std::optional<SegmentId> segment;
    bool isPoint = false;  ///< a scan point: the place is measured
};

/// What the pointer is on: segments and planes as they are shown. A segment of no plane within the tolerance wins over
/// what is behind it; otherwise the nearest plane does, by its area or by one of its segments.
///
/// The tolerance is what Passing::seen gives for the pixels that a pointer may miss by.
std::optional<Picked> pick(const MapScene& scene, const Ray& ray, double tolerance);

/// The scan point nearest to the line of sight among those within the tolerance that nothing is in front of.
std::optional<Picked> pickPoint(const MapScene& scene, const Ray& ray, double tolerance);

}  // namespace planewright
