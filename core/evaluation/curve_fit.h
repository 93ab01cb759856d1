// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace planewright {

/// A straight line through points by least squares.
struct LineFit {
    double slope = 0.0;
    double intercept = 0.0;
    double explained = 0.0;  ///< R²: share of the variance of y that it explains
};
/// A level line through their mean where x or y is the same everywhere; all zero without points.
LineFit lineThrough(const std::vector<double>& x, const std::vector<double>& y);

/// y = factor · x^exponent, by a straight line through the logarithms.
struct PowerFit {
    double exponent = 0.0;
    double factor = 0.0;
    double explained = 0.0;  ///< R² of the logarithms
};
PowerFit powerThrough(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace planewright
