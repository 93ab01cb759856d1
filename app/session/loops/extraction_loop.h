// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/session/loops/channel.h"
#include "app/session/loops/scan_item.h"
#include "app/session/loops/snapshot_bridge.h"
#include "core/geometry/slice_corrector.h"
#include "core/pipeline/plane_extractor.h"
#include "core/types/error.h"

namespace planewright {

/// How a scan is extracted.
struct ExtractionPlan {
    ScanDescription description;             ///< of the slices as they were measured
    std::vector<ParametersFrom> parameters;  ///< one at least; the first from the beginning on, whatever its step
    bool explain = false;                    ///< snapshots tell every decision
};

/// Works slices in as they come, to the same planes, bit for bit, as an extraction of their recording: corrected by
/// `sensor.*` of the first parameters, without slices whose angle is suspect, parameters changed between steps, and the
/// forced last pass when no more come.
class ExtractionLoop {
public:
    /// `onFailed` hears of exceptions, as for want of memory, on the loop's thread; the loop then ends.
    ExtractionLoop(ExtractionPlan plan, Channel<ExtractionItem>& in, SnapshotBridge& out, const Clock& clock,
                   std::function<void(const Error&)> onFailed);

    /// Until the channel is closed and empty.
    void run();

    /// Ends the loop between two steps, without the last pass.
    void abandon();

    /// What is said once about the corrected slices.
    const ScanDescription& correctedDescription() const { return corrector_.description(); }

    /// How long the last step took.
    std::chrono::nanoseconds stepTime() const { return stepTime_; }

    /// Slices worked in.
    int steps() const { return steps_; }

private:
    void take(ExtractionItem item);
    void takeCorrected(std::optional<ScanSlice> corrected);
    void extract(const SharedSlice& measured, const SharedSlice& slice);
    void changeParametersUpTo(int step);

    Channel<ExtractionItem>& in_;
    SnapshotBridge& out_;
    const Clock& clock_;
    std::function<void(const Error&)> onFailed_;
    bool correctsNothing_;
    SliceCorrector corrector_;
    PlaneExtractor extractor_;
    std::shared_ptr<const Parameters> inForce_;
    std::deque<ParametersFrom> later_;  ///< parameters that are not in force yet
    std::deque<SharedSlice> measured_;  ///< slices that the corrector has and has not given back
    std::atomic<bool> abandoned_{false};
    std::atomic<std::chrono::nanoseconds> stepTime_{std::chrono::nanoseconds{0}};
    std::atomic<int> steps_{0};
};

}  // namespace planewright
