// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/reextraction.h"

#include <utility>

namespace planewright {

Reextraction::Reextraction(ExtractionPlan plan, const std::vector<SharedSlice>& measured, std::function<void()> onNews,
                           std::function<void(const Error&)> onFailed, const Clock& clock)
    : slices_(static_cast<int>(measured.size())),
      measured_(clock),
      bridge_(std::move(onNews)),
      extraction_(std::move(plan), measured_, bridge_, clock, std::move(onFailed))
{
    for (const SharedSlice& slice : measured)
        measured_.push(slice);
    measured_.close();
}

std::vector<std::function<void()>> Reextraction::loops()
{
    return {[this] { extraction_.run(); }};
}

PipelineStatus Reextraction::status() const
{
    PipelineStatus status;
    status.queueDepth = measured_.depth();
    status.stepTime = extraction_.stepTime();
    status.acquired = slices_;
    status.extracted = extraction_.steps();
    return status;
}

}  // namespace planewright
