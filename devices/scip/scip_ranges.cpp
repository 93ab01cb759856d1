// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_ranges.h"

#include <algorithm>
#include <cmath>

namespace planewright {

namespace {

/// The least range of the short family: whatever it says of its limits, below are its codes.
constexpr std::uint32_t kShortRangeCodes = 20;

std::uint32_t millimetres(double metres)
{
    return static_cast<std::uint32_t>(std::lround(1000.0 * metres));
}

/// UTM-30LX, UST and all others (SCIP 2.0, table 4).
ScipReturn longRangeCode(std::uint32_t raw, std::uint32_t farthest)
{
    switch (raw) {
        case 1:
            return ScipReturn::NoObject;
        case 2:
        case 4:
            return ScipReturn::TooNear;
        case 3:
            return ScipReturn::Interference;
        case 5:
            return ScipReturn::Error;
        default:
            return raw > farthest ? ScipReturn::NoObject : ScipReturn::Undocumented;
    }
}

/// URG-04LX (SCIP 2.0, table 3).
ScipReturn shortRangeCode(std::uint32_t raw, std::uint32_t farthest)
{
    if (raw == 0 || raw > farthest)
        return ScipReturn::NoObject;
    if (raw <= 2)
        return ScipReturn::Weak;
    return raw >= 6 && raw <= 19 ? ScipReturn::Error : ScipReturn::Undocumented;
}

}  // namespace

ScipRanges::ScipRanges(std::string_view model, const LaserLimits& limits)
    : isShortRange_(model.find("04LX") != std::string_view::npos),
      nearest_(millimetres(limits.rangeMin)),
      farthest_(millimetres(limits.rangeMax))
{
    if (isShortRange_)
        nearest_ = std::max(nearest_, kShortRangeCodes);
}

ScipReturn ScipRanges::kindOf(std::uint32_t raw) const
{
    if (rangeOf(raw))
        return ScipReturn::Range;
    return isShortRange_ ? shortRangeCode(raw, farthest_) : longRangeCode(raw, farthest_);
}

}  // namespace planewright
