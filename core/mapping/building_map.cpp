// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/building_map.h"

#include <algorithm>

#include "core/geometry/plane_frame.h"
#include "core/geometry/polygon_union.h"

namespace planewright {

std::vector<Outline::Polygon> fusedOutline(const BuildingMap& map, const MapPlane& plane)
{
    const PlaneFrame frame(plane.parameters.normal, plane.parameters.distance, Eigen::Vector3d::UnitZ());
    std::vector<PlanarRing> rings;
    const auto add = [&](const std::vector<Eigen::Vector3d>& corners, const Pose& pose, bool hole) {
        PlanarRing ring;
        for (const Eigen::Vector3d& corner : corners)
            ring.push_back(frame.toPlane(pose * corner));
        if ((signedArea(ring) < 0.0) != hole)
            std::ranges::reverse(ring);
        rings.push_back(std::move(ring));
    };
    for (const Sighting& sighting : plane.sightings) {
        const MapStop& stop = map.stops[sighting.stop];
        for (const Outline::Polygon& part : stop.stop->planes[sighting.plane].parts) {
            add(part.ring, stop.pose, false);
            for (const auto& hole : part.holes)
                add(hole, stop.pose, true);
        }
    }
    const auto inSpace = [&frame](const PlanarRing& ring) {
        std::vector<Eigen::Vector3d> corners;
        for (const Eigen::Vector2d& corner : ring)
            corners.push_back(frame.toSpace(corner));
        return corners;
    };
    std::vector<Outline::Polygon> parts;
    for (const PlanarPolygon& polygon : unionOf(rings)) {
        Outline::Polygon& part = parts.emplace_back();
        part.ring = inSpace(polygon.ring);
        for (const PlanarRing& hole : polygon.holes)
            part.holes.push_back(inSpace(hole));
    }
    return parts;
}

}  // namespace planewright
