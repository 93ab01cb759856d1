// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/inspector_control.h"

#include <algorithm>

#include "ui/models/decision_text.h"

namespace planewright {

namespace {

/// How often the inspector follows steps that come faster than the playhead rests.
constexpr std::chrono::milliseconds kLiveEvery{300};
/// Narrower, most rows would take three lines.
constexpr int kLeastInspectorWidth = 300;  // [px]

bool hasPlane(const Snapshot& snapshot, PlaneId plane)
{
    return std::any_of(snapshot.planes.begin(), snapshot.planes.end(),
                       [plane](const auto& candidate) { return candidate->id == plane; });
}

bool hasSegment(const Snapshot& snapshot, const SegmentId& segment)
{
    const std::size_t slice = snapshot.segments.find(segment.step);
    return slice < snapshot.segments.slices() && segment.index >= 0 &&
           static_cast<std::size_t>(segment.index) < snapshot.segments.slice(slice).size();
}

}  // namespace

InspectorControl::InspectorControl(WindowParts& parts, HistoryControl& history)
    : QObject(&parts),
      parts_(parts),
      history_(history),
      tabs_(new QTabWidget),
      inspector_(new InspectorPanel),
      whyNot_(new WhyNotPanel)
{
    tabs_->setObjectName(QStringLiteral("inspectorTabs"));
    tabs_->setAccessibleName(tr("Step inspector"));
    tabs_->setDocumentMode(true);
    tabs_->setMinimumWidth(kLeastInspectorWidth);
    tabs_->addTab(inspector_, tr("Step"));
    tabs_->addTab(whyNot_, tr("Why not?"));
    inspector_->setLengthStyle(parts_.preferences.lengths);
    whyNot_->setLengthStyle(parts_.preferences.lengths);
    parts_.window->setPanel(QStringLiteral("dockInspector"), tabs_);

    live_.setSingleShot(true);
    live_.setInterval(kLiveEvery);
    connect(&live_, &QTimer::timeout, this, [this] { showStep(false); });
    connect(&parts_.playhead, &Playhead::placeChanged, this, [this](int place) {
        // Where a scan begins anew nothing of the one before stays.
        if (place < 0)
            showStep(false);
        else if (!live_.isActive())
            live_.start();
    });
    connect(&history_, &HistoryControl::rested, this, [this] {
        live_.stop();
        showStep(true);
        askWhyNot();
    });
    connect(&parts_, &WindowParts::preferencesChanged, this, [this] {
        inspector_->setLengthStyle(parts_.preferences.lengths);
        whyNot_->setLengthStyle(parts_.preferences.lengths);
    });
    connectInspector();
    connectWhyNot();
}

void InspectorControl::connectInspector()
{
    connect(&parts_.playhead, &Playhead::phaseChanged, this,
            [this] { inspector_->setShownPhase(parts_.playhead.phase()); });
    connect(inspector_, &InspectorPanel::shown, this, [this] { showStep(true); });
    connect(inspector_, &InspectorPanel::operandsChosen, this, &InspectorControl::select);
    connect(inspector_, &InspectorPanel::phaseRequested, this, [this](std::size_t phase) {
        parts_.playhead.goTo(parts_.playhead.place());
        parts_.playhead.showPhase(phase);
    });
    connect(inspector_, &InspectorPanel::parameterRequested, this,
            [this](const QString& key) { parts_.showParameter(key.toStdString()); });
    connect(inspector_, &InspectorPanel::playPhaseRequested, this, [this] { history_.goByPhase(1); });
    connect(inspector_, &InspectorPanel::whyNotRequested, this, &InspectorControl::beginWhyNot);
}

void InspectorControl::connectWhyNot()
{
    connect(parts_.window->actions()[QStringLiteral("actWhyNot")], &QAction::triggered, this,
            &InspectorControl::beginWhyNot);
    connect(whyNot_, &WhyNotPanel::shown, this, &InspectorControl::askWhyNot);
    connect(whyNot_, &WhyNotPanel::asked, this, &InspectorControl::askWhyNot);
    connect(whyNot_, &WhyNotPanel::parameterRequested, this,
            [this](const QString& key) { parts_.showParameter(key.toStdString()); });
}

void InspectorControl::showStep(bool byPhases)
{
    if (!inspector_->isVisible())
        return;
    const auto place = static_cast<std::size_t>(parts_.playhead.place());
    const std::vector<ExtractedStep>& steps = parts_.session.history();
    if (parts_.playhead.place() < 0 || place >= steps.size() || steps[place].snapshot != parts_.playhead.snapshot()) {
        told_ = {};
        inspector_->setStep(std::nullopt);
        return;
    }
    const ExtractedStep& step = steps[place];
    InspectedStep told;
    told.snapshot = step.snapshot;
    if (byPhases)
        told.phased = history_.explained();
    if (told_ == std::pair(told.snapshot.get(), told.phased.get()))
        return;
    told_ = {told.snapshot.get(), told.phased.get()};
    told.parameters = step.parameters ? *step.parameters : parts_.session.parameters();
    if (step.slice)
        told.time = step.slice->time;
    const bool isOver = parts_.playhead.history().back()->report.step < 0;
    const std::size_t last = steps.size() - (isOver ? 2 : 1);
    told.newest = last < steps.size() ? steps[last].snapshot->report.step : -1;
    told.planned = isOver ? told.newest + 1 : parts_.playhead.planned();
    inspector_->setStep(std::move(told));
    inspector_->setShownPhase(parts_.playhead.phase());
}

/// Clusters stand for their segments; what the map does not show, as pieces that are no segments, cannot be selected.
void InspectorControl::select(const std::vector<Operand>& operands)
{
    const std::shared_ptr<const Snapshot> now = parts_.playhead.snapshot();
    if (!now)
        return;
    const int place = parts_.playhead.place();
    const Snapshot* before = place > 0 ? parts_.playhead.history()[static_cast<std::size_t>(place) - 1].get() : nullptr;
    std::set<PlaneId> planes;
    std::set<SegmentId> segments;
    for (const Operand& operand : operands) {
        if (const auto* plane = std::get_if<PlaneRef>(&operand))
            planes.insert(plane->id);
        else if (const auto* segment = std::get_if<SegmentId>(&operand))
            segments.insert(*segment);
        else if (const auto* cluster = std::get_if<ClusterRef>(&operand)) {
            const std::vector<SegmentId> all = segmentsOfCluster(cluster->id, before, *now);
            segments.insert(all.begin(), all.end());
        }
    }
    std::erase_if(planes, [this](PlaneId plane) {
        return std::none_of(parts_.shown->planes.begin(), parts_.shown->planes.end(),
                            [plane](const ShownPlane& shown) { return shown.plane->id == plane; });
    });
    parts_.selection.select(std::move(planes), std::move(segments));
}

/// With what is selected, where that is two planes, or a segment and a plane.
void InspectorControl::beginWhyNot()
{
    const std::set<PlaneId>& planes = parts_.selection.planes();
    const std::set<SegmentId>& segments = parts_.selection.segments();
    if (planes.size() == 2 && segments.empty())
        whyNot_->setOperands(PlaneRef{*planes.begin()}, PlaneRef{*planes.rbegin()});
    else if (planes.size() == 1 && segments.size() == 1)
        whyNot_->setOperands(*segments.begin(), PlaneRef{*planes.begin()});
    parts_.window->showInspector();
    tabs_->setCurrentWidget(whyNot_);
    askWhyNot();
    whyNot_->setFocus();
}

QString InspectorControl::missing(const Operand& operand) const
{
    const std::shared_ptr<const Snapshot> snapshot = parts_.playhead.snapshot();
    const auto* plane = std::get_if<PlaneRef>(&operand);
    const auto* segment = std::get_if<SegmentId>(&operand);
    if ((plane == nullptr || hasPlane(*snapshot, plane->id)) && (segment == nullptr || hasSegment(*snapshot, *segment)))
        return {};
    return tr("There is no %1 at step %2. Choose another one, or another step.")
        .arg(operandText(operand), stepText(snapshot->report.step));
}

void InspectorControl::askWhyNot()
{
    if (!whyNot_->isVisible())
        return;
    const std::shared_ptr<const Snapshot> snapshot = parts_.playhead.snapshot();
    if (!snapshot) {
        whyNot_->setProblem(tr("Choose a step in the timeline."));
        return;
    }
    std::vector<PlaneId> planes;
    for (const auto& plane : snapshot->planes)
        planes.push_back(plane->id);
    whyNot_->setPlanes(planes);
    const auto first = whyNot_->first();
    const auto second = whyNot_->second();
    if (!first || !second) {
        whyNot_->setProblem(
            tr("Choose two planes, or a segment and a plane: here, or select them in the 3D view or the "
               "tables and press Y."));
        return;
    }
    for (const Operand& operand : {*first, *second}) {
        if (const QString problem = missing(operand); !problem.isEmpty()) {
            whyNot_->setProblem(problem);
            return;
        }
    }
    auto answer = parts_.session.whyNot(snapshot->report.step, *first, *second);
    if (answer)
        whyNot_->setAnswer(std::move(*answer), stepText(snapshot->report.step));
    else
        whyNot_->setProblem(QString::fromStdString(answer.error().message));
}

}  // namespace planewright
