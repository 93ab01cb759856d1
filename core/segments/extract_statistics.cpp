// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/extract_statistics.h"

#include <algorithm>
#include <cmath>

namespace planewright {

namespace {

/// How many points beside a division may change sides.
constexpr int kMovablePoints = 6;
/// Points that a line of its own needs.
constexpr int kShortestPiece = 4;
/// Points at each end of a piece that may be left out as strangers, and how far off they are, in standard deviations.
constexpr int kTrimmedPoints = 2;
constexpr double kTrimSigmas = 2.5;
/// Points farther than this from their line are left out where the line explains its points badly.
constexpr double kClipSigmas = 3.0;
/// Divisions one within the other before a piece is halved instead.
constexpr int kDeepestDivision = 48;
/// Pieces longer than this are tried on every fourth point first, and only a clear hit is trusted.
constexpr int kLongPiece = 48;
constexpr int kStride = 4;
constexpr float kClearHit = 1.5F * 1.5F;
/// A single weight serves a segment whose ranges differ by less than this factor.
constexpr double kOneWeightRatio = 1.6;
/// χ² with two degrees of freedom that the common line of two pieces may cost: 99.9 %.
constexpr double kCommonLine = 13.8;
/// No variance is taken for smaller [m²], lest a scanner without noise divide by zero.
constexpr double kLeastVariance = 1e-12;

double square(double x)
{
    return x * x;
}

/// Variance of a point across a line of this normal [m²]: range noise along the ray, bearing noise across it.
double varianceAcross(double normalU, double normalV, double u, double v, const NoiseParameters& noise)
{
    const double along = square(normalU * u + normalV * v);
    const double across = square(normalV * u - normalU * v);
    const double relative =
        square(noise.rangeConstant) / std::max(along + across, kLeastVariance) + square(noise.rangeProportional);
    return std::max(kLeastVariance, along * relative + across * square(noise.bearing));
}

double centroidVariance(const MomentLine& line, const LineMoments& moments, const NoiseParameters& noise)
{
    return varianceAcross(line.normalU(), line.normalV(), moments.u, moments.v, noise);
}

double distanceTo(const MomentLine& line, const LineMoments& moments, double u, double v)
{
    return line.normalU() * (u - moments.u) + line.normalV() * (v - moments.v);
}

/// Largest sum of squares, in variances, that a straight piece of so many points plausibly has.
double largestChi(double points)
{
    const double freedom = std::max(1.0, points - 2.0);
    return freedom + 3.0 * std::sqrt(2.0 * freedom);
}

}  // namespace

/// Splits a run at the points farthest from its chords, and settles the borders between the pieces.
void StatisticsExtractor::splitRun(int first, int last, const Parameters& parameters)
{
    const auto fixed = static_cast<float>(square(parameters.segments.splitDistance));
    const auto sigmas = static_cast<float>(square(parameters.segments.splitSigmas));
    const auto bearing = static_cast<float>(square(parameters.noise.bearing));
    const DeviationLimits limits{fixed, sigmas, bearing};
    const DeviationLimits clear{kClearHit * fixed, kClearHit * sigmas, bearing};
    const BeamArrays points = points_.arrays();
    const auto divisionOf = [&](const Open& open) {
        if (open.last - open.first < 2)
            return -1;
        const ChordF chord = points_.chordOf(open.first, open.last);
        if (open.last - open.first >= kLongPiece) {
            const int hit =
                points_.kernels().farthest(points, open.first + kStride, open.last - kStride, kStride, chord, clear);
            if (hit >= 0)
                return points_.kernels().farthest(points, std::max(open.first + 1, hit - kStride),
                                                  std::min(open.last - 1, hit + kStride), 1, chord, limits);
        }
        return points_.kernels().farthest(points, open.first + 1, open.last - 1, 1, chord, limits);
    };

    const std::size_t begin = pieces_.size();
    open_.clear();
    open_.push_back({first, last, 0});
    while (!open_.empty()) {
        const Open open = open_.back();
        open_.pop_back();
        int division = divisionOf(open);
        if (division < 0) {
            // Neighbours share their point of division; it belongs to the left one until the border is settled.
            const bool shared = pieces_.size() > begin && pieces_.back().last == open.first;
            const int start = shared ? open.first + 1 : open.first;
            if (open.last - start + 1 >= kShortestPiece)
                pieces_.push_back({start, open.last, points_.momentsOf(start, open.last)});
            continue;
        }
        if (open.depth >= kDeepestDivision)
            division = (open.first + open.last) / 2;
        open_.push_back({division, open.last, open.depth + 1});
        open_.push_back({open.first, division, open.depth + 1});
    }
    for (std::size_t i = begin + 1; i < pieces_.size(); ++i)
        settleBorder(pieces_[i - 1], pieces_[i], parameters.noise);
}

/// Moves the border between two neighbouring pieces to where their lines say it is; points of no piece between them
/// take part.
void StatisticsExtractor::settleBorder(Piece& left, Piece& right, const NoiseParameters& noise) const
{
    if (right.first - left.last - 1 > kMovablePoints)
        return;
    const auto movable = [](const Piece& piece) { return std::clamp(piece.points() / 3, 1, kMovablePoints); };
    const int low = left.last - movable(left) + 1;
    const int high = right.first + movable(right) - 1;
    for (int i = low; i <= left.last; ++i)
        left.moments.remove(points_.u(i), points_.v(i));
    for (int i = right.first; i <= high; ++i)
        right.moments.remove(points_.u(i), points_.v(i));
    const MomentLine leftLine = lineOf(left.moments);
    const MomentLine rightLine = lineOf(right.moments);
    const double leftVariance = centroidVariance(leftLine, left.moments, noise);
    const double rightVariance = centroidVariance(rightLine, right.moments, noise);
    // Of all borders in reach the one with the smallest sum of squares, where a stranger to both counts as a limit.
    constexpr double kStranger = kClipSigmas * kClipSigmas;
    const auto leftCost = [&](int i) {
        return square(distanceTo(leftLine, left.moments, points_.u(i), points_.v(i))) / leftVariance;
    };
    const auto rightCost = [&](int i) {
        return square(distanceTo(rightLine, right.moments, points_.u(i), points_.v(i))) / rightVariance;
    };
    double sum = 0.0;
    double best = 0.0;
    int border = low;  // first point of the right piece
    for (int i = low; i <= high; ++i) {
        sum += std::min(leftCost(i), kStranger) - std::min(rightCost(i), kStranger);
        if (sum < best) {
            best = sum;
            border = i + 1;
        }
    }
    left.last = border - 1;
    right.first = border;
    while (left.last >= low && leftCost(left.last) > kStranger)
        --left.last;
    while (right.first <= high && rightCost(right.first) > kStranger)
        ++right.first;
    for (int i = low; i <= left.last; ++i)
        left.moments.add(points_.u(i), points_.v(i));
    for (int i = right.first; i <= high; ++i)
        right.moments.add(points_.u(i), points_.v(i));
}

/// Leaves out up to two points at each end that do not lie on the line of the others: mixed pixels at an edge.
void StatisticsExtractor::trimEnds(Piece& piece, const NoiseParameters& noise) const
{
    for (int side = 0; side < 2; ++side) {
        for (int trimmed = 0; trimmed < kTrimmedPoints && piece.points() > kShortestPiece; ++trimmed) {
            const int i = side == 0 ? piece.first : piece.last;
            MomentLine line = lineOf(piece.moments);
            const double suspicious = square(0.5 * kTrimSigmas) * centroidVariance(line, piece.moments, noise);
            if (square(distanceTo(line, piece.moments, points_.u(i), points_.v(i))) < suspicious)
                break;
            LineMoments others = piece.moments;
            others.remove(points_.u(i), points_.v(i));
            line = lineOf(others);
            const double variance = centroidVariance(line, others, noise);
            const double along =
                line.directionU * (points_.u(i) - others.u) + line.directionV * (points_.v(i) - others.v);
            const double leverage = 1.0 + 1.0 / others.count + along * along / std::max(line.along, kLeastVariance);
            if (square(distanceTo(line, others, points_.u(i), points_.v(i))) <
                square(kTrimSigmas) * leverage * variance)
                break;
            piece.moments = others;
            piece.first += side == 0 ? 1 : 0;
            piece.last -= side == 0 ? 0 : 1;
        }
    }
}

/// Leaves the points out that lie off the line, where it explains its points badly.
void StatisticsExtractor::clip(Piece& piece, const NoiseParameters& noise) const
{
    const MomentLine line = lineOf(piece.moments);
    const double variance = centroidVariance(line, piece.moments, noise);
    if (line.across <= variance * largestChi(piece.moments.count))
        return;
    LineMoments inside;
    for (int i = piece.first; i <= piece.last; ++i) {
        const double own = varianceAcross(line.normalU(), line.normalV(), points_.u(i), points_.v(i), noise);
        if (square(distanceTo(line, piece.moments, points_.u(i), points_.v(i))) < square(kClipSigmas) * own)
            inside.add(points_.u(i), points_.v(i));
    }
    if (inside.count < kShortestPiece || 2.0 * inside.count < piece.moments.count)
        return;
    piece.clipped = inside.count < piece.moments.count;
    piece.moments = inside;
}

bool StatisticsExtractor::belongTogether(const Piece& left, const Piece& right, const Parameters& parameters,
                                         double bearingStep, LineMoments& together) const
{
    if (right.first - left.last - 1 > kTrimmedPoints)
        return false;
    const double gap =
        std::hypot(points_.u(right.first) - points_.u(left.last), points_.v(right.first) - points_.v(left.last));
    const double range = std::max(points_.range(left.last), points_.range(right.first));
    if (gap >= std::max(parameters.segments.mergeGap, parameters.segments.mergeGapSteps * range * bearingStep))
        return false;
    together = left.moments;
    together.add(right.moments);
    const MomentLine line = lineOf(together);
    const double variance = centroidVariance(line, together, parameters.noise);
    const double apart = lineOf(left.moments).across + lineOf(right.moments).across;
    return line.across - apart < kCommonLine * variance && line.across < variance * largestChi(together.count);
}

SegmentStatistics StatisticsExtractor::statisticsOf(const Piece& piece, const NoiseParameters& noise) const
{
    const LineMoments& moments = piece.moments;
    MomentLine line = lineOf(moments);
    const double spanU = points_.u(piece.last) - points_.u(piece.first);
    const double spanV = points_.v(piece.last) - points_.v(piece.first);
    if (spanU * line.directionU + spanV * line.directionV < 0.0) {
        line.directionU = -line.directionU;
        line.directionV = -line.directionV;
    }

    SegmentStatistics segment;
    segment.firstBeam = points_.beam(piece.first);
    segment.lastBeam = points_.beam(piece.last);
    segment.points = static_cast<int>(moments.count);
    segment.u = moments.u;
    segment.v = moments.v;
    segment.directionU = line.directionU;
    segment.directionV = line.directionV;
    segment.thickness = line.across / moments.count;
    segment.spread = line.along / moments.count;
    const double offset = line.normalU() * moments.u + line.normalV() * moments.v;
    const double foot = -(line.directionU * moments.u + line.directionV * moments.v);  // from the centroid
    const double startAlong =
        line.directionU * (points_.u(piece.first) - moments.u) + line.directionV * (points_.v(piece.first) - moments.v);
    const double endAlong = startAlong + line.directionU * spanU + line.directionV * spanV;
    const double nearest = foot > startAlong && foot < endAlong
                               ? std::abs(offset)
                               : std::min(points_.range(piece.first), points_.range(piece.last));
    const double farthest = std::max(points_.range(piece.first), points_.range(piece.last));
    if (farthest < kOneWeightRatio * nearest || piece.clipped) {
        // One weight for all points: that of the mean variance along the segment, by Simpson's rule.
        const auto varianceAt = [&](double along) {
            return varianceAcross(line.normalU(), line.normalV(), moments.u + along * line.directionU,
                                  moments.v + along * line.directionV, noise);
        };
        const double weight =
            6.0 / (varianceAt(startAlong) + 4.0 * varianceAt(0.5 * (startAlong + endAlong)) + varianceAt(endAlong));
        segment.offsetInformation = moments.count * weight;
        segment.slopeInformation = line.along * weight;
        segment.chi = line.across * weight;
        segment.start = startAlong;
        segment.end = endAlong;
    } else {
        const ChordF frame{static_cast<float>(moments.u), static_cast<float>(moments.v),
                           static_cast<float>(line.directionU), static_cast<float>(line.directionV)};
        const WeightModel model{static_cast<float>(std::max(std::abs(offset), 1e-4)), static_cast<float>(foot),
                                static_cast<float>(std::max(kLeastVariance, square(noise.rangeConstant))),
                                static_cast<float>(square(noise.rangeProportional)),
                                static_cast<float>(square(noise.bearing))};
        const ChordSums sums = points_.kernels().weightedSums(points_.arrays(), piece.first, piece.last, frame, model);
        const auto w = static_cast<double>(sums.weight);
        const double t = static_cast<double>(sums.t) / w;
        const double h = static_cast<double>(sums.h) / w;
        const double tt = static_cast<double>(sums.tt) - w * t * t;
        const double th = static_cast<double>(sums.th) - w * t * h;
        const double hh = static_cast<double>(sums.hh) - w * h * h;
        const double slope = th / tt;
        const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
        const double sine = slope * cosine;
        // The frame is one of floats; its exact values are taken so that rounding it moves nothing.
        const auto c = static_cast<double>(frame.directionU);
        const auto s = static_cast<double>(frame.directionV);
        segment.u = static_cast<double>(frame.u) + c * t - s * h;
        segment.v = static_cast<double>(frame.v) + s * t + c * h;
        const double norm = 1.0 / std::sqrt(c * c + s * s);
        segment.directionU = norm * (cosine * c - sine * s);
        segment.directionV = norm * (cosine * s + sine * c);
        segment.offsetInformation = w;
        segment.slopeInformation = tt;
        segment.chi = std::max(0.0, hh - slope * th);
        segment.start = startAlong - t;
        segment.end = endAlong - t;
    }
    // A line that explains its points badly holds strangers: it shall not pull at the plane with its full weight.
    const double freedom = std::max(1.0, static_cast<double>(segment.points) - 2.0);
    if (segment.chi > freedom + 4.0 * std::sqrt(2.0 * freedom)) {
        const double share = square(freedom / segment.chi);
        segment.offsetInformation *= share;
        segment.slopeInformation *= share;
    }
    const auto farther = [&](int i, int neighbour) {
        return neighbour < 0 || neighbour >= points_.count() ||
               std::abs(points_.beam(i) - points_.beam(neighbour)) > kBridgedBeams ||
               points_.range(neighbour) > points_.range(i);
    };
    const auto marked = [&](int i) { return i >= points_.count() || points_.breaksBefore(i); };
    segment.startsFree = marked(piece.first) && farther(piece.first, piece.first - 1);
    segment.endsFree = marked(piece.last + 1) && farther(piece.last, piece.last + 1);
    return segment;
}

void StatisticsExtractor::extract(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters,
                                  std::vector<SegmentStatistics>& segments)
{
    points_.take(slice, sensor, parameters);
    pieces_.clear();
    int first = 0;
    for (int i = 1; i <= points_.count(); ++i) {
        if (i < points_.count() && !points_.breaksBefore(i))
            continue;
        if (i - first >= kShortestPiece)
            splitRun(first, i - 1, parameters);
        first = i;
    }

    std::size_t kept = 0;
    for (Piece& piece : pieces_) {
        trimEnds(piece, parameters.noise);
        clip(piece, parameters.noise);
        LineMoments together;
        if (kept > 0 && belongTogether(pieces_[kept - 1], piece, parameters, slice.bearingStep, together)) {
            Piece& before = pieces_[kept - 1];
            before.clipped = before.clipped || piece.clipped || piece.first != before.last + 1;
            before.last = piece.last;
            before.moments = together;
        } else {
            pieces_[kept++] = piece;
        }
    }
    for (std::size_t i = 0; i < kept; ++i) {
        if (pieces_[i].moments.count >= static_cast<double>(parameters.segments.minPoints))
            segments.push_back(statisticsOf(pieces_[i], parameters.noise));
    }
}

}  // namespace planewright
