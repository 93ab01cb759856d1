// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Geometry>

#include "core/geometry/minimum_rectangle.h"
#include "core/geometry/plane_frame.h"
#include "core/geometry/polygon_union.h"
#include "core/geometry/strips.h"
#include "core/types/angle.h"

namespace planewright {
namespace {

using Ring = std::vector<Eigen::Vector3d>;

/// The plane's segments in order of step and index, those with finite end points.
std::vector<const LineSegment*> segmentsOf(const Plane& plane, const SegmentLog& log)
{
    std::vector<const LineSegment*> segments;
    segments.reserve(plane.segments.size());
    for (const SegmentId& id : plane.segments) {
        const LineSegment& segment = log[id];
        if (segment.start.allFinite() && segment.end.allFinite())
            segments.push_back(&segment);
    }
    std::ranges::sort(segments, {}, [](const LineSegment* segment) { return segment->id; });
    return segments;
}

/// The frame along the longest segment, or across it where the slices hold more pieces than there are slices: the union
/// sweeps along the second axis and is fast where few pieces lie side by side.
PlaneFrame frameFor(const Plane& plane, const std::vector<const LineSegment*>& segments)
{
    const LineSegment* longest =
        *std::ranges::max_element(segments, {}, [](const LineSegment* segment) { return segment->length(); });
    std::size_t slices = 1;
    for (std::size_t i = 1; i < segments.size(); ++i)
        slices += segments[i]->id.step != segments[i - 1]->id.step ? 1 : 0;
    const Eigen::Vector3d along = longest->end - longest->start;
    return {plane.normal, plane.distance, segments.size() > slices * slices ? plane.normal.cross(along) : along};
}

/// The step between slices where the plane was seen: more than 1 in a recording of every other slice, say.
int stepBetweenSlices(const SegmentLog& log, int firstStep, int lastStep)
{
    int least = std::numeric_limits<int>::max();
    const std::size_t last = log.find(lastStep);
    for (std::size_t slice = log.find(firstStep); slice < last && least > 1; ++slice)
        least = std::min(least, log.stepOf(slice + 1) - log.stepOf(slice));
    return least;
}

std::vector<Row> rowsOf(const std::vector<const LineSegment*>& segments, const SegmentLog& log, const PlaneFrame& frame)
{
    const int between = stepBetweenSlices(log, segments.front()->id.step, segments.back()->id.step);
    std::vector<Row> rows;
    int step = 0;
    for (const LineSegment* segment : segments) {
        if (rows.empty() || segment->id.step != step)
            rows.push_back({segment->id.step / between, {}});
        step = segment->id.step;
        const Stretch stretch{frame.toPlane(segment->start), frame.toPlane(segment->end)};
        if (stretch.start != stretch.end)
            rows.back().stretches.push_back(stretch);
    }
    return rows;
}

/// The hull of the end points, unless they lie on one line.
std::vector<PlanarPolygon> hullOf(const PlanarRing& endPoints)
{
    constexpr double kFlat = 1e-9;
    PlanarRing hull = convexHull(endPoints);
    const RectangleSides sides = minimumRectangle(hull);
    if (hull.size() < 3 || std::min(sides.along, sides.across) <= kFlat * std::max(sides.along, sides.across))
        return {};
    return {{std::move(hull), {}}};
}

bool comesBefore(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return std::ranges::lexicographical_compare(a, b);
}

bool ringComesBefore(const Ring& a, const Ring& b)
{
    return std::ranges::lexicographical_compare(a, b, comesBefore);
}

/// A ring in space, begun at its smallest vertex.
Ring canonicalRing(const PlanarRing& planar, const PlaneFrame& frame)
{
    Ring ring;
    ring.reserve(planar.size());
    for (const Eigen::Vector2d& point : planar)
        ring.push_back(frame.toSpace(point));
    std::rotate(ring.begin(), std::ranges::min_element(ring, comesBefore), ring.end());
    return ring;
}

std::vector<Outline::Polygon> canonicalParts(const std::vector<PlanarPolygon>& polygons, const PlaneFrame& frame)
{
    std::vector<Outline::Polygon> parts;
    for (const PlanarPolygon& polygon : polygons) {
        Outline::Polygon part{canonicalRing(polygon.ring, frame), {}};
        for (const PlanarRing& hole : polygon.holes)
            part.holes.push_back(canonicalRing(hole, frame));
        std::ranges::sort(part.holes, ringComesBefore);
        parts.push_back(std::move(part));
    }
    std::ranges::sort(parts, ringComesBefore, &Outline::Polygon::ring);
    return parts;
}

/// Area and its first moment, by triangles from a common corner: holes count negative because they turn the other way.
struct AreaMoment {
    Eigen::Vector2d corner;
    double area = 0.0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();

