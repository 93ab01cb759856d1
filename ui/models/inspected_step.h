// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/params/parameters.h"
#include "core/pipeline/plane_extractor.h"
#include "core/types/snapshot.h"
#include "core/types/step_report.h"

namespace planewright {

/// A step of a scan that somebody looks into.
struct InspectedStep {
    std::shared_ptr<const Snapshot> snapshot;         ///< what it gave; its report has times and decisions
    std::shared_ptr<const PhasedStep> phased;         ///< how it went; null: by the report alone
    Parameters parameters;                            ///< in force
    std::optional<std::chrono::microseconds> time{};  ///< of its slice since the start of the scan
    int newest = -1;                                  ///< step of the newest slice
    int planned = 0;                                  ///< steps that there will be; 0 where nobody knows
};

/// A phase of such a step, due or not, or a pass of the forced last one.
struct InspectedPhase {
    Phase phase = Phase::Extract;
    std::string_view pass;
    std::optional<std::size_t> number;      ///< among those that were due; none where it was not
    std::shared_ptr<const Snapshot> after;  ///< with the report that `decisions` are of; null where it was not due
    std::span<const Decision> decisions;    ///< of this phase
    std::optional<int> next;                ///< of one that was not due: the step at which it is, from 0
    std::chrono::nanoseconds time{0};       ///< zero where nobody measured
};

/// All phases of Table I in their order, due or not; of the forced last pass its passes.
std::vector<InspectedPhase> phasesOf(const InspectedStep& step);

/// The segments of a cluster as somebody sees them who asks what a step decided about it: those that it held before and
/// after, and those that joined it meanwhile. `before` may be null.
std::vector<SegmentId> segmentsOfCluster(ClusterId cluster, const Snapshot* before, const Snapshot& after);

}  // namespace planewright
