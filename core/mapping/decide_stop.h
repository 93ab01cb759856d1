// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "core/mapping/building_map.h"
#include "core/mapping/match_stop.h"
#include "core/mapping/near_planes.h"
#include "core/params/mapping_parameters.h"

namespace planewright {

/// Where a stop is, and what that rests on.
struct StopDecision {
    StopTrust trust = StopTrust::Unplaced;
    StopMatch match;                 ///< of a stop that is placed; its registration holds the pose
    std::vector<Pose> alternatives;  ///< other poses that the planes would allow
};

/// Weighs what a stop's planes and odometry say.
///
/// Matched where odometry expects it, and looked for by its planes alone within reach of that, whatever its heading.
/// The planes decide where they match clearly more in another place than where odometry says, if that place is the only
/// one; odometry decides where they would match as well in several. Where neither does, the stop is not placed.
StopDecision decideStop(const Stop& stop, const StopExtents& extents, const NearPlanes& near, const PosePrior& expected,
                        const MappingParameters& parameters);

/// The same without odometry: placed where the planes fix a place, and only one.
StopDecision decideStop(const Stop& stop, const StopExtents& extents, const NearPlanes& near,
                        const MappingParameters& parameters);

/// Other poses within reach of where a stop is expected at which its planes would be about as many of the map's as in a
/// match, those left out that both match alike.
std::vector<Pose> rivalsOf(const StopMatch& match, const Stop& stop, const StopExtents& extents, const NearPlanes& near,
                           const PosePrior& expected, const MappingParameters& parameters);

}  // namespace planewright
