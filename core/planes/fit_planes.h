// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/planes/plane_map.h"

namespace planewright {

/// Makes planes of the clusters' segments (section 4.3, Table V, Table I line 8).
///
/// Each cluster is searched until it gives no more planes. Only segments that have joined since the last search start
/// hypotheses (all do with `everySegment`, as in the last pass): old ones alone gave nothing then and would give
/// nothing now, and so the work stays proportional to the segments that come in.
void fitPlanes(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder, bool everySegment = false);

}  // namespace planewright
