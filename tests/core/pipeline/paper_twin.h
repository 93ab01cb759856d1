// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

#include "core/params/parameters.h"
#include "core/types/snapshot.h"

namespace planewright {

inline double distanceOf(const Eigen::Vector3d& point, const Plane& plane)
{
    return std::abs(plane.normal.dot(point) - plane.distance);
}

/// D_ij and |n·δ| of Eq. (8), with their limits.
struct Match {
    double distance = 0.0;
    double distanceLimit = 0.0;
    double orthogonality = 0.0;
    double orthogonalityLimit = 0.0;

    Match(const LineSegment& s, const Plane& plane, const AssignmentParameters& p)
    {
        const double start = distanceOf(s.start, plane);
        const double end = distanceOf(s.end, plane);
        distance = std::max(start, end);
        const Eigen::Vector3d& n = plane.normal;
        const double variance =
            start > end ? n.transpose() * s.startCovariance * n : n.transpose() * s.endCovariance * n;
        distanceLimit = std::max(p.planeDistance, p.planeDistanceSigmas * std::sqrt(variance));
        orthogonality = std::abs(n.dot((s.start - s.end) / (s.start - s.end).norm()));
        orthogonalityLimit = std::max(std::sin(p.orthogonality), p.orthogonalitySigmas * s.directionSigma);
    }

    bool isSame(double told) const { return std::abs(told - distance) < 1e-9; }
};

inline double largestAngleVariance(const Plane& plane)
{
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(plane.covariance.topLeftCorner<2, 2>()).eigenvalues()[1];
}

/// Eq. (22): of all end points the distance that exceeds its limit most, and this limit.
inline std::pair<double, double> pairDistance(const Plane& a, const Plane& b, const Snapshot& snapshot,
                                              const Parameters& p)
{
    std::pair<double, double> worst{-1.0, 1.0};
    for (const auto& [from, to] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
        for (const SegmentId& id : from->segments) {
            const LineSegment& s = snapshot.segments[id];
            for (const auto& [point, covariance] :
                 {std::pair{s.start, s.startCovariance}, std::pair{s.end, s.endCovariance}}) {
                Eigen::Vector3d lever;
                lever << to->tangents.transpose() * point, -1.0;
                const double ofPlane = std::sqrt(lever.dot(to->covariance * lever));
                const double ofPoint = std::sqrt(to->normal.dot(covariance * to->normal));
                const double limit = std::max(p.assignment.planeDistance, p.assignment.planeDistanceSigmas * ofPoint) +
                                     std::max(p.planes.mergeDistance, p.planes.mergeSigmas * ofPlane);
                const double distance = distanceOf(point, *to);
                if (distance / limit > worst.first / worst.second)
                    worst = {distance, limit};
            }
        }
    }
    return worst;
}

}  // namespace planewright
