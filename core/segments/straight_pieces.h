// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "core/params/parameters.h"
#include "core/segments/beam_points.h"
#include "core/segments/line_piece.h"
#include "core/segments/slice_trace.h"

namespace planewright {

/// Divides the runs of a slice into straight pieces; keeps its working storage from slice to slice.
class StraightPieces {
public:
    /// The pieces of at least `shortest` points, in bearing order.
    ///
    /// Runs between breakpoints are divided where a point is too far from its chord, in standard deviations
    /// (iterative end-point fit), and then where two lines explain a piece much better than one. Borders between
    /// pieces are settled by their lines. The pieces are fitted. A trace, where there is one, is told of the
    /// divisions, and `dropped` gets what has too few points, and points that lie off the lines beside them.
    std::span<LinePiece> divide(const BeamPoints& points, int shortest, const Parameters& parameters,
                                SliceTrace* trace = nullptr, std::vector<TracedPiece>* dropped = nullptr);

private:
    /// An interval that may have to be divided.
    struct Open {
        int first = 0;
        int last = 0;
        int depth = 0;
        int momentsFirst = -1;  ///< the moments are of the points from there to the last, where they are known
        LineMoments moments;
    };

    void open(int first, int last, int depth);
    bool isDoubtful(const ChordF& chord, int division, const Parameters& parameters) const;
    void splitRun(int first, int last, const Parameters& parameters);
    LinePiece& addPiece(int first, int last);
    LinePiece pieceOf(int first, int last) const;
    LineMoments fewPoints(int first, int last) const;
    void tellSplit(const ChordF& chord, int division, int depth, const Parameters& parameters) const;
    void tellBend(const LinePiece& piece, int division, const NoiseParameters& noise) const;
    void tellDropped(int first, int last) const;
    void tellStranger(int point, double deviation) const;
    void settleBorder(LinePiece& left, LinePiece& right, const NoiseParameters& noise) const;
    bool hasOneVariance(const LinePiece& piece, const NoiseParameters& noise) const;
    double wantedGain(const LinePiece& piece, const NoiseParameters& noise) const;
    int bestDivision(const LinePiece& piece, const NoiseParameters& noise) const;
    int bendOf(const LinePiece& piece, int depth, const NoiseParameters& noise) const;
    void divideBent(const LinePiece& piece, int division, int depth, const NoiseParameters& noise);

    const BeamPoints* points_ = nullptr;
    int shortest_ = 0;
    SliceTrace* trace_ = nullptr;
    std::vector<TracedPiece>* dropped_ = nullptr;
    std::vector<Open> open_;
    std::vector<LinePiece> pieces_;
    std::vector<LinePiece> straight_;
};

}  // namespace planewright
