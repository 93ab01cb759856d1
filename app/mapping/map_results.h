// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/formats/plane_result.h"
#include "core/geometry/pose.h"
#include "core/mapping/building_map.h"
#include "core/mapping/stop.h"
#include "core/types/error.h"

namespace planewright {

/// A stop of a map as a file gave it.
struct StopScan {
    std::string name;  ///< as people call it: file and scan
    std::string path;
    int scan = 0;  ///< its number in a `.pwscan`; 0 where the file has just one
    int floor = 0;
    std::optional<Pose> odometry;     ///< where wheels tell it to be, in a frame of their own
    std::vector<PlaneResult> planes;  ///< in the stop's frame
};

/// The stops of one floor, in their order.
struct FloorScans {
    int floor = 0;
    std::vector<std::size_t> stops;  ///< their numbers over all floors
};

/// The floors of a building from the lowest up.
std::vector<FloorScans> floorsOf(std::span<const StopScan> stops);

/// A stop as a map takes it; the motion leads from the stop before it on its floor. Planes without a covariance, as the
/// preset `paper` gives them, are an Unreadable error.
Result<Stop> stopOf(const StopScan& scan, int number, const StopScan* before);

/// The planes of a map of these stops, in the frame that `frame` puts it in, numbered from `firstId`: with the outline
/// of all that saw them, the name and class that most of these gave, and their stops.
std::vector<PlaneResult> mapPlaneResults(const BuildingMap& map, std::span<const StopScan> stops, const Pose& frame,
                                         PlaneId firstId);

}  // namespace planewright
