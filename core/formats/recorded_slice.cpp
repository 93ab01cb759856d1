// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/recorded_slice.h"

#include <cmath>
#include <limits>

#include "core/formats/number_cells.h"
#include "core/formats/number_text.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

double readBack(double radians)
{
    return degrees(degreesReadingBackTo(radians));
}

}  // namespace

double degreesReadingBackTo(double radians)
{
    const double near = toDegrees(radians);
    if (const auto written = readNumber<double>(formatNumber(near)); written && degrees(*written) == radians)
        return *written;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double candidate : {near, std::nextafter(near, -kInfinity), std::nextafter(near, kInfinity)}) {
        if (degrees(candidate) == radians)
            return candidate;
    }
    return near;
}

double recordedMillimetres(double range)
{
    return range > 0.0 ? std::floor(range * 1000.0 + 0.5) : 0.0;
}

ScanSlice asRecorded(ScanSlice slice)
{
    slice.tilt = readBack(slice.tilt);
    if (slice.tiltEnd)
        slice.tiltEnd = readBack(*slice.tiltEnd);
    if (slice.tiltCommanded)
        slice.tiltCommanded = readBack(*slice.tiltCommanded);
    slice.firstBearing = readBack(slice.firstBearing);
    slice.bearingStep = readBack(slice.bearingStep);
    for (double& range : slice.ranges)
        range = recordedMillimetres(range) / 1000.0;
    return slice;
}

ScanDescription asRecorded(ScanDescription description)
{
    description.firstBearing = readBack(description.firstBearing);
    description.bearingStep = readBack(description.bearingStep);
    return description;
}

}  // namespace planewright
