// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/clusters/direction_clusters.h"
#include "core/types/line_segment.h"

namespace planewright {

/// The running number of a segment among so many, whose ids `idOf` gives and which rise; −1 where it is not there.
template <class IdOf>
SegmentNumber findSegment(const SegmentId& segment, SegmentNumber count, IdOf idOf)
{
    SegmentNumber first = 0;
    for (SegmentNumber end = count; first < end;) {
        const SegmentNumber middle = first + (end - first) / 2;
        if (idOf(middle) < segment)
            first = middle + 1;
        else
            end = middle;
    }
    return first < count && idOf(first) == segment ? first : -1;
}

}  // namespace planewright
