// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/beam_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/segments/lanes.h"

// One body each, inlined into a function per kind of processor, so that the compiler vectorises it for that kind.
#define PLANEWRIGHT_BODY [[gnu::always_inline]] inline

namespace planewright {

namespace {

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
        marks[i] = (missing | (du * du + dv * dv >= limit * limit)) ? 1 : 0;
    }
}

/// Squared deviation from a chord where it is beyond the limits, else 0; of one point or of a register of them.
template <class Number, class Points>
PLANEWRIGHT_BODY void countDeviation(const Points& u, const Points& v, const Points& relativeVariance, Number normalU,
                                     Number normalV, Number offset, const DeviationLimitsOf<Number>& limits,
                                     Points& counted)
{
    const Points along = normalU * u + normalV * v;
    const Points across = normalV * u - normalU * v;
    const Points deviation = along - offset;
    const Points squared = deviation * deviation;
    const Points variance = along * along * relativeVariance + across * across * limits.bearingVariance;
    const Points ofSigmas = limits.sigmasSquared * variance;
    const Points limit = ofSigmas > limits.fixedSquared ? ofSigmas : Points{} + limits.fixedSquared;
    counted = squared > limit ? squared : Points{};
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
    for (int i = first; i <= last; ++i) {
        Number counted;
        countDeviation(u[i], v[i], relative[i], normalU, normalV, offset, limits, counted);
        largest = std::max(largest, counted);
    }
    if (largest == Number{0})
        return -1;
    for (int i = first; i <= last; ++i) {
        Number counted;
        countDeviation(u[i], v[i], relative[i], normalU, normalV, offset, limits, counted);
        if (counted == largest)
            return i;
    }
    return -1;
}

/// Numbers of a register's worth of points from one on.
template <int Width>
PLANEWRIGHT_BODY void load(const float* numbers, int first, typename LanesOf<Width>::Floats& floats)
{
    floats = *reinterpret_cast<const typename Register<Width>::Anywhere*>(numbers + first);
}

/// The same in sixteen lanes at once; those past the end are looked at but do not count.
template <int Width>
PLANEWRIGHT_BODY int farthestBody(const BeamArrays& points, int first, int last, const ChordF& chord,
                                  const DeviationLimits& limits)
{
    using Lanes = LanesOf<Width>;
    using Floats = typename Lanes::Floats;
    using Integers = typename Lanes::Integers;
    const float normalU = -chord.directionV;
    const float normalV = chord.directionU;
    const float offset = normalU * chord.u + normalV * chord.v;
    Lanes best;
    Integers found[Lanes::kParts] = {};
    const auto look = [&](int i, bool all) PLANEWRIGHT_INLINED {
        for (int p = 0; p < Lanes::kParts; ++p) {
            Floats u, v, relative, counted;
            load<Width>(points.u, i + p * Width, u);
            load<Width>(points.v, i + p * Width, v);
            load<Width>(points.relativeVariance, i + p * Width, relative);
            if (!all) {  // the chord's own point does not deviate
                const Integers counts = Register<Width>::kNumbers <= last - i - p * Width;
                u = counts ? u : Floats{} + chord.u;
                v = counts ? v : Floats{} + chord.v;
            }
            countDeviation(u, v, relative, normalU, normalV, offset, limits, counted);
            found[p] = counted > best.part[p] ? Integers{} + i : found[p];
            best.part[p] = counted > best.part[p] ? counted : best.part[p];
        }
    };
    int i = first;
    for (; i + kLanes <= last + 1; i += kLanes)
        look(i, true);
    if (i <= last)
        look(i, false);
    const float largest = best.largest();
    if (largest == 0.0F)
        return -1;
    int farthest = last;
    for (int p = 0; p < Lanes::kParts; ++p) {
        const Integers place =
            best.part[p] == largest ? found[p] + Register<Width>::kNumbers + p * Width : Integers{} + last;
        for (int lane = 0; lane < Width; ++lane)
            farthest = std::min(farthest, place[lane]);
    }
    return farthest;
}

/// Every point counts alike.
struct PlainWeight {
    template <class Floats>
    PLANEWRIGHT_BODY void operator()(const Floats&, Floats& weight) const
    {
        weight = Floats{} + 1.0F;
    }
};

/// The inverse of a point's variance across the line, by the range that the line predicts for it.
struct NoiseWeight {
    float foot;
    float offsetSquared;
    float constant;
    float proportional;
    float bearing;

    template <class Floats>
    PLANEWRIGHT_BODY void operator()(const Floats& t, Floats& weight) const
    {
        const Floats x = t - foot;
        const Floats xx = x * x;
        weight = 1.0F / (constant / (offsetSquared + xx) + proportional + xx * bearing);
    }
};

