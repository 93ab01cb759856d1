// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <vector>

#include "core/planes/plane_map.h"
#include "core/types/why_not.h"

namespace planewright {

/// How a segment and a plane compare in Eq. (8).
struct AssignmentTest {
    double distance = 0.0;       ///< D_ij: the farther of the two end points from the plane [m]
    double orthogonality = 0.0;  ///< |n·δ|, the sine of the angle between segment and plane
    double distanceLimit = 0.0;
    double orthogonalityLimit = 0.0;

    bool pass() const { return distance < distanceLimit && orthogonality < orthogonalityLimit; }
};

/// Compares a segment with a plane, Eq. (8), by the farther end point: the paper prints the nearer one, by which a
/// segment that leaves a wall at a right angle could belong to it.
AssignmentTest compareForAssignment(const LineSegment& segment, const GrowingPlane& plane,
                                    const AssignmentParameters& parameters);

/// D_ij of Eq. (8) [m]: the distance of the farther end point from the plane.
inline double fartherEnd(const LineSegment& segment, const GrowingPlane& plane)
{
    return std::max(plane.distanceTo(segment.start), plane.distanceTo(segment.end));
}

/// Square of the distance [m²] from which on a segment's farther end matches no plane, whatever its direction: for a
/// cheap test before compareForAssignment.
inline double squaredReach(const LineSegment& segment, const AssignmentParameters& parameters)
{
    // No direction has a larger variance than all of them together.
    const double variance = std::max(segment.startCovariance.trace(), segment.endCovariance.trace());
    return std::max(parameters.planeDistance * parameters.planeDistance,
                    parameters.planeDistanceSigmas * parameters.planeDistanceSigmas * variance);
}

/// Assigns a segment to the best matched plane, if one matches, and refits that plane after every so many additions.
/// Gives true where it was assigned. A plane that is not settled and that the segment contests is passed over
/// (segment_run.h), and so is one that has not changed since step `since`.
bool assignToBestPlane(SegmentNumber number, PlaneMap& map, const Parameters& parameters, StepRecorder& recorder,
                       int since = -1);

/// The ways in which a segment may come to a plane, as things are: it is assigned, or in the last pass moves there from
/// the plane that it belongs to.
std::vector<Conditions> waysIntoPlane(SegmentNumber number, const GrowingPlane& plane, PlaneMap& map,
                                      const Parameters& parameters);

/// Assigns the segments from `first` on to existing planes (section 4.1.4, Table III); gives those left over.
std::vector<SegmentNumber> assignToPlanes(SegmentNumber first, PlaneMap& map, const Parameters& parameters,
                                          StepRecorder& recorder);

}  // namespace planewright
