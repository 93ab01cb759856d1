// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/planes/plane_fit.h"
#include "core/planes/segment_table.h"

namespace planewright {

/// The shorter extent of the end points in their plane, along their principal axes [m].
double shorterExtent(const std::vector<SegmentNumber>& members, const PlaneFit& fit, const SegmentTable& table);

/// How a plane is seen.
struct PlaneView {
    double range = 0.0;      ///< mean over its segments [m]
    double incidence = 0.0;  ///< mean sine of the angle at which rays meet it
};
PlaneView viewOf(const std::vector<SegmentNumber>& members, const PlaneFit& fit, const SegmentTable& table);

}  // namespace planewright
