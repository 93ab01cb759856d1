// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/map_floors.h"

#include <utility>

#include "app/cli/progress.h"

namespace planewright {

Result<std::vector<MappedFloor>> mapFloors(std::span<const StopScan> stops, std::span<const FloorScans> floors,
                                           const std::map<int, Pose>& frames)
{
    std::vector<MappedFloor> mapped;
    Progress progress("mapping, stop");
    std::size_t done = 0;
    for (const FloorScans& floor : floors) {
        MappedFloor& map = mapped.emplace_back();
        map.floor = floor.floor;
        map.frame = frames.at(floor.floor);
        const StopScan* before = nullptr;
        for (const std::size_t number : floor.stops) {
            progress.show(done++, stops.size());
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
        if (const auto adjusted = map.builder.adjust(); !adjusted)
            return tl::unexpected{adjusted.error()};
    }
    return mapped;
}

}  // namespace planewright
