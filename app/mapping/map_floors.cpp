// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/map_floors.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace planewright {

Result<std::vector<MappedFloor>> mapFloors(std::span<const StopScan> stops, std::span<const FloorScans> floors,
                                           const std::map<int, Pose>& frames, const MappingPlan& plan)
{
    std::vector<MappedFloor> mapped;
    std::size_t done = 0;
    for (const FloorScans& floor : floors) {
        MappedFloor& map = mapped.emplace_back();
        map.floor = floor.floor;
        map.frame = frames.at(floor.floor);
        map.builder = MapBuilder(plan.parameters);
        const StopScan* before = nullptr;
        for (const std::size_t number : floor.stops) {
            if (plan.stop.stop_requested())
                return fail(ErrorCode::Interrupted, "making the map was cancelled");
            if (plan.progress)
                plan.progress(done++, stops.size());
            auto stop = stopOf(stops[number], static_cast<int>(number), before);
            if (!stop)
                return tl::unexpected{stop.error()};
            auto joined = map.builder.join(std::move(*stop));
            if (!joined) {
                joined.error().message = stops[number].name + ": " + joined.error().message;
                return tl::unexpected{joined.error()};
            }
            map.joins.push_back(*joined);
            before = &stops[number];
        }
        matchByHand(map.builder, stops, plan.edits, map.problems);
        if (const auto adjusted = map.builder.adjust(); !adjusted)
            return tl::unexpected{adjusted.error()};
    }
    return mapped;
}

void placeFloors(std::span<MappedFloor> floors, const std::map<int, Pose>& ofStops)
{
    for (MappedFloor& floor : floors) {
        for (const MapStop& stop : floor.builder.map().stops) {
            const auto place = ofStops.find(stop.stop->id);
            if (place == ofStops.end())
                continue;
            if (stop.isPlaced())
                floor.frame = place->second * stop.pose.inverse();
            else
                floor.problems.push_back("floor " + std::to_string(floor.floor) + ": stop " +
                                         std::to_string(stop.stop->id) +
                                         ", by which it was placed, is not on the map; place it by another stop");
        }
    }
}

std::vector<PlaneResult> planesOfFloors(std::span<const MappedFloor> floors, std::span<const StopScan> stops)
{
    std::vector<PlaneResult> planes;
    for (const MappedFloor& floor : floors) {
        auto more = mapPlaneResults(floor.builder.map(), stops, floor.frame, static_cast<PlaneId>(planes.size()));
        std::ranges::move(more, std::back_inserter(planes));
    }
    return planes;
}

std::vector<StampedPose> posesOfFloors(std::span<const MappedFloor> floors)
{
    std::vector<StampedPose> poses;
    for (const MappedFloor& floor : floors) {
        for (const MapStop& stop : floor.builder.map().stops) {
            if (stop.isPlaced())
                poses.push_back({static_cast<double>(stop.stop->id), floor.frame * stop.pose});
        }
    }
    std::ranges::sort(poses, {}, &StampedPose::time);
    return poses;
}

}  // namespace planewright
