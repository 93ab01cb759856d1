// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/params/parameters.h"
#include "core/types/snapshot.h"
#include "core/types/step_report.h"
#include "tests/benchmarks/scoring.h"

namespace planewright {

/// The presets that the report is about, the default last.
inline constexpr std::array<std::string_view, 2> kPresets{"paper", "precise"};

/// The parameters of a method preset, as a user has them who sets nothing else.
Parameters presetParameters(std::string_view preset);

/// The product on a scan.
struct ProductRun {
    std::shared_ptr<const Snapshot> found;
    double milliseconds = 0.0;        ///< median over the repeats, from slices in memory to planes, without clock
    std::vector<StepReport> reports;  ///< of one more run with a clock; the last pass last
};

ProductRun runProduct(const Recording& recording, const Parameters& parameters, int repeats);

/// Its labels and planes against the truth.
Score judged(const ProductRun& run, const Recording& recording, const Parameters& parameters, const Judge& judge);

/// Line segments of the scan.
inline double segmentsOf(const ProductRun& run)
{
    return static_cast<double>(run.found->segments.segmentCount());
}

}  // namespace planewright
