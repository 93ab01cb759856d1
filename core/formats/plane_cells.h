// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/formats/plane_result.h"

namespace planewright {

/// One value of a plane as the planes files name and print it.
struct PlaneCell {
    enum class Kind { Number, Text, Polygon, List };
    std::string_view name;  ///< of the column
    Kind kind = Kind::Number;
    std::string text;  ///< empty if unknown; of a polygon its WKT, of a list its numbers with blanks between
};

/// All values of a plane in the order of the columns: angles in degrees, lengths in metres, areas in m².
///
/// A plane of a map has the stops that saw it as the last one. Without segments, as known planes are, their number, the
/// steps and the errors are unknown; without parts of the outline all that is measured on it; with an all-zero
/// covariance the sigmas.
std::vector<PlaneCell> planeCells(const PlaneResult& result);

/// By how much a normal may be turned: root of the larger eigenvalue of the tangent angles' covariance [rad].
double normalSigma(const Eigen::Matrix3d& covariance);

/// True where a plane's covariance is known.
bool hasCovariance(const Plane& plane);

/// `POLYGON Z ((…))`, or `MULTIPOLYGON Z (((…)),((…)))` for several parts; rings closed, outer ones counter-clockwise
/// seen from +n. Empty without parts.
std::string wellKnownText(const Outline& outline);

}  // namespace planewright
