// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <span>

#include "core/formats/floor_plan_sketch.h"
#include "core/formats/plane_result.h"
#include "core/types/error.h"

namespace planewright {

/// Draws a plan as SVG at a true scale of 1 to `denominator`: a line for each stretch in which an outline crosses the
/// height [m], over a grid and with a bar; squared to its walls. `stops` are marked with their numbers. Errors:
/// NotWritten.
///
/// CSS classes as roomDrawings, and `stop`.
Result<void> writeFloorPlanSvg(std::ostream& out, std::span<const PlaneResult> planes, double height,
                               double denominator, std::span<const PlanStop> stops);

}  // namespace planewright
