// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/range_noise.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "core/types/square.h"

namespace planewright {

namespace {

/// Samples of a slice while little is known, how many are much, and samples of a slice from then on.
constexpr std::size_t kFirstSamples = 192;
constexpr std::int64_t kMuch = 2048;
constexpr std::size_t kLaterSamples = 32;
/// What was told counts like so many samples, at each of two ranges [m].
constexpr double kToldSamples = 24.0;
constexpr std::array kToldRanges{2.0, 8.0};
/// A sample where the bearing noise adds more than this share of the told variance tells nothing of the range noise.
constexpr double kBearingShare = 0.25;
/// However little noise is told, samples are taken as if it were so many times the range.
constexpr double kLeastTold = 1e-4;
/// The median of a normal deviate's size, in standard deviations.
constexpr double kMedianSize = 0.6745;
/// Sizes beyond so many standard deviations are edges.
constexpr double kEdgeSigmas = 3.5;
constexpr int kEdgeRounds = 4;
/// The parts of the noise are at least this share of what was told, where ranges err by themselves.
constexpr double kLeastShare = 0.0625;
/// The law of the noise is fitted so many times, and is weighed by itself.
constexpr int kLawRounds = 4;
constexpr double kSmallestVariance = 1e-12;  // [m²]

constexpr int kLowestRange = -4;  // 1/16 m
constexpr int kLowestSize = -16;

constexpr int kBias = 127;  // of a float's exponent

/// Eighths of an octave above 2^lowest, by the leading bits of a float.
std::size_t eighthsAbove(float x, int lowest, std::size_t count)
{
    const int eighths = static_cast<int>(std::bit_cast<std::uint32_t>(x) >> 20U) - 8 * (kBias + lowest);
    return static_cast<std::size_t>(std::clamp(eighths, 0, static_cast<int>(count) - 1));
}

/// The same in whole octaves.
std::size_t octaveAbove(float x, int lowest, std::size_t count)
{
    const int octaves = static_cast<int>(std::bit_cast<std::uint32_t>(x) >> 23U) - (kBias + lowest);
    return static_cast<std::size_t>(std::clamp(octaves, 0, static_cast<int>(count) - 1));
}

double eighth(std::size_t i)
{
    return std::ldexp(1.0 + static_cast<double>(i % 8) / 8.0, kLowestSize + static_cast<int>(i / 8));
}

/// What some samples at a squared range [m²] tell of the variance there [m²].
struct VarianceAtRange {
    double samples;
    double squaredRange;
    double variance;
    double least;  ///< as which it is weighed at least [m²]
};

/// σ² = constant + proportional ρ².
struct VarianceLaw {
    double constant;      // [m²]
    double proportional;  // [m² per m²]
};

/// Least squares for the law, no part of it below the lowest. The variance of a variance that n samples tell is in
/// proportion to its square over n; which square is told by the law found before.
VarianceLaw lawOf(std::span<const VarianceAtRange> evidence, const VarianceLaw& before, const VarianceLaw& lowest)
{
    double sum = 0.0;
    double sumR = 0.0;
    double sumRr = 0.0;
    double sumS = 0.0;
    double sumRs = 0.0;
    for (const auto& [samples, r, s, least] : evidence) {
        const double weight = samples / square(std::max(least, before.constant + before.proportional * r));
        sum += weight;
        sumR += weight * r;
        sumRr += weight * r * r;
        sumS += weight * s;
        sumRs += weight * r * s;
    }
    double proportional = (sum * sumRs - sumR * sumS) / (sum * sumRr - sumR * sumR);
    double constant = (sumS - proportional * sumR) / sum;
    if (proportional < lowest.proportional) {
        proportional = lowest.proportional;
        constant = (sumS - proportional * sumR) / sum;
    } else if (constant < lowest.constant) {
        constant = lowest.constant;
        proportional = (sumRs - constant * sumR) / sumRr;
    }
    return {std::max(constant, lowest.constant), std::max(proportional, lowest.proportional)};
}

}  // namespace

void RangeNoise::add(const ScanSlice& slice, const SensorModel& sensor, const NoiseParameters& told)
{
    const std::size_t beams = slice.ranges.size();
    const std::size_t wanted = samples_ < kMuch ? kFirstSamples : kLaterSamples;
    const std::size_t stride = std::max<std::size_t>(1, beams / wanted);
    const double nearest = std::max(1e-3, sensor.rangeMin);
    const double farthest = sensor.rangeMax;
    const double cosine = 2.0 * std::cos(slice.bearingStep);
    const double perBeam = square(0.5 * told.bearing / slice.bearingStep);
    const double root = std::sqrt(6.0);
    std::int64_t taken = 0;
    for (std::size_t i = 1 + slices_++ * 7 % stride; i + 1 < beams; i += stride) {
        const double before = slice.ranges[i - 1];
        const double range = slice.ranges[i];
        const double after = slice.ranges[i + 1];
        // One question, not four: which of them fails is anyone's guess.
        const double least = std::min(std::min(before, range), after);
        const double most = std::max(std::max(before, range), after);
        if (!((least >= nearest) & (most <= farthest) &
              (square(after - before) * perBeam <=
               kBearingShare * std::max(told.rangeVariance(range), square(kLeastTold * range)))))
            continue;
        const double residual = range * (range * (before + after) / (before * after) - cosine) / root;
        Octave& octave = octaves_[octaveAbove(static_cast<float>(range), kLowestRange, kRanges)];
        ++octave.counts[eighthsAbove(static_cast<float>(std::abs(residual)), kLowestSize, kSizes)];
        ++octave.samples;
        octave.squaredRanges += range * range;
        ++taken;
    }
    samples_ += taken;
}

/// Standard deviation [m] by the median of the sizes that are no edges.
double RangeNoise::sigmaOf(const Octave& octave)
{
    std::array<std::uint32_t, kSizes + 1> below{};  // samples of smaller size
    for (std::size_t i = 0; i < kSizes; ++i)
        below[i + 1] = below[i] + octave.counts[i];
    double sigma = 0.0;
    std::uint32_t counted = below[kSizes];
    std::size_t i = kSizes - 1;
    for (int round = 0; round < kEdgeRounds; ++round) {
        if (round > 0)
            counted = below[eighthsAbove(static_cast<float>(kEdgeSigmas * sigma), kLowestSize, kSizes) + 1];
        // The first size up to which half of them are: it does not grow from round to round.
        const double half = 0.5 * counted;
        while (i > 0 && below[i] >= half)
            --i;
        const double share = octave.counts[i] > 0 ? (half - below[i]) / octave.counts[i] : 0.0;
        sigma = (eighth(i) + share * (eighth(i + 1) - eighth(i))) / kMedianSize;
    }
    return sigma;
}

NoiseParameters RangeNoise::estimate(const NoiseParameters& told) const
{
    std::array<VarianceAtRange, kRanges + kToldRanges.size()> evidence;
    std::size_t count = 0;
    for (const double range : kToldRanges) {
        // Weighed by itself where the scanner is better, so that it fades there as well.
        const double variance = std::max(kSmallestVariance, told.rangeVariance(range));
        evidence[count++] = {kToldSamples, range * range, variance, variance};
    }
    for (const Octave& octave : octaves_) {
        const auto samples = static_cast<double>(octave.samples);
        if (octave.samples > 0)
            evidence[count++] = {samples, octave.squaredRanges / samples, square(sigmaOf(octave)), kSmallestVariance};
    }
    const double leastShare = square(told.systematic > 0.0 ? 1.0 : kLeastShare);
    const VarianceLaw least{leastShare * square(told.rangeConstant), leastShare * square(told.rangeProportional)};
    VarianceLaw law{square(told.rangeConstant), square(told.rangeProportional)};
    // Where ranges err together this residual sees too little, most of all nearby: what was told tells what counts.
    const int rounds = told.systematic > 0.0 ? 1 : kLawRounds;
    for (int round = 0; round < rounds; ++round)
        law = lawOf(std::span(evidence).first(count), law, least);
    NoiseParameters found = told;
    found.rangeConstant = std::sqrt(law.constant);
    found.rangeProportional = std::sqrt(law.proportional);
    return found;
}

double RangeNoise::share(const NoiseParameters& found, const NoiseParameters& told) const
{
    double varianceFound = 0.0;
    double varianceTold = 0.0;
    for (const Octave& octave : octaves_) {
        if (octave.samples == 0)
            continue;
        const auto samples = static_cast<double>(octave.samples);
        const double range = std::sqrt(octave.squaredRanges / samples);
        varianceFound += samples * found.rangeVariance(range);
        varianceTold += samples * told.rangeVariance(range);
    }
    return varianceTold > 0.0 ? std::sqrt(varianceFound / varianceTold) : 1.0;
}

}  // namespace planewright
