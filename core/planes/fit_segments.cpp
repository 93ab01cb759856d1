// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/fit_segments.h"

#include <cmath>

#include <Eigen/Geometry>

#include "core/planes/track_publishing.h"

namespace planewright {

namespace {

/// Sine of the angle at which rays must meet a plane at least; a slice's own plane is none.
constexpr double kGrazing = 0.02;
/// χ² of segments, in those that a plane of them may have, beyond which linearising it anew does not help.
constexpr double kHopeless = 4.0;

}  // namespace

bool fitSegments(std::span<const SegmentNumber> numbers, const TrackMap& map, const Parameters& parameters,
                 double floor, PlaneEstimate& estimate)
{
    const SegmentNumber a = numbers.front();
    const SegmentNumber c = numbers.back();
    const Eigen::Vector3d along = directionOf(a, map);
    Eigen::Vector3d across = map.centroid(c) - map.centroid(a);
    const Eigen::Vector3d normal = along.cross(across);
    const double length = normal.norm();
    const Eigen::Vector3d ray = map.centroid(c) - map.slice(map.segment(c).slice).frame.origin;
    if (!(length > 1e-3 * across.norm()) || std::abs(normal.dot(ray)) < kGrazing * length * ray.norm())
        return false;
    estimate = PlaneEstimate(normal / length, normal.dot(map.centroid(a)) / length);
    for (int round = 0; round < 2; ++round) {
        if (round > 0)
            estimate = PlaneEstimate(estimate.normal(), estimate.distance());
        for (const SegmentNumber number : numbers) {
            const TrackedSegment& s = map.segment(number);
            const SegmentStatistics* one = &s.statistics;
            estimate.accumulate(estimate.inSlice(map.slice(s.slice).frame), std::span{&one, 1}, parameters.noise, floor,
                                1.0);
        }
        if (!estimate.solve() || estimate.chi() > kHopeless * parameters.likelihood.seedGate)
            return false;
        if (estimate.angleFromLinearisation() < 0.02)
            break;
    }
    return true;
}

}  // namespace planewright
