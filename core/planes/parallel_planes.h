// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/planes/track_map.h"
#include "core/types/angle.h"

namespace planewright {

/// Planes of rooms are parallel to this angle [rad].
inline constexpr double kParallel = degrees(0.5);
/// Where that alone is to say that a segment afar is of a plane: the jambs of two doors 5 m apart turn a plane that is
/// off by the depth of a frame by half a degree.
inline constexpr double kSurelyParallel = degrees(0.2);
/// The largest χ² that parallelChi gives: of a plane that is parallel to none.
inline constexpr double kNoParallel = 13.8;

/// χ² (2 degrees of freedom) of a plane's normal against that of the nearest plane whose own is known to an angle
/// [rad], where planes are parallel to another [rad]: what speaks for a plane whose direction few segments tell. Planes
/// of two segments and the plane `except` say nothing.
double parallelChi(const PlaneEstimate& estimate, const TrackMap& map, double knownAngle, double parallelAngle,
                   PlaneId except = kNoPlane);

}  // namespace planewright
