// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/end_point_fit.h"

#include <algorithm>
#include <cmath>

namespace planewright {

namespace {

/// How many points beside a division may change sides.
constexpr int kMovablePoints = 6;

/// Points that a piece must have for a line that does not rest on the points at its ends.
constexpr int kShortestPiece = 4;

/// Divisions at the farthest point, one within the other, before a piece is halved instead. Real slices need a few; a
/// zigzag of 65,536 points, each of which is the farthest in turn, would cost the square of its length.
constexpr int kDeepestDivision = 48;

/// Points at the end of a piece that are in question: few enough for a line through the others.
int movablePoints(const PointRun& piece)
{
    return std::clamp(piece.points() / 3, 1, kMovablePoints);
}

/// Moves the border between two pieces that meet at a division to where their lines say it is.
///
/// Points between them belong to neither so far. Both have at least kShortestPiece points, and keep three.
void settleBorder(const SlicePoints& points, PointRun& left, PointRun& right, const SegmentParameters& parameters,
                  std::vector<TracedPiece>* dropped)
{
    const int low = left.last - movablePoints(left) + 1;
    const int high = right.first + movablePoints(right) - 1;
    const SliceLine leftLine = points.lineThrough({left.first, low - 1});
    const SliceLine rightLine = points.lineThrough({high + 1, right.last});
    const auto within = [&](const SliceLine& line, int beam) {
        const Test test{"line_distance", line.distanceTo(points[beam]), Comparison::LessEqual,
                        splitDistance(points, beam, line.normal(), parameters)};
        if (dropped != nullptr && !test.pass())
            dropped->push_back(offTheLine(beam, test));
        return test.pass();
    };
    // Of all borders in reach, the one with the smallest sum of squared distances to the two lines, where a point of
    // neither counts as much as one at the limit.
    const auto cost = [&](const SliceLine& line, int beam) {
        const double limit = splitDistance(points, beam, line.normal(), parameters);
        const double distance = line.distanceTo(points[beam]);
        return std::min(distance * distance, limit * limit);
    };
    double sum = 0.0;
    for (int beam = low; beam <= high; ++beam)
        sum += cost(rightLine, beam);
    double best = sum;
    int border = low;  // first beam of the right piece
    for (int beam = low; beam <= high; ++beam) {
        sum += cost(leftLine, beam) - cost(rightLine, beam);
        if (sum < best) {
            best = sum;
            border = beam + 1;
        }
    }
    left.last = border - 1;
    right.first = border;
    // A point that fits neither line, such as a mixed pixel between two depths, ends no piece.
    while (left.last >= low && !within(leftLine, left.last))
        --left.last;
    while (right.first <= high && !within(rightLine, right.first))
        ++right.first;
}

/// How far the point of a division is from the chord.
TracedSplit divisionAt(const SlicePoints& points, int division, const PointRun& piece,
                       const SegmentParameters& parameters)
{
    const Eigen::Vector2d chord = (points[piece.last] - points[piece.first]).normalized();
    const Eigen::Vector2d normal{-chord.y(), chord.x()};
    return {division,
            {"chord_distance", std::abs(normal.dot(points[division] - points[piece.first])), Comparison::Greater,
             splitDistance(points, division, normal, parameters)}};
}

}  // namespace

double splitDistance(const SlicePoints& points, int beam, const Eigen::Vector2d& normal,
                     const SegmentParameters& parameters)
{
    return std::max(parameters.splitDistance, parameters.splitSigmas * std::sqrt(points.varianceAcross(beam, normal)));
}

int farthestFromChord(const SlicePoints& points, const PointRun& run, const SegmentParameters& parameters)
{
    return farthestFromChord(points, {run.first + 1, run.last - 1}, run, parameters);
}

int farthestFromChord(const SlicePoints& points, const PointRun& among, const PointRun& ends,
                      const SegmentParameters& parameters)
{
    const Eigen::Vector2d start = points[ends.first];
    Eigen::Vector2d chord = points[ends.last] - start;
    const double length = chord.norm();
    if (length == 0.0)
        return -1;
    chord /= length;
    return beamKernels().farthestExactly(points.arrays(), among.first, among.last,
                                         {start.x(), start.y(), chord.x(), chord.y()},
                                         {parameters.splitDistance * parameters.splitDistance,
                                          parameters.splitSigmas * parameters.splitSigmas, points.bearingVariance()});
}

void splitByEndPointFit(const SlicePoints& points, const PointRun& run, const SegmentParameters& parameters,
                        std::vector<PointRun>& pieces, SliceTrace* trace, std::vector<TracedPiece>* dropped)
{
    const std::size_t begin = pieces.size();
    struct Open {
        PointRun piece;
        int depth;
    };
    // A stack on the heap, not the call stack: a run may have 65,536 points and split at every one.
    std::vector<Open> open{{run, 0}};
    while (!open.empty()) {
        const auto [piece, depth] = open.back();
        open.pop_back();
        int division = piece.points() > 2 ? farthestFromChord(points, piece, parameters) : -1;
        if (division < 0) {
            pieces.push_back(piece);
            continue;
        }
        if (depth >= kDeepestDivision)
            division = (piece.first + piece.last) / 2;
        if (trace != nullptr)
            trace->splits.push_back(depth < kDeepestDivision
                                        ? divisionAt(points, division, piece, parameters)
                                        : TracedSplit{division,
                                                      {"divisions", static_cast<double>(depth),
                                                       Comparison::GreaterEqual, kDeepestDivision}});
        open.push_back({{division, piece.last}, depth + 1});
        open.push_back({{piece.first, division}, depth + 1});
    }

    // Neighbours share their point of division so far; from here on it belongs to the left one alone until settled.
    // Pieces too short for a line of their own only take part as points between their neighbours.
    for (std::size_t i = begin + 1; i < pieces.size(); ++i)
        ++pieces[i].first;
    if (pieces.size() > begin + 1) {
        const auto tooShort = [](const PointRun& piece) { return piece.points() < kShortestPiece; };
        for (std::size_t i = begin; i < pieces.size() && dropped != nullptr; ++i) {
            if (tooShort(pieces[i]))
                dropped->push_back(tooFew(pieces[i].first, pieces[i].last, pieces[i].points(),
                                          {"points_of_line", 0.0, Comparison::GreaterEqual, kShortestPiece}));
        }
        pieces.erase(std::remove_if(pieces.begin() + static_cast<std::ptrdiff_t>(begin), pieces.end(), tooShort),
                     pieces.end());
    }
    for (std::size_t i = begin + 1; i < pieces.size(); ++i)
        settleBorder(points, pieces[i - 1], pieces[i], parameters, dropped);
}

}  // namespace planewright
