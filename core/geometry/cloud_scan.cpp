// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/cloud_scan.h"

#include <Eigen/Geometry>

namespace planewright {

namespace {

constexpr double kLeapCosine = 0.70710678118654752;  // of 45°
/// A step back by less than this [rad] is how the numbers of a file are rounded.
constexpr double kRoundedStep = 1e-6;

}  // namespace

std::vector<CloudSlice> splitSweeps(std::span<const Eigen::Vector3f> points)
{
    std::vector<CloudSlice> slices;
    Eigen::Vector3d before = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // Σ of the steps so far: at a right angle to the sweep
    for (const Eigen::Vector3f& point : points) {
        const Eigen::Vector3d ray = point.cast<double>().normalized();
        const Eigen::Vector3d turn = before.cross(ray);
        const bool isBack = !normal.isZero(0.0) && turn.dot(normal) < -kRoundedStep * normal.norm();
        if (slices.empty() || isBack || before.dot(ray) < kLeapCosine) {
            slices.emplace_back();
            normal.setZero();
        } else {
            normal += turn;
        }
        slices.back().push_back({point, 0});
        before = ray;
    }
    return slices;
}

}  // namespace planewright
