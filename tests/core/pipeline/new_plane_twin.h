// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

#include "core/params/parameters.h"
#include "core/types/snapshot.h"
#include "tests/core/pipeline/paper_twin.h"
#include "tests/core/pipeline/told_step.h"

namespace planewright {

/// How many slices segments are of.
inline std::size_t slicesOf(const std::vector<SegmentId>& segments)
{
    std::set<int> steps;
    for (const SegmentId& segment : segments)
        steps.insert(segment.step);
    return steps.size();
}

/// A plane's numbers at its making, from its segments.
struct Shape {
    double points = 0.0;
    double extent = 0.0;     ///< the shorter one along the principal axes
    double range = 0.0;      ///< mean
    double incidence = 0.0;  ///< mean sine
    double error = 0.0;      ///< mean squared Mahalanobis distance of the end points

    Shape(const Plane& plane, const Snapshot& snapshot, const PlaneParameters& p)
    {
        const Eigen::Vector3d& n = plane.normal;
        std::vector<Eigen::Vector3d> ends;
        for (const SegmentId& id : plane.segments) {
            const LineSegment& s = snapshot.segments[id];
            points += s.points;
            const Eigen::Vector3d ray = 0.5 * (s.start + s.end) - s.viewpoint;
            range += ray.norm();
            incidence += std::abs(n.dot(ray.normalized()));
            for (const auto& [end, covariance] :
                 {std::pair{s.start, s.startCovariance}, std::pair{s.end, s.endCovariance}}) {
                ends.push_back(end);
                const double variance = n.dot(covariance * n) + p.flatness * p.flatness + 1e-12;
                error += std::pow(n.dot(end) - plane.distance, 2) / variance;
            }
        }
        const auto count = static_cast<double>(plane.segments.size());
        range /= count;
        incidence /= count;
        error /= 2.0 * count;
        extent = shorterSide(ends, n);
    }

    static double shorterSide(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& normal)
    {
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& point : points)
            mean += point / static_cast<double>(points.size());
        // Scatter within the plane: along the normal it is 0, the shorter axis has the middle eigenvalue.
        Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
        const Eigen::Matrix3d flat = Eigen::Matrix3d::Identity() - normal * normal.transpose();
        for (const Eigen::Vector3d& point : points)
            scatter += flat * (point - mean) * (point - mean).transpose() * flat;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
        const Eigen::Vector3d axis = axes.eigenvectors().col(1);
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const Eigen::Vector3d& point : points) {
            low = std::min(low, axis.dot(point));
            high = std::max(high, axis.dot(point));
        }
        return high - low;
    }
};

/// Segments beside a plane that it might have had, which face one of its own and stand a little off it: farther than
/// its own may, by no more than four times as much.
inline int contradictionsOf(const Plane& plane, const std::vector<SegmentId>& candidates, const SegmentLog& log,
                            const PlaneParameters& p)
{
    const auto shareOf = [&](const Eigen::Vector3d& point, const Eigen::Matrix3d& covariance) {
        const double sigma = std::sqrt(plane.normal.dot(covariance * plane.normal));
        return distanceOf(point, plane) / std::max(p.inlierDistance, p.inlierSigmas * sigma);
    };
    return static_cast<int>(std::count_if(candidates.begin(), candidates.end(), [&](const SegmentId& id) {
        const LineSegment& s = log[id];
        const double farther = std::max(shareOf(s.start, s.startCovariance), shareOf(s.end, s.endCovariance));
        if (holds(plane.segments, id) || farther < 1.0 || farther >= 4.0)
            return false;
        return std::any_of(plane.segments.begin(), plane.segments.end(), [&](const SegmentId& own) {
            return std::abs(own.step - id.step) <= 5 && log[own].firstBeam <= s.lastBeam &&
                   s.firstBeam <= log[own].lastBeam;
        });
    }));
}

}  // namespace planewright
