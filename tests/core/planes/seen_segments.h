// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/planes/plane_map.h"
#include "core/simulation/random.h"
#include "tests/core/planes/recorded_decisions.h"

namespace planewright {

/// How a segment was seen, apart from where it lies. By the beams all segments face each other in neighbouring slices.
struct Look {
    int firstBeam = 100;
    int lastBeam = 129;
    int points = 30;
    double sigma = 0.01;                                  ///< of its end points, the same in all directions [m]
    Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();  ///< [m]
};

/// A segment through points, which are in bearing order; its moments are summed up about the mean of all.
inline LineSegment segmentThrough(int step, const std::vector<Eigen::Vector3d>& points, const Look& look = {})
{
    LineSegment segment;
    segment.id.step = step;
    segment.firstBeam = look.firstBeam;
    segment.lastBeam = look.lastBeam;
    segment.points = static_cast<int>(points.size());
    segment.start = points.front();
    segment.end = points.back();
    segment.direction = (segment.start - segment.end).normalized();
    segment.startCovariance = look.sigma * look.sigma * Eigen::Matrix3d::Identity();
    segment.endCovariance = segment.startCovariance;
    segment.viewpoint = look.viewpoint;
    segment.moments.count = static_cast<double>(points.size());
    for (const Eigen::Vector3d& point : points)
        segment.moments.mean += point / segment.moments.count;
    for (const Eigen::Vector3d& point : points)
        segment.moments.scatter += (point - segment.moments.mean) * (point - segment.moments.mean).transpose();
    return segment;
}

/// A segment of equally spaced points between two ends.
inline LineSegment segmentBetween(int step, const Eigen::Vector3d& start, const Eigen::Vector3d& end,
                                  const Look& look = {})
{
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < look.points; ++i)
        points.emplace_back(start + (end - start) * (static_cast<double>(i) / static_cast<double>(look.points - 1)));
    return segmentThrough(step, points, look);
}

/// Parallel segments in slices one after another: a sheet from a corner, along each segment, and up from one to the
/// next.
struct Sheet {
    Eigen::Vector3d corner = Eigen::Vector3d(-1.0, 4.0, 0.0);
    Eigen::Vector3d along = Eigen::Vector3d(2.0, 0.0, 0.0);
    Eigen::Vector3d up = Eigen::Vector3d(0.0, 0.0, 0.1);
    int rows = 6;
    int firstStep = 0;

    LineSegment row(int i, const Look& look = {}) const
    {
        const Eigen::Vector3d start = corner + static_cast<double>(i) * up;
        return segmentBetween(firstStep + i, start, start + along, look);
    }
    Segments segments(const Look& look = {}) const
    {
        Segments all;
        for (int i = 0; i < rows; ++i)
            all.push_back(row(i, look));
        return all;
    }
};

/// A wall 4 m ahead, drawn over x and the height z; `shift` moves it away along its normal +y.
inline Sheet wall(int rows, double shift = 0.0, int firstStep = 0)
{
    return {Eigen::Vector3d(-1.0, 4.0 + shift, 0.1 * firstStep), {2.0, 0.0, 0.0}, {0.0, 0.0, 0.1}, rows, firstStep};
}

