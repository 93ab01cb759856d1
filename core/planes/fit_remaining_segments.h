// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/planes/plane_map.h"

namespace planewright {

/// Tries the segments of the clusters again on the planes that exist by now (Table I line 10).
///
/// Gives the number of segments that were fitted.
int fitRemainingSegments(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder);

}  // namespace planewright
