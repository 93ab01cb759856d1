// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <span>

#include "core/formats/parameter_events.h"
#include "core/formats/stats.h"
#include "core/types/error.h"
#include "core/types/recording.h"
#include "core/types/snapshot.h"

namespace planewright {

/// How a recording is worked through.
struct ExtractionPlan {
    int repeats = 1;  ///< runs; the times are medians over them
    /// Hears of every step of the first run with explanations, where set; an error ends the run.
    std::function<Result<void>(const StepReport&)> onReport;
};

/// The result of an extraction.
struct ExtractionResult {
    std::shared_ptr<const Snapshot> snapshot;
    Stats stats;
};

/// Extracts the planes of a whole recording, on this thread, with the parameters in force at each step (one set at
/// least); shows progress. Only calls of the extractor are timed.
Result<ExtractionResult> runExtraction(const Recording& recording, std::span<const ParametersFrom> parameters,
                                       const ExtractionPlan& plan);

}  // namespace planewright
