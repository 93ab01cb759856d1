// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/ray_caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include <Eigen/Geometry>

namespace planewright {

namespace {

/// Share of an edge by which a surface is taken to be larger, so that rays do not slip between neighbours.
constexpr double kSeam = 1e-12;

/// From the sensor's frame to that of a slice.
class SliceFrame {
public:
    SliceFrame(double tilt, double pitchAxisOffset)
        : sine_(std::sin(tilt)), cosine_(std::cos(tilt)), offset_(pitchAxisOffset)
    {
    }

    Eigen::Vector3d direction(const Eigen::Vector3d& v) const
    {
        return {v.x(), v.y() * sine_ - v.z() * cosine_, v.y() * cosine_ + v.z() * sine_};
    }

    Eigen::Vector3d point(const Eigen::Vector3d& p) const { return direction(p) - Eigen::Vector3d(0.0, 0.0, offset_); }

private:
    double sine_;
    double cosine_;
    double offset_;
};

std::array<Eigen::Vector3d, 4> cornersOf(const RectangleSurface& r)
{
    return {r.corner, r.corner + r.edgeU, r.corner + r.edgeV, r.corner + r.edgeU + r.edgeV};
}

/// Corners of the box about the whole cylinder.
std::array<Eigen::Vector3d, 8> cornersOf(const CylinderSurface& c)
{
    const Eigen::Vector3d second = c.axis.normalized().cross(c.radius);
    std::array<Eigen::Vector3d, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = c.base + ((i & 1U) != 0 ? c.radius : -c.radius) + ((i & 2U) != 0 ? second : -second);
        if ((i & 4U) != 0)
            corners[i] += c.axis;
    }
    return corners;
}

/// False where the hull of the corners lies wholly on one side of the wedge of rays.
///
/// A ray off the slice plane by the angle s reaches p only if |w| ≤ |p| sin s; turning the slice by s moves the laser
/// by d_l s as well. Points beyond that form a convex set, so four corners in it keep the whole rectangle in it.
bool mayMeet(std::span<const Eigen::Vector3d> corners, const SliceFrame& frame, double pitchAxisOffset, double spread)
{
    bool above = true;
    bool below = true;
    for (const Eigen::Vector3d& corner : corners) {
        const Eigen::Vector3d p = frame.point(corner);
        const double reach = (p.norm() + std::abs(pitchAxisOffset)) * spread + 1e-9;
        above = above && p.z() > reach;
        below = below && p.z() < -reach;
    }
    return !above && !below;
}

}  // namespace

SurfaceSelection allSurfaces(const Scene& scene)
{
    SurfaceSelection selection;
    for (std::size_t i = 0; i < scene.rectangles.size(); ++i)
        selection.rectangles.push_back(i);
    for (std::size_t i = 0; i < scene.cylinders.size(); ++i)
        selection.cylinders.push_back(i);
    return selection;
}

SurfaceSelection surfacesNear(const Scene& scene, double tilt, double pitchAxisOffset, double spread)
{
    const SliceFrame frame(tilt, pitchAxisOffset);
    SurfaceSelection selection;
    for (std::size_t i = 0; i < scene.rectangles.size(); ++i)
        if (mayMeet(cornersOf(scene.rectangles[i]), frame, pitchAxisOffset, spread))
            selection.rectangles.push_back(i);
    for (std::size_t i = 0; i < scene.cylinders.size(); ++i)
        if (mayMeet(cornersOf(scene.cylinders[i]), frame, pitchAxisOffset, spread))
            selection.cylinders.push_back(i);
    return selection;
}

RayCaster::RayCaster(const Scene& scene, const SurfaceSelection& selection, double tilt, double pitchAxisOffset)
    : scene_(scene)
{
    const SliceFrame frame(tilt, pitchAxisOffset);
    rectangles_.reserve(selection.rectangles.size());
    for (const std::size_t i : selection.rectangles) {
        const RectangleSurface& surface = scene.rectangles[i];
        const Eigen::Vector3d corner = frame.point(surface.corner);
        const Eigen::Vector3d u = frame.direction(surface.edgeU);
        const Eigen::Vector3d v = frame.direction(surface.edgeV);
        const Eigen::Vector3d normal = u.cross(v);
        const Eigen::Vector3d toU = v.cross(normal) / normal.squaredNorm();
        const Eigen::Vector3d toV = normal.cross(u) / normal.squaredNorm();
        rectangles_.push_back({normal, normal.dot(corner), toU, toU.dot(corner), toV, toV.dot(corner), i});
    }
    cylinders_.reserve(selection.cylinders.size());
    for (const std::size_t i : selection.cylinders) {
        const CylinderSurface& surface = scene.cylinders[i];
        const Eigen::Vector3d axis = frame.direction(surface.axis.normalized());
        const Eigen::Vector3d first = frame.direction(surface.radius.normalized());
        cylinders_.push_back({frame.point(surface.base), first, axis.cross(first), axis, surface.radius.norm(),
                              surface.axis.norm(), surface.sweep, scene.rectangles.size() + i});
    }
}

std::optional<RayHit> RayCaster::cast(const Eigen::Vector3d& direction) const
{
    RayHit nearest;
    nearest.range = std::numeric_limits<double>::infinity();
    for (const Rectangle& r : rectangles_) {
        const double range = r.distance / r.normal.dot(direction);
        if (!(range > 0.0 && range < nearest.range))
            continue;
        const double a = range * r.toU.dot(direction) - r.originU;
        const double b = range * r.toV.dot(direction) - r.originV;
        if (a < -kSeam || a > 1.0 + kSeam || b < -kSeam || b > 1.0 + kSeam)
            continue;
        const RectangleSurface& surface = scene_.rectangles[r.index];
        nearest = {range, surface.plane, r.index, surface.dropout};
    }
    for (const Cylinder& cylinder : cylinders_)
        castAtCylinder(cylinder, direction, nearest);
    if (nearest.range == std::numeric_limits<double>::infinity())
        return std::nullopt;
    return nearest;
}

void RayCaster::castAtCylinder(const Cylinder& cylinder, const Eigen::Vector3d& direction, RayHit& nearest) const
{
    // In the cylinder's cross-section: |o + t d|² = R², as a t² + 2 b t + c = 0.
    const Eigen::Vector2d d(direction.dot(cylinder.first), direction.dot(cylinder.second));
    const Eigen::Vector2d o(-cylinder.base.dot(cylinder.first), -cylinder.base.dot(cylinder.second));
    const double a = d.squaredNorm();
    const double b = d.dot(o);
    const double c = o.squaredNorm() - cylinder.radius * cylinder.radius;
    const double discriminant = b * b - a * c;
    if (a == 0.0 || discriminant < 0.0)
        return;
    // Without the difference of nearly equal numbers of the schoolbook formula.
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    for (const double range : {q / a, c / q}) {
        if (!(range > 0.0 && range < nearest.range))
            continue;
        const Eigen::Vector2d across = o + range * d;
        const double along = (range * direction - cylinder.base).dot(cylinder.axis);
        double angle = std::atan2(across.y(), across.x());
        if (angle < -kSeam)
            angle += 2.0 * std::numbers::pi;
        if (along < -kSeam || along > cylinder.height + kSeam || angle > cylinder.sweep + kSeam)
            continue;
        nearest = {range, kNotPlanar, cylinder.index, 0.0};
    }
}

}  // namespace planewright
