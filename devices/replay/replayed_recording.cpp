// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/replay/replayed_recording.h"

#include <utility>

namespace planewright {

ReplayedRecording::ReplayedRecording(std::shared_ptr<const Recording> recording, std::string name, const Clock& clock,
                                     double speed, std::optional<int> plannedSlices)
    : recording_(std::move(recording)),
      name_(std::move(name)),
      plannedSlices_(plannedSlices),
      pacer_(clock, isReplaySpeed(speed) ? speed : 1.0)
{
}

Result<void> ReplayedRecording::begin(const std::stop_token& /*stop*/)
{
    next_ = 0;
    pacer_.restart();
    return {};
}

Result<std::optional<ScanSlice>> ReplayedRecording::next(const std::stop_token& stop)
{
    if (next_ == recording_->slices.size())
        return std::nullopt;
    const ScanSlice& slice = recording_->slices[next_];
    if (!pacer_.wait(slice.time, stop))
        return std::nullopt;
    ++next_;
    return slice;
}

Result<void> ReplayedRecording::pause()
{
    pacer_.pause();
    return {};
}

Result<void> ReplayedRecording::resume()
{
    pacer_.resume();
    return {};
}

}  // namespace planewright
