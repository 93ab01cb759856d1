// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/scan_branch.h"

#include <utility>

#include "app/session/loops/reextraction.h"
#include "devices/clock.h"

namespace planewright {

ScanBranch::ScanBranch(ScanDescription measured, std::vector<SharedSlice> slices, const Parameters& parameters,
                       int plannedSteps, QObject* parent)
    : QObject(parent), parameters_(parameters)
{
    run_ = std::make_unique<SessionRun>([&](const ScanEvents& events) {
        ExtractionPlan plan{std::move(measured), {{0, parameters}}, true};
        return std::make_unique<Reextraction>(std::move(plan), slices, events.onNews, events.onExtractionFailed,
                                              steadyClock());
    });
    history_ = ScanHistory{run_->work().correctedDescription(), plannedSteps};
    connect(run_.get(), &SessionRun::news, this, &ScanBranch::take);
    connect(run_.get(), &SessionRun::extractionFailed, this, [this](const Error& error) { problem_ = error; });
    connect(run_.get(), &SessionRun::ended, this, [this] {
        take();
        isFinished_ = !problem_;
        emit ended();
    });
    run_->start();
}

void ScanBranch::take()
{
    std::vector<ExtractedStep> steps = run_->work().take();
    if (steps.empty())
        return;
    history_.add(std::move(steps));
    emit grown(static_cast<int>(history_.steps().size()));
}

}  // namespace planewright
