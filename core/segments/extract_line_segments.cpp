// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/extract_line_segments.h"

#include <algorithm>
#include <cmath>

#include "core/segments/breakpoints.h"
#include "core/segments/end_point_fit.h"
#include "core/segments/merge_pieces.h"

namespace planewright {

namespace {

/// Eq. (5), turned round: long enough and of enough points.
bool isAvailable(const SlicePoints& points, const PointRun& piece, const SegmentParameters& parameters)
{
    return points.echoesIn(piece) >= parameters.minPoints &&
           (points[piece.first] - points[piece.last]).norm() >= parameters.minLength;
}

/// Moments in space of the points of a piece, all taken at the tilt of its middle.
PointMoments momentsInSpace(const SlicePoints& points, const PointRun& piece, const BeamDirection& middle,
                            const SensorModel& sensor)
{
    const SliceMoments flat = points.momentsOf(piece);
    Eigen::Matrix<double, 3, 2> axes;
    axes.col(0) = Eigen::Vector3d::UnitX();
    axes.col(1) = Eigen::Vector3d{0.0, middle.sinTilt, -middle.cosTilt};
    PointMoments moments;
    moments.count = flat.points;
    moments.mean = axes * flat.centroid + toCartesian(0.0, middle, sensor);
    moments.scatter = axes * (moments.count * flat.covariance) * axes.transpose();
    return moments;
}

/// True where the neighbour of an end point is an echo nearer by more than the gap of one surface.
bool isShadowed(const SlicePoints& points, int beam, int neighbour, double perRange, const Parameters& parameters)
{
    if (neighbour < 0 || neighbour >= points.beams() || !points.hasEcho(neighbour))
        return false;
    const double range = points.range(beam);
    const double gap =
        range * perRange + parameters.segments.breakpointSigmas * std::sqrt(parameters.noise.rangeVariance(range));
    return points.range(beam) - points.range(neighbour) > gap;
}

/// The direction of a beam.
BeamDirection directionOf(const SlicePoints& points, int beam, const ScanSlice& slice)
{
    const double tilt = slice.tiltAt(static_cast<std::size_t>(beam));
    return {points.sine(beam), points.cosine(beam), std::sin(tilt), std::cos(tilt)};
}

LineSegment inSpace(const SlicePoints& points, const PointRun& piece, const ScanSlice& slice, double perRange,
                    const SensorModel& sensor, const Parameters& parameters)
{
    const NoiseParameters& noise = parameters.noise;
    const auto first = static_cast<std::size_t>(piece.first);
    const auto last = static_cast<std::size_t>(piece.last);
    const SliceLine line = points.lineThrough(piece);

    LineSegment segment;
    segment.firstBeam = piece.first;
    segment.lastBeam = piece.last;
    segment.points = line.points;
    const BeamDirection start = directionOf(points, piece.first, slice);
    const BeamDirection end = directionOf(points, piece.last, slice);
    const BeamDirection middle = directionOf(points, (piece.first + piece.last) / 2, slice);
    segment.start = toCartesian(slice.ranges[first], start, sensor);
    segment.end = toCartesian(slice.ranges[last], end, sensor);
    segment.direction = (segment.start - segment.end).normalized();
    segment.startCovariance = cartesianCovariance(slice.ranges[first], start, sensor, noise);
    segment.endCovariance = cartesianCovariance(slice.ranges[last], end, sensor, noise);
    segment.viewpoint = toCartesian(0.0, middle, sensor);
    segment.startShadowed = isShadowed(points, piece.first, piece.first - 1, perRange, parameters);
    segment.endShadowed = isShadowed(points, piece.last, piece.last + 1, perRange, parameters);
    segment.directionSigma = std::sqrt(points.varianceAcross(piece.first, line.normal()) +
                                       points.varianceAcross(piece.last, line.normal())) /
                             segment.length();
    segment.rms = std::sqrt(line.variance);
    segment.moments = momentsInSpace(points, piece, middle, sensor);
    return segment;
}

}  // namespace

Segments LineSegmentExtractor::extract(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters)
{
    points_.take(slice, sensor, parameters.noise);
    splitAtBreakpoints(points_, slice.bearingStep, parameters.segments, runs_);
    pieces_.clear();
    for (const PointRun& run : runs_)
        splitByEndPointFit(points_, run, parameters.segments, pieces_);
    mergePieces(points_, slice.bearingStep, parameters.segments, pieces_);

    const double perRange = gapPerRange(slice.bearingStep, parameters.segments);
    Segments segments;
    for (const PointRun& piece : pieces_) {
        if (!isAvailable(points_, piece, parameters.segments))
            continue;
        segments.push_back(inSpace(points_, piece, slice, perRange, sensor, parameters));
        segments.back().id = {slice.step, static_cast<int>(segments.size()) - 1};
    }
    return segments;
}

}  // namespace planewright
