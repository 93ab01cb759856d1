// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/slice_sketch.h"

#include <cmath>

namespace planewright {

Eigen::Vector2d SliceSketch::pointAt(int beam) const
{
    const auto at = static_cast<std::size_t>(beam);
    const double bearing = slice->bearing(at);
    return {slice->ranges[at] * std::cos(bearing), slice->ranges[at] * std::sin(bearing)};
}

}  // namespace planewright
