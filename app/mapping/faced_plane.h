// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/geometry/outline.h"
#include "core/geometry/pose.h"
#include "core/mapping/building_map.h"

namespace planewright {

/// A plane of a floor as it was seen: its normal points away from who saw it.
struct FacedPlane {
    Eigen::Vector3d normal;
    double distance = 0.0;  ///< n·p [m]
    std::vector<Outline::Polygon> parts;
};

/// The planes of a floor's map, in the frame that `frame` leads into.
std::vector<FacedPlane> facedPlanes(const BuildingMap& map, const Pose& frame);

/// The plane, with its outline, after a motion in its frame.
FacedPlane moved(FacedPlane plane, const Pose& motion);

}  // namespace planewright
