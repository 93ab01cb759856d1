// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/types/line_segment.h"

namespace planewright {

/// The line segments of a scan, slice after slice: copying shares, appending leaves copies as they were.
///
/// Full chunks of slices are shared between copies, so that a snapshot per step costs pointers and no segment.
class SegmentLog {
public:
    /// Adds the segments of the next slice; its step must exceed those before.
    void append(int step, std::shared_ptr<const Segments> segments);

    std::size_t slices() const { return full_.size() * kChunk + tail_.size(); }
    int stepOf(std::size_t slice) const { return entry(slice).step; }
    const Segments& slice(std::size_t slice) const { return *entry(slice).segments; }

    /// The slice of a step (binary search), or slices() where the step was not seen.
    std::size_t find(int step) const;

    /// The segment of an id that this log gave out.
    const LineSegment& operator[](const SegmentId& id) const;

    std::size_t segmentCount() const { return segmentCount_; }

private:
    static constexpr std::size_t kChunk = 64;
    struct Entry {
        int step = 0;
        std::shared_ptr<const Segments> segments;
    };
    using Chunk = std::vector<Entry>;

    const Entry& entry(std::size_t slice) const
    {
        return slice < full_.size() * kChunk ? (*full_[slice / kChunk])[slice % kChunk]
                                             : tail_[slice - full_.size() * kChunk];
    }

    std::vector<std::shared_ptr<const Chunk>> full_;
    Chunk tail_;
    std::size_t segmentCount_ = 0;
};

}  // namespace planewright
