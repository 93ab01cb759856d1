// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include "core/formats/labels.h"
#include "core/geometry/sensor_model.h"

namespace planewright {

Labels labelsOf(const Snapshot& snapshot, const Recording& recording)
{
    const SensorModel sensor = sensorOf(recording.description);
    Labels labels;
    labels.reserve(recording.slices.size());
    for (const ScanSlice& slice : recording.slices)
        labels.emplace_back(slice.ranges.size(), kNoLabel);

    const auto byStep = [](const ScanSlice& slice, int step) { return slice.step < step; };
    for (const auto& plane : snapshot.planes) {
        for (const SegmentId& id : plane->segments) {
            const auto slice = std::lower_bound(recording.slices.begin(), recording.slices.end(), id.step, byStep);
            if (slice == recording.slices.end() || slice->step != id.step)
                continue;
            std::vector<int>& line = labels[static_cast<std::size_t>(slice - recording.slices.begin())];
            const LineSegment& segment = snapshot.segments[id];
            const auto first = static_cast<std::size_t>(segment.firstBeam);
            const auto last = std::min(static_cast<std::size_t>(segment.lastBeam) + 1, line.size());
            for (std::size_t beam = first; beam < last; ++beam) {
                if (sensor.hasEcho(slice->ranges[beam]))
                    line[beam] = plane->id;
            }
        }
    }
    return labels;
}

}  // namespace planewright
