// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/clusters/direction_clusters.h"
#include "core/planes/growing_plane.h"
#include "core/planes/segment_table.h"
#include "core/types/step_recorder.h"

namespace planewright {

/// What the extraction knows between two steps: the segments, the planes Π and the clusters Ψ.
struct PlaneMap {
    SegmentTable segments;
    std::vector<GrowingPlane> planes;  ///< in order of id
    DirectionClusters clusters;
    PlaneId nextPlane = 0;
    int step = 0;           ///< the step that is running
    int comparedStep = -1;  ///< at which all pairs of planes were compared for merging last; −1 = not yet

    /// True where neither of two planes has changed since all pairs were compared: the verdict would be the same.
    bool comparedAlready(const GrowingPlane& a, const GrowingPlane& b) const
    {
        return a.changedStep() < comparedStep && b.changedStep() < comparedStep;
    }

    GrowingPlane& plane(PlaneId id);

    /// Makes a plane of a fit and marks its segments as its own.
    GrowingPlane& makePlane(const PlaneFit& fit, std::vector<SegmentNumber> members, const PlaneParameters& parameters);

    /// Gives every plane the segments that the table says are its own, after owners were changed there.
    void takeMembersFromOwners(const PlaneParameters& parameters);

    /// Takes the segments that belong to a plane out of the clusters.
    void removeOwnedFromClusters();
};

/// Puts segments into the clusters of like direction (Table IV) and says so.
void addToClusters(const std::vector<SegmentNumber>& segments, PlaneMap& map, const ClusterParameters& parameters,
                   StepRecorder& recorder);

}  // namespace planewright
