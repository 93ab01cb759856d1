// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/triangulate.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "core/geometry/plane_frame.h"

namespace planewright {
namespace {

/// An edge of a ring that is not level, from the lower level to the upper one.
struct Edge {
    std::size_t bottom;
    std::size_t top;
    double bottomX;
    double topX;
};

/// The area between two edges from one level to another.
struct Trapezoid {
    std::size_t left;
    std::size_t right;
    std::size_t bottom;
    std::size_t top;
};

/// Cuts a polygon into trapezoids with level sides, at the heights of its vertices, and these into triangles.
///
/// A sweep with the even-odd rule: it asks for nothing about the rings, so that rings which touch themselves or each
/// other, and vertices on a straight edge, need no care.
class TrapezoidSweep {
public:
    explicit TrapezoidSweep(const std::vector<PlanarRing>& rings);
    void appendTriangles(const PlaneFrame& frame, std::vector<Triangle>& triangles);

private:
    std::size_t levelOf(double y) const;
    double x(std::size_t edge, std::size_t level) const;
    void sortAcross(std::vector<std::size_t>& active, std::size_t level) const;
    void sweep();
    std::vector<double> chain(const Trapezoid& trapezoid, std::size_t level) const;

    std::vector<double> levels_;
    std::vector<Edge> edges_;  // by rising bottom level
    std::vector<Trapezoid> trapezoids_;
    std::vector<std::vector<double>> corners_;  // x of all trapezoid corners of a level, rising
};

TrapezoidSweep::TrapezoidSweep(const std::vector<PlanarRing>& rings)
{
    constexpr double kSameLevel = 1e-9;  // [m]
    for (const PlanarRing& ring : rings) {
        for (const Eigen::Vector2d& point : ring)
            levels_.push_back(point.y());
    }
    std::ranges::sort(levels_);
    const auto sameLevel = [](double a, double b) { return b - a <= kSameLevel; };
    levels_.erase(std::unique(levels_.begin(), levels_.end(), sameLevel), levels_.end());
    corners_.resize(levels_.size());

    for (const PlanarRing& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Eigen::Vector2d& from = ring[i];
            const Eigen::Vector2d& to = ring[(i + 1) % ring.size()];
            const Edge edge{levelOf(from.y()), levelOf(to.y()), from.x(), to.x()};
            if (edge.bottom < edge.top)
                edges_.push_back(edge);
            else if (edge.bottom > edge.top)
                edges_.push_back({edge.top, edge.bottom, edge.topX, edge.bottomX});
        }
    }
    std::ranges::stable_sort(edges_, {}, &Edge::bottom);
    sweep();
}

/// The level of a vertex: the last one that is not above it.
std::size_t TrapezoidSweep::levelOf(double y) const
{
    return static_cast<std::size_t>(std::ranges::upper_bound(levels_, y) - levels_.begin()) - 1;
}

double TrapezoidSweep::x(std::size_t edge, std::size_t level) const
{
    const Edge& e = edges_[edge];
    if (level == e.bottom)
        return e.bottomX;
    if (level == e.top)
        return e.topX;
    const double rise = (levels_[level] - levels_[e.bottom]) / (levels_[e.top] - levels_[e.bottom]);
    return e.bottomX + rise * (e.topX - e.bottomX);
}

/// Sorts the edges between a level and the next from left to right. They are nearly sorted: by insertion.
void TrapezoidSweep::sortAcross(std::vector<std::size_t>& active, std::size_t level) const
{
    const auto twiceTheMiddle = [&](std::size_t edge) { return x(edge, level) + x(edge, level + 1); };
    for (std::size_t i = 1; i < active.size(); ++i) {
        const std::size_t edge = active[i];
        const double place = twiceTheMiddle(edge);
        std::size_t j = i;
        for (; j > 0 && twiceTheMiddle(active[j - 1]) > place; --j)
            active[j] = active[j - 1];
        active[j] = edge;
    }
}

void TrapezoidSweep::sweep()
{
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> active;
    std::vector<std::size_t> openOf(edges_.size(), kNone);  // the trapezoid right of an edge that still grows
    std::size_t next = 0;
    for (std::size_t level = 0; level + 1 < levels_.size(); ++level) {
        std::erase_if(active, [&](std::size_t edge) { return edges_[edge].top == level; });
        for (; next < edges_.size() && edges_[next].bottom == level; ++next)
            active.push_back(next);
        sortAcross(active, level);
        for (std::size_t i = 0; i + 1 < active.size(); i += 2) {
            const std::size_t left = active[i];
            const std::size_t right = active[i + 1];
            const std::size_t open = openOf[left];
            if (open != kNone && trapezoids_[open].right == right && trapezoids_[open].top == level) {
                trapezoids_[open].top = level + 1;
            } else {
                openOf[left] = trapezoids_.size();
                trapezoids_.push_back({left, right, level, level + 1});
            }
        }
    }
    for (const Trapezoid& t : trapezoids_) {
        for (const std::size_t level : {t.bottom, t.top}) {
            corners_[level].push_back(x(t.left, level));
            corners_[level].push_back(x(t.right, level));
        }
    }
    for (std::vector<double>& corners : corners_) {
        std::ranges::sort(corners);
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    }
}

/// The level side of a trapezoid with the corners of its neighbours on it, from left to right.
std::vector<double> TrapezoidSweep::chain(const Trapezoid& trapezoid, std::size_t level) const
{
    const double left = x(trapezoid.left, level);
    const double right = x(trapezoid.right, level);
    const std::vector<double>& corners = corners_[level];
    const auto first = std::ranges::lower_bound(corners, left);
    const auto last = std::ranges::upper_bound(corners, right);
    if (last - first < 2)
        return {left};
    return {first, last};
}

void TrapezoidSweep::appendTriangles(const PlaneFrame& frame, std::vector<Triangle>& triangles)
{
    for (const Trapezoid& t : trapezoids_) {
        const std::vector<double> low = chain(t, t.bottom);
        const std::vector<double> high = chain(t, t.top);
        const auto lowPoint = [&](std::size_t i) { return frame.toSpace({low[i], levels_[t.bottom]}); };
        const auto highPoint = [&](std::size_t i) { return frame.toSpace({high[i], levels_[t.top]}); };
        // How far along its side the next corner lies: the side that is behind goes on, for well-shaped triangles.
        const auto progress = [](const std::vector<double>& side, std::size_t i) {
            return i + 1 < side.size() ? (side[i + 1] - side.front()) / (side.back() - side.front()) : 2.0;
        };
        for (std::size_t i = 0, j = 0; i + 1 < low.size() || j + 1 < high.size();) {
            if (progress(low, i) <= progress(high, j)) {
                triangles.push_back({lowPoint(i), lowPoint(i + 1), highPoint(j)});
                ++i;
            } else {
                triangles.push_back({lowPoint(i), highPoint(j + 1), highPoint(j)});
                ++j;
            }
        }
    }
}

/// The direction of a ring's longest edge: most trapezoids then have a vertex in each corner.
Eigen::Vector3d longestEdge(const std::vector<Eigen::Vector3d>& ring)
{
    Eigen::Vector3d longest = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Eigen::Vector3d edge = ring[(i + 1) % ring.size()] - ring[i];
        if (edge.squaredNorm() > longest.squaredNorm())
            longest = edge;
    }
    return longest;
}

PlanarRing planarRing(const std::vector<Eigen::Vector3d>& ring, const PlaneFrame& frame)
{
    PlanarRing planar;
    planar.reserve(ring.size());
    for (const Eigen::Vector3d& point : ring)
        planar.push_back(frame.toPlane(point));
    return planar;
}

}  // namespace

std::vector<Triangle> triangulate(const Outline& outline, const Eigen::Vector3d& normal)
{
    std::vector<Triangle> triangles;
    for (const Outline::Polygon& part : outline.parts) {
        if (part.ring.size() < 3)
            continue;
        const PlaneFrame frame(normal, normal.dot(part.ring.front()), longestEdge(part.ring));
        std::vector<PlanarRing> rings{planarRing(part.ring, frame)};
        for (const auto& hole : part.holes)
            rings.push_back(planarRing(hole, frame));
        TrapezoidSweep(rings).appendTriangles(frame, triangles);
    }
    return triangles;
}

}  // namespace planewright
