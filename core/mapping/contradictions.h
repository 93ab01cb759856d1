// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/mapping/building_map.h"

namespace planewright {

/// Divides planes of the map whose sightings contradict each other into groups that agree: a stop that took two
/// surfaces for one tells of a plane in between, and two surfaces near to each other may have been matched before it
/// was known how even they are. The largest group keeps the plane, other groups become planes of their own, and a
/// sighting that agrees with no other is left open. Only where there is a largest group, no sighting might as well be
/// of another group, and nobody matched by hand. Returns how many sightings left their plane: the map is to be adjusted
/// again.
int divideContradictions(BuildingMap& map);

}  // namespace planewright
