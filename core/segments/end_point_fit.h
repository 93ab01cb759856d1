// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/segments/slice_points.h"
#include "core/segments/slice_trace.h"

namespace planewright {

/// h_o of a point [m]: how far it may lie from a chord with this normal before the run is split there.
double splitDistance(const SlicePoints& points, int beam, const Eigen::Vector2d& normal,
                     const SegmentParameters& parameters);

/// The point of a run that lies farthest from the chord between its ends, among those beyond h_o; −1 where none is.
int farthestFromChord(const SlicePoints& points, const PointRun& run, const SegmentParameters& parameters);

/// The same among some points only, which must all be echoes, from the chord between the ends of another run.
int farthestFromChord(const SlicePoints& points, const PointRun& among, const PointRun& ends,
                      const SegmentParameters& parameters);

/// Splits a run of echoes into straight pieces by iterative end-point fitting (section 4.1.2, Fig. 3a).
///
/// A run is divided at the point farthest from the chord between its ends until none is farther than h_o. A point of
/// division, and the few next to it, then go to that one of the two pieces whose line is nearer, since a point of the
/// other wall as an end point would tilt the segment. Pieces come in bearing order, are appended and do not overlap.
/// A run that needs no split stays whole; otherwise pieces of fewer than four points are left out. A trace, where
/// there is one, is told of the divisions, and `dropped` gets the pieces left out and points that end no piece.
void splitByEndPointFit(const SlicePoints& points, const PointRun& run, const SegmentParameters& parameters,
                        std::vector<PointRun>& pieces, SliceTrace* trace = nullptr,
                        std::vector<TracedPiece>* dropped = nullptr);

}  // namespace planewright
