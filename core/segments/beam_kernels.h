// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace planewright {

/// Scan points of a slice as structure of numbers: the laser's frame in the slice's own plane, u right, v ahead [m].
template <class Number>
struct BeamArraysOf {
    const Number* u = nullptr;
    const Number* v = nullptr;
    const Number* relativeVariance = nullptr;  ///< σ_ρ²/ρ²
};
using BeamArrays = BeamArraysOf<float>;

/// A straight line through a point in the slice's plane, with a unit vector along it.
template <class Number>
struct ChordOf {
    Number u = 0;
    Number v = 0;
    Number directionU = 1;
    Number directionV = 0;
};
using ChordF = ChordOf<float>;

/// What makes a point's deviation from a chord count.
template <class Number>
struct DeviationLimitsOf {
    Number fixedSquared = 0;     ///< smallest squared deviation [m²]
    Number sigmasSquared = 0;    ///< in variances of the point across the chord
    Number bearingVariance = 0;  ///< σ_θ² [rad²]
};
using DeviationLimits = DeviationLimitsOf<float>;

/// Sums over points in the frame of a chord: t along it, h across it [m].
struct ChordSums {
    float weight = 0.0F;
    float t = 0.0F, h = 0.0F;
    float tt = 0.0F, th = 0.0F, hh = 0.0F;
};

/// Range noise as line fits weigh it: σ² = constant² + (proportional ρ)².
struct WeightModel {
    float offset = 0.0F;            ///< distance of the line from the laser [m]
    float foot = 0.0F;              ///< t of the point nearest to the laser [m]
    float constantVariance = 0.0F;  ///< [m²]
    float proportionalVariance = 0.0F;
    float bearingVariance = 0.0F;  ///< [rad²]
};

/// The inner loops over scan points, for one kind of processor.
///
/// All kinds give the same bits: sums run in sixteen lanes that are added up in a fixed order, products and sums are
/// never contracted, and everything else is independent of order.
struct BeamKernels {
    const char* name;

    /// range [m], u and v of every beam, and σ_ρ²/ρ²; all 0 where the range is outside the limits. Gives the number of
    /// beams inside.
    int (*place)(const double* ranges, const float* cosine, const float* sine, int beams, float rangeMin,
                 float rangeMax, float constantVariance, float proportionalVariance, float* range, float* u, float* v,
                 float* relativeVariance);

    /// The same for numbers of double precision.
    int (*placeExactly)(const double* ranges, const double* cosine, const double* sine, int beams, double rangeMin,
                        double rangeMax, double constantVariance, double proportionalVariance, double* range, double* u,
                        double* v, double* relativeVariance);

    /// Marks with 1 each beam whose range is 0, and with 0 each other one.
    void (*markMissing)(const float* range, int beams, std::uint8_t* marks);

    /// Marks with 1 each point i in 1 … count − 1 that is farther from its predecessor than D_o of Eq. (3): gapPerRange
    /// times range, plus `sigmas` standard deviations of a range. Mark 0 is 1.
    void (*markGaps)(const BeamArrays& points, const float* range, int count, float gapPerRange, float sigmas,
                     std::uint8_t* marks);

    /// The same for numbers of double precision, among all beams: a beam without echo (range 0) and the one after it
    /// are marked too.
    void (*markGapsExactly)(const BeamArraysOf<double>& points, const double* range, int count, double gapPerRange,
                            double sigmas, std::uint8_t* marks);

    /// The point of [first, last] with the largest deviation from the chord among those beyond the limits; −1 where
    /// there is none. Fifteen elements of the arrays after `last` are read, here and in the sums.
    int (*farthest)(const BeamArrays& points, int first, int last, const ChordF& chord, const DeviationLimits& limits);

    /// The same for numbers of double precision, with nothing read after `last`.
    int (*farthestExactly)(const BeamArraysOf<double>& points, int first, int last, const ChordOf<double>& chord,
                           const DeviationLimitsOf<double>& limits);

    /// Sums over the points [first, last], each of weight 1.
    ChordSums (*sums)(const BeamArrays& points, int first, int last, const ChordF& chord);

    /// Sums over the points [first, last], each weighed by the inverse of its variance across the chord.
    ChordSums (*weightedSums)(const BeamArrays& points, int first, int last, const ChordF& chord,
                              const WeightModel& model);
};

/// All kinds that this processor can run, the fastest last.
std::span<const BeamKernels> availableBeamKernels();

/// The fastest kind that this processor can run.
const BeamKernels& beamKernels();

}  // namespace planewright
