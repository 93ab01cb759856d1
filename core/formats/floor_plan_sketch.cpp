// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/floor_plan_sketch.h"

#include "core/formats/room_drawings.h"
#include "core/geometry/cut_outline.h"

namespace planewright {

FloorPlanSketch floorPlanSketch(std::span<const PlaneResult> planes, double height, std::span<const PlanStop> stops)
{
    FloorPlanSketch sketch;
    const Eigen::Vector2d forward = squaredDirection(planes);
    const Eigen::Vector2d right{forward.y(), -forward.x()};
    const auto seen = [&](const Eigen::Vector2d& place) {
        const Eigen::Vector2d turned{right.dot(place), forward.dot(place)};
        sketch.lowest = sketch.lowest.cwiseMin(turned);
        sketch.highest = sketch.highest.cwiseMax(turned);
        return turned;
    };
    for (const PlaneResult& plane : planes) {
        for (const PlanLine& line : cutAtHeight(plane.outline, plane.plane->normal, height))
            sketch.lines.push_back({plane.className == "wall", seen(line.from), seen(line.to)});
    }
    for (const PlanStop& stop : stops)
        sketch.stops.push_back({seen(stop.place), stop.number});
    return sketch;
}

}  // namespace planewright
