// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "core/types/line_segment.h"
#include "ui/common/shown_map.h"

namespace planewright {

/// Which plane and which cluster each segment of a shown map belongs to.
class SegmentOwners {
public:
    SegmentOwners() = default;
    explicit SegmentOwners(const ShownMap& map);

    /// The place among `map.planes` of the plane that holds the segment `index` of the slice at a place of the log;
    /// −1 for none.
    int planeAt(std::size_t slice, std::size_t index) const { return planes_[slice][index]; }
    /// The id of its cluster, or kNoCluster.
    ClusterId clusterAt(std::size_t slice, std::size_t index) const { return clusters_[slice][index]; }

    /// Of all segments of a slice.
    const std::vector<int>& planesOf(std::size_t slice) const { return planes_[slice]; }

    std::size_t slices() const { return planes_.size(); }

private:
    std::vector<std::vector<int>> planes_;
    std::vector<std::vector<ClusterId>> clusters_;
};

}  // namespace planewright
