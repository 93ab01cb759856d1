// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/types/angle.h"
#include "core/types/recording.h"
#include "core/types/snapshot.h"

namespace planewright {

/// Two slices, of steps 4 and 7, of five beams 30° apart from 30° on; beam 1 of step 4 has no return, beam 2 one that
/// is too far.
inline Recording sampleScan()
{
    Recording recording;
    recording.description = {"", degrees(30.0), degrees(30.0), 5, 0.1, 30.0, 0.25, {}};
    ScanSlice slice;
    slice.step = 4;
    slice.tilt = degrees(90.0);
    slice.firstBearing = degrees(30.0);
    slice.bearingStep = degrees(30.0);
    slice.ranges = {2.0, 0.0, 40.0, 2.0, 2.0};
    recording.slices.push_back(slice);
    slice.step = 7;
    slice.tilt = 0.0;
    slice.ranges = {1.0, 1.0, 1.0, 1.0, 1.0};
    recording.slices.push_back(slice);
    return recording;
}

/// Of sampleScan: plane 9 holds segment 4.0 (beams 0 to 3), cluster 2 holds 7.0 (beams 0 to 1), plane 1 holds 7.1
/// (beams 2 to 4); step 5 had no segment, and none of step 8 was recorded.
inline Snapshot sampleSnapshot()
{
    const auto segment = [](SegmentId id, int first, int last, double y) {
        LineSegment made;
        made.id = id;
        made.firstBeam = first;
        made.lastBeam = last;
        made.points = last - first + 1;
        made.start = {1.5, y, 0.25};
        made.end = {-1.0 / 3.0, y, -0.0};
        made.rms = 0.0035;
        return made;
    };
    Snapshot snapshot;
    snapshot.segments.append(4, std::make_shared<Segments>(Segments{segment({4, 0}, 0, 3, 1)}));
    snapshot.segments.append(5, std::make_shared<Segments>());
    snapshot.segments.append(7,
                             std::make_shared<Segments>(Segments{segment({7, 0}, 0, 1, 2), segment({7, 1}, 2, 4, 3)}));
    snapshot.segments.append(8, std::make_shared<Segments>(Segments{segment({8, 0}, 0, 4, 4)}));
    const auto plane = [&](PlaneId id, std::vector<SegmentId> segments) {
        auto made = std::make_shared<Plane>();
        made->id = id;
        made->segments = std::move(segments);
        snapshot.planes.push_back(made);
    };
    plane(1, {{7, 1}, {8, 0}});
    plane(9, {{4, 0}});
    auto cluster = std::make_shared<DirectionCluster>();
    cluster->id = 2;
    cluster->segments = {{7, 0}};
    snapshot.clusters.push_back(cluster);
    return snapshot;
}

}  // namespace planewright
