// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/calibration/robust_spread.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/types/square.h"

namespace planewright {

double medianOf(std::span<double> values)
{
    if (values.empty())
        return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double spreadOf(std::span<const Deviation> deviations, double most)
{
    constexpr double kMedianSquare = 0.4549;  // of a standard normal deviate
    constexpr int kHalvings = 20;
    double low = 0.0;
    double high = most;
    std::vector<double> squares(deviations.size());
    for (int halving = 0; halving < kHalvings; ++halving) {
        const double middle = 0.5 * (low + high);
        std::transform(deviations.begin(), deviations.end(), squares.begin(), [middle](const Deviation& deviation) {
            return deviation.squared / (deviation.variance + square(middle));
        });
        (medianOf(squares) > kMedianSquare ? low : high) = middle;
    }
    return low;
}

}  // namespace planewright
