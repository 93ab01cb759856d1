// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>
#include <vector>

#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"

namespace planewright {

using Names = std::vector<std::string_view>;

/// Slices of one wall and the plane of all.
struct OneWall {
    NoddingScan scan;

    explicit OneWall(int slices, const Surface& surface = kWall, double firstTilt = degrees(85.0),
                     double tiltStep = kTiltStep)
    {
        scan.nod(slices, {surface}, firstTilt, tiltStep);
        make(surface);
    }
    /// Makes the plane once more, after its segments were changed.
    void make(const Surface& surface)
    {
        if (!scan.map.planes().empty())
            scan.map.dissolve(scan.map.planes().front().id);
        scan.makePlane(scan.column(0, 0, scan.map.slices() - 1), surface);
    }
    PlaneTrack& plane() { return scan.map.planes().front(); }
    SegmentStatistics& segment(SegmentNumber number) { return scan.map.segment(number).statistics; }
    void thin() { thinTracks(scan.map, scan.parameters, scan.recorded.recorder); }
    void drop() { dropUnfounded(scan.map, scan.parameters, scan.recorded.recorder); }

    /// The tests that the plane was dropped for; empty where it was not.
    Names droppedFor()
    {
        drop();
        const auto decisions = scan.recorded.decisions(DecisionKind::NoFit);
        return decisions.empty() ? Names{} : failed(decisions.front().tests);
    }
    double reducedChi()
    {
        double sum = 0.0;
        for (const SegmentNumber number : plane().members)
            sum += plane().estimate.residualChi(plane().estimate.inSlice(scan.map.slice(number).frame), segment(number),
                                                scan.parameters.noise, scan.parameters.flatnessFloor());
        return sum / (2.0 * static_cast<double>(plane().members.size()) - 3.0);
    }
};

}  // namespace planewright
