// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/mapping/building_map.h"
#include "core/mapping/near_planes.h"

namespace planewright {

/// The stops whose planes may be those of a stop, by its number.
using StopsAround = std::function<std::vector<std::size_t>(std::size_t stop)>;

/// Looks once more at what was undecided when stops joined, now that poses and planes of the map are adjusted and have
/// covariances: planes of the map that are one are merged, and a stop's plane that was left open becomes part of the
/// one plane that it fits, or a new one where it fits none. Two planes are one where their parameters agree and would
/// tell them apart if they were not, the places where they were seen meet, nothing else would fit as well, and no stop
/// saw them apart. What was matched by hand stays as it is. Returns how much was decided: the map's parameters are
/// those of before, to be adjusted again.
int fusePlanes(BuildingMap& map, std::span<const StopExtents> extents, const StopsAround& around, double gap);

}  // namespace planewright
