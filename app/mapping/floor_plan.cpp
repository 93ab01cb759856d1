// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/floor_plan.h"

#include "core/formats/planes_dxf.h"

namespace planewright {

FloorPlan floorPlanOf(const MappedFloor& floor, std::span<const StopScan> stops, double cutHeight)
{
    FloorPlan plan;
    plan.floor = floor.floor;
    plan.planes = mapPlaneResults(floor.builder.map(), stops, floor.frame, 0);
    const auto ground = floorHeight(plan.planes);
    plan.isFloorKnown = ground.has_value();
    plan.height = ground ? *ground + cutHeight : floor.frame.translation.z();
    for (const MapStop& stop : floor.builder.map().stops) {
        if (stop.isPlaced())
            plan.stops.push_back({(floor.frame * stop.pose).translation.head<2>(), stop.stop->id});
    }
    return plan;
}

Result<void> writeFloorPlan(std::ostream& out, std::string_view suffix, const FloorPlan& plan, double denominator)
{
    if (suffix == ".dxf")
        return writeFloorPlanDxf(out, plan.planes, plan.height);
    return writeFloorPlanSvg(out, plan.planes, plan.height, denominator, plan.stops);
}

std::string floorPlanPath(const std::string& path, int floor)
{
    const std::size_t dot = path.rfind('.');
    return path.substr(0, dot) + "-floor-" + std::to_string(floor) + path.substr(dot);
}

}  // namespace planewright
