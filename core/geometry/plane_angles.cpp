// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/plane_angles.h"

#include <cmath>
#include <numbers>

#include "core/types/angle.h"

namespace planewright {

double planeTilt(const Eigen::Vector3d& normal)
{
    return std::atan2(normal.head<2>().norm(), std::abs(normal.z()));
}

std::optional<double> planeHeading(const Eigen::Vector3d& normal)
{
    constexpr double kLevel = degrees(1.0);
    constexpr double kTurn = 2.0 * std::numbers::pi;
    if (planeTilt(normal) < kLevel)
        return std::nullopt;
    const double heading = std::atan2(normal.x(), normal.y());
    return heading < 0.0 ? std::fmod(heading + kTurn, kTurn) : heading;
}

}  // namespace planewright
