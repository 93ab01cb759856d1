// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

#include "core/types/recording.h"
#include "devices/pacer.h"
#include "devices/scan_source.h"

namespace planewright {

/// A recording played back as if it were a scanner: at the pace of its slices' times, faster, slower, or step by step.
class ReplayedRecording : public ScanSource {
public:
    /// A speed that isReplaySpeed refuses is taken as real time. `plannedSlices` that the scan was begun with, those
    /// that are missing among them; empty where nobody knows.
    ReplayedRecording(std::shared_ptr<const Recording> recording, std::string name, const Clock& clock, double speed,
                      std::optional<int> plannedSlices);

    const ScanDescription& description() const override { return recording_->description; }
    std::optional<int> plannedSlices() const override { return plannedSlices_; }
    bool isLive() const override { return false; }
    std::string name() const override { return name_; }

    Result<void> begin(const std::stop_token& stop) override;
    Result<std::optional<ScanSlice>> next(const std::stop_token& stop) override;
    Result<void> pause() override;
    Result<void> resume() override;
    Result<void> step() override { return pacer_.step(); }
    Result<void> setSpeed(double speed) override { return pacer_.setSpeed(speed); }

private:
    std::shared_ptr<const Recording> recording_;
    std::string name_;
    std::optional<int> plannedSlices_;
    Pacer pacer_;
    std::size_t next_ = 0;
};

}  // namespace planewright
