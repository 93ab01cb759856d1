// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/sensor_model.h"
#include "core/segments/slice_trace.h"
#include "core/types/line_segment.h"
#include "core/types/scan_slice.h"
#include "ui/common/palette.h"

namespace planewright {

/// One slice and what its segmentation did, for a drawing in the laser's own frame.
struct SliceSketch {
    std::shared_ptr<const ScanSlice> slice;  ///< null for none
    SensorModel sensor;
    SliceTrace trace;
    std::vector<Rgb> colours;         ///< of each piece of the trace, as the 3D view has them
    std::vector<std::string> owners;  ///< of each piece: "P03", "C4", or empty

    bool hasEcho(int beam) const { return sensor.hasEcho(slice->ranges[static_cast<std::size_t>(beam)]); }
    /// The point of a beam, x to the right and y ahead [m].
    Eigen::Vector2d pointAt(int beam) const;
    SegmentId idOf(const TracedPiece& piece) const { return {slice->step, piece.segment}; }
};

}  // namespace planewright
