// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/extract_line_segments.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/segments/breakpoints.h"
#include "core/segments/end_point_fit.h"
#include "core/segments/merge_pieces.h"

namespace planewright {

namespace {

/// Echoes that a run must have.
constexpr int kFewestOfRun = 2;

/// Eq. (5), turned round: long enough and of enough points.
struct Availability {
    Test points;
    Test length;

    bool pass() const { return points.pass() && length.pass(); }
};
Availability availabilityOf(const SlicePoints& points, const PointRun& piece, const SegmentParameters& parameters)
{
    return {
        {"points", static_cast<double>(points.echoesIn(piece)), Comparison::GreaterEqual,
         static_cast<double>(parameters.minPoints)},
        {"length", (points[piece.first] - points[piece.last]).norm(), Comparison::GreaterEqual, parameters.minLength}};
}

TracedPiece traced(const PointRun& piece, const Availability& available, int segment)
{
    TracedPiece told;
    told.firstBeam = piece.first;
    told.lastBeam = piece.last;
    told.points = static_cast<int>(available.points.value);
    told.tests = {available.points, available.length};
    if (available.pass())
        told.segment = segment;
    else
        told.fate = available.points.pass() ? PieceFate::TooShort : PieceFate::TooFewPoints;
    return told;
}

/// Moments in space of the points of a piece, all taken at the tilt of its middle.
PointMoments momentsInSpace(const SlicePoints& points, const PointRun& piece, const BeamDirection& middle,
                            const SensorModel& sensor)
{
    const SliceMoments flat = points.momentsOf(piece);
    Eigen::Matrix<double, 3, 2> axes;
    axes.col(0) = Eigen::Vector3d::UnitX();
    axes.col(1) = Eigen::Vector3d{0.0, middle.sinTilt, -middle.cosTilt};
    if (sensor.isTurned)
        axes = (sensor.attitude * axes).eval();
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

/// Echoes in no run of runs_ are alone between two breakpoints.
void LineSegmentExtractor::traceRuns(const ScanSlice& slice, const Parameters& parameters, SliceTrace& trace,
                                     std::vector<TracedPiece>& dropped)
{
    echoes_.clear();
    for (int beam = 0; beam < points_.beams(); ++beam) {
        if (points_.hasEcho(beam))
            echoes_.push_back(beam);
    }
    auto run = runs_.begin();
    int before = -1;
    for (const int beam : echoes_) {
        while (run != runs_.end() && run->last < beam)
            ++run;
        const bool isInRun = run != runs_.end() && run->first <= beam;
        if (isInRun && run->first < beam) {
            before = beam;
            continue;
        }
        if (before >= 0)
            trace.breaks.push_back(
                {before, beam, (points_[beam] - points_[before]).norm(),
                 breakpointDistance(points_.range(before), slice.bearingStep, parameters.segments, parameters.noise),
                 beam - before > 1});
        trace.runs.push_back({beam, isInRun ? run->last : beam, isInRun ? run->points() : 1});
        if (!isInRun)
            dropped.push_back(tooFew(beam, beam, 1, {"points_of_run", 0.0, Comparison::GreaterEqual, kFewestOfRun}));
        before = beam;
    }
}

Segments LineSegmentExtractor::extract(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters,
                                       SliceTrace* trace)
{
    std::vector<TracedPiece> dropped;

    points_.take(slice, sensor, parameters.noise);
    splitAtBreakpoints(points_, slice.bearingStep, parameters.segments, runs_);
    if (trace != nullptr)
        traceRuns(slice, parameters, *trace, dropped);
    pieces_.clear();
    for (const PointRun& run : runs_)
        splitByEndPointFit(points_, run, parameters.segments, pieces_, trace, trace != nullptr ? &dropped : nullptr);
    mergePieces(points_, slice.bearingStep, parameters.segments, pieces_, trace);

    const double perRange = gapPerRange(slice.bearingStep, parameters.segments);
    Segments segments;
    for (const PointRun& piece : pieces_) {
        const Availability available = availabilityOf(points_, piece, parameters.segments);
        if (trace != nullptr)
            trace->pieces.push_back(traced(piece, available, static_cast<int>(segments.size())));
        if (!available.pass())
            continue;
        segments.push_back(inSpace(points_, piece, slice, perRange, sensor, parameters));
        segments.back().id = {slice.step, static_cast<int>(segments.size()) - 1};
    }
    if (trace != nullptr)
        addLeftovers(std::move(dropped), echoes_, *trace);
    return segments;
}

}  // namespace planewright
