// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/segments/slice_points.h"
#include "core/segments/slice_trace.h"

namespace planewright {

/// Joins neighbouring pieces of one straight line (section 4.1.2, Eq. (4); Table II, lines 10 to 15).
///
/// Two pieces are joined when their lines differ by less than α_o, the gap between their end points is less than d_o,
/// no other surface stands between them, and the joined piece would not be split again: by angle and gap alone, a wall
/// and the door a few centimetres behind it would be one line. Pieces must come in bearing order and stay so. A trace,
/// where there is one, is told of the joins.
void mergePieces(const SlicePoints& points, double bearingStep, const SegmentParameters& parameters,
                 std::vector<PointRun>& pieces, SliceTrace* trace = nullptr);

}  // namespace planewright
