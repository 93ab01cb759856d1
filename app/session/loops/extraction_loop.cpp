// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/extraction_loop.h"

#include <cassert>
#include <exception>
#include <limits>
#include <utility>

namespace planewright {

ExtractionLoop::ExtractionLoop(ExtractionPlan plan, Channel<ExtractionItem>& in, SnapshotBridge& out,
                               const Clock& clock, std::function<void(const Error&)> onFailed)
    : in_(in),
      out_(out),
      clock_(clock),
      onFailed_(std::move(onFailed)),
      correctsNothing_(plan.parameters.front().parameters.sensor.correctsNothing()),
      corrector_(plan.description, plan.parameters.front().parameters.sensor),
      extractor_(sensorOf(corrector_.description()), plan.parameters.front().parameters,
                 {[&clock] { return clock.now(); }, plan.explain}),
      inForce_(std::make_shared<const Parameters>(plan.parameters.front().parameters)),
      later_(plan.parameters.begin() + 1, plan.parameters.end())
{
}

void ExtractionLoop::run()
try {
    while (!abandoned_) {
        std::optional<ExtractionItem> item = in_.pop();
        if (!item)
            break;
        take(std::move(*item));
    }
    if (abandoned_)
        return;
    takeCorrected(corrector_.finish());
    changeParametersUpTo(std::numeric_limits<int>::max());
    out_.publish({nullptr, nullptr, extractor_.finish(), inForce_});
} catch (const std::exception& exception) {
    in_.abandon();
    onFailed_({ErrorCode::Internal, "the extraction ended by an internal error (" + std::string{exception.what()} +
                                        "); all slices are kept, extract them again"});
}

void ExtractionLoop::take(ExtractionItem item)
{
    if (auto* parameters = std::get_if<ParametersFrom>(&item)) {
        // What somebody sets now takes the place of what was set when the scan was recorded.
        std::erase_if(later_, [&](const ParametersFrom& other) { return other.step >= parameters->step; });
        later_.push_back(std::move(*parameters));
        return;
    }
    SharedSlice slice = std::get<SharedSlice>(std::move(item));
    if (slice->angleSuspect)
        return;
    if (correctsNothing_) {
        extract(slice, slice);
        return;
    }
    measured_.push_back(slice);
    takeCorrected(corrector_.push(*slice));
}

void ExtractionLoop::takeCorrected(std::optional<ScanSlice> corrected)
{
    if (!corrected)
        return;
    const SharedSlice measured = std::move(measured_.front());
    measured_.pop_front();
    extract(measured, std::make_shared<const ScanSlice>(std::move(*corrected)));
}

void ExtractionLoop::extract(const SharedSlice& measured, const SharedSlice& slice)
{
    changeParametersUpTo(slice->step);
    const auto began = clock_.now();
    std::shared_ptr<const Snapshot> snapshot = extractor_.step(*slice);
    stepTime_ = clock_.now() - began;
    out_.publish({measured, slice, std::move(snapshot), inForce_});
    ++steps_;
}

void ExtractionLoop::changeParametersUpTo(int step)
{
    for (; !later_.empty() && later_.front().step <= step; later_.pop_front()) {
        inForce_ = std::make_shared<const Parameters>(later_.front().parameters);
        extractor_.setParameters(*inForce_);
    }
}

void ExtractionLoop::abandon()
{
    abandoned_ = true;
    in_.abandon();
}

}  // namespace planewright
