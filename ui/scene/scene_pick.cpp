// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/scene/scene_pick.h"

#include <limits>

namespace planewright {

namespace {

/// Points this much farther than the nearest are behind it [m].
constexpr double kBehind = 0.1;

struct Nearest {
    double along = std::numeric_limits<double>::infinity();
    std::optional<Picked> picked;

    void offer(double distance, Picked other)
    {
        if (distance < along) {
            along = distance;
            picked = std::move(other);
        }
    }
};

void offerPlanes(const MapScene& scene, const Ray& ray, Nearest& nearest)
{
    if (!scene.layers()[Layer::Planes].visible)
        return;
    for (const ShownPlane& plane : scene.map().planes) {
        if (plane.hidden || !plane.outline)
            continue;
        for (const Triangle& triangle : plane.outline->triangles) {
            if (const auto along = hit(ray, triangle))
                nearest.offer(*along, {ray.at(*along), plane.plane->id, std::nullopt});
        }
    }
}

}  // namespace

std::optional<Picked> pick(const MapScene& scene, const Ray& ray, double tolerance)
{
    const ShownMap& map = scene.map();
    const SegmentOwners& owners = scene.owners();
    const bool parallel = scene.camera().parallel;
    Nearest ofPlanes;
    Nearest leftOver;
    offerPlanes(scene, ray, ofPlanes);
    for (std::size_t slice = 0; slice < owners.slices(); ++slice) {
        for (const LineSegment& segment : map.snapshot->segments.slice(slice)) {
            const int owner = owners.planeAt(slice, static_cast<std::size_t>(segment.id.index));
            if (!scene.layers()[owner < 0 ? Layer::Unfitted : Layer::FittedSegments].visible)
                continue;
            if (owner >= 0 && map.planes[static_cast<std::size_t>(owner)].hidden)
                continue;
            const auto passing = pass(ray, segment.start, segment.end);
            if (!passing || passing->seen(parallel) > tolerance)
                continue;
            const PlaneId id = owner < 0 ? kNoPlane : map.planes[static_cast<std::size_t>(owner)].plane->id;
            (owner < 0 ? leftOver : ofPlanes).offer(passing->along, {ray.at(passing->along), id, segment.id});
        }
    }
    return leftOver.picked && leftOver.along < ofPlanes.along + kBehind ? leftOver.picked : ofPlanes.picked;
}

std::optional<Picked> pickPoint(const MapScene& scene, const Ray& ray, double tolerance)
{
    const bool parallel = scene.camera().parallel;
    Nearest nearest;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](const Eigen::Vector3d& point) {
        const auto passing = pass(ray, point);
        if (!passing || passing->seen(parallel) > tolerance || passing->along > nearest.along + kBehind)
            return;
        const bool inFront = passing->along < nearest.along - kBehind;
        if (inFront || passing->seen(parallel) < least) {
            least = passing->seen(parallel);
            nearest.along = passing->along;
            nearest.picked = Picked{point, kNoPlane, std::nullopt, true};
        }
    };
    for (const auto& slice : scene.map().slices) {
        for (std::size_t beam = 0; beam < slice->ranges.size(); ++beam) {
            if (scene.map().sensor.hasEcho(slice->ranges[beam]))
                offer(toCartesian(slice->ranges[beam], slice->bearing(beam), slice->tiltAt(beam), scene.map().sensor));
        }
    }
    return nearest.picked;
}

}  // namespace planewright
