// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/session/loops/acquisition_loop.h"
#include "app/session/loops/extraction_loop.h"
#include "app/session/loops/recording_loop.h"
#include "app/session/loops/scan_work.h"

namespace planewright {

/// One scan to be taken, recorded and extracted.
struct PipelineSetup {
    std::shared_ptr<ScanSource> source;
    std::unique_ptr<SliceRecorder> recorder;  ///< null: the recording is off
    std::vector<ParametersFrom> parameters;   ///< one at least, as in ExtractionPlan
    bool explain = false;
    bool extracts = true;  ///< otherwise the scan is only recorded, and without parameters
    AutomaticRecovery recovery = {};
};

/// Hears of a scan, each on one of its threads.
struct ScanEvents {
    AcquisitionEvents acquisition;
    RecordingEvents recording;
    std::function<void()> onNews;  ///< take() gives something
    std::function<void(const Error&)> onExtractionFailed;
};

/// The way of a scan's slices: source → recorder → extractor → bridge.
class ScanPipeline : public ScanWork {
public:
    ScanPipeline(PipelineSetup plan, ScanEvents events, const Clock& clock);

    /// Acquisition, recording, extraction. They end by themselves: after the last slice, finish() or abandon().
    std::vector<std::function<void()>> loops() override;

    Result<void> pause();
    Result<void> resume();
    Result<void> step() { return source_->step(); }
    Result<void> setSpeed(double speed) { return source_->setSpeed(speed); }
    Result<void> stopMotion() { return source_->stopMotion(); }

    /// In force from the next slice on that is taken, and recorded so. `sensor.*` and `method.estimator` stay what they
    /// were at the beginning of the scan. False where no slice comes any more.
    bool setParameters(Parameters parameters);

    void finish() { acquisition_.finish(); }
    void retry() { acquisition_.retry(); }
    void giveUp() { acquisition_.giveUp(); }

    /// Ends everything soon: no more slices, no more steps; what was taken is still recorded where the disk lets it.
    void abandon() override;

    std::vector<ExtractedStep> take() override { return bridge_.take(); }
    PipelineStatus status() const override;
    bool records() const { return recording_.isOn(); }
    /// What is said once about the slices as they were measured.
    const ScanDescription& measuredDescription() const { return description_; }
    const ScanDescription& correctedDescription() const override { return extraction_.correctedDescription(); }

private:
    std::shared_ptr<ScanSource> source_;
    bool extracts_;
    ScanDescription description_;  ///< as the recording gives it back
    Parameters first_;
    Channel<AcquiredItem> acquired_;
    Channel<ExtractionItem> recorded_;
    SnapshotBridge bridge_;
    AcquisitionLoop acquisition_;
    RecordingLoop recording_;
    ExtractionLoop extraction_;
};

}  // namespace planewright
