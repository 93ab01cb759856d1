// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "app/session/loops/acquisition_loop.h"
#include "app/session/loops/extraction_loop.h"
#include "app/session/loops/recording_loop.h"

namespace planewright {

/// One scan to be taken, recorded and extracted.
struct ScanPlan {
    std::shared_ptr<ScanSource> source;
    std::unique_ptr<SliceRecorder> recorder;  ///< null: the recording is off
    std::vector<ParametersFrom> parameters;   ///< one at least, as in ExtractionPlan
    bool explain = false;
};

/// Hears of a scan, each on one of its threads.
struct ScanEvents {
    AcquisitionEvents acquisition;
    RecordingEvents recording;
    std::function<void()> onNews;  ///< take() gives something
    std::function<void(const Error&)> onExtractionFailed;
};

/// How a scan goes on.
struct PipelineStatus {
    double slicesPerSecond = 0.0;
    std::size_t queueDepth = 0;  ///< slices that wait for the recorder or the extractor
    std::chrono::nanoseconds stepTime{0};
    int acquired = 0;   ///< slices taken
    int extracted = 0;  ///< of these, worked in
    int lost = 0;       ///< steps that were passed over
    RecordingStatus recording;
};

/// The way of a scan's slices: source → recorder → extractor → bridge. It starts no thread: whoever owns it runs each
/// of loops() on one, and joins them before it goes. Everything else may be called by any thread at any time.
class ScanPipeline {
public:
    ScanPipeline(ScanPlan plan, ScanEvents events, const Clock& clock);

    /// Acquisition, recording, extraction. They end by themselves: after the last slice, finish() or abandon().
    std::array<std::function<void()>, 3> loops();

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
    void abandon();

    std::vector<ExtractedStep> take() { return bridge_.take(); }
    PipelineStatus status() const;
    bool records() const { return recording_.isOn(); }
    const ScanDescription& correctedDescription() const { return extraction_.correctedDescription(); }

private:
    std::shared_ptr<ScanSource> source_;
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
