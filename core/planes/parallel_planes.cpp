// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/parallel_planes.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace planewright {

double parallelChi(const PlaneEstimate& estimate, const TrackMap& map, double knownAngle, double parallelAngle,
                   PlaneId except)
{
    double least = kNoParallel;
    for (const PlaneTrack& plane : map.planes()) {
        const double variance = plane.estimate.normalVariance();
        if (plane.ofPair || plane.id == except || variance >= knownAngle * knownAngle)
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

}  // namespace planewright
