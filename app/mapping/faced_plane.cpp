// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/faced_plane.h"

#include <utility>

namespace planewright {

FacedPlane moved(FacedPlane plane, const Pose& motion)
{
    plane.normal = motion.rotation * plane.normal;
    plane.distance += plane.normal.dot(motion.translation);
    for (Outline::Polygon& part : plane.parts) {
        for (Eigen::Vector3d& corner : part.ring)
            corner = motion * corner;
        for (auto& hole : part.holes) {
            for (Eigen::Vector3d& corner : hole)
                corner = motion * corner;
        }
    }
    return plane;
}

std::vector<FacedPlane> facedPlanes(const BuildingMap& map, const Pose& frame)
{
    std::vector<FacedPlane> planes;
    for (const MapPlane& plane : map.planes) {
        if (!plane.sightings.empty())
            planes.push_back(
                moved({plane.parameters.normal, plane.parameters.distance, fusedOutline(map, plane)}, frame));
    }
    return planes;
}

}  // namespace planewright
