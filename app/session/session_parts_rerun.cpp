// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <utility>

#include "app/session/loops/reextraction.h"
#include "app/session/session_parameters.h"
#include "app/session/session_parts.h"

namespace planewright {

void SessionParts::startRerun()
{
    run.reset();
    pipeline = nullptr;
    rerunCancelled_ = false;
    const ParametersFrom present{0, parameters.back().parameters};
    auto next = std::make_unique<SessionRun>([&](const ScanEvents& events) {
        ExtractionPlan plan{measuredDescription, {present}, options.explain};
        return std::make_unique<Reextraction>(std::move(plan), history.measured(), events.onNews,
                                              events.onExtractionFailed, clock);
    });
    rerunHistory_.emplace(next->work().correctedDescription(), history.plannedSteps());
    begin(std::move(next));
}

Result<void> SessionParts::exchange(bool (FormerExtractions::*verb)(ScanHistory&))
{
    if (const std::string_view refusal = machine.refusal(SessionRequest::Rerun); !refusal.empty())
        return fail(ErrorCode::Usage, std::string{refusal});
    if (!(former.*verb)(history))
        return {};
    if (std::vector<ParametersFrom> its = parametersOf(history); !its.empty())
        parameters = std::move(its);
    storeParameters();
    emit session.parametersChanged();
    emit session.historyChanged(static_cast<int>(history.steps().size()));
    showMap();
    return {};
}

void SessionParts::cancelRerun()
{
    rerunCancelled_ = true;
    run->work().abandon();
}

/// A re-run is complete, unless it was cancelled.
void SessionParts::takeRerun()
{
    if (!rerunCancelled_) {
        former.replace(history, std::move(*rerunHistory_));
        parameters = {{0, parameters.back().parameters}};
        storeParameters();
        emit session.historyChanged(static_cast<int>(history.steps().size()));
        emit session.rerunMade();
    }
    rerunHistory_.reset();
}

/// What is extracted from the file from now on is what is shown.
void SessionParts::storeParameters()
{
    if (!opened.project)
        return;
    for (const ParametersFrom& from : parameters) {
        if (const auto stored = opened.project->appendParameters(opened.scan, from.parameters, from.step); !stored)
            return tellFault(stored.error());
    }
}

}  // namespace planewright
