// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "core/evaluation/compare_planes.h"
#include "core/evaluation/plane_errors.h"
#include "core/types/snapshot.h"

namespace planewright {

/// What two planes of two maps of one scan must have to be one.
struct MapMatchLimits {
    PlaneMatchLimits apart{};
    double overlap = 0.25;  ///< least share of common beams in all beams of both, 0 to 1
};

/// A plane of map A and the plane of map B that it is.
struct PairedPlanes {
    PlaneId a = kNoPlane;
    PlaneId b = kNoPlane;
    PlaneDifference difference;
    double overlap = 0.0;  ///< share of common beams in all beams of both
};

/// A plane that has no partner, and the plane of the other map that has most of its beams.
struct UnpairedPlane {
    PlaneId plane = kNoPlane;
    PlaneId nearest = kNoPlane;  ///< kNoPlane where none shares a beam
    double share = 0.0;          ///< of its beams that are the nearest's
};

/// How two maps of the same slices differ.
struct MapComparison {
    std::vector<PairedPlanes> pairs;   ///< in order of A's ids
    std::vector<UnpairedPlane> onlyA;  ///< in order of id
    std::vector<UnpairedPlane> onlyB;  ///< in order of id
    PlaneErrors errors;                ///< of the pairs
};

/// Pairs the planes of two extractions of the same slices, as after different parameters.
///
/// A plane is seen by the beams of its segments. Of the pairs within the limits the one with the largest overlap is
/// taken first (then the nearest in angle, then in order), each plane once.
MapComparison compareMaps(const Snapshot& a, const Snapshot& b, const MapMatchLimits& limits = {});

}  // namespace planewright
