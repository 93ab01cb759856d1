// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/segments/slice_points.h"

namespace planewright {

/// Gap between neighbouring points of one surface in proportion to their range: the first term of Eq. (3).
double gapPerRange(double bearingStep, const SegmentParameters& parameters);

/// D_o of Eq. (3) [m]: the largest gap between neighbouring points of one surface, seen at a range [m] with a bearing
/// step [rad]. The step is the bearing's, although the paper prints the letter of the pitch.
double breakpointDistance(double range, double bearingStep, const SegmentParameters& parameters,
                          const NoiseParameters& noise);

/// The bearing step [rad] whose gaps count where the maximum-likelihood method looks for breakpoints: that of the
/// slice, or 0.25° where it is finer. Noise of the ranges alone is farther apart than D_o once for so many beams,
/// however many they are; and what a finer step could tell apart, the division into straight pieces tells from all
/// points.
double breakpointStep(double bearingStep);

/// Splits a slice into runs of neighbouring points that lie on one surface (Table II, lines 2 to 6).
///
/// Two neighbours stay together while their gap is below D_o of Eq. (3), which grows with range so that far, sparsely
/// sampled walls are not shredded. A beam without echo ends the run. Runs come in bearing order, never overlap and hold
/// at least two points; a slice without echoes gives none.
void splitAtBreakpoints(const SlicePoints& points, double bearingStep, const SegmentParameters& parameters,
                        std::vector<PointRun>& runs);

}  // namespace planewright
