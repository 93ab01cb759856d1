// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <iosfwd>

#include "core/types/error.h"
#include "core/types/sensor_noise.h"
#include "core/types/step_report.h"

namespace planewright {

/// Totals of an extraction. Times are those of the algorithm alone, the median over the repeats.
struct Stats {
    std::int64_t points = 0;   ///< beams of all slices
    std::int64_t returns = 0;  ///< of these, with an echo
    std::int64_t segments = 0;
    std::int64_t fitted = 0;    ///< segments on a plane
    std::int64_t unfitted = 0;  ///< segments on none
    std::int64_t planes = 0;
    std::int64_t splits = 0;
    std::int64_t merges = 0;
    double meanError = 0.0;                                      ///< fitting error E, mean over the planes
    double dataAccessRatio = 0.0;                                ///< Eq. (23) [%]
    SensorNoise noise;                                           ///< that the planes were estimated with
    std::chrono::nanoseconds total{};                            ///< from slices in memory to planes
    std::array<std::chrono::nanoseconds, kPhases> phases{};      ///< of the total, in each phase
    std::chrono::nanoseconds stepMedian{}, step99{}, stepMax{};  ///< of the time of one step
    int repeats = 1;
};

/// Writes the statistics as one JSON object, `planewright-stats 1`. Errors: NotWritten.
Result<void> writeStats(std::ostream& out, const Stats& stats);

}  // namespace planewright
