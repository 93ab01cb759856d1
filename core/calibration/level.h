// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/calibration/plane_system.h"

namespace planewright {

/// Where up is, by floors and ceilings taken as level and walls taken as plumb.
struct Level {
    double pitch = 0.0;  ///< what is missing to the measured pitch for up to be up [rad]
    double roll = 0.0;   ///< how far the pitch axis falls to the right [rad]
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of both [rad²]
    int levelPlanes = 0;
    int plumbPlanes = 0;
};

/// Finds up as the direction that most planes of a scan are at right angles to or parallel with; it is looked for
/// within 20 degrees of the scanner's own.
///
/// `tolerance` [rad] is how far a floor may be from level and a wall from plumb (standard deviation); where they
/// disagree by more, that counts. Before any plane is seen, the pitch axis is taken to be level within 3 degrees
/// (standard deviation), which matters only where all walls are parallel and there is no floor. Planes that tell
/// nothing of the pitch (walls along the line of sight alone) give none.
std::optional<Level> findLevel(const SeenPlanes& seen, const PlanesEstimate& planes, double tolerance);

}  // namespace planewright
