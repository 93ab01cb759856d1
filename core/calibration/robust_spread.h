// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>

namespace planewright {

/// A deviation, squared, and the variance that is known of it.
struct Deviation {
    double squared = 0.0;
    double variance = 0.0;
};

/// Median of some numbers, of which it changes the order; 0 where there are none.
double medianOf(std::span<double> values);

/// Standard deviation by which all stray beside what is known of each: it makes the median of their normalised squares
/// that of normal deviates. Between 0 and `most`, found by halving; 0 where there are none.
double spreadOf(std::span<const Deviation> deviations, double most);

}  // namespace planewright
