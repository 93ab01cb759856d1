// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose.h"
#include "core/mapping/uncertain_plane.h"

namespace planewright {

/// A plane of the map that a stop's plane may be, compared at the pose that is expected.
struct MatchCandidate {
    std::size_t known = 0;                            ///< the caller's number of the map's plane
    Eigen::Vector3d apart = Eigen::Vector3d::Zero();  ///< `difference` from the stop's plane to it
    Eigen::Matrix3d noise = Eigen::Matrix3d::Zero();  ///< covariance of that, the pose taken as known
};

/// A stop's plane with all that it may be.
struct MatchChoices {
    Matrix3x6d jacobian = Matrix3x6d::Zero();  ///< of `apart` by the pose's error
    std::vector<MatchCandidate> candidates;
    std::vector<std::size_t> others;  ///< planes of the stop that are surely not the same one, by their places
};

/// What the search may do.
struct MatchLimits {
    double gate = 16.27;       ///< χ² of one pair, given those before it: 99.9 % of 3 degrees of freedom
    double rivalMargin = 9.0;  ///< what fits worse by less than this much χ² is a rival
    int mostNodes = 500;       ///< of the search; the order in which they are visited is fixed
};

/// The pairs that fit together and have the most planes of the map in them; of equally many, those with the least χ²
/// beyond what is expected.
struct JointMatch {
    std::vector<std::optional<std::size_t>> chosen;  ///< for each plane of the stop: its candidate by place, or none
    std::vector<std::vector<std::size_t>> rivals;    ///< candidates that would fit as well
    std::vector<bool> isContested;                   ///< what was chosen may as well be another plane of the stop
    /// For each pair, how far off the plane would have been looked for without it, by the other pairs and the expected
    /// pose: standard deviation along its normal [m]. Where that is large, any plane about there would have fitted.
    std::vector<double> looseness;
    int pairs = 0;                           ///< planes of the map that are in it
    double chiSquare = 0.0;                  ///< joint, 3 expected of each plane of the stop
    Vector6d error = Vector6d::Zero();       ///< of the expected pose, as the pairs tell
    Matrix6d covariance = Matrix6d::Zero();  ///< of the pose with the pairs
    bool cutShort = false;                   ///< the search met its limit: more pairs may fit
};

/// Joint compatibility branch and bound (Neira and Tardós 2001): pairs are accepted together or not at all, each tested
/// with the pose that those before it leave, which sums up to the joint Mahalanobis distance. Planes with the fewest
/// candidates come first; candidates that the pose so far rules out are struck out at every step.
///
/// Several planes of a stop may be one plane of the map, which counts once: an extraction may have found it in parts.
/// Those that are `others` of each other may not.
JointMatch matchJointly(std::span<const MatchChoices> planes, const Matrix6d& poseCovariance,
                        const MatchLimits& limits = {});

}  // namespace planewright
