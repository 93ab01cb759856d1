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

    const PointRun joined{left.first, right.last};
    const auto straight = [&](const PointRun& part) {
        const Eigen::Vector2d start = points[joined.first];
        const Eigen::Vector2d chord = (points[joined.last] - start).normalized();
        const Eigen::Vector2d normal{-chord.y(), chord.x()};
        for (int beam = part.first; beam <= part.last; ++beam) {
            if (points.hasEcho(beam) &&
                std::abs(normal.dot(points[beam] - start)) > splitDistance(points, beam, normal, parameters))
                return false;
        }
        return true;
    };
    return straight(left) && straight(right);
}

}  // namespace

void mergePieces(const SlicePoints& points, double bearingStep, const SegmentParameters& parameters,
                 std::vector<PointRun>& pieces)
{
    std::size_t kept = 0;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        if (belongTogether(points, pieces[kept], pieces[i], bearingStep, parameters))
            pieces[kept].last = pieces[i].last;
        else
            pieces[++kept] = pieces[i];
    }
    if (!pieces.empty())
        pieces.resize(kept + 1);
}

}  // namespace planewright
