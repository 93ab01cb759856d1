// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/slice_trace.h"

#include <algorithm>
#include <cmath>

#include "core/segments/extract_line_segments.h"
#include "core/segments/extract_statistics.h"

namespace planewright {

void SliceTrace::clear()
{
    runs.clear();
    breaks.clear();
    splits.clear();
    joins.clear();
    pieces.clear();
}

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
    parameters.makeFiner(noise.fineness);
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

TracedPiece offTheLine(int beam, const Test& test)
{
    TracedPiece piece;
    piece.firstBeam = piece.lastBeam = beam;
    piece.points = 1;
    piece.fate = PieceFate::OffTheLines;
    piece.tests.push_back(test);
    return piece;
}

void addLeftovers(std::vector<TracedPiece> dropped, std::span<const int> echoes, SliceTrace& trace)
{
    const auto isLeft = [](const TracedPiece& a, const TracedPiece& b) { return a.firstBeam < b.firstBeam; };
    std::stable_sort(dropped.begin(), dropped.end(), isLeft);
    // Beams rise, and so do pieces and runs: each is passed once.
    const auto goPast = [](auto& next, auto end, int beam) {
        while (next != end && next->lastBeam < beam)
            ++next;
        return next != end && next->firstBeam <= beam;
    };
    const std::size_t settled = trace.pieces.size();
    std::size_t kept = 0;
    auto reason = dropped.cbegin();
    auto run = trace.runs.cbegin();
    // Of a dropped piece as much as was left, and of echoes of none as many as are beside each other.
    const TracedPiece* of = nullptr;
    bool goesOn = false;
    for (const int beam : echoes) {
        while (kept < settled && trace.pieces[kept].lastBeam < beam)
            ++kept;
        if (kept < settled && trace.pieces[kept].firstBeam <= beam) {
            goesOn = false;
            continue;
        }
        const bool beginsRun = goPast(run, trace.runs.cend(), beam) && run->firstBeam == beam;
        const TracedPiece* const why = goPast(reason, dropped.cend(), beam) ? &*reason : nullptr;
        if (goesOn && !beginsRun && why == of) {
            trace.pieces.back().lastBeam = beam;
            ++trace.pieces.back().points;
            continue;
        }
        TracedPiece& piece = trace.pieces.emplace_back();
        piece.firstBeam = piece.lastBeam = beam;
        piece.points = 1;
        piece.fate = why != nullptr ? why->fate : PieceFate::OffTheLines;
        if (why != nullptr)
            piece.tests = why->tests;
        of = why;
        goesOn = true;
    }
    std::sort(trace.pieces.begin(), trace.pieces.end(), isLeft);
    std::sort(trace.splits.begin(), trace.splits.end(),
              [](const TracedSplit& a, const TracedSplit& b) { return a.beam < b.beam; });
}

void tellDiscarded(const SliceTrace& trace, int step, StepRecorder& recorder)
{
    for (const TracedPiece& piece : trace.pieces) {
        if (piece.segment < 0)
            recorder.decide(DecisionKind::Reject, {PieceRef{step, piece.firstBeam, piece.lastBeam}}, piece.tests);
    }
}

}  // namespace planewright
