// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "core/types/plane.h"

namespace planewright {

/// How well planes tell where the scanner stands.
///
/// A plane whose distance is known to σ_d fixes the scanner along its normal, and nothing across it: together they
/// give Σ n nᵀ/σ_d² of information on a shift of the scanner (Appendix B). Directions are taken as known.
struct AxisStrength {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of a shift along x, y and z [1/m²]
    /// Standard deviation of a shift along x, y and z, the other two unknown [m]; empty where no plane tells.
    std::array<std::optional<double>, 3> sigma;
    Eigen::Vector3d weakest = Eigen::Vector3d::Zero();  ///< the direction that is known worst, unit length, z ≥ 0
    std::optional<double> weakestSigma;                 ///< of a shift along it [m]; empty where no plane tells
};

/// Of what is known of a shift [1/m²], or of a turn [1/rad²] about the axes: symmetric, none of it below zero.
AxisStrength strengthOf(const Eigen::Matrix3d& information);

/// Of planes with a covariance; those without one tell nothing here.
AxisStrength axisStrength(std::span<const std::shared_ptr<const Plane>> planes);

}  // namespace planewright
