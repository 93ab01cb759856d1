// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/minimum_rectangle.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace planewright {
namespace {

/// Appends the points' lower chain from left to right, or the upper one when walked from right to left.
template <class Iterator>
void appendChain(Iterator first, Iterator last, PlanarRing& hull)
{
    const std::size_t base = hull.size();
    for (; first != last; ++first) {
        while (hull.size() >= base + 2 && cross(hull.back() - hull[hull.size() - 2], *first - hull.back()) <= 0.0)
            hull.pop_back();
        hull.push_back(*first);
    }
    hull.pop_back();  // the other chain begins with it
}

}  // namespace

PlanarRing convexHull(PlanarRing points)
{
    std::ranges::sort(points, [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3)
        return points;
    PlanarRing hull;
    appendChain(points.begin(), points.end(), hull);
    appendChain(points.rbegin(), points.rend(), hull);
    return hull;
}

RectangleSides minimumRectangle(const PlanarRing& hull)
{
    if (hull.size() < 2)
        return {};
    const std::size_t n = hull.size();
    const auto corner = [&](std::size_t i) -> const Eigen::Vector2d& { return hull[i % n]; };

    RectangleSides best;
    double bestArea = std::numeric_limits<double>::infinity();
    std::size_t right = 1;
    std::size_t top = 1;
    std::size_t left = 1;
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector2d side = (corner(i + 1) - corner(i)).normalized();
        const Eigen::Vector2d inward{-side.y(), side.x()};
        // Each caliper only ever moves on; it stops where its direction no longer gains.
        const auto moveOn = [&](std::size_t& caliper, std::size_t from, const Eigen::Vector2d& direction) {
            caliper = std::max(caliper, from);
            while (caliper < i + n && direction.dot(corner(caliper + 1) - corner(caliper)) > 0.0)
                ++caliper;
        };
        moveOn(right, i + 1, side);
        moveOn(top, right, inward);
        moveOn(left, top, -side);

        const double along = side.dot(corner(right) - corner(left));
        const double across = inward.dot(corner(top) - corner(i));
        constexpr double kEqual = 1e-9;
        const double area = along * across;
        if (area < bestArea * (1.0 - kEqual) ||
            (area <= bestArea * (1.0 + kEqual) && along + across < best.along + best.across)) {
            best = {side, along, across};
            bestArea = area;
        }
    }
    return best;
}

}  // namespace planewright
