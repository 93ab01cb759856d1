// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "core/types/angle_range.h"
#include "core/types/error.h"

namespace planewright {

/// Angles from `first` in steps, as A:B:STEP gives them [rad].
struct AngleRange {
    double first = 0.0;
    double step = 0.0;
    int count = 0;
};

/// Reads A:B:STEP in degrees; whether B is an angle of its own is said by `end`. STEP may be negative where B is below
/// A, for tilts that go down. Errors (Usage) name the option: not three numbers, no angle at all, more than `most`, an
/// angle beyond ±360°. Without `most` the number of angles comes from elsewhere and stays 0.
Result<AngleRange> parseAngleRange(const std::string& option, const std::string& text, RangeEnd end,
                                   std::optional<int> most);

}  // namespace planewright
