// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/extent.h"

#include <algorithm>

#include "core/geometry/simplify_ring.h"

namespace planewright {

namespace {

bool isInside(const PlanarRing& ring, const Eigen::Vector2d& point)
{
    bool inside = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Eigen::Vector2d& a = ring[j];
        const Eigen::Vector2d& b = ring[i];
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    return inside;
}

double squaredDistance(const Eigen::Vector2d& point, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const Eigen::Vector2d side = to - from;
    const double length = side.squaredNorm();
    const double along = length > 0.0 ? std::clamp(side.dot(point - from) / length, 0.0, 1.0) : 0.0;
    return (point - from - along * side).squaredNorm();
}

bool sidesMeet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d,
               double squaredGap)
{
    const bool crossing =
        cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
    return crossing || squaredDistance(a, c, d) <= squaredGap || squaredDistance(b, c, d) <= squaredGap ||
           squaredDistance(c, a, b) <= squaredGap || squaredDistance(d, a, b) <= squaredGap;
}

Eigen::AlignedBox2d boxOf(const PlanarRing& ring)
{
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& point : ring)
        box.extend(point);
    return box;
}

bool ringsMeet(const PlanarRing& a, const PlanarRing& b, double gap)
{
    if (a.empty() || b.empty() || boxOf(a).squaredExteriorDistance(boxOf(b)) > gap * gap)
        return false;
    if (isInside(a, b.front()) || isInside(b, a.front()))
        return true;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (sidesMeet(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()], gap * gap))
                return true;
        }
    }
    return false;
}

}  // namespace

Extent extentOf(const std::vector<Outline::Polygon>& parts, const Eigen::Vector3d& normal, double tolerance)
{
    Extent extent;
    for (const Outline::Polygon& part : parts) {
        if (part.ring.empty())
            continue;
        const PlaneFrame frame(normal, normal.dot(part.ring.front()), Eigen::Vector3d::UnitZ());
        PlanarRing ring;
        for (const Eigen::Vector3d& corner : part.ring)
            ring.push_back(frame.toPlane(corner));
        extent.emplace_back();
        for (const Eigen::Vector2d& corner : simplifyRing(ring, tolerance))
            extent.back().push_back(frame.toSpace(corner));
    }
    return extent;
}

std::vector<PlanarRing> onPlane(const Extent& extent, const Pose& pose, const PlaneFrame& frame)
{
    std::vector<PlanarRing> rings;
    rings.reserve(extent.size());
    for (const auto& corners : extent) {
        PlanarRing& ring = rings.emplace_back();
        ring.reserve(corners.size());
        for (const Eigen::Vector3d& corner : corners)
            ring.push_back(frame.toPlane(pose * corner));
    }
    return rings;
}

bool meet(std::span<const PlanarRing> a, std::span<const PlanarRing> b, double gap)
{
    return std::ranges::any_of(a, [&](const PlanarRing& ring) {
        return std::ranges::any_of(b, [&](const PlanarRing& other) { return ringsMeet(ring, other, gap); });
    });
}

bool contains(std::span<const PlanarRing> rings, const Eigen::Vector2d& point)
{
    return std::ranges::any_of(rings, [&](const PlanarRing& ring) { return !ring.empty() && isInside(ring, point); });
}

}  // namespace planewright
