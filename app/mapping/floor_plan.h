// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "app/mapping/map_floors.h"
#include "core/formats/floor_plan_svg.h"
#include "core/formats/plane_result.h"
#include "core/types/error.h"

namespace planewright {

/// What kinds of files a plan of a map may be.
inline constexpr std::array<std::string_view, 2> kMapPlanSuffixes{".dxf", ".svg"};

/// A plan of one floor, seen from above in the frame of the building.
struct FloorPlan {
    int floor = 0;
    double height = 0.0;              ///< at which it is cut [m]
    bool isFloorKnown = false;        ///< or else the height is counted from the scanner of the first stop
    std::vector<PlaneResult> planes;  ///< of that floor
    std::vector<PlanStop> stops;      ///< those that are placed
};

/// The plan of a floor, cut so high above its largest plane of the class floor [m]. Where there is none, it is cut at
/// the height of the first stop's scanner.
FloorPlan floorPlanOf(const MappedFloor& floor, std::span<const StopScan> stops, double cutHeight);

/// Draws a plan as the suffix says; an SVG at a scale of 1 to `denominator`. Errors: NotWritten.
Result<void> writeFloorPlan(std::ostream& out, std::string_view suffix, const FloorPlan& plan, double denominator);

/// Where a floor's plan goes if there are several: `plan.dxf` becomes `plan-floor-2.dxf`.
std::string floorPlanPath(const std::string& path, int floor);

}  // namespace planewright
