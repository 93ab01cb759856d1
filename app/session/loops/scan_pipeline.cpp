// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/scan_pipeline.h"

#include <utility>

#include "core/formats/recorded_slice.h"

namespace planewright {

ScanPipeline::ScanPipeline(PipelineSetup plan, ScanEvents events, const Clock& clock)
    : source_(plan.source),
      extracts_(plan.extracts),
      description_(source_->isLive() ? asRecorded(source_->description()) : source_->description()),
      first_(plan.parameters.front().parameters),
      acquired_(clock),
      recorded_(clock),
      bridge_(std::move(events.onNews)),
      acquisition_(*source_, acquired_, clock, std::move(events.acquisition), plan.recovery),
      recording_(std::move(plan.recorder), description_, source_->plannedSlices(),
                 extracts_ ? plan.parameters : std::vector<ParametersFrom>{}, acquired_, recorded_, clock,
                 std::move(events.recording)),
      extraction_({description_, plan.parameters, plan.explain}, recorded_, bridge_, clock,
                  std::move(events.onExtractionFailed))
{
}

std::vector<std::function<void()>> ScanPipeline::loops()
{
    const auto extract = [this] {
        if (extracts_)
            extraction_.run();
        while (recorded_.pop()) {
        }
    };
    return {[this] { acquisition_.run(); }, [this] { recording_.run(); }, extract};
}

Result<void> ScanPipeline::pause()
{
    Result<void> paused = source_->pause();
    if (paused)
        acquired_.push(ScanEvent{ScanEvent::Kind::Pause, {}, {}, {}});
    return paused;
}

Result<void> ScanPipeline::resume()
{
    acquired_.push(ScanEvent{ScanEvent::Kind::Resume, {}, {}, {}});
    return source_->resume();
}

bool ScanPipeline::setParameters(Parameters parameters)
{
    parameters.sensor = first_.sensor;
    parameters.method = first_.method;
    return acquired_.push(std::move(parameters));
}

void ScanPipeline::abandon()
{
    acquisition_.finish();
    recording_.hurry();
    extraction_.abandon();
}

PipelineStatus ScanPipeline::status() const
{
    PipelineStatus status;
    status.slicesPerSecond = acquisition_.slicesPerSecond();
    status.queueDepth = acquired_.depth() + recorded_.depth();
    status.stepTime = extraction_.stepTime();
    status.acquired = acquisition_.slices();
    status.extracted = extraction_.steps();
    status.lost = acquisition_.lost();
    status.recording = recording_.status();
    return status;
}

}  // namespace planewright
