// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/slice_maker.h"

#include <algorithm>
#include <utility>

namespace planewright {

namespace {

/// Samples from so long before a slice are on one line with those in it.
constexpr std::chrono::milliseconds kLineBefore{75};

}  // namespace

bool SliceMaker::isDue(const LaserScan& scan, const TiltTrack& track)
{
    return !track.isEmpty() && track.last().at >= scan.last;
}

std::optional<ScanSlice> SliceMaker::make(LaserScan scan, const TiltTrack& track, int step, double commanded)
{
    auto first = track.pitchAt(scan.first, kLargestSkew);
    auto last = track.pitchAt(scan.last, kLargestSkew);
    if (!first || !last)
        return std::nullopt;
    if (geometry_.continuous) {
        const auto line = track.lineSince(scan.first - kLineBefore);
        // A count is rounded by half of one at most; what is farther off is a head that changes its speed.
        if (line && line->residual <= 0.75 * geometry_.resolution) {
            first = line->pitchAt(scan.first);
            last = line->pitchAt(scan.last);
        }
    }
    largestSkew_ = std::max({largestSkew_, track.skewAt(scan.first), track.skewAt(scan.last)});
    if (!begin_)
        begin_ = scan.first;

    ScanSlice slice;
    slice.step = step;
    // A laser whose clock was set anew may seem to have gone back by a little.
    slice.time = std::max(lastTime_, std::chrono::duration_cast<std::chrono::microseconds>(scan.first - *begin_));
    lastTime_ = slice.time;
    if (geometry_.continuous) {
        slice.tilt = *first;
        slice.tiltEnd = *last;
    } else {
        slice.tilt = track.meanPitch(scan.first, scan.last).value_or(0.5 * (*first + *last));
    }
    slice.tiltCommanded = commanded;
    slice.firstBearing = geometry_.firstBearing;
    slice.bearingStep = geometry_.bearingStep;
    slice.timeSuspect = scan.timeSuspect;
    slice.ranges.reserve(scan.ranges.size());
    for (const std::uint32_t range : scan.ranges)
        slice.ranges.push_back(range / 1000.0);
    return slice;
}

}  // namespace planewright
