// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/extract_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "core/segments/breakpoints.h"
#include "core/segments/line_of_rays.h"
#include "core/segments/seen_line.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

/// The fewest points of a segment are told for this angle between beams [rad]; a wider one needs fewer, but so many.
constexpr double kToldStep = degrees(0.25);
constexpr int kFewestPoints = 3;
/// Points at each end of a piece that may be left out as strangers, and how far off they are, in standard deviations.
constexpr int kTrimmedPoints = 2;
constexpr double kTrimSigmas = 2.5;
/// The variance across the common line of two pieces is surely less than so many times the larger of theirs.
constexpr double kRoughly = 4.0;
/// So few points tell too little of their scatter to say how noise turned their line: it is drawn by their rays.
constexpr int kFewPoints = 8;
/// A single weight serves a segment whose ranges differ by less than this factor.
constexpr double kOneWeightRatio = 1.6;

}  // namespace

/// Leaves out up to two points at each end that do not lie on the line of the others: mixed pixels at an edge.
void StatisticsExtractor::trimEnds(LinePiece& piece, const NoiseParameters& noise,
                                   std::vector<TracedPiece>* dropped) const
{
    for (int side = 0; side < 2; ++side) {
        for (int trimmed = 0; trimmed < kTrimmedPoints && piece.points() > shortest_; ++trimmed) {
            const int i = side == 0 ? piece.first : piece.last;
            const double suspicious = square(0.5 * kTrimSigmas) * piece.variance;
            if (square(distanceTo(piece.line, piece.moments, points_.u(i), points_.v(i))) < suspicious)
                break;
            LineMoments others = piece.moments;
            others.remove(points_.u(i), points_.v(i));
            const MomentLine line = lineOf(others);
            const double variance = centroidVariance(line, others, noise);
            const double along =
                line.directionU * (points_.u(i) - others.u) + line.directionV * (points_.v(i) - others.v);
            const double leverage = 1.0 + 1.0 / others.count + along * along / std::max(line.along, kLeastVariance);
            const double deviation = square(distanceTo(line, others, points_.u(i), points_.v(i)));
            if (deviation < square(kTrimSigmas) * leverage * variance)
                break;
            if (dropped != nullptr)
                dropped->push_back(offTheLine(points_.beam(i), {"line_chi2", deviation / (leverage * variance),
                                                                Comparison::Less, square(kTrimSigmas)}));
            piece.moments = others;
            piece.line = line;
            piece.variance = variance;
            piece.first += side == 0 ? 1 : 0;
            piece.last -= side == 0 ? 0 : 1;
        }
    }
}

/// Leaves the points out that lie off the line, where it explains its points badly.
void StatisticsExtractor::clip(LinePiece& piece, const NoiseParameters& noise) const
{
    const MomentLine& line = piece.line;
    if (line.across <= piece.variance * largestChi(piece.moments.count))
        return;
    LineMoments inside;
    for (int i = piece.first; i <= piece.last; ++i) {
        const double own = varianceAcross(line.normalU(), line.normalV(), points_.u(i), points_.v(i), noise);
        if (square(distanceTo(line, piece.moments, points_.u(i), points_.v(i))) < square(kClipSigmas) * own)
            inside.add(points_.u(i), points_.v(i));
    }
    if (inside.count < shortest_ || 2.0 * inside.count < piece.moments.count)
        return;
    piece.clipped = inside.count < piece.moments.count;
    piece.moments = inside;
    fitLine(piece, noise);
}

bool StatisticsExtractor::belongTogether(const LinePiece& left, const LinePiece& right, const Parameters& parameters,
                                         double bearingStep, LinePiece& together) const
{
    if (right.first - left.last - 1 > kTrimmedPoints)
        return false;
    const double gap =
        square(points_.u(right.first) - points_.u(left.last)) + square(points_.v(right.first) - points_.v(left.last));
    const double range = std::max(points_.range(left.last), points_.range(right.first));
    if (gap >= square(std::max(parameters.segments.mergeGap, parameters.segments.mergeGapSteps * range * bearingStep)))
        return false;
    together.first = left.first;
    together.last = right.last;
    together.moments = left.moments;
    together.moments.add(right.moments);
    const double apart = left.line.across + right.line.across;
    const double roughly = kRoughly * std::max(left.variance, right.variance);
    if (!isOneLine(together.moments.count, axesOf(together.moments).smaller, apart, roughly))
        return false;
    together.clipped = left.clipped || right.clipped || right.first != left.last + 1;
    fitLine(together, parameters.noise);
    return isOneLine(together.moments.count, together.line.across, apart, together.variance);
}

