// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/simulation/building.h"
#include "tests/core/mapping/simulated_floor.h"

namespace planewright {

/// A true plane seen from one of its sides.
struct Side {
    int plane = 0;          ///< its id in the scenes
    bool isTurned = false;  ///< its normal points to the other side than the first stop's scene says

    auto operator<=>(const Side&) const = default;
};

using Tangents = Eigen::Matrix<double, 3, 2>;

/// What the points of a stop tell of a side that it saw: of the plane with this number in ScannedFloor::planes, as
/// information about its tangents there, and d.
struct SideInformation {
    int plane = 0;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/// A floor of a simulated building as it was scanned and found.
struct ScannedFloor {
    std::vector<SimulatedStop> stops;
    std::vector<OrientedPlane> planes;  ///< in the frame of the floor; sides that lie in one plane are one
    std::vector<Tangents> tangents;     ///< of each plane
    std::vector<std::map<Side, SideInformation>> seen;  ///< by each stop
    /// Of each plane that a stop found: the side that most of its points lie on; none for what is no true plane.
    std::vector<std::vector<std::optional<Side>>> sides;
};

/// Scans a floor from each stop of a route, with noise `default` and settings `table8`, and finds its planes with
/// `precise`.
ScannedFloor scanFloor(const SimulatedBuilding& building, const std::vector<BuildingStop>& route, std::uint64_t seed);

/// What a map can know to be one: pieces of true planes, by number, for each plane that a stop found. Two sightings are
/// of one piece where they overlap in their true places, or are of one side and one stop.
std::vector<std::vector<int>> piecesOf(const ScannedFloor& floor);

/// The Cramér-Rao bound of each piece about the tangents of its plane, and d, by all points of all stops and odometry
/// together, with the poses unknown but the first. Points of a side that their stop did not find count for the first
/// piece that the side has.
std::vector<Eigen::Matrix3d> boundsOf(const ScannedFloor& floor, const std::vector<std::vector<int>>& pieces);

}  // namespace planewright
