// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/planes/track_map.h"
#include "core/types/angle.h"

namespace planewright {

/// Planes of rooms are parallel to this angle [rad].
inline constexpr double kParallel = degrees(0.5);
/// The largest χ² that parallelChi gives: of a plane that is parallel to none.
inline constexpr double kNoParallel = 13.8;

/// χ² (2 degrees of freedom) of a plane's normal against that of the nearest plane whose own is known to an angle
/// [rad]: what speaks for a plane whose direction few segments tell. Planes of two segments and the plane `except` say
/// nothing.
double parallelChi(const PlaneEstimate& estimate, const TrackMap& map, double knownAngle, PlaneId except = kNoPlane);

}  // namespace planewright