/// Few points, by their rays. False where these do not tell a line, are noisier than they are apart, or are not of one
/// weight.
bool StatisticsExtractor::describeByRays(const LinePiece& piece, const NoiseParameters& noise,
                                         SegmentStatistics& segment) const
{
    if (piece.clipped || piece.points() > kFewPoints)
        return false;
    std::array<SlicePoint, kFewPoints> points;
    double nearest = points_.range(piece.first);
    double farthest = nearest;
    for (int i = piece.first; i <= piece.last; ++i) {
        points[static_cast<std::size_t>(i - piece.first)] = {points_.u(i), points_.v(i)};
        nearest = std::min(nearest, points_.range(i));
        farthest = std::max(farthest, points_.range(i));
    }
    const SlicePoint& first = points.front();
    const SlicePoint& last = points[static_cast<std::size_t>(piece.points() - 1)];
    const double aside = (first.u * last.v - first.v * last.u) / farthest;
    if (farthest >= kOneWeightRatio * nearest ||
        square(aside) < square(kDirectedSigmas) * noise.rangeVariance(farthest))
        return false;
    const auto count = static_cast<std::size_t>(piece.points());
    const std::optional<LineOfRays> line = lineOfRays(std::span(points).first(count));
    if (!line)
        return false;
    const double weight = 1.0 / meanVariance({line->distance, line->from, line->to}, noise);
    segment.u = line->u;
    segment.v = line->v;
    segment.directionU = line->directionU();
    segment.directionV = line->directionV();
    segment.start = line->from - line->place;
    segment.end = line->to - line->place;
    segment.offsetInformation = segment.points * weight;
    segment.slopeInformation = line->along * weight;
    segment.chi = line->across * weight;
    segment.thickness = line->across / segment.points;
    segment.spread = line->along / segment.points;
    return true;
}

void StatisticsExtractor::describeByMoments(const LinePiece& piece, const NoiseParameters& noise,
                                            SegmentStatistics& segment) const
{
    const LineMoments& moments = piece.moments;
    MomentLine line = piece.line;
    const double spanU = points_.u(piece.last) - points_.u(piece.first);
    const double spanV = points_.v(piece.last) - points_.v(piece.first);
    if (spanU * line.directionU + spanV * line.directionV < 0.0) {
        line.directionU = -line.directionU;
        line.directionV = -line.directionV;
    }

    segment.u = moments.u;
    segment.v = moments.v;
    segment.directionU = line.directionU;
    segment.directionV = line.directionV;
    segment.thickness = line.across / moments.count;
    segment.spread = line.along / moments.count;
    const double away = line.normalU() * moments.u + line.normalV() * moments.v;
    const double offset = std::copysign(std::max(std::abs(away), kLeastOffset), away);
    const double foot = -(line.directionU * moments.u + line.directionV * moments.v);  // from the centroid
    const double startAlong =
        line.directionU * (points_.u(piece.first) - moments.u) + line.directionV * (points_.v(piece.first) - moments.v);
    const double endAlong = startAlong + line.directionU * spanU + line.directionV * spanV;
    const SeenLine seen{offset, startAlong - foot, endAlong - foot};
    const double nearest = foot > startAlong && foot < endAlong
                               ? std::abs(offset)
                               : std::min(points_.range(piece.first), points_.range(piece.last));
    const double farthest = std::max(points_.range(piece.first), points_.range(piece.last));
    if (farthest < kOneWeightRatio * nearest || piece.clipped) {
        // One weight for all points: that of the mean variance along the segment.
        const double weight = 1.0 / meanVariance(seen, noise);
        const double slope = moments.count <= kFewPoints ? 0.0 : likeliestSlope(line, seen, noise);
        const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
        segment.directionU = cosine * (line.directionU + slope * line.normalU());
        segment.directionV = cosine * (line.directionV + slope * line.normalV());
        segment.offsetInformation = moments.count * weight;
        segment.slopeInformation = line.along * weight;
        segment.chi = line.across * weight;
        segment.start = startAlong;
        segment.end = endAlong;
    } else {
        const ChordF frame{static_cast<float>(moments.u), static_cast<float>(moments.v),
                           static_cast<float>(line.directionU), static_cast<float>(line.directionV)};
        const WeightModel model{static_cast<float>(std::abs(offset)), static_cast<float>(foot),
                                static_cast<float>(std::max(kLeastVariance, square(noise.rangeConstant))),
                                static_cast<float>(square(noise.rangeProportional)),
                                static_cast<float>(square(noise.bearing))};
        const ChordSums sums = points_.kernels().weightedSums(points_.arrays(), piece.first, piece.last, frame, model);
        const WeightBias bias = weightBias(seen, noise);
        const auto w = static_cast<double>(sums.weight);
        const double t = static_cast<double>(sums.t) / w;
        const double h = static_cast<double>(sums.h) / w;
        const double tt = static_cast<double>(sums.tt) - w * t * t;
        const double th = static_cast<double>(sums.th) - w * t * h;
        const double hh = static_cast<double>(sums.hh) - w * h * h;
        // What noise makes of Σ w t h: by the weights, and by lying along the line as well as across it.
        const double ofNoise = w * (bias.moment + (foot - t) * bias.offset) - moments.count * foot / offset;
        const double slope = (th - ofNoise) / tt;
        const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
        const double sine = slope * cosine;
        // The frame is one of floats; its exact values are taken so that rounding it moves nothing.
        const auto c = static_cast<double>(frame.directionU);
        const auto s = static_cast<double>(frame.directionV);
        segment.u = static_cast<double>(frame.u) + c * t - s * (h - bias.offset);
        segment.v = static_cast<double>(frame.v) + s * t + c * (h - bias.offset);
        const double norm = 1.0 / std::sqrt(c * c + s * s);
        segment.directionU = norm * (cosine * c - sine * s);
        segment.directionV = norm * (cosine * s + sine * c);
        segment.offsetInformation = w;
        segment.slopeInformation = tt;
        segment.chi = std::max(0.0, hh - slope * (2.0 * th - slope * tt));
        segment.start = startAlong - t;
        segment.end = endAlong - t;
    }
}

