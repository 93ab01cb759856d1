// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "app/mapping/map_edits.h"
#include "app/mapping/map_results.h"
#include "core/formats/trajectory_tum.h"
#include "core/mapping/map_builder.h"
#include "core/params/mapping_parameters.h"
#include "core/types/error.h"

namespace planewright {

/// The map of a floor, and where its frame is in the building.
struct MappedFloor {
    int floor = 0;
    Pose frame;
    MapBuilder builder;
    std::vector<JoinReport> joins;      ///< of each of its stops
    std::vector<std::string> problems;  ///< edits that could not be applied
};

/// How a map is made.
struct MappingPlan {
    MappingParameters parameters;
    std::vector<StopEdit> edits = {};                                      ///< matches by hand among them
    std::function<void(std::size_t done, std::size_t all)> progress = {};  ///< hears of every stop, where set
    std::stop_token stop = {};
};

/// Makes a map of each floor, adjusted as a whole; `frames` are those of the floors by their numbers. Errors:
/// Unreadable for a stop that no map can be made of; Interrupted after a stop.
Result<std::vector<MappedFloor>> mapFloors(std::span<const StopScan> stops, std::span<const FloorScans> floors,
                                           const std::map<int, Pose>& frames, const MappingPlan& plan);

/// Puts floors where they were placed by hand (floorsByHand); the others stay. A floor whose stop is not placed on it
/// stays too, and says so among its problems.
void placeFloors(std::span<MappedFloor> floors, const std::map<int, Pose>& ofStops);

/// The planes of all floors in the frame of the building, numbered from 0.
std::vector<PlaneResult> planesOfFloors(std::span<const MappedFloor> floors, std::span<const StopScan> stops);

/// Where the stops that are placed are in the building, with their numbers as times, in their order.
std::vector<StampedPose> posesOfFloors(std::span<const MappedFloor> floors);

}  // namespace planewright
