// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/reassign_segments.h"

#include <algorithm>

#include "core/planes/assign_to_planes.h"

namespace planewright {

namespace {

/// The plane nearest to a segment, among those that it may belong to and that are nearer than its own.
const GrowingPlane* nearerPlane(const LineSegment& segment, const GrowingPlane& own, const PlaneMap& map,
                                const Parameters& parameters)
{
    const GrowingPlane* nearest = nullptr;
    double distance = fartherEnd(segment, own);
    for (const GrowingPlane& plane : map.planes) {
        const double here = fartherEnd(segment, plane);
        if (here < distance && compareForAssignment(segment, plane, parameters.assignment).pass()) {
            nearest = &plane;
            distance = here;
        }
    }
    return nearest;
}

void explainMove(const LineSegment& segment, const GrowingPlane& from, const GrowingPlane& to, StepRecorder& recorder)
{
    recorder.decide(DecisionKind::Assign, {segment.id, PlaneRef{from.id()}},
                    {{"plane_distance", fartherEnd(segment, to), Comparison::Less, fartherEnd(segment, from)}},
                    {PlaneRef{to.id()}});
}

}  // namespace

void reassignSegments(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    // All moves are decided on the planes as they are, so that the order of the planes does not matter.
    for (const GrowingPlane& own : map.planes) {
        for (const SegmentNumber number : own.members()) {
            const LineSegment& segment = map.segments[number];
            const GrowingPlane* nearer = nearerPlane(segment, own, map, parameters);
            if (nearer == nullptr)
                continue;
            if (recorder.explains())
                explainMove(segment, own, *nearer, recorder);
            map.segments.owner(number) = nearer->id();
        }
    }

    std::vector<SegmentNumber> homeless;
    map.takeMembersFromOwners(parameters.planes);
    std::erase_if(map.planes, [&](const GrowingPlane& plane) {
        if (plane.members().size() >= static_cast<std::size_t>(parameters.planes.minSegments))
            return false;
        for (const SegmentNumber number : plane.members()) {
            map.segments.owner(number) = kNoPlane;
            homeless.push_back(number);
        }
        return true;
    });
    addToClusters(homeless, map, parameters.clusters, recorder);
    for (GrowingPlane& plane : map.planes)
        plane.refineIfChanged(map.segments, parameters.planes, map.step);
}

}  // namespace planewright