void StatisticsExtractor::describe(const LinePiece& piece, const NoiseParameters& noise,
                                   SegmentStatistics& segment) const
{
    segment.firstBeam = points_.beam(piece.first);
    segment.lastBeam = points_.beam(piece.last);
    segment.points = static_cast<int>(piece.moments.count);
    if (!describeByRays(piece, noise, segment))
        describeByMoments(piece, noise, segment);
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
}

void StatisticsExtractor::traceRuns(const ScanSlice& slice, const Parameters& parameters, SliceTrace& trace) const
{
    for (int first = 0; first < points_.count();) {
        const int next = points_.nextBreak(first + 1);
        if (first > 0) {
            const int beams = points_.beam(first) - points_.beam(first - 1);
            const int counted = beams > kBridgedBeams ? 1 : beams;
            trace.breaks.push_back(
                {points_.beam(first - 1), points_.beam(first),
                 std::hypot(points_.u(first) - points_.u(first - 1), points_.v(first) - points_.v(first - 1)),
                 breakpointDistance(points_.range(first - 1), breakpointStep(slice.bearingStep * counted),
                                    parameters.segments, parameters.noise),
                 beams > kBridgedBeams});
        }
        trace.runs.push_back({points_.beam(first), points_.beam(next - 1), next - first});
        first = next;
    }
}

void StatisticsExtractor::tracePiece(const LinePiece& piece, int segment, SliceTrace& trace) const
{
    const Test test{"points", piece.moments.count, Comparison::GreaterEqual, static_cast<double>(shortest_)};
    TracedPiece traced;
    traced.firstBeam = points_.beam(piece.first);
    traced.lastBeam = points_.beam(piece.last);
    traced.points = static_cast<int>(piece.moments.count);
    traced.fate = test.pass() ? PieceFate::Segment : PieceFate::TooFewPoints;
    traced.segment = test.pass() ? segment : -1;
    traced.tests.push_back(test);
    trace.pieces.push_back(std::move(traced));
}

void StatisticsExtractor::extract(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters,
                                  std::vector<SegmentStatistics>& segments, SliceTrace* trace)
{
    points_.take(slice, sensor, parameters);
    std::vector<TracedPiece> dropped;
    if (trace != nullptr)
        traceRuns(slice, parameters, *trace);
    // Narrow faces must be seen by coarse scanners too: what counts as short follows the resolution.
    const int told = std::max(kFewestPoints, parameters.segments.minPoints);
    shortest_ = std::clamp(static_cast<int>(std::lround(told * kToldStep / slice.bearingStep)), kFewestPoints, told);
    const std::span<LinePiece> pieces =
        straight_.divide(points_, shortest_, parameters, trace, trace != nullptr ? &dropped : nullptr);

    std::size_t kept = 0;
    for (LinePiece& piece : pieces) {
        trimEnds(piece, parameters.noise, trace != nullptr ? &dropped : nullptr);
        clip(piece, parameters.noise);
        LinePiece together;
        if (kept > 0 && belongTogether(pieces[kept - 1], piece, parameters, slice.bearingStep, together)) {
            if (trace != nullptr)
                trace->joins.push_back({points_.beam(pieces[kept - 1].last), points_.beam(piece.first)});
            pieces[kept - 1] = together;
            continue;
        }
        if (&pieces[kept] != &piece)
            pieces[kept] = piece;
        ++kept;
    }
    const std::size_t before = segments.size();
    for (std::size_t i = 0; i < kept; ++i) {
        if (trace != nullptr)
            tracePiece(pieces[i], static_cast<int>(segments.size() - before), *trace);
        if (pieces[i].moments.count >= static_cast<double>(shortest_))
            describe(pieces[i], parameters.noise, segments.emplace_back());
    }
    if (trace != nullptr) {
        echoes_.clear();
        for (int i = 0; i < points_.count(); ++i)
            echoes_.push_back(points_.beam(i));
        addLeftovers(std::move(dropped), echoes_, *trace);
    }
}

}  // namespace planewright
