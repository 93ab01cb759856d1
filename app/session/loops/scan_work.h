// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <vector>

#include "app/session/loops/recording_loop.h"
#include "app/session/loops/snapshot_bridge.h"
#include "core/types/recording.h"

namespace planewright {

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

/// Something that makes the steps of a scan on threads of its owner's. It starts none: whoever owns it runs each of
/// loops() on one, and joins them before it goes. Everything else may be called by any thread at any time.
class ScanWork {
public:
    virtual ~ScanWork() = default;

    /// They end by themselves, or soon after abandon().
    virtual std::vector<std::function<void()>> loops() = 0;

    /// Ends everything soon, between two steps.
    virtual void abandon() = 0;

    /// The steps that were made since it was called last.
    virtual std::vector<ExtractedStep> take() = 0;

    virtual PipelineStatus status() const = 0;

    /// What is said once about the corrected slices.
    virtual const ScanDescription& correctedDescription() const = 0;
};

}  // namespace planewright
