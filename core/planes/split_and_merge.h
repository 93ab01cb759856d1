// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/planes/plane_map.h"

namespace planewright {

/// Splits the planes whose fitting error has grown beyond e_f (section 4.4, Table VII lines 1 to 8).
///
/// The segments of such a plane are searched for planes anew; the largest found keeps the plane's id, the others get
/// ids of their own, and segments in none of them are clustered again.
void splitPlanes(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder);

/// δ_Π of Eq. (22) [m]: the largest distance of an end point of one plane to the other plane, both ways.
double planePairDistance(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table);

/// Gap between the segments of two planes [m], as far as it matters: the smallest distance between a segment of one and
/// a segment of the other, 0 where two lie in neighbouring slices and face each other; at most `enough` is looked for.
double inPlaneGap(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table, double enough);

/// Merges planes that are one (section 4.4, Table VII lines 9 to 13): the pair with the smallest distance first, as
/// long as a pair passes Eq. (21), Eq. (22) with its limit, the gap, and the fitting error of both together.
void mergePlanes(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder);

}  // namespace planewright
