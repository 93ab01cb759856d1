// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/slice_points.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace planewright {

void SlicePoints::take(const ScanSlice& slice, const SensorModel& sensor, const NoiseParameters& noise)
{
    tables_.select(slice);
    const BearingTables<double>::Table& table = tables_.current();
    const std::size_t beams = slice.ranges.size();
    u_.resize(beams);
    v_.resize(beams);
    range_.resize(beams);
    relativeRangeVariance_.resize(beams);
    sums_.resize(beams + 1);
    bearingVariance_ = noise.bearing * noise.bearing;
    const double constant = noise.rangeConstant * noise.rangeConstant;
    const double proportional = noise.rangeProportional * noise.rangeProportional;
    // A range of zero is no echo, whatever the limits are.
    const double rangeMin = std::max(sensor.rangeMin, std::numeric_limits<double>::min());
    beamKernels().placeExactly(slice.ranges.data(), table.cosine.data(), table.sine.data(), static_cast<int>(beams),
                               rangeMin, sensor.rangeMax, constant, proportional, range_.data(), u_.data(), v_.data(),
                               relativeRangeVariance_.data());

    Sums sums;
    sums_[0] = sums;
    for (std::size_t i = 0; i < beams; ++i) {
        const double u = u_[i];
        const double v = v_[i];
        sums.count += range_[i] > 0.0 ? 1 : 0;
        sums.u += u;
        sums.v += v;
        sums.uu += u * u;
        sums.uv += u * v;
        sums.vv += v * v;
        sums_[i + 1] = sums;
    }
}

SliceMoments SlicePoints::momentsOf(const PointRun& run) const
{
    const Sums& before = sums_[at(run.first)];
    const Sums& after = sums_[at(run.last) + 1];
    SliceMoments moments;
    moments.points = after.count - before.count;
    assert(moments.points >= 1);
    const double n = moments.points;
    const double u = (after.u - before.u) / n;
    const double v = (after.v - before.v) / n;
    moments.centroid = {u, v};
    const double uv = (after.uv - before.uv) / n - u * v;
    moments.covariance << (after.uu - before.uu) / n - u * u, uv, uv, (after.vv - before.vv) / n - v * v;
    return moments;
}

SliceLine SlicePoints::lineThrough(const PointRun& run) const
{
    const SliceMoments moments = momentsOf(run);
    SliceLine line;
    line.points = moments.points;
    line.centroid = moments.centroid;
    // Larger eigenvalue of [uu uv; uv vv] and its eigenvector, by the half angle: cos 2α = half/root, sin 2α = uv/root.
    const double uv = moments.covariance(0, 1);
    const double half = 0.5 * (moments.covariance(0, 0) - moments.covariance(1, 1));
    const double root = std::sqrt(half * half + uv * uv);
    if (root > 0.0) {
        const double larger = std::sqrt(0.5 * (1.0 + std::abs(half) / root));
        const double smaller = 0.5 * std::abs(uv) / (root * larger);
        const double side = uv < 0.0 ? -1.0 : 1.0;
        line.direction =
            half >= 0.0 ? Eigen::Vector2d{larger, side * smaller} : Eigen::Vector2d{smaller, side * larger};
    }
    line.variance = std::max(0.0, 0.5 * moments.covariance.trace() - root);
    return line;
}

}  // namespace planewright
