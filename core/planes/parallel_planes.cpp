// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/parallel_planes.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace planewright {

namespace {

/// χ² (2 degrees of freedom) up to which a plane counts as parallel to another: 99 %.
constexpr double kSameDirection = 9.2;

}  // namespace

double parallelChi(const PlaneEstimate& estimate, const TrackMap& map, double knownAngle, double parallelAngle,
                   std::initializer_list<PlaneId> except)
{
    double least = kNoParallel;
    for (const PlaneTrack& plane : map.planes()) {
        const double variance = plane.estimate.normalVariance();
        if (plane.ofPair || std::ranges::find(except, plane.id) != except.end() || variance >= knownAngle * knownAngle)
            continue;
        const double side = std::copysign(1.0, plane.estimate.normal().dot(estimate.normal()));
        const Eigen::Vector2d apart =
            estimate.tangents().transpose() * (side * plane.estimate.normal() - estimate.normal());
        const Eigen::Matrix2d covariance = estimate.covariance().topLeftCorner<2, 2>() +
                                           (variance + parallelAngle * parallelAngle) * Eigen::Matrix2d::Identity();
        least = std::min(least, apart.dot(covariance.inverse() * apart));
    }
    return least;
}

bool isSurelyParallel(const PlaneEstimate& estimate, const TrackMap& map, std::initializer_list<PlaneId> except)
{
    return parallelChi(estimate, map, kSurelyParallel, kSurelyParallel, except) < kSameDirection;
}

}  // namespace planewright
