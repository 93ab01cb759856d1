// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/geometry/triangulate.h"

namespace planewright {

/// A line of sight: from a place [m] in a direction of unit length.
struct Ray {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction = Eigen::Vector3d::UnitY();

    Eigen::Vector3d at(double distance) const { return origin + distance * direction; }
};

/// How far along a ray it meets a triangle, from either side [m]. None where it passes by, or runs within 1e-12 of
/// parallel to it.
std::optional<double> hit(const Ray& ray, const Triangle& triangle);

/// How a ray passes something thin.
struct Passing {
    double along = 0.0;  ///< along the ray to the place nearest to it [m]
    double aside = 0.0;  ///< from there to the ray [m]

    /// What the distance looks like from the ray's origin: a ratio, or metres where `parallel`.
    double seen(bool parallel) const { return parallel ? aside : aside / along; }
};

/// How a ray passes a point; none where that lies behind its origin.
std::optional<Passing> pass(const Ray& ray, const Eigen::Vector3d& point);

/// How a ray passes a line segment at the place where they come nearest; none where that lies behind its origin.
std::optional<Passing> pass(const Ray& ray, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace planewright
