// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/outline.h"
#include "core/types/edited_plane.h"
#include "core/types/plane.h"
#include "core/types/snapshot.h"

namespace planewright {

/// A plane with what files and tables say about it.
struct PlaneResult {
    std::shared_ptr<const Plane> plane;
    Outline outline;              ///< without parts where it is not known
    std::string name;             ///< given by the user; empty if none
    std::string className;        ///< floor, ceiling, wall, …; empty if none
    std::vector<int> stops = {};  ///< of a map: the stops that saw it, from 0
};

/// The planes of a snapshot in order of id, each with its outline.
std::vector<PlaneResult> planeResults(const Snapshot& snapshot);

/// Planes as the operator sees them in the order given, each with its outline; `log` holds their segments.
std::vector<PlaneResult> planeResults(std::span<const EditedPlane> planes, const SegmentLog& log);

/// A plane of which only parameters, name and scan points are known, as a simulated room has them; files leave the rest
/// empty. Turns normal and distance [m] round where needed (makeCanonical).
PlaneResult knownPlane(PlaneId id, std::string_view name, const Eigen::Vector3d& normal, double distance, int points);

}  // namespace planewright
