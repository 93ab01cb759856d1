// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/types/line_segment.h"

namespace planewright {

/// Slices that still count as next to each other: between two of them four may be missing, or belong to the other
/// bearings of an interlaced scanner.
inline constexpr int kNeighbourSlices = 5;

/// True where two segments of neighbouring slices face each other: their beams overlap, or whatever is between them is
/// hidden behind something nearer, so that nobody has seen a gap.
bool faceEachOther(const LineSegment& a, const LineSegment& b);

/// Smallest distance between two segments in space [m].
double segmentDistance(const LineSegment& a, const LineSegment& b);

}  // namespace planewright
