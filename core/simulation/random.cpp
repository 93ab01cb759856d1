// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/random.h"

#include <cmath>
#include <numbers>

namespace planewright {

namespace {

/// Spreads neighbouring numbers over all 64 bits (SplitMix64, Steele, Lea and Flood 2014).
std::uint64_t spread(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

}  // namespace

Random::Random(std::uint64_t seed, std::uint64_t stream) : engine_(spread(spread(seed) + stream)) {}

double Random::uniform()
{
    return static_cast<double>(engine_() >> 11U) * 0x1.0p-53;
}

double Random::uniform(double low, double high)
{
    return low + (high - low) * uniform();
}

int Random::integer(int first, int last)
{
    return first + static_cast<int>(uniform() * static_cast<double>(last - first + 1));
}

Random::Pair Random::normalPair()
{
    // 1 − u lies in (0, 1], so that the logarithm is finite.
    const double length = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    const double angle = 2.0 * std::numbers::pi * uniform();
    return {length * std::cos(angle), length * std::sin(angle)};
}

}  // namespace planewright
