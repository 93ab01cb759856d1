// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/params/parameters.h"
#include "core/types/plane.h"

namespace planewright {

/// A running number of a segment in the scan: the first segment of the first slice is 0.
using SegmentNumber = int;

/// Moves the average direction of a cluster on by one segment, Eq. (10) to (12).
///
/// `mean` is the average so far of `count` directions and need not be of unit length; `direction` is turned to its side
/// first, since a segment has no sense of direction and opposite ones would cancel.
Eigen::Vector3d movedAverage(const Eigen::Vector3d& mean, int count, const Eigen::Vector3d& direction,
                             const ClusterParameters& parameters);

/// A direction cluster C while it changes.
struct GrowingCluster {
    struct Member {
        SegmentNumber segment = 0;
        bool searched = false;  ///< has been the seed of a plane hypothesis
        int triedStep = -1;     ///< step at which it was tried on all planes last; −1 = not yet
    };

    ClusterId id = kNoCluster;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();        ///< moving average, not of unit length
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< the same, of unit length
    std::vector<Member> members;                           ///< in the order in which they joined
    std::shared_ptr<const DirectionCluster> published;     ///< as snapshots show it; null after a change
};

/// The set Ψ of direction clusters: unassigned segments grouped by direction (section 4.2, Table IV).
class DirectionClusters {
public:
    /// Where a segment went, and how near it was to the cluster's direction.
    struct Joined {
        ClusterId cluster = kNoCluster;
        double similarity = 0.0;  ///< |δ·δ̄| of Eq. (9) with the nearest cluster; 0 where there was none
        bool founded = false;     ///< it is the first of a new cluster
    };

    /// Puts a segment into the cluster nearest in direction, or founds a new one.
    Joined add(SegmentNumber segment, const Eigen::Vector3d& direction, const ClusterParameters& parameters);

    /// Removes the members for which `leaves(segment number)` holds; clusters left empty disappear.
    template <class Predicate>
    void remove(Predicate leaves)
    {
        for (GrowingCluster& cluster : clusters_) {
            if (std::erase_if(cluster.members, [&](const auto& member) { return leaves(member.segment); }) > 0)
                cluster.published = nullptr;
        }
        std::erase_if(clusters_, [](const GrowingCluster& cluster) { return cluster.members.empty(); });
    }

    std::vector<GrowingCluster>& all() { return clusters_; }
    const std::vector<GrowingCluster>& all() const { return clusters_; }

private:
    std::vector<GrowingCluster> clusters_;  // in order of id
    ClusterId next_ = 0;
};

}  // namespace planewright
