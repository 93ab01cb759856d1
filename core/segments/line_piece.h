// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>

#include "core/params/parameters.h"
#include "core/segments/line_moments.h"
#include "core/types/square.h"

namespace planewright {

/// Neighbouring points of a slice by their place among the echoes, both ends included, and their moments.
struct LinePiece {
    int first = 0;
    int last = 0;
    LineMoments moments;
    bool clipped = false;   ///< points far from the line were left out of the moments
    MomentLine line;        ///< of the moments, where the piece has been fitted
    double variance = 0.0;  ///< of a point across the line, at the mean of the points [m²]

    int points() const { return last - first + 1; }
};

/// No variance is taken for smaller [m²], lest a scanner without noise divide by zero.
inline constexpr double kLeastVariance = 1e-12;
/// Points farther than this from their line are left out where the line explains its points badly.
inline constexpr double kClipSigmas = 3.0;

/// Variance of a point across a line of this normal [m²], times the squared length of the normal: range noise along the
/// ray, bearing noise across it.
inline double varianceAcross(double normalU, double normalV, double u, double v, const NoiseParameters& noise)
{
    const double along = square(normalU * u + normalV * v);
    const double across = square(normalV * u - normalU * v);
    const double relative =
        square(noise.rangeConstant) / std::max(square(u) + square(v), kLeastVariance) + square(noise.rangeProportional);
    const double least = kLeastVariance * (square(normalU) + square(normalV));
    return std::max(least, along * relative + across * square(noise.bearing));
}

/// The same at the mean of the points.
inline double centroidVariance(const MomentLine& line, const LineMoments& moments, const NoiseParameters& noise)
{
    return varianceAcross(line.normalU(), line.normalV(), moments.u, moments.v, noise);
}

/// Works out the line of a piece's moments.
inline void fitLine(LinePiece& piece, const NoiseParameters& noise)
{
    piece.line = lineOf(piece.moments);
    piece.variance = centroidVariance(piece.line, piece.moments, noise);
}

/// Signed distance of a point to a line [m].
inline double distanceTo(const MomentLine& line, const LineMoments& moments, double u, double v)
{
    return line.normalU() * (u - moments.u) + line.normalV() * (v - moments.v);
}

/// Largest sum of squares, in variances, that a straight piece of so many points plausibly has.
inline double largestChi(double points)
{
    const double freedom = std::max(1.0, points - 2.0);
    return freedom + 3.0 * std::sqrt(2.0 * freedom);
}

/// χ² with two degrees of freedom that the common line of two pieces may cost: 99.9 %.
inline constexpr double kCommonLine = 13.8;

/// True where one line explains points with a sum of squares `across` [m²] well, and its two parts no worse than a line
/// each, whose sums are `apart` [m²] together; `variance` is that of a point across the line [m²].
inline bool isOneLine(double points, double across, double apart, double variance)
{
    return across - apart < kCommonLine * variance && across < variance * largestChi(points);
}

}  // namespace planewright
