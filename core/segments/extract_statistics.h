// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"
#include "core/segments/beam_points.h"
#include "core/segments/line_moments.h"
#include "core/segments/segment_statistics.h"
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
    /// pieces merged where one line explains both.
    void extract(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters,
                 std::vector<SegmentStatistics>& segments);

    /// Echoes of the slice that was extracted last.
    int echoes() const { return points_.count(); }

private:
    /// Neighbouring points by their place among the echoes, both ends included, and their moments.
    struct Piece {
        int first = 0;
        int last = 0;
        LineMoments moments;
        bool clipped = false;  ///< points beyond 3 σ were left out of the moments

        int points() const { return last - first + 1; }
    };
    struct Open {
        int first = 0;
        int last = 0;
        int depth = 0;
    };

    void splitRun(int first, int last, const Parameters& parameters);
    LineMoments fewPoints(int first, int last) const;
    void settleBorder(Piece& left, Piece& right, const NoiseParameters& noise) const;
    int bestDivision(const Piece& piece, const MomentLine& line, double variance) const;
    void divideBent(const Piece& piece, int depth, const NoiseParameters& noise);
    void trimEnds(Piece& piece, const NoiseParameters& noise) const;
    void clip(Piece& piece, const NoiseParameters& noise) const;
    bool belongTogether(const Piece& left, const Piece& right, const Parameters& parameters, double bearingStep,
                        LineMoments& together) const;
    SegmentStatistics statisticsOf(const Piece& piece, const NoiseParameters& noise) const;

    BeamPoints points_;
    int shortest_ = 0;  // points of the shortest piece
    std::vector<Open> open_;
    std::vector<Piece> pieces_;
    std::vector<Piece> straight_;
};

}  // namespace planewright
