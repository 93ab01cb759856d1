// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace planewright {

/// Extent across the ray, in standard deviations of a range, below which it is noise that directs a segment's line.
inline constexpr double kDirectedSigmas = 2.0;

/// What the scan points of a line segment leave behind: all that a likelihood needs to know of them.
///
/// In the slice's own plane, u right along the pitch axis and v ahead [m]. The thickness of the points across the line
/// stays out of the plane's normal equations: it is noise that would correlate with the regressors.
struct SegmentStatistics {
    int firstBeam = 0;
    int lastBeam = 0;
    int points = 0;
    double u = 0.0, v = 0.0;                    ///< weighted centroid, on the line
    double directionU = 1.0, directionV = 0.0;  ///< unit vector along the line, towards higher bearings
    double start = 0.0, end = 0.0;              ///< projected end points: distances from the centroid along the line
    double offsetInformation = 0.0;             ///< Σ w, of the centroid's place across the line [1/m²]
    double slopeInformation = 0.0;              ///< Σ w t², of the line's angle [1/rad²]
    double chi = 0.0;                           ///< Σ w e² about the line; expectation points − 2
    double thickness = 0.0;                     ///< mean squared distance of the points from the line [m²]
    double spread = 0.0;                        ///< mean squared distance from the centroid along the line [m²]
    bool startsFree = false;                    ///< beyond the first beam something clearly farther follows
    bool endsFree = false;                      ///< the same beyond the last beam

    double length() const { return end - start; }
};

}  // namespace planewright
