// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"
#include "core/segments/beam_points.h"
#include "core/segments/segment_statistics.h"
#include "core/segments/slice_trace.h"
#include "core/segments/straight_pieces.h"
#include "core/types/scan_slice.h"

namespace planewright {

/// Extracts line segments with their statistics; keeps its working storage from slice to slice.
///
/// Each scan point is touched here and never again.
class StatisticsExtractor {
public:
    explicit StatisticsExtractor(const BeamKernels& kernels = beamKernels()) : points_(kernels) {}

    /// Appends the segments of a slice in bearing order (Table II) to `segments`.
    ///
    /// Breakpoints by Eq. (3), lifted where 1/ρ is linear in the bearing, as it is on any straight wall however
    /// shallow; end-point fit with a threshold in standard deviations; borders between pieces settled by their lines;
    /// pieces merged where one line explains both. A trace, which must be empty, is told what was done.
    void extract(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters,
                 std::vector<SegmentStatistics>& segments, SliceTrace* trace = nullptr);

    /// Echoes of the slice that was extracted last.
    int echoes() const { return points_.count(); }

private:
    void traceRuns(const ScanSlice& slice, const Parameters& parameters, SliceTrace& trace) const;
    void tracePiece(const LinePiece& piece, int segment, SliceTrace& trace) const;
    void trimEnds(LinePiece& piece, const NoiseParameters& noise, std::vector<TracedPiece>* dropped) const;
    void clip(LinePiece& piece, const NoiseParameters& noise) const;
    bool belongTogether(const LinePiece& left, const LinePiece& right, const Parameters& parameters, double bearingStep,
                        LinePiece& together) const;
    bool describeByRays(const LinePiece& piece, const NoiseParameters& noise, SegmentStatistics& segment) const;
    void describeByMoments(const LinePiece& piece, const NoiseParameters& noise, SegmentStatistics& segment) const;
    void describe(const LinePiece& piece, const NoiseParameters& noise, SegmentStatistics& segment) const;

    BeamPoints points_;
    int shortest_ = 0;  // points of the shortest piece
    StraightPieces straight_;
    std::vector<int> echoes_;  // beams with one, of a slice that is traced
};

}  // namespace planewright
