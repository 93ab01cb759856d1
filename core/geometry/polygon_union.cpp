// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/polygon_union.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include <Eigen/Geometry>
#include <polyclipping/clipper.hpp>

#include "core/geometry/simplify_ring.h"

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
constexpr double kCorner = 1e-3;        // a vertex this near to the line of its neighbours is no corner [m]
constexpr std::size_t kUnitedAtOnce = 32;

/// The grid on which Clipper computes.
struct Grid {
    double unitsPerMetre;

    /// Fine enough for coordinates up to `reach` [m].
    explicit Grid(double reach)
        : unitsPerMetre(reach * kUnitsPerMetre > kGridLimit ? kGridLimit / reach : kUnitsPerMetre)
    {
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

double reachOf(const std::vector<PlanarRing>& rings)
{
    double reach = 0.0;
    for (const PlanarRing& ring : rings) {
        for (const Eigen::Vector2d& point : ring)
            reach = std::max(reach, point.cwiseAbs().maxCoeff());
    }
    return reach;
}

using Box = Eigen::AlignedBox2d;
using Group = std::vector<std::size_t>;

/// Cuts a group of boxes where a gap wider than the margin goes through it across an axis.
std::vector<Group> cutAcross(Group group, int axis, const std::vector<Box>& boxes, double margin)
{
    std::ranges::stable_sort(group, {}, [&](std::size_t i) { return boxes[i].min()[axis]; });
    std::vector<Group> pieces;
    double reach = -std::numeric_limits<double>::infinity();
    for (const std::size_t i : group) {
        if (pieces.empty() || boxes[i].min()[axis] > reach + margin)
            pieces.emplace_back();
        pieces.back().push_back(i);
        reach = std::max(reach, boxes[i].max()[axis]);
    }
    return pieces;
}

/// Groups of rings that lie apart. Clipper slows down with the square of what lies side by side.
std::vector<Group> groupsApart(const std::vector<PlanarRing>& rings, double margin)
{
    std::vector<Box> boxes(rings.size());
    Group all;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        for (const Eigen::Vector2d& point : rings[i])
            boxes[i].extend(point);
        all.push_back(i);
    }
    struct Work {
        Group group;
        int axis;
        int uncut;  ///< axes tried without a cut
    };
    std::vector<Group> groups;
    std::vector<Work> open{{std::move(all), 0, 0}};
    while (!open.empty()) {
        Work work = std::move(open.back());
        open.pop_back();
        if (work.uncut == 2 || work.group.size() < 2) {
            std::ranges::sort(work.group);
            groups.push_back(std::move(work.group));
            continue;
        }
        std::vector<Group> pieces = cutAcross(std::move(work.group), work.axis, boxes, margin);
        const int uncut = pieces.size() == 1 ? work.uncut + 1 : 0;
        for (Group& piece : pieces)
            open.push_back({std::move(piece), 1 - work.axis, uncut});
    }
    return groups;
}

/// The union of paths that follow each other: parts first, because neighbours melt into few edges.
///
/// Holes below an area are left out: neither more paths nor closing cracks makes a hole larger, and Clipper's time
/// grows with the square of the paths side by side, which slivers between strips are by the thousand.
Paths unite(std::span<const Path> paths, double smallestHole)
{
    ClipperLib::Clipper clipper;
    if (paths.size() <= kUnitedAtOnce) {
        for (const Path& path : paths)
            clipper.AddPath(path, ClipperLib::ptSubject, true);
    } else {
        const std::size_t part = (paths.size() + 3) / 4;
        for (; !paths.empty(); paths = paths.subspan(std::min(part, paths.size())))
            clipper.AddPaths(unite(paths.first(std::min(part, paths.size())), smallestHole), ClipperLib::ptSubject,
                             true);
    }
    Paths united;
    clipper.Execute(ClipperLib::ctUnion, united, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    std::erase_if(united, [smallestHole](const Path& path) {
        const double area = ClipperLib::Area(path);
        return area < 0.0 && area > -smallestHole;
    });
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

/// Appends the polygons of Clipper's result that are no slivers. Clipper turns outer rings left and holes right.
void appendPolygons(const PolyTree& tree, const Grid& grid, std::vector<PlanarPolygon>& polygons)
{
    const auto cornersOf = [&](const PolyNode& node) { return simplifyRing(grid.fromGrid(node.Contour), kCorner); };
    for (const PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
        if (node->IsHole())
            continue;
        PlanarPolygon polygon{cornersOf(*node), {}};
        if (signedArea(polygon.ring) < kSmallestPart)
            continue;
        for (const PolyNode* child : node->Childs) {
            PlanarRing hole = cornersOf(*child);
            if (signedArea(hole) < -kSmallestHole)
                polygon.holes.push_back(std::move(hole));
        }
        polygons.push_back(std::move(polygon));
    }
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
    const Grid grid(reachOf(rings));
    std::vector<PlanarPolygon> polygons;
    for (const Group& group : groupsApart(rings, 3.0 * kCrack)) {
        Paths paths;
        for (const std::size_t i : group)
            paths.push_back(grid.toGrid(rings[i]));
        paths = unite(paths, kSmallestHole * grid.unitsPerMetre * grid.unitsPerMetre);
        for (Path& path : paths)
            path = grid.toGrid(simplifyRing(grid.fromGrid(path), kCorner));
        PolyTree closed;
        closeCracks(paths, kCrack * grid.unitsPerMetre, closed);
        appendPolygons(closed, grid, polygons);
    }
    return polygons;
}

double sharedArea(const std::vector<PlanarRing>& a, const std::vector<PlanarRing>& b)
{
    const Grid grid(std::max(reachOf(a), reachOf(b)));
    ClipperLib::Clipper clipper;
    for (const PlanarRing& ring : a)
        clipper.AddPath(grid.toGrid(ring), ClipperLib::ptSubject, true);
    for (const PlanarRing& ring : b)
        clipper.AddPath(grid.toGrid(ring), ClipperLib::ptClip, true);
    Paths shared;
    clipper.Execute(ClipperLib::ctIntersection, shared, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    double area = 0.0;
    for (const Path& path : shared)
        area += ClipperLib::Area(path);
    return std::abs(area) / (grid.unitsPerMetre * grid.unitsPerMetre);
}

}  // namespace planewright
