// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Core>

namespace planewright {

/// Farthest point of a cloud that is read [m]: as far as a recording can hold.
inline constexpr double kFarthestPoint = 1000.0;

inline constexpr std::string_view kTooFar = "the point is farther than 1000 m; give coordinates in metres";

/// True where a point is too far.
inline bool isTooFar(const Eigen::Vector3d& point)
{
    return !(point.squaredNorm() <= kFarthestPoint * kFarthestPoint);
}

/// A coordinate: a number, or nan and inf in any of their spellings as NaN; nothing for any other text.
std::optional<double> readCoordinate(std::string_view text);

}  // namespace planewright
