// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

namespace planewright {

/// Whether the last of a range of angles is an angle of its own.
enum class RangeEnd {
    Open,   ///< 10:170:1.16 gives 137
    Closed  ///< both ends count: 0:180:0.25 gives 721
};

/// How many angles a range from first in steps to last holds, all in one unit: floor((last − first)/step + 1e-9), and
/// one more where both ends count. Below 1 where the step leads away from the end or past it; the step is not 0.
inline double angleCount(double first, double last, double step, RangeEnd end)
{
    constexpr double kRounding = 1e-9;
    return std::floor((last - first) / step + kRounding) + (end == RangeEnd::Closed ? 1.0 : 0.0);
}

}  // namespace planewright
