// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/fit_remaining_segments.h"

#include <algorithm>

#include "core/planes/assign_to_planes.h"

namespace planewright {

int fitRemainingSegments(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder, bool onEveryPlane)
{
    // In order of the segments, so that the result does not depend on how clusters happen to be filled.
    std::vector<GrowingCluster::Member> remaining;
    for (GrowingCluster& cluster : map.clusters.all()) {
        for (auto& member : cluster.members) {
            remaining.push_back(member);
            member.triedStep = map.step;
        }
    }
    std::sort(remaining.begin(), remaining.end(), [](const auto& a, const auto& b) { return a.segment < b.segment; });

    const auto fitted = std::count_if(remaining.begin(), remaining.end(), [&](const GrowingCluster::Member& member) {
        return assignToBestPlane(member.segment, map, parameters, recorder, onEveryPlane ? -1 : member.triedStep);
    });
    if (fitted > 0)
        map.removeOwnedFromClusters();
    return static_cast<int>(fitted);
}

}  // namespace planewright
