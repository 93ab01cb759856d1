// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

#include "core/planes/refit_methods.h"
#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"

namespace planewright {

namespace {

/// What a published segment still says of the points that it was made of.
SegmentStatistics statisticsOf(const LineSegment& segment, const SliceFrame& frame)
{
    SegmentStatistics s;
    s.firstBeam = segment.firstBeam;
    s.lastBeam = segment.lastBeam;
    s.points = segment.points;
    const Eigen::Vector3d centroid = segment.moments.mean - frame.origin;
    s.u = centroid.x();
    s.v = centroid.dot(frame.ahead);
    s.directionU = -segment.direction.x();  // δ points from the end to the start
    s.directionV = -segment.direction.dot(frame.ahead);
    s.start = (segment.moments.mean - segment.start).dot(segment.direction);
    s.end = (segment.moments.mean - segment.end).dot(segment.direction);
    s.spread = segment.direction.dot(segment.moments.scatter * segment.direction) / std::max(1, segment.points);
    s.thickness = segment.rms * segment.rms;
    if (segment.directionSigma > 0.0)
        s.slopeInformation = 1.0 / (segment.directionSigma * segment.directionSigma);
    if (segment.placeSigma > 0.0)
        s.offsetInformation = 1.0 / (segment.placeSigma * segment.placeSigma);
    return s;
}

/// A published segment in the frame of Eq. (6).
LineSegment turnedBack(LineSegment segment, const SensorModel& sensor)
{
    if (sensor.isTurned)
        turn(segment, sensor.attitude.transpose());
    return segment;
}

/// The segments alone, as if nothing else had been seen; `steps` gets the segments' own ids by their number.
TrackMap mapOf(const SegmentSlices& slices, const Refit& refit, std::vector<SegmentId>& ids)
{
    const SensorModel sensor = sensorOf(refit.description);
    TrackMap map;
    for (const SegmentSlice& slice : slices) {
        ScanSlice scan;
        scan.step = slice.step;
        scan.tilt = slice.tilt;
        scan.firstBearing = refit.description.firstBearing;
        scan.bearingStep = refit.description.bearingStep;
        const SliceFrame frame = frameOf(slice.tilt, sensor);
        std::vector<SegmentStatistics> statistics;
        for (const LineSegment& segment : slice.segments) {
            statistics.push_back(statisticsOf(turnedBack(segment, sensor), frame));
            ids.push_back(segment.id);
        }
        map.append(scan, sensor, statistics);
    }
    return map;
}

/// The parameters with the noise that the snapshot was made with.
Parameters parametersOf(const Refit& refit)
{
    Parameters parameters = refit.parameters;
    const SensorNoise& noise = refit.snapshot.noise;
    parameters.noise.rangeConstant = noise.rangeConstant;
    parameters.noise.rangeProportional = noise.rangeProportional;
    parameters.noise.pitch = noise.pitch;
    return parameters;
}

/// Where a plane of all these points is about: the start of its fit.
PlaneEstimate startOf(const SegmentSlices& slices, const SensorModel& sensor)
{
    PointMoments all;
    for (const SegmentSlice& slice : slices) {
        for (const LineSegment& segment : slice.segments)
            all += turnedBack(segment, sensor).moments;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(all.scatter);
    const Eigen::Vector3d normal = axes.eigenvectors().col(0);
    return {normal, normal.dot(all.mean)};
}

std::vector<Plane> publishedPlanes(TrackMap& map, const std::vector<SegmentId>& ids)
{
    std::vector<Plane> planes;
    for (PlaneTrack& track : map.planes()) {
        Plane plane = *publishedPlane(track, map);
        // The map counts the segments that it was given; the snapshot has more in a slice.
        plane.segments.clear();
        for (const SegmentNumber number : track.members)
            plane.segments.push_back(ids[static_cast<std::size_t>(number)]);
        if (plane.normal.allFinite() && plane.covariance.allFinite())
            planes.push_back(std::move(plane));
    }
    return planes;
}

}  // namespace

std::optional<Plane> refitTracks(const SegmentSlices& slices, const Refit& refit)
{
    std::vector<SegmentId> ids;
    TrackMap map = mapOf(slices, refit, ids);
    if (ids.size() < 2)
        return std::nullopt;
    const Parameters parameters = parametersOf(refit);
    std::vector<SegmentNumber> all(ids.size());
    std::iota(all.begin(), all.end(), 0);
    if (map.makePlane(std::move(all), startOf(slices, sensorOf(refit.description)), slices.back().step, parameters) ==
        nullptr)
        return std::nullopt;
    refineTracks(map, parameters);
    std::vector<Plane> planes = publishedPlanes(map, ids);
    if (planes.empty())
        return std::nullopt;
    return std::move(planes.front());
}

std::vector<Plane> searchTracks(const SegmentSlices& slices, const Refit& refit)
{
    std::vector<SegmentId> ids;
    TrackMap map = mapOf(slices, refit, ids);
    if (ids.empty())
        return {};
    const Parameters parameters = parametersOf(refit);
    StepReport report;
    const StepClock noClock;
    StepRecorder recorder(report, noClock, false);
    seedTracks(map, 0, parameters, recorder);
    joinRemaining(map, 0, parameters, recorder);
    mergeTracks(map, parameters, recorder);
    splitTracks(map, parameters, recorder);
    splitContested(map, parameters, recorder);
    thinTracks(map, parameters, recorder);
    seedTracks(map, 0, parameters, recorder);
    joinRemaining(map, 0, parameters, recorder);
    mergeTracks(map, parameters, recorder);
    thinTracks(map, parameters, recorder);
    dropUnfounded(map, parameters, recorder);
    refineTracks(map, parameters);
    return publishedPlanes(map, ids);
}

}  // namespace planewright
