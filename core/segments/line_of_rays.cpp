// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/line_of_rays.h"

#include <cmath>

#include "core/types/square.h"

namespace planewright {

namespace {

/// A ray is taken to meet the line no farther away than so many times where its point is.
constexpr double kFarthest = 10.0;

/// 1/ρ as a linear function of the bearing's tangent, both as seen along a ray in the middle: intercept + slope · x.
struct InverseRange {
    double middleU, middleV;  // unit vector
    double intercept = 0.0;
    double slope = 0.0;
};

std::optional<InverseRange> inverseRangeOf(std::span<const SlicePoint> points)
{
    SlicePoint middle;
    for (const SlicePoint& point : points) {
        middle.u += point.u;
        middle.v += point.v;
    }
    const double length = std::hypot(middle.u, middle.v);
    if (!(length > 0.0))
        return std::nullopt;
    InverseRange fitted{middle.u / length, middle.v / length};

    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const SlicePoint& point : points) {
        const double ahead = fitted.middleU * point.u + fitted.middleV * point.v;
        if (!(ahead > 0.0))
            return std::nullopt;
        const double tangent = (fitted.middleU * point.v - fitted.middleV * point.u) / ahead;
        x += tangent;
        y += 1.0 / ahead;
        xx += square(tangent);
        xy += tangent / ahead;
    }
    const auto count = static_cast<double>(points.size());
    const double spread = xx - x * x / count;
    if (!(spread > 0.0))
        return std::nullopt;
    fitted.slope = (xy - x * y / count) / spread;
    fitted.intercept = (y - fitted.slope * x) / count;
    return fitted;
}

}  // namespace

std::optional<LineOfRays> lineOfRays(std::span<const SlicePoint> points)
{
    const std::optional<InverseRange> inverse = inverseRangeOf(points);
    if (!inverse)
        return std::nullopt;
    LineOfRays line;
    line.distance = 1.0 / std::hypot(inverse->intercept, inverse->slope);
    line.normalU = line.distance * (inverse->intercept * inverse->middleU - inverse->slope * inverse->middleV);
    line.normalV = line.distance * (inverse->intercept * inverse->middleV + inverse->slope * inverse->middleU);

    const auto count = static_cast<double>(points.size());
    double off = 0.0, squaredOff = 0.0, squaredPlaces = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double away = line.normalU * points[i].u + line.normalV * points[i].v;
        if (!(kFarthest * away > line.distance))
            return std::nullopt;
        const double place = line.distance / away * (line.directionU() * points[i].u + line.directionV() * points[i].v);
        (i == 0 ? line.from : line.to) = place;
        line.place += place / count;
        squaredPlaces += square(place);
        off += (away - line.distance) / count;
        squaredOff += square(away - line.distance);
    }
    line.along = squaredPlaces - count * square(line.place);
    line.across = squaredOff - count * square(off);
    line.u = (line.distance + off) * line.normalU + line.place * line.directionU();
    line.v = (line.distance + off) * line.normalV + line.place * line.directionV();
    return line;
}

}  // namespace planewright
