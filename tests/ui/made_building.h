// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/geometry/tangents.h"
#include "ui/common/shown_map.h"

namespace planewright {

/// A square wall, floor or ceiling of 4 m about a middle, as the window shows it.
inline ShownPlane madeMapPlane(PlaneId id, const Eigen::Vector3d& normal, const Eigen::Vector3d& middle,
                               const std::string& className)
{
    auto plane = std::make_shared<Plane>();
    plane->id = id;
    plane->normal = normal;
    plane->distance = normal.dot(middle);
    plane->tangents = tangentsOf(normal);
    const Eigen::Vector3d a = 2.0 * plane->tangents.col(0);
    const Eigen::Vector3d b = 2.0 * plane->tangents.col(1);
    Outline::Polygon part{{middle + a + b, middle - a + b, middle - a - b, middle + a - b}, {}};
    auto filled = std::make_shared<FilledOutline>();
    filled->outline = outlineOf({part}, normal, plane->distance);
    filled->triangles = triangulate(filled->outline, normal);
    return {std::move(plane), {}, className, false, false, std::move(filled)};
}

/// Two stops on floor 0 and one on floor 1, another one taken out: four planes, of which stop 1 saw the second again
/// and leaves one open.
inline std::shared_ptr<const ShownMap> madeBuilding()
{
    auto map = std::make_shared<ShownMap>();
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    map->planes = {madeMapPlane(0, z, -1.0 * z, "floor"), madeMapPlane(1, x, 2.0 * x, "wall"),
                   madeMapPlane(2, -x, -2.0 * x, "wall"), madeMapPlane(3, z, 2.0 * z, "floor")};
    map->finished = true;
    auto building = std::make_shared<ShownBuilding>();
    building->planes = {
        {0, 0, 0.5e-3, {{1, 4}, {2, 0}}}, {0, 0, 1e-3, {{1, 5}}}, {0, 1, 3e-3, {{2, 1}}}, {1, 2, 30e-3, {{4, 0}}}};
    const auto stopAt = [](int number, int scan, int floor, const Eigen::Vector3d& place, const std::string& trust) {
        ShownStop stop;
        stop.number = number;
        stop.scan = scan;
        stop.name = "house.pwscan, scan " + std::to_string(scan);
        stop.floor = floor;
        stop.isPlaced = true;
        stop.pose.translation = place;
        stop.raw = Pose{Eigen::Quaterniond::Identity(), place + Eigen::Vector3d(0.1 * number, 0.0, 0.0)};
        stop.sigmaShift = 2e-3 * number;
        stop.trust = trust;
        return stop;
    };
    building->stops = {stopAt(0, 1, 0, {0.0, 0.0, 0.0}, "first"), stopAt(1, 2, 0, {0.0, 1.5, 0.0}, "odometry decides"),
                       stopAt(2, 4, 1, {0.0, 0.0, 3.0}, "first")};
    building->stops[0].fresh = 2;
    building->stops[1].matched = 1;
    building->stops[1].fresh = 1;
    building->stops[1].open = 1;
    building->stops[1].warning = "its planes would fit 1 other place as well; odometry alone tells which";
    building->stops[2].fresh = 1;
    ShownStop& omitted = building->stops.emplace_back();
    omitted.scan = 3;
    omitted.name = "house.pwscan, scan 3";
    building->matches = {{0, {1, 4}, "floor", 16.0, MatchState::New, 0, {}, 0.0, false},
                         {0, {1, 5}, "wall", 16.0, MatchState::New, 1, {}, 0.0, false},
                         {1, {2, 0}, "floor", 12.5, MatchState::Matched, 0, {}, 2.25, true},
                         {1, {2, 1}, "wall", 8.0, MatchState::New, 2, {}, 0.0, false},
                         {1, {2, 7}, "wall", 1.0, MatchState::Open, kNoPlane, {1, 2}, 0.0, false},
                         {2, {4, 0}, "floor", 16.0, MatchState::New, 3, {}, 0.0, false}};
    building->floors = {0, 1};
    building->allStops = 3;
    map->building = std::move(building);
    return map;
}

}  // namespace planewright
