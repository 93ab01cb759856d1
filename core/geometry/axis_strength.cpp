// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/axis_strength.h"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace planewright {

namespace {

/// A direction counts as unknown where it is known a million times worse than the best: planes that differ by less than
/// a thousandth of a radian from parallel tell nothing of what lies along them.
constexpr double kLeastShare = 1e-6;

}  // namespace

AxisStrength axisStrength(std::span<const std::shared_ptr<const Plane>> planes)
{
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    for (const auto& plane : planes) {
        const double variance = plane->covariance(2, 2);
        if (variance > 0.0 && std::isfinite(variance))
            information += plane->normal * plane->normal.transpose() / variance;
    }
    return strengthOf(information);
}

AxisStrength strengthOf(const Eigen::Matrix3d& information)
{
    AxisStrength strength;
    strength.information = information;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved{strength.information};
    const Eigen::Vector3d known = solved.eigenvalues();
    const auto isKnown = [&](int which) { return known[which] > 0.0 && known[which] > kLeastShare * known[2]; };

    strength.weakest = solved.eigenvectors().col(0);
    if (strength.weakest.z() < 0.0)
        strength.weakest = -strength.weakest;
    if (isKnown(0))
        strength.weakestSigma = 1.0 / std::sqrt(known[0]);
    for (int axis = 0; axis < 3; ++axis) {
        double variance = 0.0;
        bool told = true;
        for (int which = 0; which < 3; ++which) {
            const double share = std::pow(solved.eigenvectors()(axis, which), 2);
            if (isKnown(which))
                variance += share / known[which];
            else
                told = told && share < kLeastShare;
        }
        if (told)
            strength.sigma[static_cast<std::size_t>(axis)] = std::sqrt(variance);
    }
    return strength;
}

}  // namespace planewright
