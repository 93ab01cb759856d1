// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <Eigen/Core>

namespace planewright {

/// How steep a plane of this unit normal stands [rad]: 0 for a floor or ceiling, π/2 for a wall.
double planeTilt(const Eigen::Vector3d& normal);

/// Where the normal points as seen from above [rad]: 0 straight ahead (+y), clockwise, below 2π. A wall to the right
/// has π/2. Nothing for a plane that is level within 1°, whose normal points nowhere in particular.
std::optional<double> planeHeading(const Eigen::Vector3d& normal);

}  // namespace planewright
