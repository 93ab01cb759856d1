// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace planewright {

GrowingPlane& PlaneMap::plane(PlaneId id)
{
    const auto found = std::find_if(planes.begin(), planes.end(), [id](const GrowingPlane& p) { return p.id() == id; });
    assert(found != planes.end());
    return *found;
}

GrowingPlane& PlaneMap::makePlane(const PlaneFit& fit, std::vector<SegmentNumber> members,
                                  const PlaneParameters& parameters)
{
    for (const SegmentNumber segment : members)
        segments.owner(segment) = nextPlane;
    planes.emplace_back(nextPlane++, fit, std::move(members), segments, parameters, step);
    return planes.back();
}

void PlaneMap::takeMembersFromOwners(const PlaneParameters& parameters)
{
    std::vector<std::vector<SegmentNumber>> members(static_cast<std::size_t>(nextPlane));
    for (SegmentNumber number = 0; number < segments.size(); ++number) {
        if (segments.owner(number) != kNoPlane)
            members[static_cast<std::size_t>(segments.owner(number))].push_back(number);
    }
    for (GrowingPlane& growing : planes)
        growing.setMembers(std::move(members[static_cast<std::size_t>(growing.id())]), segments, parameters, step);
}

void PlaneMap::removeOwnedFromClusters()
{
    clusters.remove([this](SegmentNumber segment) { return segments.owner(segment) != kNoPlane; });
}

void addToClusters(const std::vector<SegmentNumber>& segments, PlaneMap& map, const ClusterParameters& parameters,
                   StepRecorder& recorder)
{
    for (const SegmentNumber number : segments) {
        const LineSegment& segment = map.segments[number];
        const auto joined = map.clusters.add(number, segment.direction, parameters);
        if (recorder.explains()) {
            recorder.decide(
                DecisionKind::Cluster, {segment.id},
                {{"direction_similarity", joined.similarity, Comparison::Greater, std::cos(parameters.directionLimit)}},
                {ClusterRef{joined.cluster}});
        }
    }
}

}  // namespace planewright
