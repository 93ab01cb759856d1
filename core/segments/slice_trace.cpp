// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/slice_trace.h"

#include <algorithm>
#include <cmath>

#include "core/segments/extract_line_segments.h"
#include "core/segments/extract_statistics.h"

namespace planewright {

SliceTrace traceSlice(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters)
{
    SliceTrace trace;
    if (parameters.method.estimator == Estimator::Likelihood) {
        StatisticsExtractor extractor;
        std::vector<SegmentStatistics> segments;
        extractor.extract(slice, sensor, parameters, segments, &trace);
    } else {
        LineSegmentExtractor extractor;
        extractor.extract(slice, sensor, parameters, &trace);
    }
    const auto pointAt = [&](int beam) {
        const auto at = static_cast<std::size_t>(beam);
        const double bearing = slice.bearing(at);
        return Eigen::Vector2d{slice.ranges[at] * std::cos(bearing), slice.ranges[at] * std::sin(bearing)};
    };
    for (TracedPiece& piece : trace.pieces)
        piece.length = (pointAt(piece.lastBeam) - pointAt(piece.firstBeam)).norm();
    return trace;
}

Parameters withNoise(Parameters parameters, const SensorNoise& noise)
{
    parameters.noise.rangeConstant = noise.rangeConstant;
    parameters.noise.rangeProportional = noise.rangeProportional;
    parameters.noise.pitch = noise.pitch;
    return parameters;
}

TracedPiece tooFew(int firstBeam, int lastBeam, int points, Test test)
{
    TracedPiece piece;
    piece.firstBeam = firstBeam;
    piece.lastBeam = lastBeam;
    piece.points = points;
    piece.fate = PieceFate::TooFewPoints;
    test.value = points;
    piece.tests.push_back(test);
    return piece;
}

void addLeftovers(const std::vector<TracedPiece>& dropped, const std::vector<int>& echoes, SliceTrace& trace)
{
    const std::vector<TracedPiece> settled = trace.pieces;
    const auto isIn = [](const TracedPiece& piece, int beam) {
        return piece.firstBeam <= beam && beam <= piece.lastBeam;
    };
    const auto holder = [&](const std::vector<TracedPiece>& pieces, int beam) {
        return std::find_if(pieces.begin(), pieces.end(), [&](const TracedPiece& piece) { return isIn(piece, beam); });
    };
    // Of a dropped piece as much as was left, and of echoes of none as many as are beside each other.
    const TracedPiece* of = nullptr;
    bool goesOn = false;
    for (const int beam : echoes) {
        if (holder(settled, beam) != settled.end()) {
            goesOn = false;
            continue;
        }
        const bool beginsRun = std::any_of(trace.runs.begin(), trace.runs.end(),
                                           [&](const TracedRun& run) { return run.firstBeam == beam; });
        const auto found = holder(dropped, beam);
        const TracedPiece* const reason = found == dropped.end() ? nullptr : &*found;
        if (goesOn && !beginsRun && reason == of) {
            trace.pieces.back().lastBeam = beam;
            ++trace.pieces.back().points;
            continue;
        }
        TracedPiece& piece = trace.pieces.emplace_back();
        piece.firstBeam = piece.lastBeam = beam;
        piece.points = 1;
        piece.fate = reason != nullptr ? reason->fate : PieceFate::OffTheLines;
        if (reason != nullptr)
            piece.tests = reason->tests;
        of = reason;
        goesOn = true;
    }
    std::sort(trace.pieces.begin(), trace.pieces.end(),
              [](const TracedPiece& a, const TracedPiece& b) { return a.firstBeam < b.firstBeam; });
    std::sort(trace.splits.begin(), trace.splits.end(),
              [](const TracedSplit& a, const TracedSplit& b) { return a.beam < b.beam; });
}

}  // namespace planewright
