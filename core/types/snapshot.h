// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include "core/types/line_segment.h"
#include "core/types/plane.h"
#include "core/types/segment_log.h"
#include "core/types/sensor_noise.h"
#include "core/types/step_report.h"

namespace planewright {

/// The state of the extraction after a step: immutable, shared, and sharing with the snapshot before what did not
/// change.
struct Snapshot {
    StepReport report;
    SensorNoise noise;
    SegmentLog segments;                                            ///< of all slices so far
    std::vector<std::shared_ptr<const Plane>> planes;               ///< in order of id
    std::vector<std::shared_ptr<const DirectionCluster>> clusters;  ///< in order of id; those that hold a segment
};

}  // namespace planewright
