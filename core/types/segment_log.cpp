// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/segment_log.h"

#include <cassert>
#include <utility>

namespace planewright {

void SegmentLog::append(int step, std::shared_ptr<const Segments> segments)
{
    assert(slices() == 0 || step > stepOf(slices() - 1));
    segmentCount_ += segments->size();
    tail_.push_back({step, std::move(segments)});
    if (tail_.size() == kChunk) {
        full_.push_back(std::make_shared<const Chunk>(std::move(tail_)));
        tail_.clear();
    }
}

std::size_t SegmentLog::find(int step) const
{
    std::size_t low = 0;
    std::size_t high = slices();
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (stepOf(middle) < step)
            low = middle + 1;
        else
            high = middle;
    }
    return low < slices() && stepOf(low) == step ? low : slices();
}

const LineSegment& SegmentLog::operator[](const SegmentId& id) const
{
    const std::size_t place = find(id.step);
    assert(place < slices());
    return slice(place)[static_cast<std::size_t>(id.index)];
}

}  // namespace planewright
