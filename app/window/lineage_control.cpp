// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/lineage_control.h"

#include <algorithm>

namespace planewright {

namespace {

/// How often the graph grows while a scan runs.
constexpr std::chrono::milliseconds kGrowEvery{300};

bool shows(const ShownMap& map, PlaneId plane)
{
    return std::any_of(map.planes.begin(), map.planes.end(),
                       [plane](const ShownPlane& shown) { return shown.plane->id == plane; });
}

}  // namespace

LineageControl::LineageControl(WindowParts& parts, QTabWidget& tabs)
    : QObject(&parts), parts_(parts), panel_(new LineagePanel), seen_(parts.shown)
{
    panel_->setPlanePalette(parts_.layers.palette);
    tabs.addTab(panel_, tr("Lineage"));
    grow_.setSingleShot(true);
    grow_.setInterval(kGrowEvery);
    connect(&grow_, &QTimer::timeout, this, &LineageControl::showChart);
    connect(&parts_.selection, &MapSelection::changed, this, &LineageControl::takeSelection);
    connect(&parts_, &WindowParts::mapShown, this, &LineageControl::follow);
    connect(parts_.window->actions()[QStringLiteral("actSelectNone")], &QAction::triggered, this, [this] {
        chosen_.clear();
        showChart();
    });
    connect(&parts_.playhead, &Playhead::historyChanged, this, [this] {
        if (!grow_.isActive())
            grow_.start();
    });
    connect(&parts_.playhead, &Playhead::placeChanged, this, [this] {
        const auto snapshot = parts_.playhead.snapshot();
        panel_->setStep(snapshot ? snapshot->report.step : 0, snapshot != nullptr);
    });
    connect(panel_, &LineagePanel::shown, this, &LineageControl::showChart);
    connect(panel_, &LineagePanel::planeChosen, this, &LineageControl::goTo);
    connect(&parts_, &WindowParts::layersChanged, this, [this] { panel_->setPlanePalette(parts_.layers.palette); });
}

/// The step of what the window shows, as lives count it.
int LineageControl::shownStep() const
{
    return parts_.shown->finished ? -1 : parts_.shown->step;
}

void LineageControl::takeSelection()
{
    // What another map drops from the selection nobody has chosen.
    if (following_ || parts_.shown != seen_)
        return;
    chosen_ = parts_.selection.planes();
    chosenAt_ = shownStep();
    showChart();
}

void LineageControl::follow()
{
    seen_ = parts_.shown;
    const Playhead::History& history = parts_.playhead.history();
    const auto beginning = history.empty() ? nullptr : history.front();
    if (beginning != beginning_) {
        beginning_ = beginning;
        takeSelection();
        return;
    }
    if (chosen_.empty() || !parts_.shown->snapshot)
        return;
    const PlaneLives& lives = parts_.session.planeLives();
    std::set<PlaneId> found;
    for (const PlaneId plane : chosen_) {
        for (const PlaneId there : lives.follow(plane, chosenAt_, shownStep())) {
            if (shows(*parts_.shown, there))
                found.insert(there);
        }
        // Edits make planes that the scan knows nothing of.
        if (shows(*parts_.shown, plane))
            found.insert(plane);
    }
    following_ = true;
    parts_.selection.selectPlanes(std::move(found));
    following_ = false;
    panel_->setChosen(parts_.selection.planes());
}

void LineageControl::goTo(PlaneId plane, int step)
{
    const Playhead::History& history = parts_.playhead.history();
    const bool hasLastPass = !history.empty() && history.back()->report.step < 0;
    const int place = step < 0 && hasLastPass ? static_cast<int>(history.size()) - 1 : parts_.playhead.placeOf(step);
    if (place < 0)
        return;
    // A plane that is no more is what became of it.
    chosen_ = {plane};
    const bool isThere = parts_.session.planeLives().isThere(plane, step);
    chosenAt_ = isThere || place == 0 ? step : history[static_cast<std::size_t>(place) - 1]->report.step;
    const bool moves = place != parts_.playhead.place();
    parts_.playhead.goTo(place);
    if (!moves)
        follow();
    showChart();
}

void LineageControl::showChart()
{
    if (!panel_->isVisible())
        return;
    const PlaneLives& lives = parts_.session.planeLives();
    std::set<PlaneId> family;
    for (const PlaneId plane : chosen_) {
        for (const PlaneId relative : lives.familyOf(plane))
            family.insert(relative);
    }
    const Playhead::History& history = parts_.playhead.history();
    const bool hasLastPass = !history.empty() && history.back()->report.step < 0;
    const std::size_t steps = history.size() - (hasLastPass ? 1 : 0);
    const int newest = steps > 0 ? history[steps - 1]->report.step : -1;
    panel_->setChart(lineageChart(lives, {family.begin(), family.end()}, newest, hasLastPass));
    panel_->setChosen(parts_.selection.planes());
    const auto snapshot = parts_.playhead.snapshot();
    panel_->setStep(snapshot ? snapshot->report.step : 0, snapshot != nullptr);
}

}  // namespace planewright
