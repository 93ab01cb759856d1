// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>

#include "app/mapping/faced_plane.h"
#include "app/mapping/snap_height.h"
#include "core/geometry/pose.h"
#include "core/types/error.h"

namespace planewright {

/// How a floor comes to stand over the walls of another one, and at the height that the stairs between both tell.
struct FloorSnap {
    Pose motion;           ///< of the floor in the frame of both: a turn about the vertical and a shift
    int walls = 0;         ///< of the floor that stand over walls of the other
    double rms = 0.0;      ///< how far they are off these then, in their middles [m]
    bool isFixed = false;  ///< false where all these walls are parallel: along them the floor stays as it is
    std::optional<HeightSnap> height;  ///< nothing where no stairs tell it: the floor stays as high as it is
};

/// Finds the turn, of 35° at most, and the shift, of 3 m at most each way, on which most walls of a floor agree to
/// stand over those of another. Partners are upright planes that face the same way and are beside each other for half a
/// metre and more. Both are in one frame whose z is up. Floors that share few walls may find a shift on which more of
/// the others agree: what comes out is to be looked at. There its height is that of `snapHeight`. Errors (Usage): no
/// wall has a partner.
Result<FloorSnap> snapFloor(std::span<const FacedPlane> floor, std::span<const FacedPlane> onto);

}  // namespace planewright
