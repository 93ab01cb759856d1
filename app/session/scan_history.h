// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include "app/session/loops/snapshot_bridge.h"
#include "app/session/session_map.h"
#include "core/types/recording.h"

namespace planewright {

/// Every step of a scan, all of it shared: going back to any of them costs pointers.
class ScanHistory {
public:
    ScanHistory() = default;
    /// The description is of the corrected slices; no planned steps where nobody knows.
    ScanHistory(ScanDescription description, int plannedSteps);

    void add(std::vector<ExtractedStep> steps);

    const std::vector<ExtractedStep>& steps() const { return steps_; }
    const ScanDescription& description() const { return description_; }
    int plannedSteps() const { return plannedSteps_; }

    /// The slices as they were measured, for another extraction.
    std::vector<SharedSlice> measured() const;

    /// The scan as it is now, and as it was after a step or the last one before it. From the last step of a scan that
    /// is over on, both are the same.
    std::shared_ptr<const SessionMap> newest() const;
    std::shared_ptr<const SessionMap> at(int step) const;

private:
    std::shared_ptr<const SessionMap> mapOf(std::size_t steps) const;

    ScanDescription description_;
    int plannedSteps_ = 0;
    std::vector<ExtractedStep> steps_;
    std::vector<SharedSlice> slices_;  ///< of the steps, without the forced last pass
};

}  // namespace planewright