/// Adds up weight, t, h, tt, th and hh over points in sixteen lanes; `weigh(t)` gives a point's weight.
template <int Width, class Weigh>
PLANEWRIGHT_BODY ChordSums sumsBody(const BeamArrays& points, int first, int last, const ChordF& chord, Weigh weigh)
{
    using Lanes = LanesOf<Width>;
    using Floats = typename Lanes::Floats;
    using Integers = typename Lanes::Integers;
    Lanes sumW, sumT, sumH, sumTT, sumTH, sumHH;
    const auto add = [&](int i, bool all) PLANEWRIGHT_INLINED {
        for (int p = 0; p < Lanes::kParts; ++p) {
            Floats u, v, w;
            load<Width>(points.u, i + p * Width, u);
            load<Width>(points.v, i + p * Width, v);
            const Floats du = u - chord.u;
            const Floats dv = v - chord.v;
            Floats t = chord.directionU * du + chord.directionV * dv;
            Floats h = chord.directionU * dv - chord.directionV * du;
            weigh(t, w);
            if (!all) {
                const Integers counts = Register<Width>::kNumbers <= last - i - p * Width;
                t = counts ? t : Floats{};
                h = counts ? h : Floats{};
                w = counts ? w : Floats{};
            }
            const Floats wt = w * t;
            const Floats wh = w * h;
            sumW.part[p] += w;
            sumT.part[p] += wt;
            sumH.part[p] += wh;
            sumTT.part[p] += wt * t;
            sumTH.part[p] += wt * h;
            sumHH.part[p] += wh * h;
        }
    };
    int i = first;
    for (; i + kLanes <= last + 1; i += kLanes)
        add(i, true);
    if (i <= last)
        add(i, false);
    return {sumW.sum(), sumT.sum(), sumH.sum(), sumTT.sum(), sumTH.sum(), sumHH.sum()};
}

template <int Width>
PLANEWRIGHT_BODY ChordSums plainSumsBody(const BeamArrays& points, int first, int last, const ChordF& chord)
{
    return sumsBody<Width>(points, first, last, chord, PlainWeight{});
}

template <int Width>
PLANEWRIGHT_BODY ChordSums weightedSumsBody(const BeamArrays& points, int first, int last, const ChordF& chord,
                                            const WeightModel& model)
{
    const float squared = model.offset * model.offset;
    return sumsBody<Width>(points, first, last, chord,
                           NoiseWeight{model.foot, squared, squared * model.constantVariance,
                                       squared * model.proportionalVariance, model.bearingVariance});
}

// A function of each body for one kind of processor.
// NOLINTBEGIN(bugprone-macro-parentheses): TARGET is an attribute of a function, which takes no parentheses.
#define PLANEWRIGHT_KERNELS(KIND, WIDTH, TARGET)                                                                       \
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
        return farthestBody<WIDTH>(points, first, last, chord, limits);                                                \
    }                                                                                                                  \
    TARGET int farthestExactly##KIND(const BeamArraysOf<double>& points, int first, int last,                          \
                                     const ChordOf<double>& chord, const DeviationLimitsOf<double>& limits)            \
    {                                                                                                                  \
        return farthestExactlyBody(points, first, last, chord, limits);                                                \
    }                                                                                                                  \
    TARGET ChordSums sums##KIND(const BeamArrays& points, int first, int last, const ChordF& chord)                    \
    {                                                                                                                  \
        return plainSumsBody<WIDTH>(points, first, last, chord);                                                       \
    }                                                                                                                  \
    TARGET ChordSums weightedSums##KIND(const BeamArrays& points, int first, int last, const ChordF& chord,            \
                                        const WeightModel& model)                                                      \
    {                                                                                                                  \
        return weightedSumsBody<WIDTH>(points, first, last, chord, model);                                             \
    }                                                                                                                  \
    constexpr BeamKernels k##KIND{#KIND,          place##KIND,           placeExactly##KIND, markMissing##KIND,        \
                                  markGaps##KIND, markGapsExactly##KIND, farthest##KIND,     farthestExactly##KIND,    \
                                  sums##KIND,     weightedSums##KIND};
// NOLINTEND(bugprone-macro-parentheses)

PLANEWRIGHT_KERNELS(Baseline, 4, )
#ifdef __x86_64__
PLANEWRIGHT_KERNELS(Avx2, 8, [[gnu::target("avx2")]])
PLANEWRIGHT_KERNELS(Avx512, 16, [[gnu::target("avx512f,avx512bw,avx512vl,avx512dq")]])
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
