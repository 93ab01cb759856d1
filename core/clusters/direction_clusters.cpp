// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/clusters/direction_clusters.h"

#include <cmath>

namespace planewright {

Eigen::Vector3d movedAverage(const Eigen::Vector3d& mean, int count, const Eigen::Vector3d& direction,
                             const ClusterParameters& parameters)
{
    const Eigen::Vector3d turned = mean.dot(direction) < 0.0 ? Eigen::Vector3d{-direction} : direction;
    const double n = count;
    switch (parameters.average) {
        case MovingAverage::Simple:  // Eq. (10)
            return (n * mean + turned) / (n + 1.0);
        case MovingAverage::LinearlyWeighted:  // Eq. (11): weights 1, 2, … N, N + 1, whose sum is (N + 1)(N + 2)/2
            return (n * (n + 1.0) / 2.0 * mean + (n + 1.0) * turned) / ((n + 1.0) * (n + 2.0) / 2.0);
        case MovingAverage::ExponentiallyWeighted:  // Eq. (12)
            return parameters.decay * turned + (1.0 - parameters.decay) * mean;
    }
    return mean;
}

DirectionClusters::Joined DirectionClusters::add(SegmentNumber segment, const Eigen::Vector3d& direction,
                                                 const ClusterParameters& parameters)
{
    Joined joined;
    GrowingCluster* nearest = nullptr;
    for (GrowingCluster& cluster : clusters_) {
        const double similarity = std::abs(direction.dot(cluster.direction));
        if (similarity > joined.similarity) {
            joined.similarity = similarity;
            nearest = &cluster;
        }
    }
    if (nearest == nullptr || joined.similarity <= std::cos(parameters.directionLimit)) {
        clusters_.push_back({next_++, direction, direction, {}, nullptr});
        nearest = &clusters_.back();
        joined.founded = true;
    } else {
        const auto count = static_cast<int>(nearest->members.size());
        nearest->mean = movedAverage(nearest->mean, count, direction, parameters);
        nearest->direction = nearest->mean.normalized();
    }
    nearest->members.push_back({segment, false});
    nearest->published = nullptr;
    joined.cluster = nearest->id;
    return joined;
}

}  // namespace planewright
