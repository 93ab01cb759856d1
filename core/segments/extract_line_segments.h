// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"
#include "core/segments/slice_points.h"
#include "core/segments/slice_trace.h"
#include "core/types/line_segment.h"
#include "core/types/scan_slice.h"

namespace planewright {

/// Extracts the line segments of slices; keeps its working storage from slice to slice.
class LineSegmentExtractor {
public:
    /// The line segments of a slice in bearing order (Table II), as segments in space (section 4.1.3).
    ///
    /// Each scan point is touched here and never again: what later steps need of it is in the segment's moments. A
    /// trace, which must be empty, is told what was done.
    Segments extract(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters,
                     SliceTrace* trace = nullptr);

    /// Echoes of the slice that was extracted last.
    int echoes() const { return points_.echoes(); }

private:
    void traceRuns(const ScanSlice& slice, const Parameters& parameters, SliceTrace& trace,
                   std::vector<TracedPiece>& dropped);

    SlicePoints points_;
    std::vector<PointRun> runs_;
    std::vector<PointRun> pieces_;
    std::vector<int> echoes_;  // beams with one, of a slice that is traced
};

}  // namespace planewright
