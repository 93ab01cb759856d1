// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <optional>
#include <span>

#include "core/formats/plane_result.h"
#include "core/types/error.h"

namespace planewright {

/// Writes planes as a DXF drawing in space: the triangles of their outlines as 3DFACE, wound counter-clockwise seen
/// from +n, and each ring and hole as a closed POLYLINE; a layer for each class. Metres. Errors: NotWritten.
Result<void> writePlanesDxf(std::ostream& out, std::span<const PlaneResult> planes);

/// How high the floor is: the centroid of the largest plane of the class `floor` [m]. Nothing where there is none.
std::optional<double> floorHeight(std::span<const PlaneResult> planes);

/// Writes a plan as a DXF drawing seen from above: a LINE for each stretch in which an outline crosses the height [m],
/// with z = 0; a layer for each class. x right, y forward, metres. Errors: NotWritten.
Result<void> writeFloorPlanDxf(std::ostream& out, std::span<const PlaneResult> planes, double height);

}  // namespace planewright
