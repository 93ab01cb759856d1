// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"
#include "core/pipeline/extraction_method.h"
#include "core/types/scan_slice.h"
#include "core/types/snapshot.h"
#include "core/types/step_recorder.h"

namespace planewright {

/// What a caller may ask of an extraction beside its planes.
struct ExtractionOptions {
    StepClock clock;       ///< measures the phases; without one their times are zero
    bool explain = false;  ///< keep every decision with its numbers in the step reports
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

    /// Parameters for the steps to come; `method.estimator` stays what it was at the start.
    void setParameters(const Parameters& parameters)
    {
        parameters_ = parameters;
        method_->parametersChanged();
    }

private:
    std::shared_ptr<const Snapshot> makeSnapshot(StepReport report);

    SensorModel sensor_;
    Parameters parameters_;
    ExtractionOptions options_;
    std::unique_ptr<ExtractionMethod> method_;
};

}  // namespace planewright
