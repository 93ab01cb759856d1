// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "core/types/line_segment.h"
#include "core/types/recording.h"
#include "core/types/segment_log.h"

namespace planewright {

/// Some segments of one slice, with the pitch that the slice had.
struct SegmentSlice {
    int step = 0;
    double tilt = 0.0;  ///< [rad]
    Segments segments;  ///< those that were asked for, in their order; may be none
};

/// Slices in order of step.
using SegmentSlices = std::vector<SegmentSlice>;

/// Takes segments out of a log, slice by slice, from the first slice that holds one to the last; slices between them
/// are there without segments. A slice whose pitch no segment tells, because it has none at all, is left out. Ids that
/// the log does not hold are passed over.
SegmentSlices slicesOf(std::span<const SegmentId> segments, const SegmentLog& log, const ScanDescription& description);

}  // namespace planewright
