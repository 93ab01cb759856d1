// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <numbers>

namespace planewright {

/// Radians of an angle given in degrees; all code below the user's eye counts in radians.
constexpr double degrees(double angle)
{
    return angle * (std::numbers::pi / 180.0);
}

/// Degrees of an angle given in radians, for files and for the user's eye.
constexpr double toDegrees(double radians)
{
    return radians * (180.0 / std::numbers::pi);
}

}  // namespace planewright
