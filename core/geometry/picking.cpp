// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/picking.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace planewright {

// Möller and Trumbore (1997).
std::optional<double> hit(const Ray& ray, const Triangle& triangle)
{
    constexpr double kParallel = 1e-12;
    const Eigen::Vector3d first = triangle[1] - triangle[0];
    const Eigen::Vector3d second = triangle[2] - triangle[0];
    const Eigen::Vector3d across = ray.direction.cross(second);
    const double volume = first.dot(across);
    if (std::abs(volume) < kParallel)
        return std::nullopt;
    const Eigen::Vector3d offset = ray.origin - triangle[0];
    const double u = offset.dot(across) / volume;
    const Eigen::Vector3d turned = offset.cross(first);
    const double v = ray.direction.dot(turned) / volume;
    if (u < 0.0 || v < 0.0 || u + v > 1.0)
        return std::nullopt;
    const double along = second.dot(turned) / volume;
    if (along <= 0.0)
        return std::nullopt;
    return along;
}

std::optional<Passing> pass(const Ray& ray, const Eigen::Vector3d& point)
{
    const double along = ray.direction.dot(point - ray.origin);
    if (along <= 0.0)
        return std::nullopt;
    return Passing{along, (point - ray.at(along)).norm()};
}

std::optional<Passing> pass(const Ray& ray, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
    const Eigen::Vector3d line = to - from;
    const Eigen::Vector3d offset = from - ray.origin;
    // The part of the line across the ray decides where they come nearest.
    const Eigen::Vector3d lineAcross = line - ray.direction.dot(line) * ray.direction;
    const Eigen::Vector3d offsetAcross = offset - ray.direction.dot(offset) * ray.direction;
    const double length = lineAcross.squaredNorm();
    const double place = length > 0.0 ? std::clamp(-offsetAcross.dot(lineAcross) / length, 0.0, 1.0) : 0.0;
    return pass(ray, from + place * line);
}

}  // namespace planewright
