// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"
#include "core/pipeline/extraction_method.h"
#include "core/types/error.h"
#include "core/types/scan_slice.h"
#include "core/types/snapshot.h"
#include "core/types/step_recorder.h"
#include "core/types/why_not.h"

namespace planewright {

/// What a caller may ask of an extraction beside its planes.
struct ExtractionOptions {
    StepClock clock;       ///< measures the phases; without one their times are zero
    bool explain = false;  ///< keep every decision with its numbers in the step reports
};

/// The state after one phase of a step.
struct PhaseState {
    Phase phase = Phase::Extract;
    std::string_view pass;  ///< of the forced last pass, which works in several: its name; otherwise empty
    /// The counts of its report are those after the phase, with the splits and merges of the step so far; its decisions
    /// and times are those of this phase alone.
    std::shared_ptr<const Snapshot> snapshot;
};

/// A step as it went.
struct PhasedStep {
    std::vector<PhaseState> phases;            ///< those that were due, in order
    std::shared_ptr<const Snapshot> snapshot;  ///< what the step gave, with all decisions
};

/// Extracts the planes of a scan slice by slice, while it runs: Table I.
///
/// Given the same slices and parameters it gives the same planes, bit for bit, however they come. It owns no thread, no
/// clock and no random numbers.
class PlaneExtractor {
public:
    PlaneExtractor(const SensorModel& sensor, const Parameters& parameters, ExtractionOptions options = {});

    /// Works one slice in; its step must exceed those before. Gives the state after it.
    std::shared_ptr<const Snapshot> step(const ScanSlice& slice);

    /// The forced last pass after the last slice: the schedule alone would leave up to six slices unprocessed. The
    /// snapshot's report has step −1 and phase Finish.
    std::shared_ptr<const Snapshot> finish();

    /// The same without a snapshot, for callers that need only the last: its report.
    StepReport advance(const ScanSlice& slice);
    StepReport conclude();

    /// The same phase by phase, with every decision, whatever the options say. What follows is what would follow
    /// step() and finish().
    PhasedStep stepByPhases(const ScanSlice& slice);
    PhasedStep finishByPhases();

    /// Why two planes are not one, or a segment is not in a plane, as things are after the last step; the operands in
    /// either order. Usage error for other operands, for one twice, and for what is not there.
    Result<WhyNot> whyNot(const Operand& a, const Operand& b);

    /// Parameters for the steps to come; `method.estimator` stays what it was at the start.
    void setParameters(const Parameters& parameters)
    {
        parameters_ = parameters;
        method_->parametersChanged();
    }

private:
    Result<void> mustBeThere(const Operand& operand) const;
    void work(const ScanSlice& slice, StepReport& report, StepRecorder& recorder);
    void workLast(StepReport& report, StepRecorder& recorder);
    template <class Work>
    PhasedStep byPhases(Work work);
    std::shared_ptr<const Snapshot> makeSnapshot(StepReport report);

    SensorModel sensor_;
    Parameters parameters_;
    ExtractionOptions options_;
    std::unique_ptr<ExtractionMethod> method_;
};

}  // namespace planewright
