// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/mapping/building_map.h"
#include "core/types/error.h"

namespace planewright {

/// Writes the covariances of all poses and planes, each with everything else unknown, against the first stop: of the
/// linear problem at an adjusted map, exact. Observations that the robust loss holds off count by their weight there.
///
/// Fails with Internal where the observations do not fix the map.
Result<void> computeCovariances(BuildingMap& map);

}  // namespace planewright
