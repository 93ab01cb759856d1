// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/planes/plane_map.h"

namespace planewright {

/// Tries the segments of the clusters again on the planes that exist by now (Table I line 10).
///
/// A plane that has not changed since a segment was tried on it is passed over, unless `onEveryPlane` says otherwise.
/// Gives the number of segments that were fitted.
int fitRemainingSegments(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder,
                         bool onEveryPlane = false);

}  // namespace planewright
