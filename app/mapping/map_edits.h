// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/mapping/map_results.h"
#include "app/mapping/stop_inputs.h"
#include "core/formats/map_edit.h"
#include "core/mapping/map_builder.h"
#include "core/types/error.h"

namespace planewright {

/// An edit of a map and the file that holds it, whose scans it names.
struct StopEdit {
    std::string path;
    MapEdit edit;
};

/// The edits in force that recordings hold, file by file in their order. What cannot be used of them is told to
/// `problems`. Errors: Unreadable.
Result<std::vector<StopEdit>> mapEditsOf(std::span<const std::string> paths, std::vector<std::string>& problems);

/// The stops that are left, in their order, with the odometry that was typed in. An edit of a stop that is not there is
/// told to `problems`.
std::vector<StopInput> withEdits(std::vector<StopInput> inputs, std::span<const StopEdit> edits,
                                 std::vector<std::string>& problems);

/// Where floors were placed by hand: the pose in the building of one stop of each such floor, by the stop's number.
std::map<int, Pose> floorsByHand(std::span<const StopScan> stops, std::span<const StopEdit> edits);

/// Matches planes of a floor's stops as edits say; the map follows at the next adjust(). An edit that cannot be applied
/// is told to `problems`; those of stops on other floors are not looked at.
void matchByHand(MapBuilder& builder, std::span<const StopScan> stops, std::span<const StopEdit> edits,
                 std::vector<std::string>& problems);

}  // namespace planewright
