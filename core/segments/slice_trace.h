// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"
#include "core/types/scan_slice.h"
#include "core/types/sensor_noise.h"
#include "core/types/step_recorder.h"
#include "core/types/step_report.h"

namespace planewright {

/// Neighbouring echoes without a breakpoint between them, by their beams, both ends included.
struct TracedRun {
    int firstBeam = 0;
    int lastBeam = 0;
    int points = 0;
};

/// A place between two neighbouring echoes where one run ends and the next begins.
struct TracedBreak {
    int before = 0;        ///< beam of the last echo of the one run
    int after = 0;         ///< beam of the first echo of the next
    double gap = 0.0;      ///< between them [m]
    double limit = 0.0;    ///< D_o of Eq. (3) between them [m]
    bool missing = false;  ///< too many beams between them have no echo, whatever the gap is
};

/// A point at which a run was divided.
struct TracedSplit {
    int beam = 0;
    Test test;  ///< "chord_distance" [m], "two_lines_gain" [χ²] or "divisions"
};

/// Two pieces beside each other that became one again.
struct TracedJoin {
    int before = 0;  ///< last beam of the left one
    int after = 0;   ///< first beam of the right one
};

/// What became of a piece of a slice.
enum class PieceFate { Segment, TooFewPoints, TooShort, OffTheLines };
inline constexpr std::array<std::string_view, 4> kPieceFateNames{"segment", "too few points", "too short",
                                                                 "off the lines beside it"};
constexpr std::string_view name(PieceFate fate)
{
    return kPieceFateNames[static_cast<std::size_t>(fate)];
}

/// Neighbouring echoes that were kept as a line segment, or discarded, by their beams, both ends included.
struct TracedPiece {
    int firstBeam = 0;
    int lastBeam = 0;
    int points = 0;       ///< those that counted
    double length = 0.0;  ///< from the first point to the last [m]
    PieceFate fate = PieceFate::Segment;
    int segment = -1;         ///< place among the segments of the slice; −1 where it is none
    std::vector<Test> tests;  ///< what it had to pass: "points", "length" [m], "points_of_line", "points_of_run",
                              ///< "line_distance" [m], "line_chi2" [χ²]
};

/// What the segmentation of one slice did. Everything is in bearing order.
///
/// Each echo is in one run and in one piece at most, kept or discarded; those left out within a kept piece count as in
/// it.
struct SliceTrace {
    std::vector<TracedRun> runs;
    std::vector<TracedBreak> breaks;
    std::vector<TracedSplit> splits;
    std::vector<TracedJoin> joins;
    std::vector<TracedPiece> pieces;

    /// Empties it for another slice; its storage stays.
    void clear();
};

/// What the extraction does with a slice, by the code that it runs (`method.estimator` says which). Where noise is
/// estimated, `parameters.noise` must be what was in force at the step: that of its snapshot. A slice without echoes
/// gives an empty trace.
SliceTrace traceSlice(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters);

/// The parameters with the noise that was known at a step.
Parameters withNoise(Parameters parameters, const SensorNoise& noise);

/// A piece that has too few points: the test gives name and limit.
TracedPiece tooFew(int firstBeam, int lastBeam, int points, Test test);

/// A point at the end of a piece that lies off its line: the test has its numbers.
TracedPiece offTheLine(int beam, const Test& test);

/// Ends a trace: of the pieces that were dropped on the way, what no other piece has taken over is discarded for the
/// reason that they give, of several the first that was dropped; echoes of a run that are in none lie off the lines
/// beside them. `echoes`: all their beams, in bearing order.
void addLeftovers(std::vector<TracedPiece> dropped, std::span<const int> echoes, SliceTrace& trace);

/// Tells of each piece that became no segment that it was rejected, and by which numbers.
void tellDiscarded(const SliceTrace& trace, int step, StepRecorder& recorder);

}  // namespace planewright
