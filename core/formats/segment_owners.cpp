// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/segment_owners.h"

namespace planewright {

SegmentOwners segmentOwners(const Snapshot& snapshot)
{
    SegmentOwners owners;
    const SegmentLog& log = snapshot.segments;
    for (std::size_t slice = 0; slice < log.slices(); ++slice) {
        owners.planes.emplace_back(log.slice(slice).size(), kNoPlane);
        owners.clusters.emplace_back(log.slice(slice).size(), kNoCluster);
    }
    const auto mark = [&](std::vector<std::vector<int>>& all, const auto& holders) {
        for (const auto& holder : holders) {
            for (const SegmentId& id : holder->segments)
                all[log.find(id.step)][static_cast<std::size_t>(id.index)] = holder->id;
        }
    };
    mark(owners.planes, snapshot.planes);
    mark(owners.clusters, snapshot.clusters);
    return owners;
}

}  // namespace planewright
