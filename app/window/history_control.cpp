// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/history_control.h"

#include <algorithm>
#include <utility>

namespace planewright {

namespace {

/// A playhead that is drawn along the timeline rests for less than this between two steps.
constexpr std::chrono::milliseconds kPlayheadRest{60};

}  // namespace

QString phaseChipWords(const PhaseState& state)
{
    const QString pass = QString::fromUtf8(state.pass.data(), static_cast<qsizetype>(state.pass.size()));
    switch (state.phase) {
        case Phase::Extract:
            return HistoryControl::tr("extracting segments");
        case Phase::Assign:
            return HistoryControl::tr("assigning to planes");
        case Phase::Cluster:
            return HistoryControl::tr("clustering");
        case Phase::Fit:
            return HistoryControl::tr("fitting planes");
        case Phase::SplitMerge:
            return HistoryControl::tr("splitting and merging");
        case Phase::Remaining:
            return HistoryControl::tr("fitting what remained");
        case Phase::Finish:
            break;
    }
    if (pass.isEmpty())
        return HistoryControl::tr("the last pass");
    return HistoryControl::tr("the last pass: %1").arg(QString(pass).replace(QLatin1Char('_'), QLatin1Char(' ')));
}

Result<void> lookAtStep(WindowParts& parts, int step)
{
    const QString refusal = parts.session.refusal(SessionRequest::GoToStep);
    if (!refusal.isEmpty())
        return fail(ErrorCode::Usage, refusal.toStdString());
    Playhead& playhead = parts.playhead;
    const auto& history = playhead.history();
    const bool isNewest = std::none_of(history.begin(), history.end(),
                                       [step](const auto& snapshot) { return snapshot->report.step > step; });
    if (isNewest)
        playhead.follow();
    else
        playhead.goTo(playhead.placeOf(step));
    return {};
}

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
    const PhaseState* state = step && *phase < step->phases.size() ? &step->phases[*phase] : nullptr;
    parts_.shownPhase = state != nullptr ? state->snapshot : nullptr;
    emit phaseShown(state != nullptr ? phaseChipWords(*state) : QString());
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
