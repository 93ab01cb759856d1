// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>

#include "app/mapping/faced_plane.h"

namespace planewright {

/// How a floor comes to stand at its height above or below another one.
struct HeightSnap {
    double lift = 0.0;  ///< of the floor [m]
    int surfaces = 0;   ///< level planes and risers of the floor that are also the other's
    double rms = 0.0;   ///< how far these are off then [m]
};

/// Finds the lift, of 1.5 m at most either way, on which most of what two floors see of the stairs between them agrees:
/// treads, landings, and the floor of the lower one as it is seen from above are as high, and so are the tops of
/// risers. Both floors are in one frame whose z is up, and stand over each other.
///
/// Only what lies between the floors they lead to can be seen from both: a storey's own furniture has no say, and
/// floors whose level planes to stand on come within a metre of each other are no two storeys. Nothing where no plane
/// to stand on is known of either, where these are so near each other as they are now, or where nothing agrees.
std::optional<HeightSnap> snapHeight(std::span<const FacedPlane> floor, std::span<const FacedPlane> onto);

}  // namespace planewright
