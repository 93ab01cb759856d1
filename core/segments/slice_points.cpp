// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/slice_points.h"

#include <cassert>

namespace planewright {

void SlicePoints::updateBearings(const ScanSlice& slice)
{
    const std::size_t beams = slice.ranges.size();
    if (cosine_.size() == beams && firstBearing_ == slice.firstBearing && bearingStep_ == slice.bearingStep)
        return;
    firstBearing_ = slice.firstBearing;
    bearingStep_ = slice.bearingStep;
    cosine_.resize(beams);
    sine_.resize(beams);
    for (std::size_t i = 0; i < beams; ++i) {
        cosine_[i] = std::cos(slice.bearing(i));
        sine_[i] = std::sin(slice.bearing(i));
    }
}

void SlicePoints::take(const ScanSlice& slice, const SensorModel& sensor, const NoiseParameters& noise)
{
    updateBearings(slice);
    const std::size_t beams = slice.ranges.size();
    u_.resize(beams);
    v_.resize(beams);
    range_.resize(beams);
    relativeRangeVariance_.resize(beams);
    echo_.resize(beams);
    sums_.resize(beams + 1);
    bearingVariance_ = noise.bearing * noise.bearing;

    Sums sums;
    sums_[0] = sums;
    for (std::size_t i = 0; i < beams; ++i) {
        const double range = slice.ranges[i];
        const bool echo = sensor.hasEcho(range);
        const double u = echo ? range * cosine_[i] : 0.0;
        const double v = echo ? range * sine_[i] : 0.0;
        u_[i] = u;
        v_[i] = v;
        range_[i] = echo ? range : 0.0;
        relativeRangeVariance_[i] = echo ? noise.rangeVariance(range) / (range * range) : 0.0;
        echo_[i] = echo ? 1 : 0;
        sums.count += echo ? 1 : 0;
        sums.u += u;
        sums.v += v;
        sums.uu += u * u;
        sums.uv += u * v;
        sums.vv += v * v;
        sums_[i + 1] = sums;
    }
}

SliceLine SlicePoints::lineThrough(const PointRun& run) const
{
    const Sums& before = sums_[at(run.first)];
    const Sums& after = sums_[at(run.last) + 1];
    SliceLine line;
    line.points = after.count - before.count;
    assert(line.points >= 2);
    const double n = line.points;
    const double u = (after.u - before.u) / n;
    const double v = (after.v - before.v) / n;
    line.centroid = {u, v};
    const double uu = (after.uu - before.uu) / n - u * u;
    const double uv = (after.uv - before.uv) / n - u * v;
    const double vv = (after.vv - before.vv) / n - v * v;
    // Larger eigenvalue of [uu uv; uv vv] and its eigenvector, by the half angle.
    const double half = 0.5 * (uu - vv);
    const double root = std::hypot(half, uv);
    const double angle = 0.5 * std::atan2(uv, half);
    line.direction = {std::cos(angle), std::sin(angle)};
    line.variance = std::max(0.0, 0.5 * (uu + vv) - root);
    return line;
}

}  // namespace planewright
