// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/end_point_fit.h"

#include <algorithm>
#include <cmath>

namespace planewright {

namespace {

/// How many points beside a division may change sides.
constexpr int kMovablePoints = 6;

/// The line of a piece without the given number of points at its two ends, or none if fewer than three remain.
bool innerLine(const SlicePoints& points, const PointRun& piece, int cutFirst, int cutLast, SliceLine& line)
{
    const PointRun inner{piece.first + cutFirst, piece.last - cutLast};
    if (inner.points() < 3)
        return false;
    line = points.lineThrough(inner);
    return true;
}

/// Moves the border between two pieces that meet at a division to where their lines say it is.
///
/// On entry left.last is the division and right.first the point after it.
void settleBorder(const SlicePoints& points, PointRun& left, PointRun& right, const SegmentParameters& parameters)
{
    // The lines are taken without the points in question, as far as the pieces are long enough.
    const auto cut = [](const PointRun& piece) { return std::min(kMovablePoints, std::max(1, piece.points() / 3)); };
    SliceLine leftLine;
    SliceLine rightLine;
    const bool leftFits = innerLine(points, left, 0, cut(left), leftLine);
    const bool rightFits = innerLine(points, right, cut(right), 0, rightLine);
    if (!leftFits && !rightFits)
        return;

    const int low = leftFits ? left.last - cut(left) + 1 : left.last;
    const int high = rightFits ? right.first + cut(right) - 1 : right.first;
    const auto within = [&](const SliceLine& line, int beam) {
        return line.distanceTo(points[beam]) <= splitDistance(points, beam, line.normal(), parameters);
    };
    // Of all borders in reach, the one with the smallest sum of squared distances to the two lines.
    const auto cost = [&](bool fits, const SliceLine& line, int beam) {
        const Eigen::Vector2d across = fits ? line.normal() : (leftFits ? leftLine : rightLine).normal();
        const double limit = splitDistance(points, beam, across, parameters);
        const double distance = fits ? line.distanceTo(points[beam]) : limit;
        return std::min(distance * distance, limit * limit);
    };
    double sum = 0.0;
    for (int beam = low; beam <= high; ++beam)
        sum += cost(rightFits, rightLine, beam);
    double best = sum;
    int border = low;  // first beam of the right piece
    for (int beam = low; beam <= high; ++beam) {
        sum += cost(leftFits, leftLine, beam) - cost(rightFits, rightLine, beam);
        if (sum < best) {
            best = sum;
            border = beam + 1;
        }
    }
    left.last = border - 1;
    right.first = border;
    // A point that fits neither line, such as a mixed pixel between two depths, ends no piece.
    while (leftFits && left.points() > 2 && left.last >= low && !within(leftLine, left.last))
        --left.last;
    while (rightFits && right.points() > 2 && right.first <= high && !within(rightLine, right.first))
        ++right.first;
}

}  // namespace

double splitDistance(const SlicePoints& points, int beam, const Eigen::Vector2d& normal,
                     const SegmentParameters& parameters)
{
    return std::max(parameters.splitDistance, parameters.splitSigmas * std::sqrt(points.varianceAcross(beam, normal)));
}

int farthestFromChord(const SlicePoints& points, const PointRun& run, const SegmentParameters& parameters)
{
    const Eigen::Vector2d start = points[run.first];
    Eigen::Vector2d chord = points[run.last] - start;
    const double length = chord.norm();
    if (length == 0.0)
        return -1;
    chord /= length;
    const Eigen::Vector2d normal{-chord.y(), chord.x()};
    const double offset = normal.dot(start);
    const double fixed = parameters.splitDistance * parameters.splitDistance;
    const double sigmas = parameters.splitSigmas * parameters.splitSigmas;

    int farthest = -1;
    double best = fixed;
    for (int beam = run.first + 1; beam < run.last; ++beam) {
        const double distance = normal.dot(points[beam]) - offset;
        const double squared = distance * distance;
        if (squared > best && squared > sigmas * points.varianceAcross(beam, normal)) {
            best = squared;
            farthest = beam;
        }
    }
    return farthest;
}

void splitByEndPointFit(const SlicePoints& points, const PointRun& run, const SegmentParameters& parameters,
                        std::vector<PointRun>& pieces)
{
    const std::size_t begin = pieces.size();
    // A stack on the heap, not the call stack: a run may have 65,536 points and split at every one.
    std::vector<PointRun> open{run};
    while (!open.empty()) {
        const PointRun piece = open.back();
        open.pop_back();
        const int division = piece.points() > 2 ? farthestFromChord(points, piece, parameters) : -1;
        if (division < 0) {
            pieces.push_back(piece);
        } else {
            open.push_back({division, piece.last});
            open.push_back({piece.first, division});
        }
    }

    // Neighbours share their point of division so far; from here on it belongs to the left one alone until settled.
    for (std::size_t i = begin + 1; i < pieces.size(); ++i)
        ++pieces[i].first;
    for (std::size_t i = begin + 1; i < pieces.size(); ++i) {
        if (pieces[i].points() >= 1 && pieces[i - 1].points() >= 1)
            settleBorder(points, pieces[i - 1], pieces[i], parameters);
    }
    std::erase_if(pieces, [&](const PointRun& piece) { return piece.points() < 2; });
}

}  // namespace planewright
