// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/mapping/floor_plan.h"
#include "app/mapping/map_edits.h"
#include "app/mapping/map_floors.h"
#include "app/mapping/stop_inputs.h"
#include "core/params/parameters.h"
#include "core/types/error.h"
#include "ui/common/shown_map.h"

namespace planewright {

/// What map is to be made of a recording's scans.
struct BuildingRequest {
    std::string path;
    std::vector<MapEdit> edits;    ///< those in force
    std::optional<int> until;      ///< the map as it was after so many stops; none: after all
    std::optional<int> readAgain;  ///< a scan whose planes may have been edited since
    std::function<Result<std::vector<ParametersFrom>>(const std::string& scanner, std::vector<ParametersFrom> stored)>
        parameters;
};

/// A map with all that is shown and written of it.
struct BuiltMap {
    std::vector<StopScan> stops;
    std::vector<MappedFloor> floors;
    std::vector<PlaneResult> planes;  ///< of all floors
    std::vector<FloorPlan> plans;     ///< of each floor, cut at the floor itself
    Parameters parameters;            ///< of the last extraction
    std::shared_ptr<const ShownMap> shown;
    std::vector<std::string> problems;  ///< what could not be read or applied
};

/// Makes maps of a recording's scans, one after the other on one thread; the planes of a scan are extracted once.
///
/// Several floors stand where odometry says: the first stop of each floor is the floor's frame, and its pose by
/// odometry is that frame's.
class BuildingMaker {
public:
    /// Hears how far it is.
    using Progress = std::function<void(const char* what, std::size_t done, std::size_t all)>;

    /// Errors: Interrupted after a stop; Unreadable, naming what cannot be used.
    Result<std::shared_ptr<const BuiltMap>> make(const BuildingRequest& request, const Progress& progress,
                                                 const std::stop_token& stop);

private:
    Result<std::vector<StopScan>> stopsOf(const std::vector<StopInput>& inputs, const BuildingRequest& request,
                                          const Progress& progress, const std::stop_token& stop, BuiltMap& built);

    std::string path_;
    std::map<int, ReadStop> read_;  ///< by the scan's number
};

}  // namespace planewright
