// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/planes/plane_map.h"
#include "core/planes/plane_search.h"
#include "core/types/why_not.h"

namespace planewright {

/// Splits the planes whose fitting error has grown beyond e_f (section 4.4, Table VII lines 1 to 8), and small ones of
/// which a larger share is contested by runs than `planes.max-contested` (an addition, see segment_run.h).
///
/// The segments of such a plane are searched for planes anew; the largest found keeps the plane's id, the others get
/// ids of their own, and segments in none of them are clustered again.
void splitPlanes(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder);

/// The planes found among segments, as a split finds them, in the order in which they were found; segments in none stay
/// behind in `members`.
std::vector<FoundPlane> partsOf(std::vector<SegmentNumber>& members, const SegmentTable& table,
                                const PlaneParameters& parameters);

/// δ_Π of Eq. (22) [m] and what it may be where it was found.
struct PairDistance {
    double value = 0.0;
    double limit = 0.0;
};

/// Distance of two planes, Eq. (22): the largest distance of an end point of either to the other.
///
/// Of all end points the one counts that exceeds its limit most, in proportion. The limit of an end point is the merge
/// distance (or as many standard deviations of the other plane there as `planes.merge-sigmas` says, if that is more)
/// on top of the distance by which it may stray from its own plane, Eq. (8).
PairDistance planePairDistance(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table,
                               const Parameters& parameters);

/// Gap between the segments of two planes [m], as far as it matters: the smallest distance between a segment of one and
/// a segment of the other, 0 where two lie in neighbouring slices and face each other; at most `enough` is looked for.
double inPlaneGap(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table, double enough);

/// Merges planes that are one (section 4.4, Table VII lines 9 to 13): the pair with the smallest distance first, as
/// long as a pair passes Eq. (21), Eq. (22) with its limit, the gap, and the fitting error of both together, and
/// neither is contested where both would lie.
void mergePlanes(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder);

/// The conditions on which two planes are merged, all of them, as they are.
Conditions mergeConditions(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table,
                           const Parameters& parameters);

/// Dissolves planes into larger ones that cover them: where at least `planes.merge-share` of a plane's segments pass
/// the assignment test, Eq. (8), with a larger plane within the gap, they go to that plane, and the others to the
/// clusters, unless their runs contest the larger plane.
///
/// A plane that began with few, short or far segments may stand at an angle that Eq. (21) never lets pass, while its
/// segments lie on a wall that is known well by now. Planes that have not changed since
/// they were compared last are passed over. Ends the comparison of pairs of this step.
void absorbPlanes(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder);

/// The conditions on which the smaller of two planes is dissolved into the other, all of them, as they are.
Conditions absorbConditions(const GrowingPlane& a, const GrowingPlane& b, const PlaneMap& map,
                            const Parameters& parameters);

}  // namespace planewright
