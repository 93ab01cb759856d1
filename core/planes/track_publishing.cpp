// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/track_publishing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/geometry/beam_covariance.h"

namespace planewright {

namespace {

double rmsOf(const PlaneTrack& plane, const TrackMap& map)
{
    double sum = 0.0;
    for (const SegmentNumber number : plane.members) {
        const TrackedSegment& segment = map.segment(number);
        const SegmentStatistics& s = segment.statistics;
        const SliceFrame& frame = map.slice(segment.slice).frame;
        const Eigen::Vector3d& n = plane.estimate.normal();
        const double place = n.dot(frame.pointAt(s.u, s.v)) - plane.estimate.distance();
        const double slope = n.dot(directionOf(number, map));
        const double across = s.directionU * n.dot(frame.ahead) - s.directionV * n.x();
        sum += s.points * (place * place + slope * slope * s.spread + across * across * s.thickness);
    }
    return std::sqrt(sum / static_cast<double>(std::max<std::int64_t>(1, plane.points)));
}

/// Degrees of freedom of its fit: two numbers a segment, less three of the plane.
double freedomOf(const PlaneTrack& plane)
{
    return std::max(1.0, 2.0 * plane.fitted - 3.0);
}

/// The tangents of an estimate as they are at right angles to its normal, which the last step of the fit has turned: by
/// so little that the covariance is the same.
Eigen::Matrix<double, 3, 2> tangentsOf(const PlaneEstimate& estimate)
{
    Eigen::Matrix<double, 3, 2> tangents = estimate.tangents();
    tangents -= estimate.normal() * (estimate.normal().transpose() * tangents);
    tangents.col(0).normalize();
    tangents.col(1) -= tangents.col(0) * tangents.col(0).dot(tangents.col(1));
    tangents.col(1).normalize();
    return tangents;
}

/// Both end points of a segment with their covariances, side by side.
void placeEnds(const SegmentStatistics& s, const SliceFrame& frame, const SensorModel& sensor,
               const NoiseParameters& noise, LineSegment& segment)
{
    const Pair along{s.start, s.end};
    const Pair u = s.u + along * s.directionU;
    const Pair v = s.v + along * s.directionV;
    const Pair squared = u * u + v * v;
    const Pair range{std::sqrt(squared[0]), std::sqrt(squared[1])};
    segment.start = frame.pointAt(u[0], v[0]);
    segment.end = frame.pointAt(u[1], v[1]);
    BeamJacobian<Pair> jacobian;
    takeJacobian<Pair>(range, v / range, u / range, frame.ahead.y(), -frame.ahead.z(), sensor, jacobian);
    const Pair proportional = noise.rangeProportional * range;
    const Pair rangeVariance = noise.rangeConstant * noise.rangeConstant + proportional * proportional;
    Pair covariance[3][3];
    takeCovariance(jacobian, rangeVariance, noise.bearing * noise.bearing, noise.pitch * noise.pitch, covariance);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            segment.startCovariance(row, column) = covariance[row][column][0];
            segment.endCovariance(row, column) = covariance[row][column][1];
        }
    }
}

}  // namespace

double meanErrorOf(const PlaneTrack& plane)
{
    return std::max(0.0, plane.estimate.chi()) / freedomOf(plane);
}

double largestMeanError(const PlaneTrack& plane, const Parameters& parameters)
{
    return parameters.likelihood.largestReducedChi(freedomOf(plane));
}

Segments segmentsOf(int place, const TrackMap& map, const SensorModel& sensor, const NoiseParameters& noise)
{
    const TrackedSlice& slice = map.slice(place);
    Segments segments;
    segments.reserve(static_cast<std::size_t>(slice.end - slice.first));
    for (SegmentNumber number = slice.first; number < slice.end; ++number) {
        const SegmentStatistics& s = map.segment(number).statistics;
        LineSegment& segment = segments.emplace_back();
        segment.id = {slice.step, number - slice.first};
        segment.firstBeam = s.firstBeam;
        segment.lastBeam = s.lastBeam;
        segment.points = s.points;
        placeEnds(s, slice.frame, sensor, noise, segment);
        const Eigen::Vector3d along = slice.frame.directionAt(s.directionU, s.directionV);
        segment.direction = -along;
        segment.viewpoint = slice.frame.origin;
        segment.directionSigma = s.slopeInformation > 0.0 ? 1.0 / std::sqrt(s.slopeInformation) : std::numbers::pi;
        segment.placeSigma = s.offsetInformation > 0.0 ? 1.0 / std::sqrt(s.offsetInformation) : 0.0;
        segment.rms = std::sqrt(s.thickness);
        segment.moments.count = s.points;
        segment.moments.mean = slice.frame.pointAt(s.u, s.v);
        // Number by number: products of such short vectors wait for what was stored just before.
        const double ofLength = s.points * s.spread;
        const double ofThickness = s.points * s.thickness;
        const Eigen::Vector3d across = slice.frame.directionAt(-s.directionV, s.directionU);
        for (Eigen::Index row = 0; row < 3; ++row) {
            for (Eigen::Index column = 0; column < 3; ++column)
                segment.moments.scatter(row, column) =
                    ofLength * along[row] * along[column] + ofThickness * across[row] * across[column];
        }
        if (sensor.isTurned)
            turn(segment, sensor.attitude);
    }
    return segments;
}

std::shared_ptr<const Plane> publishedPlane(PlaneTrack& plane, const TrackMap& map)
{
    if (plane.published)
        return plane.published;
    auto shown = std::make_shared<Plane>();
    shown->id = plane.id;
    shown->revision = plane.revision;
    shown->normal = map.turned(plane.estimate.normal());
    shown->distance = plane.estimate.distance();
    shown->fittingError = meanErrorOf(plane);
    shown->rms = rmsOf(plane, map);
    makeCanonical(shown->normal, shown->distance);
    shown->tangents = tangentsOf(plane.estimate);
    for (auto tangent : shown->tangents.colwise())
        tangent = map.turned(tangent);
    // Where the segments scatter more than their noise tells, so does the plane.
    shown->covariance = std::max(1.0, shown->fittingError) * plane.estimate.covariance();
    shown->segments.reserve(plane.members.size());
    for (const SegmentNumber number : plane.members)
        shown->segments.push_back(idOf(number, map));
    shown->points = static_cast<int>(plane.points);
    shown->bornStep = plane.bornStep;
    shown->changedStep = plane.changedStep;
    shown->lineage = plane.lineage;
    plane.published = std::move(shown);
    return plane.published;
}

std::shared_ptr<const DirectionCluster> publishedCluster(GrowingCluster& cluster, const TrackMap& map)
{
    if (!cluster.published) {
        auto shown = std::make_shared<DirectionCluster>();
        shown->id = cluster.id;
        shown->direction = map.turned(cluster.direction);
        shown->segments.reserve(cluster.members.size());
        for (const auto& member : cluster.members)
            shown->segments.push_back(idOf(member.segment, map));
        cluster.published = std::move(shown);
    }
    return cluster.published;
}

}  // namespace planewright
