// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/mapping/building_map.h"

namespace planewright {

/// How uneven walls are, as an adjusted map tells it: the flatness [m], `told` at most and a two-hundredth of it at
/// least, with which half of the sightings are nearer to the plane that several stops saw than the median of χ² says.
/// `inUse` is what the covariances of the map's stops hold now. Where few planes were seen again, `inUse`.
double unevennessOf(const BuildingMap& map, double inUse, double told);

/// Puts another flatness [m] into the covariances of all stops.
void changeFlatness(BuildingMap& map, double from, double to);

}  // namespace planewright
