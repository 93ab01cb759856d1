// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <Eigen/Eigenvalues>

#include "core/segments/slice_trace.h"
#include "core/types/snapshot.h"
#include "tests/core/pipeline/likelihood_twin.h"
#include "tests/core/pipeline/neighbour_slices.h"

namespace planewright {

/// Largest variance of a plane's normal, by the noise alone.
inline double angleVarianceOf(const Plane& plane)
{
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(ownCovariance(plane).topLeftCorner<2, 2>()).eigenvalues()[1];
}

/// What a step left behind, as somebody sees it who knows no more than the snapshot and the slices.
struct PreciseTwin {
    const Snapshot& now;
    Parameters parameters;
    NeighbourSlices neighbours;

    PreciseTwin(const Snapshot& snapshot, const Recording& recording, const Parameters& all)
        : now(snapshot), parameters(withNoise(all, snapshot.noise)), neighbours(recording, snapshot.segments)
    {
    }

    /// Whether a segment of a plane is within three beams in the slices around.
    bool faces(const LineSegment& s, const Plane& plane, bool withItself) const
    {
        return std::any_of(plane.segments.begin(), plane.segments.end(), [&](const SegmentId& id) {
            return (withItself || id != s.id) && neighbours.isBeside(s, now.segments[id], 3);
        });
    }

    JoinTwin join(const LineSegment& s, const Plane& plane, double shareOfFloor) const
    {
        return {s, plane, now.noise, shareOfFloor * parameters.flatnessFloor()};
    }

    /// How a segment fits the planes that it faces, its own among them.
    std::vector<JoinTwin> facing(const LineSegment& s) const
    {
        std::vector<JoinTwin> fits;
        for (const auto& plane : now.planes) {
            if (faces(s, *plane, true) && steepnessOf(s, plane->normal) > 2.8e-3)
                fits.push_back(join(s, *plane, 1.0));
        }
        return fits;
    }

    /// By how many slices the nearest segment of a plane is away.
    double slicesAway(const LineSegment& s, const Plane& plane) const
    {
        int least = std::numeric_limits<int>::max();
        for (const SegmentId& id : plane.segments)
            least = std::min(least, std::abs(neighbours.placeOf(now.segments[id]) - neighbours.placeOf(s)));
        return least;
    }

    /// Standard deviation of where a plane is at a point.
    static double sigmaAt(const Eigen::Vector3d& point, const Plane& plane)
    {
        Eigen::Vector3d lever;
        lever << plane.tangents.transpose() * point, -1.0;
        return std::sqrt(lever.dot(ownCovariance(plane) * lever));
    }

    /// What a segment tells of its own place, with its slice's pitch and half the floor.
    double ownSigma(const LineSegment& s) const
    {
        const Eigen::Vector3d ray = s.moments.mean - s.viewpoint;
        const double ofPoint =
            parameters.noise.rangeVariance(ray.norm()) + std::pow(parameters.noise.bearing, 2) * ray.squaredNorm();
        return std::sqrt(std::max(s.placeSigma * s.placeSigma, ofPoint / s.points) +
                         std::pow(0.5 * parameters.flatnessFloor(), 2) +
                         std::pow(parameters.noise.pitch, 2) * s.moments.mean.squaredNorm());
    }
};

}  // namespace planewright
