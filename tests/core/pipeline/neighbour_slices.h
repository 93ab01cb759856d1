// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <vector>

#include "core/types/angle.h"
#include "core/types/recording.h"
#include "core/types/segment_log.h"
#include "tests/core/pipeline/likelihood_twin.h"
#include "tests/core/planes/recorded_decisions.h"

namespace planewright {

using PlaneSegments = std::vector<const LineSegment*>;

inline PlaneSegments segmentsOf(const std::vector<SegmentId>& ids, const SegmentLog& log)
{
    PlaneSegments segments;
    for (const SegmentId& id : ids)
        segments.push_back(&log[id]);
    return segments;
}
inline PlaneSegments segmentsOf(const std::vector<Operand>& operands, const SegmentLog& log)
{
    PlaneSegments segments;
    for (const Operand& operand : operands)
        segments.push_back(&log[segmentOf(operand)]);
    return segments;
}

inline bool allDirected(const PlaneSegments& segments, const SensorNoise& noise)
{
    return std::all_of(segments.begin(), segments.end(), [&](const LineSegment* s) { return isDirected(*s, noise); });
}

/// Slices that count as next to one: two on each side, and up to eight while their tilt is within 1.5°.
class NeighbourSlices {
public:
    NeighbourSlices(const Recording& recording, const SegmentLog& log) : log_(log)
    {
        for (std::size_t place = 0; place < log.slices(); ++place) {
            const auto slice = std::find_if(recording.slices.begin(), recording.slices.end(),
                                            [&](const ScanSlice& s) { return s.step == log.stepOf(place); });
            tilts_.push_back(slice->tiltAt(slice->ranges.size() / 2));
        }
    }

    int reach(int place, int direction) const
    {
        const int available = direction < 0 ? place : static_cast<int>(tilts_.size()) - 1 - place;
        int count = std::min(2, available);
        while (count < std::min(8, available) &&
               std::abs(tilts_[static_cast<std::size_t>(place + direction * (count + 1))] -
                        tilts_[static_cast<std::size_t>(place)]) <= degrees(1.5))
            ++count;
        return count;
    }

    int placeOf(const LineSegment& s) const { return static_cast<int>(log_.find(s.id.step)); }

    /// Whether a segment is within so many beams of another, in the slices that count as next to its own.
    bool isBeside(const LineSegment& s, const LineSegment& other, int beams) const
    {
        const int place = placeOf(s);
        const int away = placeOf(other) - place;
        const bool near = away < 0 ? -away <= reach(place, -1) : away <= reach(place, 1);
        return near && other.firstBeam <= s.lastBeam + beams && s.firstBeam <= other.lastBeam + beams;
    }

    /// Whether a segment of one plane and one of the other are within 20 beams in neighbouring slices.
    bool sideBySide(const PlaneSegments& a, const PlaneSegments& b) const
    {
        return std::any_of(a.begin(), a.end(), [&](const LineSegment* s) {
            return std::any_of(b.begin(), b.end(), [&](const LineSegment* t) { return isBeside(*s, *t, 20); });
        });
    }

private:
    const SegmentLog& log_;
    std::vector<double> tilts_;
};

}  // namespace planewright
