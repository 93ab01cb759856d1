// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/beam_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>

// One body each, inlined into a function per kind of processor, so that the compiler vectorises it for that kind.
#define PLANEWRIGHT_BODY [[gnu::always_inline]] inline

namespace planewright {

namespace {

constexpr int kLanes = 16;

template <class Number>
PLANEWRIGHT_BODY int placeBody(const double* __restrict ranges, const Number* __restrict cosine,
                               const Number* __restrict sine, int beams, Number rangeMin, Number rangeMax,
                               Number constantVariance, Number proportionalVariance, Number* __restrict range,
                               Number* __restrict u, Number* __restrict v, Number* __restrict relativeVariance)
{
    int inside = 0;
    for (int i = 0; i < beams; ++i) {
        const auto measured = static_cast<Number>(ranges[i]);
        const bool echo = measured >= rangeMin && measured <= rangeMax;
        const Number r = echo ? measured : Number{0};
        const Number safe = echo ? measured : Number{1};
        range[i] = r;
        u[i] = r * cosine[i];
        v[i] = r * sine[i];
        relativeVariance[i] = constantVariance / (safe * safe) + proportionalVariance;
        inside += echo ? 1 : 0;
    }
    return inside;
}

PLANEWRIGHT_BODY void markMissingBody(const float* __restrict range, int beams, std::uint8_t* __restrict marks)
{
    for (int i = 0; i < beams; ++i)
        marks[i] = range[i] > 0.0F ? 0 : 1;
}

template <class Number>
PLANEWRIGHT_BODY void markGapsBody(const BeamArraysOf<Number>& points, const Number* __restrict range, int count,
                                   Number gapPerRange, Number sigmas, std::uint8_t* __restrict marks)
{
    const Number* __restrict u = points.u;
    const Number* __restrict v = points.v;
    const Number* __restrict relative = points.relativeVariance;
    marks[0] = 1;
    for (int i = 1; i < count; ++i) {
        const Number du = u[i] - u[i - 1];
        const Number dv = v[i] - v[i - 1];
        const Number limit = range[i - 1] * (gapPerRange + sigmas * std::sqrt(relative[i - 1]));
        const bool missing = std::min(range[i], range[i - 1]) <= Number{0};
        marks[i] = missing | (du * du + dv * dv >= limit * limit) ? 1 : 0;
    }
}

/// Squared deviation from a chord where it is beyond the limits, else 0.
template <class Number>
PLANEWRIGHT_BODY Number countedDeviation(Number u, Number v, Number relativeVariance, Number normalU, Number normalV,
                                         Number offset, const DeviationLimitsOf<Number>& limits)
{
    const Number along = normalU * u + normalV * v;
    const Number across = normalV * u - normalU * v;
    const Number deviation = along - offset;
    const Number squared = deviation * deviation;
    const Number variance = along * along * relativeVariance + across * across * limits.bearingVariance;
    const Number limit = std::max(limits.fixedSquared, limits.sigmasSquared * variance);
    return squared > limit ? squared : Number{0};
}

template <class Number>
PLANEWRIGHT_BODY int farthestExactlyBody(const BeamArraysOf<Number>& points, int first, int last,
                                         const ChordOf<Number>& chord, const DeviationLimitsOf<Number>& limits)
{
    const Number* __restrict u = points.u;
    const Number* __restrict v = points.v;
    const Number* __restrict relative = points.relativeVariance;
    const Number normalU = -chord.directionV;
    const Number normalV = chord.directionU;
    const Number offset = normalU * chord.u + normalV * chord.v;
    Number largest = 0;
    for (int i = first; i <= last; ++i)
        largest = std::max(largest, countedDeviation(u[i], v[i], relative[i], normalU, normalV, offset, limits));
    if (largest == Number{0})
        return -1;
    for (int i = first; i <= last; ++i) {
        if (countedDeviation(u[i], v[i], relative[i], normalU, normalV, offset, limits) == largest)
            return i;
    }
    return -1;
}

/// The same in sixteen lanes at once; those past the end are looked at but do not count.
PLANEWRIGHT_BODY int farthestBody(const BeamArrays& points, int first, int last, const ChordF& chord,
                                  const DeviationLimits& limits)
{
    const float* __restrict u = points.u;
    const float* __restrict v = points.v;
    const float* __restrict relative = points.relativeVariance;
    const float normalU = -chord.directionV;
    const float normalV = chord.directionU;
    const float offset = normalU * chord.u + normalV * chord.v;
    float best[kLanes] = {};
    int found[kLanes] = {};
    for (int i = first; i <= last; i += kLanes) {
        for (int lane = 0; lane < kLanes; ++lane) {
            const float deviation =
                countedDeviation(u[i + lane], v[i + lane], relative[i + lane], normalU, normalV, offset, limits);
            const bool better = (lane <= last - i) & (deviation > best[lane]);
            best[lane] = better ? deviation : best[lane];
            found[lane] = better ? i : found[lane];
        }
    }
    float largest = 0.0F;
    for (const float lane : best)
        largest = std::max(largest, lane);
    if (largest == 0.0F)
        return -1;
    int farthest = last;
    for (int lane = 0; lane < kLanes; ++lane)
        farthest = std::min(farthest, best[lane] == largest ? found[lane] + lane : last);
    return farthest;
}

PLANEWRIGHT_BODY float laneSum(const float* lanes)
{
    float eight[8];
    for (int i = 0; i < 8; ++i)
        eight[i] = lanes[i] + lanes[i + 8];
    return ((eight[0] + eight[4]) + (eight[2] + eight[6])) + ((eight[1] + eight[5]) + (eight[3] + eight[7]));
}

/// Every point counts alike.
struct PlainWeight {
    PLANEWRIGHT_BODY float operator()(float) const { return 1.0F; }
};

/// The inverse of a point's variance across the line, by the range that the line predicts for it.
struct NoiseWeight {
    float foot;
    float offsetSquared;
    float constant;
    float proportional;
    float bearing;

