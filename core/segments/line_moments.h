// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>

namespace planewright {

/// Count, mean and scatter of points in the slice's plane: sums that add and subtract.
struct LineMoments {
    double count = 0.0;
    double u = 0.0, v = 0.0;              ///< mean [m]
    double uu = 0.0, uv = 0.0, vv = 0.0;  ///< Σ (p − mean)(p − mean)ᵀ [m²]

    /// Takes in the points of another set.
    void add(const LineMoments& other)
    {
        const double total = count + other.count;
        const double du = other.u - u;
        const double dv = other.v - v;
        const double shared = count * other.count / total;
        uu += other.uu + shared * du * du;
        uv += other.uv + shared * du * dv;
        vv += other.vv + shared * dv * dv;
        const double share = other.count / total;
        u += share * du;
        v += share * dv;
        count = total;
    }

    void add(double pointU, double pointV) { add({1.0, pointU, pointV, 0.0, 0.0, 0.0}); }

    /// Takes out points that are in it; at least one must stay.
    void remove(const LineMoments& other)
    {
        const double left = count - other.count;
        const double du = other.u - u;
        const double dv = other.v - v;
        const double share = other.count / left;
        u -= share * du;
        v -= share * dv;
        const double shared = share * count;
        uu -= other.uu + shared * du * du;
        uv -= other.uv + shared * du * dv;
        vv -= other.vv + shared * dv * dv;
        count = left;
    }

    void remove(double pointU, double pointV) { remove({1.0, pointU, pointV, 0.0, 0.0, 0.0}); }
};

/// A straight line in the slice's plane through its points' mean, by total least squares.
struct MomentLine {
    double directionU = 1.0, directionV = 0.0;  ///< unit vector
    double along = 0.0;                         ///< Σ of squared distances from the mean along the line [m²]
    double across = 0.0;                        ///< Σ of squared distances from the line [m²]

    double normalU() const { return -directionV; }
    double normalV() const { return directionU; }
};

/// The axes of a scatter of points: eigenvalues [m²] and the direction of the larger one, of any length and side.
struct ScatterAxes {
    double directionU = 1.0, directionV = 0.0;
    double larger = 0.0;
    double smaller = 0.0;
};

inline ScatterAxes axesOf(const LineMoments& moments)
{
    ScatterAxes axes;
    const double half = 0.5 * (moments.uu - moments.vv);
    const double root = std::sqrt(half * half + moments.uv * moments.uv);
    if (root > 0.0) {
        axes.directionU = half >= 0.0 ? root + half : std::abs(moments.uv);
        axes.directionV = half >= 0.0 ? moments.uv : std::copysign(root - half, moments.uv);
    }
    axes.larger = 0.5 * (moments.uu + moments.vv) + root;
    // As determinant over the larger one: the difference of trace and root would cancel.
    axes.smaller =
        axes.larger > 0.0 ? std::max(0.0, (moments.uu * moments.vv - moments.uv * moments.uv) / axes.larger) : 0.0;
    return axes;
}

/// The line of least squares through the points of these moments; `directionU`, `directionV` keep no side.
inline MomentLine lineOf(const LineMoments& moments)
{
    const ScatterAxes axes = axesOf(moments);
    const double scale = 1.0 / std::sqrt(axes.directionU * axes.directionU + axes.directionV * axes.directionV);
    return {scale * axes.directionU, scale * axes.directionV, axes.larger, axes.smaller};
}

}  // namespace planewright
