// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/params/parameters.h"
#include "core/segments/line_moments.h"

namespace planewright {

/// A line is taken for no nearer to the laser than this [m]: one that meets it has no foot to count from.
inline constexpr double kLeastOffset = 1e-4;

/// A straight line and the stretch of it that was measured, as the laser sees them in the slice's own plane.
///
/// Places on it count from its foot, the point nearest to the laser, in the line's direction.
struct SeenLine {
    double offset =
        0.0;  ///< from the laser to the line along its normal [m]; negative where that looks to the laser, never zero
    double from = 0.0;  ///< place of the first point [m]
    double to = 0.0;    ///< place of the last point [m]
};

/// Variance of a point across the line at a place [m²]: range noise along the ray, bearing noise across it.
double varianceAt(double place, const SeenLine& line, const NoiseParameters& noise);

/// The same on average over the stretch, by Simpson's rule.
double meanVariance(const SeenLine& line, const NoiseParameters& noise);

/// Slope of the most likely line against that of total least squares through the same points.
///
/// Total least squares takes noise for as large along the line as across it. But the noise is along the ray: a point
/// that is too far is also too far along the line, which turns the line by the share that both have of each other.
/// With the scatter S of the points and the mean N of their noise covariances the slope minimises m'Sm / m'Nm over the
/// normals m, so that the noise need be known in its proportions only.
double likeliestSlope(const MomentLine& fitted, const SeenLine& line, const NoiseParameters& noise);

/// By how much points whose weights are taken from where they were measured seem to lie off their line, on average
/// over the weights: a point that is too far counts more, or less, than one that is too near.
struct WeightBias {
    double offset = 0.0;  ///< across the line [m]
    double moment = 0.0;  ///< the same times the place [m²]
};
WeightBias weightBias(const SeenLine& line, const NoiseParameters& noise);

}  // namespace planewright
