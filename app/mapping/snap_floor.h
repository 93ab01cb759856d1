// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "core/geometry/pose.h"
#include "core/mapping/building_map.h"
#include "core/types/error.h"

namespace planewright {

/// A plane of a floor as it was seen: its normal points away from who saw it.
struct FacedPlane {
    Eigen::Vector3d normal;
    double distance = 0.0;  ///< n·p [m]
    std::vector<Outline::Polygon> parts;
};

/// The planes of a floor's map, in the frame that `frame` leads into.
std::vector<FacedPlane> facedPlanes(const BuildingMap& map, const Pose& frame);

/// How a floor comes to stand over the walls of another one.
struct FloorSnap {
    Pose motion;           ///< of the floor in the frame of both: a turn about the vertical and a level shift
    int walls = 0;         ///< of the floor that stand over walls of the other
    double rms = 0.0;      ///< how far they are off these then, in their middles [m]
    bool isFixed = false;  ///< false where all these walls are parallel: along them the floor stays as it is
};

/// Finds the turn, of 35° at most, and the shift, of 3 m at most each way, on which most walls of a floor agree to
/// stand over those of another. Partners are upright planes that face the same way and are beside each other for half a
/// metre and more. Both are in one frame whose z is up. Floors that share few walls may find a shift on which more of
/// the others agree: what comes out is to be looked at. Errors (Usage): no wall has a partner.
Result<FloorSnap> snapFloor(std::span<const FacedPlane> floor, std::span<const FacedPlane> onto);

}  // namespace planewright
