// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/history_control.h"

#include <utility>

namespace planewright {

namespace {

/// A playhead that is drawn along the timeline rests for less than this between two steps.
constexpr std::chrono::milliseconds kPlayheadRest{60};

}  // namespace

HistoryControl::HistoryControl(WindowParts& parts) : QObject(&parts), parts_(parts)
{
    rest_.setSingleShot(true);
    rest_.setInterval(kPlayheadRest);
    connect(&rest_, &QTimer::timeout, this, &HistoryControl::rested);
    connect(&parts_.session, &ScanSession::historyChanged, this, &HistoryControl::takeHistory);
    connect(&parts_.playhead, &Playhead::placeChanged, this, &HistoryControl::takePlace);
    connect(&parts_.playhead, &Playhead::phaseChanged, this, &HistoryControl::takePhase);
    takeHistory();
}

void HistoryControl::takeHistory()
{
    const std::vector<ExtractedStep>& steps = parts_.session.history();
    const Playhead::History& before = parts_.playhead.history();
    const bool goesOn = !before.empty() && steps.size() >= before.size() && steps.front().snapshot == before.front();
    Playhead::History history;
    history.reserve(steps.size());
    if (goesOn)
        history = before;
    else
        explainedPlace_ = -1;
    for (std::size_t place = history.size(); place < steps.size(); ++place)
        history.push_back(steps[place].snapshot);
    parts_.playhead.setHistory(std::move(history), parts_.session.map()->plannedSteps);
}

/// The session shows the newest by itself.
void HistoryControl::takePlace()
{
    const Playhead& playhead = parts_.playhead;
    if (playhead.followsNewest()) {
        if (!parts_.session.map()->isNewest)
            static_cast<void>(parts_.session.goToNewest());
    } else if (playhead.place() >= 0) {
        if (const auto gone = parts_.session.goToPlace(playhead.place()); !gone)
            parts_.say(QString::fromStdString(gone.error().message));
    }
    rest_.start();
}

void HistoryControl::takePhase()
{
    const std::optional<std::size_t> phase = parts_.playhead.phase();
    const auto step = phase ? explained() : nullptr;
    parts_.shownPhase = step && *phase < step->phases.size() ? step->phases[*phase].snapshot : nullptr;
    parts_.showMap();
}

std::shared_ptr<const PhasedStep> HistoryControl::explained()
{
    const int place = parts_.playhead.place();
    if (place < 0)
        return nullptr;
    if (place != explainedPlace_) {
        const auto step = parts_.session.explained(parts_.playhead.snapshot()->report.step);
        if (!step) {
            parts_.problem(tr("history"), step.error());
            return nullptr;
        }
        explained_ = *step;
        explainedPlace_ = place;
    }
    return explained_;
}

void HistoryControl::goByPhase(int by)
{
    Playhead& playhead = parts_.playhead;
    auto step = explained();
    if (!step || step->phases.empty())
        return;
    const int last = static_cast<int>(step->phases.size()) - 1;
    const int phase = playhead.phase() ? static_cast<int>(*playhead.phase()) : last;
    if (phase + by >= 0 && phase + by <= last) {
        playhead.goTo(playhead.place());
        playhead.showPhase(static_cast<std::size_t>(phase + by));
        return;
    }
    const int place = playhead.place() + (by > 0 ? 1 : -1);
    if (place < 0 || place >= static_cast<int>(playhead.history().size()))
        return;
    playhead.goTo(place);
    step = explained();
    if (step && !step->phases.empty())
        playhead.showPhase(by > 0 ? 0 : step->phases.size() - 1);
}

}  // namespace planewright
