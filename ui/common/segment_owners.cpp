// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/segment_owners.h"

namespace planewright {

namespace {

/// Sets a value for each segment of a list; ids that the log does not hold are passed over.
template <class Value>
void mark(const std::vector<SegmentId>& segments, const SegmentLog& log, std::vector<std::vector<Value>>& values,
          Value value)
{
    for (const SegmentId& id : segments) {
        const std::size_t slice = log.find(id.step);
        if (slice < values.size() && static_cast<std::size_t>(id.index) < values[slice].size())
            values[slice][static_cast<std::size_t>(id.index)] = value;
    }
}

}  // namespace

SegmentOwners::SegmentOwners(const ShownMap& map)
{
    if (!map.snapshot)
        return;
    const SegmentLog& log = map.snapshot->segments;
    planes_.resize(log.slices());
    clusters_.resize(log.slices());
    for (std::size_t slice = 0; slice < log.slices(); ++slice) {
        planes_[slice].assign(log.slice(slice).size(), -1);
        clusters_[slice].assign(log.slice(slice).size(), kNoCluster);
    }
    for (std::size_t i = 0; i < map.planes.size(); ++i)
        mark(map.planes[i].plane->segments, log, planes_, static_cast<int>(i));
    for (const auto& cluster : map.snapshot->clusters)
        mark(cluster->segments, log, clusters_, cluster->id);
}

}  // namespace planewright
