// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/params/parameters.h"
#include "core/types/plane.h"
#include "core/types/recording.h"
#include "core/types/snapshot.h"

namespace planewright {

/// What an extraction made of a whole recording.
struct Extracted {
    Recording recording;
    std::shared_ptr<const Snapshot> found;
};

/// Which slices of a recording are taken.
enum class Slices { All, Even, Odd };

/// Extracts the planes of some of a recording's slices, which keep their step numbers.
Extracted extractFrom(const Recording& recording, Slices slices, const Parameters& parameters);

/// A plane that two extractions found, and how far it moved from one to the other.
struct RepeatedPlane {
    std::shared_ptr<const Plane> first;
    std::shared_ptr<const Plane> second;
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();       ///< angles along the first's tangents [rad], and d [m]
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of `moved`
    double squared = 0.0;                                  ///< moved' covariance⁻¹ moved: 3 is expected

    double angle() const { return moved.head<2>().norm(); }
    /// Root of the larger variance of the angles [rad].
    double angleSigma() const;
};

/// How the covariance of a difference follows from those of both planes.
enum class Share {
    Nothing,  ///< the two were made of other slices: variances add up
    Half      ///< the first's slices are among the second's: what the second knows more is the difference
};

/// How far a plane moved from one estimate to the other, in the first's tangents; nothing where the covariance of the
/// difference is not positive.
std::optional<RepeatedPlane> movedBetween(std::shared_ptr<const Plane> first, std::shared_ptr<const Plane> second,
                                          Share share);

/// What two extractions have in common.
struct Repetition {
    std::vector<RepeatedPlane> planes;
    int withoutCovariance = 0;  ///< pairs left out because the covariance of their difference is not positive
};

/// The planes of two extractions that are one: regions of neighbouring slices that share so much of either, and
/// planes of the first of at least so many points.
Repetition repeatedPlanes(const Extracted& first, const Extracted& second, Share share, double overlap, int minPoints);

}  // namespace planewright
