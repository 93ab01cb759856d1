// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/pitch_noise.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace planewright {

namespace {

/// What was told counts like so many slices.
constexpr double kToldSlices = 8.0;
/// The estimate is at least and at most so many times what was told.
constexpr double kLeastShare = 0.5;
constexpr double kMostShare = 2.0;
/// Planes of fewer slices follow each of them too closely.
constexpr int kLeastSlices = 8;
/// Planes whose normal is known less well [rad] tell nothing.
constexpr double kKnownAngle = 0.01;
/// No slice counts as farther off than so many standard deviations.
constexpr double kFarthestSigmas = 4.0;

}  // namespace

void PitchNoise::collect(SegmentNumber first, SegmentNumber end, TrackMap& map, const NoiseParameters& noise,
                         double floor)
{
    evidences_.assign(static_cast<std::size_t>(end - first), {});
    for (const PlaneTrack& plane : map.planes()) {
        if (plane.slices < kLeastSlices || plane.estimate.normalVariance() > kKnownAngle * kKnownAngle)
            continue;
        const auto from = std::lower_bound(plane.members.begin(), plane.members.end(), first);
        const std::span numbers(from, std::lower_bound(from, plane.members.end(), end));
        ofPlane_.resize(numbers.size());
        plane.estimate.pitchEvidences(map.together(numbers), noise, floor, ofPlane_);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            evidences_[static_cast<std::size_t>(numbers[i] - first)] = ofPlane_[i];
    }
}

void PitchNoise::add(TrackMap& map, int end, const NoiseParameters& noise, double floor)
{
    if (next_ >= end)
        return;
    const SegmentNumber first = map.slice(next_).first;
    collect(first, map.slice(end - 1).end, map, noise, floor);
    for (; next_ < end; ++next_) {
        const TrackedSlice& slice = map.slice(next_);
        PitchEvidence evidence;
        for (SegmentNumber number = slice.first; number < slice.end; ++number) {
            const PitchEvidence& one = evidences_[static_cast<std::size_t>(number - first)];
            evidence.information += one.information;
            evidence.gradient += one.gradient;
        }
        // What changes slowly from slice to slice is no noise of the pitch but the walls' or the scanner's own form.
        const bool tells = evidence.information * noise.pitch * noise.pitch > 1.0;
        const double error = tells ? evidence.gradient / evidence.information : 0.0;
        const double variance = tells ? 1.0 / evidence.information : 0.0;
        if (tells && lastTells_) {
            const double sigma = estimate(noise.pitch);
            const double apart = std::min(std::abs(error - lastError_), kFarthestSigmas * std::sqrt(2.0) * sigma);
            squaredErrors_ += 0.5 * (apart * apart - variance - lastVariance_);
            ++slices_;
        }
        lastTells_ = tells;
        lastError_ = error;
        lastVariance_ = variance;
    }
}

double PitchNoise::estimate(double told) const
{
    const double variance = (kToldSlices * told * told + squaredErrors_) / (kToldSlices + slices_);
    return std::sqrt(
        std::clamp(variance, kLeastShare * kLeastShare * told * told, kMostShare * kMostShare * told * told));
}

}  // namespace planewright
