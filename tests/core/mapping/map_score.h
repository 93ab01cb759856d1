// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "core/mapping/building_map.h"
#include "tests/core/mapping/simulated_floor.h"

namespace planewright {

/// A map against what is true.
struct MapScore {
    int wrong = 0;               ///< sightings that belong to another true plane than the first one of their map plane
    int possible = 0;            ///< sightings of a true plane that an earlier stop had seen at an overlapping place
    int made = 0;                ///< of these, the ones that share a map plane with such an earlier sighting
    int open = 0;                ///< sightings left open
    std::vector<double> shifts;  ///< error of each stop's place but the first, where it is said to be known to 1 cm [m]
    std::vector<double> turns;   ///< and of its attitude, where that is said to be known to 0.1° [rad]
    std::vector<double> poseErrors;   ///< e'C⁻¹e of each stop but the first, 6 expected
    std::vector<double> planeErrors;  ///< of each plane of the map, 3 expected; those of wrong sightings left out
};

/// `stops` are those that were joined, in order, `planes` the true ones that they name; errors are in the frame of the
/// first.
MapScore scoreMap(const BuildingMap& map, std::span<const SimulatedStop> stops, std::span<const OrientedPlane> planes);

double meanOf(std::span<const double> values);

}  // namespace planewright