    PLANEWRIGHT_BODY float operator()(float t) const
    {
        const float x = t - foot;
        const float xx = x * x;
        return 1.0F / (constant / (offsetSquared + xx) + proportional + xx * bearing);
    }
};

/// Adds up weight, t, h, tt, th and hh over points in sixteen lanes; `weigh(t)` gives a point's weight.
template <class Weigh>
PLANEWRIGHT_BODY ChordSums sumsBody(const BeamArrays& points, int first, int last, const ChordF& chord, Weigh weigh)
{
    const float* __restrict u = points.u;
    const float* __restrict v = points.v;
    float sumW[kLanes] = {};
    float sumT[kLanes] = {};
    float sumH[kLanes] = {};
    float sumTT[kLanes] = {};
    float sumTH[kLanes] = {};
    float sumHH[kLanes] = {};
    const auto add = [&](int i, int lane, bool counts) {
        const float du = u[i] - chord.u;
        const float dv = v[i] - chord.v;
        const float t = chord.directionU * du + chord.directionV * dv;
        const float h = chord.directionU * dv - chord.directionV * du;
        const float w = counts ? weigh(t) : 0.0F;
        const float wt = w * t;
        const float wh = w * h;
        sumW[lane] += w;
        sumT[lane] += wt;
        sumH[lane] += wh;
        sumTT[lane] += wt * t;
        sumTH[lane] += wt * h;
        sumHH[lane] += wh * h;
    };
    int i = first;
    for (; i + kLanes <= last + 1; i += kLanes) {
        for (int lane = 0; lane < kLanes; ++lane)
            add(i + lane, lane, true);
    }
    if (i <= last) {
        for (int lane = 0; lane < kLanes; ++lane)
            add(i + lane, lane, lane <= last - i);
    }
    return {laneSum(sumW), laneSum(sumT), laneSum(sumH), laneSum(sumTT), laneSum(sumTH), laneSum(sumHH)};
}

PLANEWRIGHT_BODY ChordSums plainSumsBody(const BeamArrays& points, int first, int last, const ChordF& chord)
{
    return sumsBody(points, first, last, chord, PlainWeight{});
}

PLANEWRIGHT_BODY ChordSums weightedSumsBody(const BeamArrays& points, int first, int last, const ChordF& chord,
                                            const WeightModel& model)
{
    const float squared = model.offset * model.offset;
    return sumsBody(points, first, last, chord,
                    NoiseWeight{model.foot, squared, squared * model.constantVariance,
                                squared * model.proportionalVariance, model.bearingVariance});
}

// A function of each body for one kind of processor.
// NOLINTBEGIN(bugprone-macro-parentheses): TARGET is an attribute of a function, which takes no parentheses.
#define PLANEWRIGHT_KERNELS(KIND, TARGET)                                                                              \
    TARGET int place##KIND(const double* ranges, const float* cosine, const float* sine, int beams, float rangeMin,    \
                           float rangeMax, float constantVariance, float proportionalVariance, float* range, float* u, \
                           float* v, float* relativeVariance)                                                          \
    {                                                                                                                  \
        return placeBody(ranges, cosine, sine, beams, rangeMin, rangeMax, constantVariance, proportionalVariance,      \
                         range, u, v, relativeVariance);                                                               \
    }                                                                                                                  \
    TARGET int placeExactly##KIND(const double* ranges, const double* cosine, const double* sine, int beams,           \
                                  double rangeMin, double rangeMax, double constantVariance,                           \
                                  double proportionalVariance, double* range, double* u, double* v,                    \
                                  double* relativeVariance)                                                            \
    {                                                                                                                  \
        return placeBody(ranges, cosine, sine, beams, rangeMin, rangeMax, constantVariance, proportionalVariance,      \
                         range, u, v, relativeVariance);                                                               \
    }                                                                                                                  \
    TARGET void markMissing##KIND(const float* range, int beams, std::uint8_t* marks)                                  \
    {                                                                                                                  \
        markMissingBody(range, beams, marks);                                                                          \
    }                                                                                                                  \
    TARGET void markGaps##KIND(const BeamArrays& points, const float* range, int count, float gapPerRange,             \
                               float sigmas, std::uint8_t* marks)                                                      \
    {                                                                                                                  \
        markGapsBody(points, range, count, gapPerRange, sigmas, marks);                                                \
    }                                                                                                                  \
    TARGET void markGapsExactly##KIND(const BeamArraysOf<double>& points, const double* range, int count,              \
                                      double gapPerRange, double sigmas, std::uint8_t* marks)                          \
    {                                                                                                                  \
        markGapsBody(points, range, count, gapPerRange, sigmas, marks);                                                \
    }                                                                                                                  \
    TARGET int farthest##KIND(const BeamArrays& points, int first, int last, const ChordF& chord,                      \
                              const DeviationLimits& limits)                                                           \
    {                                                                                                                  \
        return farthestBody(points, first, last, chord, limits);                                                       \
    }                                                                                                                  \
    TARGET int farthestExactly##KIND(const BeamArraysOf<double>& points, int first, int last,                          \
                                     const ChordOf<double>& chord, const DeviationLimitsOf<double>& limits)            \
    {                                                                                                                  \
        return farthestExactlyBody(points, first, last, chord, limits);                                                \
    }                                                                                                                  \
    TARGET ChordSums sums##KIND(const BeamArrays& points, int first, int last, const ChordF& chord)                    \
    {                                                                                                                  \
        return plainSumsBody(points, first, last, chord);                                                              \
    }                                                                                                                  \
    TARGET ChordSums weightedSums##KIND(const BeamArrays& points, int first, int last, const ChordF& chord,            \
                                        const WeightModel& model)                                                      \
    {                                                                                                                  \
        return weightedSumsBody(points, first, last, chord, model);                                                    \
    }                                                                                                                  \
    constexpr BeamKernels k##KIND{#KIND,          place##KIND,           placeExactly##KIND, markMissing##KIND,        \
                                  markGaps##KIND, markGapsExactly##KIND, farthest##KIND,     farthestExactly##KIND,    \
                                  sums##KIND,     weightedSums##KIND};
// NOLINTEND(bugprone-macro-parentheses)

PLANEWRIGHT_KERNELS(Baseline, )
#ifdef __x86_64__
PLANEWRIGHT_KERNELS(Avx2, [[gnu::target("avx2")]])
PLANEWRIGHT_KERNELS(Avx512, [[gnu::target("avx512f,avx512bw,avx512vl,avx512dq")]])
#endif

#ifdef __x86_64__
constexpr std::array kKinds{kBaseline, kAvx2, kAvx512};

std::size_t supportedKinds()
{
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") == 0)
        return 1;
    const bool avx512 = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
                        __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512dq") != 0;
    return avx512 ? 3 : 2;
}
#else
constexpr std::array kKinds{kBaseline};

std::size_t supportedKinds()
{
    return 1;
}
#endif

}  // namespace

std::span<const BeamKernels> availableBeamKernels()
{
    static const std::size_t kinds = supportedKinds();
    return std::span{kKinds}.first(kinds);
}

const BeamKernels& beamKernels()
{
    return availableBeamKernels().back();
}

}  // namespace planewright
