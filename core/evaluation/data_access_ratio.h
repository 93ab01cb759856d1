// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

namespace planewright {

/// Data access ratio (DAR) of Eq. (23) [%]: the two end points of each line segment, the only scan points that plane
/// fitting reads, against all scan points, beams without return included (the paper's 98,777 is 137 x 721). A scan
/// without points gives 0.
constexpr double dataAccessRatio(std::size_t segments, std::size_t points)
{
    return points == 0 ? 0.0 : 100.0 * 2.0 * static_cast<double>(segments) / static_cast<double>(points);
}

}  // namespace planewright
