// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "core/evaluation/plane_errors.h"
#include "core/types/angle.h"
#include "core/types/error.h"

namespace planewright {

/// How far two planes may be apart and still match.
struct PlaneMatchLimits {
    double angle = degrees(5.0);  ///< [rad]
    double distance = 0.1;        ///< [m]
};

/// A plane of A and the plane of B that it matched.
struct PlaneMatch {
    int a = 0;  ///< id in A
    int b = 0;  ///< id in B
    PlaneDifference difference;
};

/// Which planes of two results are the same.
struct PlaneComparison {
    std::vector<PlaneMatch> matches;  ///< in the order of B
    std::vector<int> unmatchedA;      ///< ids, in the order of A
    std::vector<int> unmatchedB;      ///< ids, in the order of B
    PlaneErrors errors;
};

/// Matches planes by their parameters alone: the pair nearest in angle first (then in distance, then in order), each
/// plane used once, both limits inclusive. Errors (Usage): more than kMaxComparedPlanes planes, or more pairs within
/// the limits than memory should hold.
Result<PlaneComparison> comparePlanes(std::span<const ComparedPlane> a, std::span<const ComparedPlane> b,
                                      const PlaneMatchLimits& limits);

}  // namespace planewright
