// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/params/parameters.h"
#include "core/types/plane.h"
#include "core/types/segment_log.h"
#include "tests/core/pipeline/leaning_runs_twin.h"

namespace planewright {

/// Smallest distance between two segments: it is convex along the first, where it is looked for.
inline double distanceOf(const LineSegment& a, const LineSegment& b)
{
    const auto fromB = [&](double t) {
        const Eigen::Vector3d point = (1.0 - t) * a.start + t * a.end;
        const Eigen::Vector3d along = b.end - b.start;
        const double part = std::clamp(along.dot(point - b.start) / along.squaredNorm(), 0.0, 1.0);
        return (point - b.start - part * along).norm();
    };
    double low = 0.0;
    double high = 1.0;
    for (int round = 0; round < 100; ++round) {
        const double left = low + (high - low) / 3.0;
        const double right = high - (high - low) / 3.0;
        (fromB(left) < fromB(right) ? high : low) = fromB(left) < fromB(right) ? right : left;
    }
    return fromB(0.5 * (low + high));
}

inline bool faces(const LineSegment& a, const LineSegment& b)
{
    if (std::abs(a.id.step - b.id.step) > 5)
        return false;
    if (a.firstBeam > b.firstBeam)
        return faces(b, a);
    return b.firstBeam <= a.lastBeam || (a.endShadowed && b.startShadowed);
}

/// Gap of two planes: none where segments face each other; where boxes along the axes are farther apart than asked for,
/// that of the boxes, which it is at least; otherwise that of the nearest two segments.
inline double gapOf(const std::vector<SegmentId>& a, const std::vector<SegmentId>& b, const SegmentLog& log,
                    double enough)
{
    for (const SegmentId& i : a) {
        for (const SegmentId& j : b) {
            if (faces(log[i], log[j]))
                return 0.0;
        }
    }
    const auto boxOf = [&](const std::vector<SegmentId>& ids) {
        Eigen::AlignedBox3d box;
        for (const SegmentId& id : ids)
            box.extend(log[id].start).extend(log[id].end);
        return box;
    };
    const double apart = boxOf(a).exteriorDistance(boxOf(b));
    if (apart > enough)
        return apart;
    double least = std::numeric_limits<double>::infinity();
    for (const SegmentId& i : a) {
        for (const SegmentId& j : b)
            least = std::min(least, distanceOf(log[i], log[j]));
    }
    return least;
}

/// The plane of two and the larger of their errors against it: each end weighs by its variance across its own plane.
struct TogetherTwin {
    FittedPlane plane;
    double error = 0.0;

    TogetherTwin(const Plane& a, const Plane& b, const SegmentLog& log, const PlaneParameters& p)
    {
        std::vector<std::pair<Eigen::Vector3d, double>> all;
        std::array<std::vector<std::pair<Eigen::Vector3d, double>>, 2> own;
        for (const Plane* of : {&a, &b}) {
            for (const SegmentId& id : of->segments) {
                const LineSegment& s = log[id];
                const auto weigh = [&](const Eigen::Matrix3d& covariance) {
                    return 1.0 / (of->normal.dot(covariance * of->normal) + p.flatness * p.flatness + 1e-12);
                };
                own[of == &a ? 0 : 1].emplace_back(s.start, weigh(s.startCovariance));
                own[of == &a ? 0 : 1].emplace_back(s.end, weigh(s.endCovariance));
            }
        }
        for (const auto& points : own)
            all.insert(all.end(), points.begin(), points.end());
        plane.fit(all);
        for (const auto& points : own) {
            double sum = 0.0;
            for (const auto& [point, weight] : points)
                sum += weight * std::pow(plane.normal.dot(point) - plane.distance, 2);
            error = std::max(error, sum / static_cast<double>(points.size()));
        }
    }
};

}  // namespace planewright
