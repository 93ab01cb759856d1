// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "devices/laser.h"

namespace planewright {

/// What stands in the place of a range.
enum class ScipReturn {
    Range,         ///< millimetres
    NoObject,      ///< nothing within reach
    TooNear,       ///< something nearer than it can measure
    Interference,  ///< a measurement error, maybe another laser
    Weak,          ///< something that reflects too little
    Error,         ///< any other error
    Undocumented,  ///< a number that no table names
};

/// Which numbers a laser sends in the place of ranges. Two families have two tables, and the same number means
/// different things in them: the model tells, never the number.
class ScipRanges {
public:
    /// The table of a model, by the MODL of its PP reply: that of the URG-04LX and its kin, or that of all others.
    ScipRanges(std::string_view model, const LaserLimits& limits);

    ScipReturn kindOf(std::uint32_t raw) const;

    /// Millimetres, where it is a range within the laser's own limits.
    std::optional<std::uint32_t> rangeOf(std::uint32_t raw) const
    {
        return raw >= nearest_ && raw <= farthest_ ? std::optional{raw} : std::nullopt;
    }

private:
    bool isShortRange_;
    std::uint32_t nearest_;   ///< [mm]
    std::uint32_t farthest_;  ///< [mm]
};

}  // namespace planewright
