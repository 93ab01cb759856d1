// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <Eigen/Core>

#include "app/mapping/faced_plane.h"

namespace planewright {

/// An upright plane from above, in the level of its frame; normal and distance [m] as those of the plane.
struct WallLine {
    Eigen::Vector2d normal;
    double distance = 0.0;
    Eigen::Vector2d from;
    Eigen::Vector2d to;

    Eigen::Vector2d along() const { return {-normal.y(), normal.x()}; }
    Eigen::Vector2d middle() const { return 0.5 * (from + to); }
    double length() const { return (to - from).norm(); }
    /// How far a place is off the line, to the side where the normal points [m].
    double offset(const Eigen::Vector2d& place) const { return normal.dot(place) - distance; }
};

/// Nothing for a plane that is more than 10° off the vertical, or was seen nowhere. One that leans is taken in the
/// middle of the height of its first part.
std::optional<WallLine> wallLine(const FacedPlane& plane);

/// How far two walls are beside each other [m], along the second; below nothing where they are not.
double overlapOf(const WallLine& wall, const WallLine& other);

}  // namespace planewright
