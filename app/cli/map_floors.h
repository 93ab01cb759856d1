// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <span>
#include <vector>

#include "app/files/map_results.h"
#include "core/mapping/map_builder.h"
#include "core/types/error.h"

namespace planewright {

/// The map of a floor, and where its frame is in the building.
struct MappedFloor {
    int floor = 0;
    Pose frame;
    MapBuilder builder;
    std::vector<JoinReport> joins;  ///< of each of its stops
};

/// Makes a map of each floor, adjusted as a whole; `frames` are those of the floors by their numbers. Shows progress.
/// Errors: Unreadable for a stop that no map can be made of.
Result<std::vector<MappedFloor>> mapFloors(std::span<const StopScan> stops, std::span<const FloorScans> floors,
                                           const std::map<int, Pose>& frames);

}  // namespace planewright
