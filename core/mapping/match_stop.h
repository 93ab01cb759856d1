// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/mapping/near_planes.h"
#include "core/mapping/register_planes.h"
#include "core/params/mapping_parameters.h"

namespace planewright {

/// A stop matched with the planes near by.
struct StopMatch {
    std::vector<std::optional<std::size_t>> planes;  ///< of the map, for each plane of the stop
    std::vector<std::vector<std::size_t>> rivals;    ///< planes of the map that one may be which is left open
    /// Planes of the map that are the same as the one matched: the stop's plane joins pieces seen apart until now.
    std::vector<std::vector<std::size_t>> joined;
    Registration registration;
    int pairs = 0;
    bool cutShort = false;  ///< the search met its limit
};

/// Matches a stop that is expected at a pose, and registers it: planes by chi-square with the uncertainty of all that
/// takes part, by side and by where they were seen; all together, then once more at the pose that they give.
StopMatch matchStop(const Stop& stop, const StopExtents& extents, const NearPlanes& near, const PosePrior& expected,
                    const MappingParameters& parameters);

/// Places that a stop may have by its planes alone, the best first: within reach of where it is expected, farther the
/// less that is known; or anywhere.
std::vector<Placement> placeStop(const Stop& stop, const StopExtents& extents, const NearPlanes& near,
                                 const std::optional<PosePrior>& about, const MappingParameters& parameters);

}  // namespace planewright
