// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "core/params/parameters.h"
#include "core/types/recording.h"

namespace planewright {

/// Standard deviations of ranges at the mean range of a scan, all in [m].
struct NoiseDoubt {
    double range = 0.0;  ///< the mean range
    double found = 0.0;  ///< by which ranges scatter there (RangeNoise)
    double told = 0.0;   ///< noise.range-constant and noise.range-proportional there
};

/// How far the ranges of a scan scatter, where that is more than twice what is told and the method takes what is told
/// for true (`noise.estimated` is off): planes fall to pieces then. Nothing where the noise may be right, or the scan
/// is too small to tell.
std::optional<NoiseDoubt> noiseDoubtOf(const Recording& recording, const NoiseParameters& told);

}  // namespace planewright
