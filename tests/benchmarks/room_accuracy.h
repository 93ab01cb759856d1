// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/evaluation/compare_labels.h"
#include "core/params/parameters.h"
#include "core/simulation/nodding_scanner.h"
#include "core/types/snapshot.h"

namespace planewright {

/// A simulated room and its scan.
struct Room {
    std::string name;
    std::uint64_t seed = 0;
    Scene scene;
    SimulationNoise noise;
    SimulatedScan scan;
};

/// A plane that was found, and how far it is from the true one.
struct PlaneDeviation {
    int id = 0;
    int truth = 0;       ///< id of the true plane
    double bound = 0.0;  ///< e'Fe: its error e in terms of the information F that all true points have
    double own = 0.0;    ///< e'C⁻¹e: in terms of its own covariance C
};

/// What was found in a room.
struct RoomAccuracy {
    std::shared_ptr<const Snapshot> found;
    double milliseconds = 0.0;               ///< median over a few repeats
    LabelComparison at50, at80;              ///< matches that share half, and four fifths, of both regions
    std::vector<PlaneDeviation> deviations;  ///< of the planes matched at 50 %, but for groups of coplanar ones
};

/// Extracts the planes of a room and compares them with the true ones of at least so many returns.
RoomAccuracy measure(const Room& room, const Parameters& parameters, std::int64_t minReturns);

/// The plane of an id.
const Plane& planeOf(int id, const Snapshot& found);

}  // namespace planewright
