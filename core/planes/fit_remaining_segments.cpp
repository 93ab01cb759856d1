// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/fit_remaining_segments.h"

#include <algorithm>

#include "core/planes/assign_to_planes.h"

namespace planewright {

int fitRemainingSegments(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    // In order of the segments, so that the result does not depend on how clusters happen to be filled.
    std::vector<SegmentNumber> remaining;
    for (const GrowingCluster& cluster : map.clusters.all()) {
        for (const auto& member : cluster.members)
            remaining.push_back(member.segment);
    }
    std::sort(remaining.begin(), remaining.end());

    const auto fitted = std::count_if(remaining.begin(), remaining.end(), [&](SegmentNumber segment) {
        return assignToBestPlane(segment, map, parameters, recorder);
    });
    if (fitted > 0)
        map.removeOwnedFromClusters();
    return static_cast<int>(fitted);
}

}  // namespace planewright