inline Segments operator+(Segments a, const Segments& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Puts segments of any slices after the last into a table, and gives their running numbers in the order given.
inline std::vector<SegmentNumber> append(SegmentTable& table, const Segments& segments)
{
    std::map<int, Segments> slices;
    std::vector<std::pair<int, int>> places;
    for (LineSegment segment : segments) {
        Segments& slice = slices[segment.id.step];
        segment.id.index = static_cast<int>(slice.size());
        places.emplace_back(segment.id.step, segment.id.index);
        slice.push_back(segment);
    }
    std::map<int, SegmentNumber> first;
    for (auto& [step, slice] : slices)
        first[step] = table.append(step, std::move(slice));
    std::vector<SegmentNumber> numbers;
    for (const auto& [step, index] : places)
        numbers.push_back(first[step] + index);
    return numbers;
}

/// Makes a plane of segments: by least squares, then refined.
inline GrowingPlane& makePlane(PlaneMap& map, std::vector<SegmentNumber> members, const PlaneParameters& parameters)
{
    std::sort(members.begin(), members.end());
    const std::vector<EndPoint> points = endPointsOf(members, map.segments);
    WeightedSums sums;
    for (const EndPoint& point : points)
        sums.add(point.position, 1.0);
    const PlaneFit fit = refinePlane(fitPlane(sums, Eigen::Vector3d::UnitY()), points, parameters);
    return map.makePlane(fit, members, parameters);
}

/// Makes one plane of each group of segments, which may be of the same slices.
inline void makePlanes(PlaneMap& map, const std::vector<Segments>& groups, const PlaneParameters& parameters)
{
    Segments all;
    for (const Segments& group : groups)
        all = all + group;
    const std::vector<SegmentNumber> numbers = append(map.segments, all);
    auto first = numbers.begin();
    for (const Segments& group : groups) {
        const auto last = first + static_cast<std::ptrdiff_t>(group.size());
        makePlane(map, std::vector<SegmentNumber>(first, last), parameters);
        first = last;
    }
}

/// Parameters that let all pass; a test tightens the one that it is about.
inline Parameters lenient()
{
    Parameters parameters;
    AssignmentParameters& assignment = parameters.assignment;
    assignment.planeDistance = 0.03;
    assignment.planeDistanceSigmas = 0.0;
    assignment.orthogonality = degrees(5.0);
    assignment.orthogonalitySigmas = 0.0;
    assignment.refitEvery = 10000;
    parameters.clusters.directionLimit = degrees(10.0);
    PlaneParameters& planes = parameters.planes;
    planes.flatness = 0.005;
    planes.minClusterSegments = 3;
    planes.minClusterSlices = 2;
    planes.baselineSigmas = 1.0;
    planes.inlierDistance = 0.03;
    planes.inlierSigmas = 0.0;
    planes.errorLimit = 4.0;
    planes.refineTolerance = 1e-12;
    planes.refineIterations = 50;
    planes.minSegments = 3;
    planes.minSlices = 2;
    planes.minPoints = 4;
    planes.minExtent = 0.0;
    planes.minExtentAngle = 0.0;
    planes.maxNormalSigma = degrees(45.0);
    planes.minIncidence = 0.0;
    planes.mergeAngle = degrees(5.0);
    planes.mergeDistance = 0.025;
    planes.mergeSigmas = 0.0;
    planes.mergeGap = 0.5;
    planes.mergeShare = 0.75;
    return parameters;
}

/// Clusters segments as a step does with those that no plane took.
inline void cluster(const std::vector<SegmentNumber>& segments, PlaneMap& map, const Parameters& parameters)
{
    Recorded recorded;
    addToClusters(segments, map, parameters.clusters, recorded.recorder);
}

inline std::vector<SegmentNumber> clusteredSegments(const PlaneMap& map)
{
    std::vector<SegmentNumber> all;
    for (const GrowingCluster& cluster : map.clusters.all()) {
        for (const auto& member : cluster.members)
            all.push_back(member.segment);
    }
    std::sort(all.begin(), all.end());
    return all;
}

inline std::vector<PlaneId> planeIds(const PlaneMap& map)
{
    std::vector<PlaneId> ids;
    for (const GrowingPlane& plane : map.planes)
        ids.push_back(plane.id());
    return ids;
}

/// The angle between two vectors, exact down to nothing.
inline double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

inline Eigen::Vector3d anyVector(Random& random)
{
    const Random::Pair pair = random.normalPair();
    return {pair.first, pair.second, random.normalPair().first};
}

inline Eigen::Vector3d anyNormal(Random& random)
{
    return anyVector(random).normalized();
}

/// A covariance of any shape whose standard deviations are about `scale` [m].
inline Eigen::Matrix3d anyCovariance(Random& random, double scale)
{
    Eigen::Matrix3d root;
    root << anyVector(random), anyVector(random), anyVector(random);
    return scale * scale * root * root.transpose();
}

}  // namespace planewright
