// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/merge_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/segments/end_point_fit.h"

namespace planewright {

namespace {

/// Echoes of neither piece that may stand between them, such as mixed pixels.
constexpr int kForeignEchoes = 0;

/// Standard deviation of the direction of a piece's line [rad]: √12 σ / (L √N).
double angleSigma(const SlicePoints& points, const PointRun& piece, const SliceLine& line)
{
    const double length = (points[piece.last] - points[piece.first]).norm();
    const double variance = points.varianceAcross((piece.first + piece.last) / 2, line.normal());
    return std::sqrt(12.0 * variance / line.points) / std::max(length, 1e-9);
}

/// Angle between two undirected lines [rad].
double angleBetween(const SliceLine& a, const SliceLine& b)
{
    const double cross = a.direction.x() * b.direction.y() - a.direction.y() * b.direction.x();
    return std::atan2(std::abs(cross), std::abs(a.direction.dot(b.direction)));
}

/// True where no echo of a part lies farther than h_o from the chord of the joined piece.
bool staysStraight(const SlicePoints& points, const PointRun& part, const PointRun& joined,
                   const SegmentParameters& parameters)
{
    if (points.echoesIn(part) == part.points())
        return farthestFromChord(points, part, joined, parameters) < 0;
    // Joined before, over beams without echo.
    for (int first = part.first; first <= part.last; ++first) {
        if (!points.hasEcho(first))
            continue;
        int last = first;
        while (last < part.last && points.hasEcho(last + 1))
            ++last;
        if (farthestFromChord(points, {first, last}, joined, parameters) >= 0)
            return false;
        first = last;
    }
    return true;
}

bool belongTogether(const SlicePoints& points, const PointRun& left, const PointRun& right, double bearingStep,
                    const SegmentParameters& parameters)
{
    const double gap = (points[right.first] - points[left.last]).norm();
    const double range = std::max(points.range(left.last), points.range(right.first));
    if (gap >= std::max(parameters.mergeGap, parameters.mergeGapSteps * range * bearingStep))
        return false;
    if (right.first - left.last > 1 && points.echoesIn({left.last + 1, right.first - 1}) > kForeignEchoes)
        return false;

    const SliceLine leftLine = points.lineThrough(left);
    const SliceLine rightLine = points.lineThrough(right);
    const double sigma = std::hypot(angleSigma(points, left, leftLine), angleSigma(points, right, rightLine));
    if (angleBetween(leftLine, rightLine) >= std::max(parameters.mergeAngle, parameters.mergeAngleSigmas * sigma))
        return false;

    return staysStraight(points, left, {left.first, right.last}, parameters) &&
           staysStraight(points, right, {left.first, right.last}, parameters);
}

}  // namespace

void mergePieces(const SlicePoints& points, double bearingStep, const SegmentParameters& parameters,
                 std::vector<PointRun>& pieces, SliceTrace* trace)
{
    std::size_t kept = 0;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        if (!belongTogether(points, pieces[kept], pieces[i], bearingStep, parameters)) {
            pieces[++kept] = pieces[i];
            continue;
        }
        if (trace != nullptr)
            trace->joins.push_back({pieces[kept].last, pieces[i].first});
        pieces[kept].last = pieces[i].last;
    }
    if (!pieces.empty())
        pieces.resize(kept + 1);
}

}  // namespace planewright
