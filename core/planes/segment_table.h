// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include "core/clusters/direction_clusters.h"
#include "core/types/segment_log.h"

namespace planewright {

/// All segments of the scan by running number, and the plane that each belongs to.
class SegmentTable {
public:
    /// Adds the segments of a slice and gives the running number of the first.
    SegmentNumber append(int step, Segments segments)
    {
        const auto first = static_cast<SegmentNumber>(segments_.size());
        auto shared = std::make_shared<const Segments>(std::move(segments));
        for (const LineSegment& segment : *shared)
            segments_.push_back(&segment);
        owners_.resize(segments_.size(), kNoPlane);
        log_.append(step, std::move(shared));
        return first;
    }

    SegmentNumber size() const { return static_cast<SegmentNumber>(segments_.size()); }
    const LineSegment& operator[](SegmentNumber number) const { return *segments_[static_cast<std::size_t>(number)]; }
    PlaneId& owner(SegmentNumber number) { return owners_[static_cast<std::size_t>(number)]; }
    PlaneId owner(SegmentNumber number) const { return owners_[static_cast<std::size_t>(number)]; }

    /// The same segments slice by slice, for snapshots.
    const SegmentLog& log() const { return log_; }

private:
    std::vector<const LineSegment*> segments_;  // owned by the log
    std::vector<PlaneId> owners_;
    SegmentLog log_;
};

}  // namespace planewright
