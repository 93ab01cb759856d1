// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/wall_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/types/angle.h"

namespace planewright {

std::optional<WallLine> wallLine(const FacedPlane& plane)
{
    if (std::abs(plane.normal.z()) > std::sin(degrees(10.0)) || plane.parts.empty())
        return std::nullopt;
    WallLine wall;
    const double level = plane.normal.head<2>().norm();
    wall.normal = plane.normal.head<2>() / level;
    const auto [lowest, highest] =
        std::ranges::minmax(plane.parts.front().ring, {}, [](const Eigen::Vector3d& p) { return p.z(); });
    wall.distance = (plane.distance - plane.normal.z() * 0.5 * (lowest.z() + highest.z())) / level;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const Outline::Polygon& part : plane.parts) {
        for (const Eigen::Vector3d& corner : part.ring) {
            least = std::min(least, wall.along().dot(corner.head<2>()));
            most = std::max(most, wall.along().dot(corner.head<2>()));
        }
    }
    wall.from = wall.distance * wall.normal + least * wall.along();
    wall.to = wall.distance * wall.normal + most * wall.along();
    return wall;
}

double overlapOf(const WallLine& wall, const WallLine& other)
{
    const Eigen::Vector2d along = other.along();
    const auto [from, to] = std::minmax({along.dot(wall.from), along.dot(wall.to)});
    const auto [otherFrom, otherTo] = std::minmax({along.dot(other.from), along.dot(other.to)});
    return std::min(to, otherTo) - std::max(from, otherFrom);
}

}  // namespace planewright
