// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/geometry/axis_strength.h"
#include "core/geometry/pose.h"
#include "core/mapping/uncertain_plane.h"

namespace planewright {

/// A plane that a stop saw and the plane of the map that it is.
struct MatchedPlanes {
    UncertainPlane seen;   ///< in the stop's frame
    UncertainPlane known;  ///< in the map's frame
    /// Where both are compared, in the stop's frame: best the middle of what was seen.
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
};

/// A pose that is known beforehand, as from odometry.
struct PosePrior {
    Pose pose;
    Matrix6d covariance = Matrix6d::Identity();
};

/// How well planes alone fix a stop, the map's planes taken as independent; axes of the map, turns about the stop.
struct PoseStrength {
    AxisStrength shift;  ///< [m], rotation unknown
    AxisStrength turn;   ///< [rad], place unknown
    bool fixesAll() const { return shift.weakestSigma && turn.weakestSigma; }
};

/// The strength that information on a pose's error (θ, τ) amounts to.
PoseStrength poseStrength(const Matrix6d& information);

/// Where a stop stands by its planes.
struct Registration {
    Pose pose;
    Matrix6d covariance = Matrix6d::Zero();   ///< of planes and prior together
    Matrix6d information = Matrix6d::Zero();  ///< of the planes alone
    PoseStrength strength;                    ///< of the planes alone: what they do not fix keeps the prior
    double chiSquare = 0.0;                   ///< of planes and prior; 3 a plane are expected
    double priorChiSquare = 0.0;              ///< of the prior's part: 6 at most are expected
    std::vector<double> pairChiSquares;       ///< of each pair
};

/// The rotation that turns directions into others best, weighted (Kabsch 1976); empty where they are all parallel.
std::optional<Eigen::Quaterniond> bestRotation(std::span<const Eigen::Vector3d> from,
                                               std::span<const Eigen::Vector3d> to, std::span<const double> weights);

/// Rotation and translation from matched planes by maximum likelihood, with the covariances of both sides: Gauss-Newton
/// from a closed-form start. Directions that the planes do not fix keep the prior; without one, where any is not fixed,
/// there is no pose.
std::optional<Registration> registerPlanes(std::span<const MatchedPlanes> pairs, const std::optional<PosePrior>& prior);

}  // namespace planewright
