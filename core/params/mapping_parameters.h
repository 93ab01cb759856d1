// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <tuple>

#include "core/params/parameter.h"
#include "core/params/parameters.h"
#include "core/types/angle.h"

namespace planewright {

/// What the map of several stops takes for granted.
struct MappingParameters {
    double flatness = 2e-3;
    double gap = 0.05;
    double range = 25.0;
    int nearStops = 12;
    double searchReach = 1.5;
    double searchTilt = degrees(5.0);
    double rivalShare = 0.8;
    int leastPairs = 3;
    double chancePlanes = 200.0;
};

constexpr auto rowsOf(const MappingParameters& /*part*/)
{
    return std::tuple{
        Parameter{"map.flatness", &MappingParameters::flatness, Unit::Metre, Range{0.0, 0.05}, "",
                  "How uneven walls are: added to the covariance of every plane of a stop."},
        Parameter{"map.gap", &MappingParameters::gap, Unit::Metre, Range{0.0, 5.0}, "",
                  "Planes are one only if the places where they were seen overlap or are no farther apart."},
        Parameter{"map.range", &MappingParameters::range, Unit::Metre, Range{1.0, 200.0}, "",
                  "Stops farther away than this see no planes in common."},
        Parameter{"map.near-stops", &MappingParameters::nearStops, Unit::Count, Range{1.0, 100.0}, "",
                  "A stop is matched with the planes of so many stops next to it."},
        Parameter{"map.search-reach", &MappingParameters::searchReach, Unit::Metre, Range{0.0, 100.0}, "",
                  "How far from its odometry a stop is looked for by its planes alone."},
        Parameter{"map.search-tilt", &MappingParameters::searchTilt, Unit::Angle, Range{0.0, degrees(180.0)}, "",
                  "How far from upright a stop may stand where it is looked for by its planes alone."},
        Parameter{
            "map.rival-share", &MappingParameters::rivalShare, Unit::None, Range{0.1, 1.0}, "",
            "Another pose is a rival if it matches this share of the planes that the best one does, those left out "
            "that both match alike."},
        Parameter{"map.least-pairs", &MappingParameters::leastPairs, Unit::Count, Range{1.0, 50.0}, "",
                  "With fewer matched planes a stop rests on odometry alone."},
        Parameter{"map.chance-planes", &MappingParameters::chancePlanes, Unit::None, Range{0.0, 1e6}, "",
                  "likelihood.chance-planes of scans that are extracted for a map, if it is less: parts that are one "
                  "plane become one again in the map."},
    };
}
static_assert(defaultsAreInRange<MappingParameters>());

/// What a scan is extracted with for a map.
inline Parameters forMap(Parameters parameters, const MappingParameters& mapping)
{
    double& own = parameters.likelihood.chancePlanes;
    own = std::max(own, mapping.chancePlanes);
    return parameters;
}

}  // namespace planewright
