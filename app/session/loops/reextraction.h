// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "app/session/loops/extraction_loop.h"
#include "app/session/loops/scan_work.h"

namespace planewright {

/// The slices of a scan that is over, worked in once more.
class Reextraction : public ScanWork {
public:
    Reextraction(ExtractionPlan plan, const std::vector<SharedSlice>& measured, std::function<void()> onNews,
                 std::function<void(const Error&)> onFailed, const Clock& clock);

    std::vector<std::function<void()>> loops() override;
    void abandon() override { extraction_.abandon(); }
    std::vector<ExtractedStep> take() override { return bridge_.take(); }
    PipelineStatus status() const override;
    const ScanDescription& correctedDescription() const override { return extraction_.correctedDescription(); }

private:
    int slices_;
    Channel<ExtractionItem> measured_;
    SnapshotBridge bridge_;
    ExtractionLoop extraction_;
};

}  // namespace planewright
