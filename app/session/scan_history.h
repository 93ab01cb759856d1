// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/session/loops/snapshot_bridge.h"
#include "app/session/session_map.h"
#include "core/pipeline/plane_lives.h"
#include "core/pipeline/step_replay.h"
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
    /// The scan as it was after the first `count` of steps(), no more than there are.
    std::shared_ptr<const SessionMap> after(std::size_t count) const;

    /// Tells how a step went, or the forced last pass (kLastPass), made or not: by the slices and the parameters that
    /// it was extracted with. Usage error where there is no such step.
    Result<std::shared_ptr<const PhasedStep>> explained(int step);
    /// Why two planes are not one, or a segment is not in a plane, after a step. Usage error as
    /// PlaneExtractor::whyNot().
    Result<WhyNot> whyNot(int step, const Operand& a, const Operand& b);

    /// Where its planes come from and what became of them.
    const PlaneLives& lives() const { return lives_; }

private:
    void addToReplay(const ExtractedStep& step);

    ScanDescription description_;
    int plannedSteps_ = 0;
    std::vector<ExtractedStep> steps_;
    std::vector<SharedSlice> slices_;  ///< of the steps, without the forced last pass
    PlaneLives lives_;
    std::optional<StepReplay> replay_;  ///< of these; nothing before the first
};

}  // namespace planewright
