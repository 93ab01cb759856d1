// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "core/mapping/building_map.h"
#include "core/types/error.h"

namespace planewright {

/// What an adjustment did.
struct MapAdjustment {
    int iterations = 0;
    double costBefore = 0.0;  ///< half the sum of all squared residuals in their standard deviations, after the loss
    double costAfter = 0.0;
    int heldOff = 0;  ///< observations and motions whose residual the robust loss held off
};

/// Adjusts all poses and planes of a map together, the first stop held: every sighting of a plane and every motion is a
/// factor with its covariance; beyond 99.9 % of chi-square its pull grows no more (Huber 1964). Poses have 6 unknowns,
/// planes 3. Fails with Internal where no solution is found; the map is as it was then.
Result<MapAdjustment> adjustMap(BuildingMap& map);

/// The same for some stops and the planes that they see, all other stops held. Planes that more than a few dozen other
/// stops see are held as well: the work does not grow with the map.
Result<MapAdjustment> adjustStops(BuildingMap& map, const std::vector<std::size_t>& stops);

}  // namespace planewright