    void add(const PlanarRing& ring)
    {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Eigen::Vector2d a = ring[i] - corner;
            const Eigen::Vector2d b = ring[(i + 1) % ring.size()] - corner;
            const double triangle = 0.5 * cross(a, b);
            area += triangle;
            moment += triangle / 3.0 * (a + b);
        }
    }
};

void measureArea(const std::vector<PlanarPolygon>& polygons, const PlanarRing& endPoints, const PlaneFrame& frame,
                 Outline& outline)
{
    AreaMoment sum{endPoints.front()};
    for (const PlanarPolygon& polygon : polygons) {
        sum.add(polygon.ring);
        for (const PlanarRing& hole : polygon.holes)
            sum.add(hole);
    }
    Eigen::Vector2d offset = Eigen::Vector2d::Zero();
    if (sum.area > 0.0) {
        offset = sum.moment / sum.area;
    } else {
        for (const Eigen::Vector2d& point : endPoints)
            offset += (point - sum.corner) / static_cast<double>(endPoints.size());
    }
    outline.area = sum.area;
    outline.centroid = frame.toSpace(sum.corner + offset);
}

void measureSides(const std::vector<PlanarPolygon>& polygons, const PlanarRing& endPoints, const PlaneFrame& frame,
                  Outline& outline)
{
    PlanarRing points;
    for (const PlanarPolygon& polygon : polygons)
        points.insert(points.end(), polygon.ring.begin(), polygon.ring.end());
    const RectangleSides sides = minimumRectangle(convexHull(polygons.empty() ? endPoints : points));

    const Eigen::Vector2d& d = sides.direction;
    const double riseAlong = std::abs(d.x() * frame.right.z() + d.y() * frame.up.z());
    const double riseAcross = std::abs(-d.y() * frame.right.z() + d.x() * frame.up.z());
    const double level = std::sin(degrees(10.0));
    const bool bothLevel = riseAlong < level && riseAcross < level;
    const bool alongIsWidth = bothLevel ? sides.along >= sides.across : riseAlong <= riseAcross;
    outline.width = alongIsWidth ? sides.along : sides.across;
    outline.height = alongIsWidth ? sides.across : sides.along;
}

}  // namespace

Outline outlineOf(const Plane& plane, const SegmentLog& log)
{
    const std::vector<const LineSegment*> segments = segmentsOf(plane, log);
    if (segments.empty())
        return {};
    const PlaneFrame frame = frameFor(plane, segments);
    PlanarRing endPoints;
    for (const LineSegment* segment : segments) {
        endPoints.push_back(frame.toPlane(segment->start));
        endPoints.push_back(frame.toPlane(segment->end));
    }

    std::vector<PlanarPolygon> polygons = unionOf(stripsBetween(rowsOf(segments, log, frame)));
    if (polygons.empty())
        polygons = hullOf(endPoints);

    Outline outline;
    outline.parts = canonicalParts(polygons, frame);
    measureArea(polygons, endPoints, frame, outline);
    measureSides(polygons, endPoints, frame, outline);
    return outline;
}

Outline outlineOf(const std::vector<Outline::Polygon>& parts, const Eigen::Vector3d& normal, double distance)
{
    const PlaneFrame frame(normal, distance, Eigen::Vector3d::UnitZ().cross(normal));
    const auto planar = [&frame](const Ring& ring, bool isHole) {
        PlanarRing flat;
        for (const Eigen::Vector3d& corner : ring)
            flat.push_back(frame.toPlane(corner));
        if ((signedArea(flat) < 0.0) != isHole)
            std::ranges::reverse(flat);
        return flat;
    };
    std::vector<PlanarPolygon> polygons;
    PlanarRing corners;
    for (const Outline::Polygon& part : parts) {
        PlanarPolygon& polygon = polygons.emplace_back();
        polygon.ring = planar(part.ring, false);
        for (const Ring& hole : part.holes)
            polygon.holes.push_back(planar(hole, true));
        corners.insert(corners.end(), polygon.ring.begin(), polygon.ring.end());
    }
    Outline outline;
    if (corners.empty())
        return outline;
    outline.parts = canonicalParts(polygons, frame);
    measureArea(polygons, corners, frame, outline);
    measureSides(polygons, corners, frame, outline);
    return outline;
}

}  // namespace planewright
