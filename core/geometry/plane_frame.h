// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace planewright {

/// A ring of points in a plane's own coordinates [m], not closed.
using PlanarRing = std::vector<Eigen::Vector2d>;

/// z of the cross product: twice the area of the triangle (0, a, b), positive where b is left of a.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Coordinates on a plane: right × up = n, so that counter-clockwise means seen from +n.
struct PlaneFrame {
    Eigen::Vector3d origin;  ///< the plane's point nearest to the sensor [m]
    Eigen::Vector3d right;   ///< first axis, unit length
    Eigen::Vector3d up;      ///< second axis, unit length

    /// The frame of n·p = d whose first axis lies along a direction; any axis serves where that is along n or zero.
    PlaneFrame(const Eigen::Vector3d& normal, double distance, const Eigen::Vector3d& along)
        : origin(distance * normal), right(along - normal.dot(along) * normal)
    {
        constexpr double kAlongNormal = 1e-9;
        right = right.norm() > kAlongNormal ? right.normalized() : normal.unitOrthogonal();
        up = normal.cross(right);
    }

    /// Coordinates of a point's foot on the plane.
    Eigen::Vector2d toPlane(const Eigen::Vector3d& point) const
    {
        const Eigen::Vector3d offset = point - origin;
        return {right.dot(offset), up.dot(offset)};
    }

    /// The point of coordinates; never a negative zero, which would print as "-0".
    Eigen::Vector3d toSpace(const Eigen::Vector2d& point) const
    {
        return ((origin + point.x() * right + point.y() * up).array() + 0.0).matrix();
    }
};

}  // namespace planewright
