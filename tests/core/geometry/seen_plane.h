// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geometry/outline.h"

namespace planewright {

/// A plane and the segments in which it was seen, drawn in the plane's own x and y. The pose puts its z = 0 anywhere.
struct SeenPlane {
    /// Ends of a segment on the plane: x, y of the start and of the end [m].
    struct Ends {
        double startX;
        double startY;
        double endX;
        double endY;
    };

    explicit SeenPlane(Eigen::Isometry3d atPose = Eigen::Isometry3d::Identity()) : pose(std::move(atPose))
    {
        plane.normal = pose.linear().col(2);
        plane.distance = plane.normal.dot(pose.translation());
    }

    /// Adds a slice with segments on the plane.
    void slice(int step, const std::vector<Ends>& stretches)
    {
        auto segments = std::make_shared<Segments>();
        for (const Ends& ends : stretches) {
            LineSegment segment;
            segment.id = {step, static_cast<int>(segments->size())};
            segment.start = pose * Eigen::Vector3d(ends.startX, ends.startY, 0.0);
            segment.end = pose * Eigen::Vector3d(ends.endX, ends.endY, 0.0);
            plane.segments.push_back(segment.id);
            segments->push_back(segment);
        }
        log.append(step, std::move(segments));
    }

    /// Adds a slice of level segments: pairs of x at a height y.
    void row(int step, double y, const std::vector<std::pair<double, double>>& stretches)
    {
        std::vector<Ends> ends;
        ends.reserve(stretches.size());
        for (const auto& [from, to] : stretches)
            ends.push_back({from, y, to, y});
        slice(step, ends);
    }

    Outline outline() const { return outlineOf(plane, log); }

    Eigen::Isometry3d pose;
    Plane plane;
    SegmentLog log;
};

/// The pose of an upright wall that faces the sensor 4 m ahead: x to the right, y up, normal ahead (d > 0).
inline Eigen::Isometry3d wallAhead()
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() << -1.0, 0.0, 0.0,  //
        0.0, 0.0, 1.0,                //
        0.0, 1.0, 0.0;
    pose.translation() = Eigen::Vector3d(0.0, 4.0, 0.0);
    return pose;
}

/// Signed area of a ring seen from +n [m²].
inline double areaSeenFrom(const Eigen::Vector3d& normal, const std::vector<Eigen::Vector3d>& ring)
{
    Eigen::Vector3d doubled = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < ring.size(); ++i)
        doubled += (ring[i] - ring[0]).cross(ring[(i + 1) % ring.size()] - ring[0]);
    return 0.5 * normal.dot(doubled);
}

/// What rounding to micrometres may change on lengths and areas of a few metres.
inline constexpr double kGrid = 1e-4;

inline bool isClose(double a, double b, double tolerance = kGrid)
{
    return std::abs(a - b) <= tolerance;
}

/// A wall 3 m × 2 m in 21 rows with a window 1 m × 0.8 m: rows 6 to 14 are interrupted from x = 1 to 2.
inline SeenPlane wallWithWindow(const Eigen::Isometry3d& pose)
{
    SeenPlane wall(pose);
    for (int k = 0; k <= 20; ++k) {
        if (k >= 6 && k <= 14)
            wall.row(k, 0.1 * k, {{0.0, 1.0}, {2.0, 3.0}});
        else
            wall.row(k, 0.1 * k, {{0.0, 3.0}});
    }
    return wall;
}

}  // namespace planewright
