// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/mapping/map_results.h"
#include "core/geometry/tangents.h"

namespace planewright {

/// A wall, floor or ceiling as one who stands at `stop` sees it: a rectangle about a middle, 2 × 2 m, whose normal
/// points away from the scanner. Angles and distance have a standard deviation of 1 mrad and 1 mm.
inline PlaneResult seenWall(PlaneId id, const Eigen::Vector3d& normal, const Eigen::Vector3d& middle,
                            const std::string& className, const Eigen::Vector3d& stop)
{
    auto plane = std::make_shared<Plane>();
    plane->id = id;
    plane->normal = normal;
    plane->distance = normal.dot(middle - stop);
    plane->tangents = tangentsOf(normal);
    plane->covariance = 1e-6 * Eigen::Matrix3d::Identity();
    plane->points = 100;
    const Eigen::Vector3d a = plane->tangents.col(0);
    const Eigen::Vector3d b = plane->tangents.col(1);
    const Eigen::Vector3d seen = middle - stop;
    Outline::Polygon part{{seen + a + b, seen - a + b, seen - a - b, seen + a - b}, {}};
    PlaneResult result;
    result.outline = outlineOf({part}, normal, plane->distance);
    result.className = className;
    result.plane = std::move(plane);
    return result;
}

/// A stop in a bare room of 6 × 8 × 3 m whose middle is the origin: four walls (0 right, 1 ahead, 2 left, 3 behind),
/// floor 4 and ceiling 5. All stops look along y.
inline StopScan stopInRoom(int scan, const Eigen::Vector3d& place)
{
    StopScan stop;
    stop.path = "room.pwscan";
    stop.scan = scan;
    stop.name = "room.pwscan, scan " + std::to_string(scan);
    stop.odometry = Pose{Eigen::Quaterniond::Identity(), place};
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    stop.planes = {seenWall(0, x, 3.0 * x, "wall", place),    seenWall(1, y, 4.0 * y, "wall", place),
                   seenWall(2, -x, -3.0 * x, "wall", place),  seenWall(3, -y, -4.0 * y, "wall", place),
                   seenWall(4, -z, -1.5 * z, "floor", place), seenWall(5, z, 1.5 * z, "ceiling", place)};
    return stop;
}

}  // namespace planewright
