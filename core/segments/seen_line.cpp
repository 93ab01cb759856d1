// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/seen_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/segments/line_piece.h"

namespace planewright {

namespace {

/// A direction from the laser, away from the line and along it.
struct Ray {
    double away = 1.0;
    double along = 0.0;
};

Ray rayThrough(double away, double along)
{
    const double scale = 1.0 / std::sqrt(square(away) + square(along));
    return {scale * away, scale * along};
}

Ray between(const Ray& a, const Ray& b)
{
    return rayThrough(a.away + b.away, a.along + b.along);
}

}  // namespace

double varianceAt(double place, const SeenLine& line, const NoiseParameters& noise)
{
    const double squaredOffset = square(line.offset);
    const double squaredRange = squaredOffset + square(place);
    return std::max(kLeastVariance,
                    squaredOffset * (square(noise.rangeConstant) / squaredRange + square(noise.rangeProportional)) +
                        square(place * noise.bearing));
}

double meanVariance(const SeenLine& line, const NoiseParameters& noise)
{
    return (varianceAt(line.from, line, noise) + 4.0 * varianceAt(0.5 * (line.from + line.to), line, noise) +
            varianceAt(line.to, line, noise)) /
           6.0;
}

double likeliestSlope(const MomentLine& fitted, const SeenLine& line, const NoiseParameters& noise)
{
    // N by Simpson's rule, but for a factor: noise along the ray is place / offset times as large along the line as it
    // is across.
    double across = 0.0;
    double both = 0.0;
    double along = 0.0;
    const auto take = [&](double place, double share) {
        const double variance = share * varianceAt(place, line, noise);
        const double ratio = place / line.offset;
        across += variance;
        both += variance * ratio;
        along += variance * ratio * ratio;
    };
    take(line.from, 1.0);
    take(0.5 * (line.from + line.to), 4.0);
    take(line.to, 1.0);
    // The zero of the derivative that is a minimum: 0 = a² S_tt N_th − a (S_tt N_hh − S_hh N_tt) − S_hh N_th.
    const double linear = fitted.along * across - fitted.across * along;
    const double root = std::sqrt(square(linear) + 4.0 * fitted.along * fitted.across * square(both));
    return linear + root > 0.0 ? -2.0 * fitted.across * both / (linear + root) : 0.0;
}

WeightBias weightBias(const SeenLine& line, const NoiseParameters& noise)
{
    // A range error e with variance V moves a point by e cos ψ across the line and e sin ψ along it, ψ between ray and
    // normal; its weight w is that of the place where it comes to lie. To second order the mean of w h over that of w
    // is w'/w V sin ψ cos ψ, and V cos² ψ = 1/w. A bearing error s is a range error of mean ρ (1/2 + tan² ψ) s².
    // Beams are evenly spaced in bearing: Simpson's rule over five bearings.
    const double away = std::abs(line.offset);
    const Ray first = rayThrough(away, line.from);
    const Ray last = rayThrough(away, line.to);
    const Ray middle = between(first, last);
    const std::array rays{first, between(first, middle), middle, between(middle, last), last};
    constexpr std::array kShares{1.0, 4.0, 2.0, 4.0, 1.0};
    double weights = 0.0;
    WeightBias bias;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double place = away * rays[i].along / rays[i].away;
        const double squaredRange = square(line.offset) + square(place);
        const double weight = kShares[i] / varianceAt(place, line, noise);
        const double off = square(noise.bearing) * (0.5 * line.offset - square(place) / line.offset) +
                           2.0 * line.offset * square(noise.rangeConstant * place / squaredRange);
        weights += weight;
        bias.offset += weight * off;
        bias.moment += weight * off * place;
    }
    return {bias.offset / weights, bias.moment / weights};
}

}  // namespace planewright
