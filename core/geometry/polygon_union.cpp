// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/polygon_union.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <polyclipping/clipper.hpp>

namespace planewright {
namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;
using ClipperLib::PolyNode;
using ClipperLib::PolyTree;

constexpr double kUnitsPerMetre = 1e6;
constexpr double kGridLimit = 5e8;      // below ClipperLib::loRange, where it computes with 64 bits and never throws
constexpr double kCrack = 0.02;         // half the width of cracks that are closed [m]
constexpr double kSmallestHole = 1e-2;  // [m²]
constexpr double kSmallestPart = 1e-3;  // [m²]
constexpr double kCollinear = 2e-5;     // a vertex this near to the line of its neighbours is left out [m]
constexpr std::size_t kUnitedAtOnce = 8;

/// The grid on which Clipper computes.
struct Grid {
    double unitsPerMetre;

    explicit Grid(const std::vector<PlanarRing>& rings)
    {
        double reach = 0.0;
        for (const PlanarRing& ring : rings) {
            for (const Eigen::Vector2d& point : ring)
                reach = std::max(reach, point.cwiseAbs().maxCoeff());
        }
        unitsPerMetre = reach * kUnitsPerMetre > kGridLimit ? kGridLimit / reach : kUnitsPerMetre;
    }

    Path toGrid(const PlanarRing& ring) const
    {
        Path path;
        path.reserve(ring.size());
        for (const Eigen::Vector2d& point : ring)
            path.emplace_back(std::llround(point.x() * unitsPerMetre), std::llround(point.y() * unitsPerMetre));
        return path;
    }

    PlanarRing fromGrid(const Path& path) const
    {
        PlanarRing ring;
        ring.reserve(path.size());
        for (const IntPoint& point : path)
            ring.emplace_back(static_cast<double>(point.X) / unitsPerMetre,
                              static_cast<double>(point.Y) / unitsPerMetre);
        return ring;
    }
};

/// The union of paths that follow each other: halves first, because Clipper slows down with the square of the paths
/// that lie side by side, and neighbours melt into few edges.
Paths unite(std::span<const Path> paths)
{
    ClipperLib::Clipper clipper;
    if (paths.size() <= kUnitedAtOnce) {
        for (const Path& path : paths)
            clipper.AddPath(path, ClipperLib::ptSubject, true);
    } else {
        const std::size_t half = paths.size() / 2;
        clipper.AddPaths(unite(paths.first(half)), ClipperLib::ptSubject, true);
        clipper.AddPaths(unite(paths.subspan(half)), ClipperLib::ptSubject, true);
    }
    Paths united;
    clipper.Execute(ClipperLib::ctUnion, united, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return united;
}

/// Closes cracks: grows the paths and shrinks them back. Square corners stay where they are.
void closeCracks(const Paths& paths, double halfWidth, PolyTree& closed)
{
    ClipperLib::ClipperOffset offset;
    Paths grown;
    offset.AddPaths(paths, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
    offset.Execute(grown, halfWidth);
    offset.Clear();
    offset.AddPaths(grown, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
    offset.Execute(closed, -halfWidth);
}

}  // namespace

double signedArea(const PlanarRing& ring)
{
    double doubled = 0.0;
    for (std::size_t i = 2; i < ring.size(); ++i)
        doubled += cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
    return 0.5 * doubled;
}

std::vector<PlanarPolygon> unionOf(const std::vector<PlanarRing>& rings)
{
    const Grid grid(rings);
    Paths paths;
    paths.reserve(rings.size());
    for (const PlanarRing& ring : rings)
        paths.push_back(grid.toGrid(ring));

    PolyTree closed;
    closeCracks(unite(paths), kCrack * grid.unitsPerMetre, closed);

    const auto ringOf = [&](const PolyNode& node, bool counterClockwise) {
        Path path = node.Contour;
        ClipperLib::CleanPolygon(path, kCollinear * grid.unitsPerMetre);
        if (ClipperLib::Orientation(path) != counterClockwise)
            ClipperLib::ReversePath(path);
        return grid.fromGrid(path);
    };
    std::vector<PlanarPolygon> polygons;
    for (const PolyNode* node = closed.GetFirst(); node != nullptr; node = node->GetNext()) {
        if (node->IsHole())
            continue;
        PlanarPolygon polygon{ringOf(*node, true), {}};
        if (signedArea(polygon.ring) < kSmallestPart)
            continue;
        for (const PolyNode* child : node->Childs) {
            PlanarRing hole = ringOf(*child, false);
            if (signedArea(hole) < -kSmallestHole)
                polygon.holes.push_back(std::move(hole));
        }
        polygons.push_back(std::move(polygon));
    }
    return polygons;
}

}  // namespace planewright
