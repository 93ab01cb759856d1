// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/compare_control.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/window/history_control.h"
#include "core/params/presets.h"
#include "core/params/registry.h"
#include "ui/models/compared_phase.h"

namespace planewright {

namespace {

/// A room with a curved wall, on which the averages of a cluster's direction differ (section 4.2, Fig. 5).
constexpr const char* kCurvedRoom = "sim:curved?seed=1&speed=0";

QString wordsOf(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// A preset of the method with what is known of the scanner.
Parameters withPreset(const Parameters& present, std::string_view preset)
{
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset), parameters);
    const bool isEstimated = parameters.noise.estimated;
    parameters.sensor = present.sensor;
    parameters.noise = present.noise;
    parameters.noise.estimated = isEstimated;
    return parameters;
}

bool haveSameValues(const Parameters& a, const Parameters& b)
{
    const std::vector<ParameterRow>& rows = parameterRows();
    return std::all_of(rows.begin(), rows.end(), [&](const ParameterRow& row) {
        return printParameter(a, row.key) == printParameter(b, row.key);
    });
}

struct Average {
    const char* value;
    const char* name;
    const char* meaning;
};
constexpr std::array<Average, 3> kAverages{
    {{"sma", "paper, SMA", "clusters by the simple moving average, Eq. (10)"},
     {"lwma", "paper, LWMA", "clusters by the linearly weighted moving average, Eq. (11)"},
     {"ewma", "paper, EWMA", "clusters by the exponentially weighted moving average, Eq. (12)"}}};

/// Where an average stands among the choices: presets come first.
int choiceOf(std::string_view average)
{
    const auto place = std::find_if(kAverages.begin(), kAverages.end(),
                                    [average](const Average& candidate) { return candidate.value == average; });
    return static_cast<int>(methodPresets().size()) + static_cast<int>(place - kAverages.begin());
}

}  // namespace

CompareControl::CompareControl(WindowParts& parts, ScanControl& scan, ThemeFollower& follower)
    : QObject(&parts), parts_(parts), scan_(scan), follower_(follower), panel_(new ComparePanel(model_))
{
    parts_.window->addBottomPanel(panel_, tr("Compare"));
    parts_.isComparing = [this] { return isBusy(); };
    connectActions();
    connect(panel_, &ComparePanel::runRequested, this, &CompareControl::run);
    connect(panel_, &ComparePanel::closeRequested, this, &CompareControl::close);
    connect(panel_, &ComparePanel::planesChosen, this, &CompareControl::choosePlanes);
    connect(&parts_.playhead, &Playhead::placeChanged, this, &CompareControl::showStep);
    connect(&parts_, &WindowParts::mapShown, this, &CompareControl::showStep);
    connect(&parts_.session, &ScanSession::parametersChanged, this, &CompareControl::refreshChoices);
    connect(&parts_.session, &ScanSession::historyChanged, this, [this](int steps) {
        if (steps == 0)
            close();
    });
    connect(&worker_, &MapWorker::shown, this, [this](const std::shared_ptr<const ShownMap>& map) {
        if (branch_)
            parts_.window->secondView().setMap(map);
    });
    refreshChoices();
}

void CompareControl::connectActions()
{
    WindowActions& actions = parts_.window->actions();
    const auto show = [this] {
        parts_.window->showBottomPanel(QStringLiteral("comparePanel"));
        panel_->setFocus();
    };
    connect(actions[QStringLiteral("actCompare")], &QAction::triggered, this, show);
    connect(actions[QStringLiteral("actLayoutCompare")], &QAction::triggered, this, [this, show] {
        parts_.window->present(false);
        parts_.window->compare();
        show();
        if (!branch_) {
            chooseAnother();
            run(panel_->choice());
        }
    });
    connect(actions[QStringLiteral("actMovingAverages")], &QAction::triggered, this, &CompareControl::showExample);
    const auto refresh = [this, &actions] {
        const bool any = parts_.shown->snapshot != nullptr;
        actions[QStringLiteral("actLayoutCompare")]->setEnabled(any);
    };
    connect(&parts_, &WindowParts::mapShown, this, refresh);
    refresh();
}

std::vector<CompareControl::Choice> CompareControl::choices(const Parameters& present)
{
    std::vector<Choice> choices;
    for (const Preset& preset : methodPresets())
        choices.push_back({wordsOf(preset.name), wordsOf(preset.meaning), withPreset(present, preset.name)});
    for (const Average& average : kAverages) {
        Parameters parameters = withPreset(present, "paper");
        if (setParameter(parameters, "clusters.average", average.value))
            choices.push_back({QString::fromLatin1(average.name), tr(average.meaning), parameters});
    }
    choices.push_back(
        {tr("parameters as set"), tr("what the Parameters tab has now: change there, then compare"), present});
    return choices;
}

void CompareControl::refreshChoices()
{
    choices_ = choices(parts_.session.parameters());
    QStringList names;
    QStringList meanings;
    for (const Choice& choice : choices_) {
        names.push_back(choice.name);
        meanings.push_back(choice.meaning);
    }
    panel_->setChoices(names, meanings);
}

/// A choice that says how the scan was extracted, with its average where that is one of the paper's.
QString CompareControl::nameOfScan() const
{
    const Parameters& parameters = *parts_.session.history().back().parameters;
    std::vector<Choice> candidates = choices(parameters);
    candidates.pop_back();  // the parameters themselves
    const auto match = std::find_if(candidates.rbegin(), candidates.rend(), [&](const Choice& candidate) {
        return haveSameValues(candidate.parameters, parameters);
    });
    return match == candidates.rend() ? tr("this scan") : match->name;
}

/// A scan beside itself shows nothing: the first choice that differs from it, where the present one does not.
void CompareControl::chooseAnother()
{
    if (parts_.session.history().empty())
        return;
    const Parameters& ofScan = *parts_.session.history().back().parameters;
    const auto isOther = [&](const Choice& choice) { return !haveSameValues(choice.parameters, ofScan); };
    if (isOther(choices_[static_cast<std::size_t>(panel_->choice())]))
        return;
    const auto other = std::find_if(choices_.begin(), choices_.end(), isOther);
    if (other != choices_.end())
        panel_->setChoice(static_cast<int>(other - choices_.begin()));
}

/// The second view looks like the first, from the same place.
void CompareControl::connectView()
{
    if (std::exchange(isLinked_, true))
        return;
    View3d& first = parts_.window->view();
    View3d& second = parts_.window->secondView();
    if (const auto presented = second.present(first.presented()); !presented)
        parts_.problem(tr("compare"), presented.error());
    connect(&first, &View3d::cameraChanged, this, [this, &first, &second] { follow(first, second); });
    connect(&second, &View3d::cameraChanged, this, [this, &first, &second] { follow(second, first); });
    connect(&first, &View3d::cameraFitted, this, [this, &first, &second] { follow(first, second); });
    connect(&second, &View3d::cameraFitted, this, [this, &first, &second] { follow(first, second); });
    connect(&first, &View3d::clipBoxChanged, this, [&first, &second] { second.setClipBox(first.scene().clipBox()); });
    connect(&second, &View3d::clicked, this, [this](const std::optional<Picked>& picked, bool /*add*/) {
        const PlaneId plane = picked ? picked->plane : kNoPlane;
        const int row = model_.rowOfB(plane);
        choosePlanes(row < 0 ? kNoPlane : model_.planeA(row), plane);
    });
    connect(&parts_, &WindowParts::layersChanged, this, [this, &second] { second.setLayers(parts_.layers); });
    connect(&parts_, &WindowParts::preferencesChanged, this, [this, &second] { second.setTheme(follower_.theme()); });
    connect(&follower_, &ThemeFollower::themeChanged, &second, &View3d::setTheme);
    connect(&parts_.selection, &MapSelection::changed, this, &CompareControl::takeSelection);
    second.setLayers(parts_.layers);
    second.setTheme(follower_.theme());
    second.setClipBox(first.scene().clipBox());
}

/// The one that follows tells nobody: who has not been moved goes on fitting the scan by itself.
void CompareControl::follow(const View3d& from, View3d& to)
{
    if (std::exchange(isFollowing_, true))
        return;
    to.setCamera(from.camera());
    isFollowing_ = false;
}

void CompareControl::run(int choice)
{
    if (choice < 0 || choice >= static_cast<int>(choices_.size()))
        return;
    if (parts_.session.history().empty()) {
        parts_.say(tr("There is no scan to compare; open or take one first."));
        return;
    }
    const Choice& chosen = choices_[static_cast<std::size_t>(choice)];
    branch_ = std::make_unique<ScanBranch>(parts_.session.measuredDescription(), parts_.session.measuredSlices(),
                                           chosen.parameters, parts_.session.map()->plannedSteps);
    branchName_ = chosen.name;
    connect(branch_.get(), &ScanBranch::grown, this, &CompareControl::takeGrown);
    connect(branch_.get(), &ScanBranch::ended, this, &CompareControl::takeEnded);
    panel_->setNames(nameOfScan(), branchName_);
    panel_->setProgress(0, static_cast<int>(parts_.session.history().size()));
    connectView();
    parts_.window->showSecondView(true);
    follow(parts_.window->view(), parts_.window->secondView());
    parts_.window->showBottomPanel(QStringLiteral("comparePanel"));
}

void CompareControl::close()
{
    branch_.reset();
    model_.setMaps(nullptr, nullptr);
    panel_->setTotals(nullptr, nullptr);
    panel_->setIdle(false);
    parts_.window->showSecondView(false);
}

void CompareControl::takeGrown()
{
    panel_->setProgress(static_cast<int>(branch_->history().steps().size()),
                        static_cast<int>(parts_.session.history().size()));
}

void CompareControl::takeEnded()
{
    panel_->setIdle(true);
    if (const auto& problem = branch_->problem()) {
        parts_.problem(tr("compare"), *problem);
        return;
    }
    showStep();
}

/// Both maps at the step that is looked at.
void CompareControl::showStep()
{
    if (!branch_ || !branch_->isFinished() || !parts_.shown->snapshot)
        return;
    const Playhead& playhead = parts_.playhead;
    const ScanHistory& history = branch_->history();
    const auto snapshot = playhead.snapshot();
    // The forced last pass has no step of its own; until it was made, the step before it is what is newest.
    const bool isLast = !snapshot || snapshot->report.step < 0;
    std::shared_ptr<const SessionMap> map =
        isLast ? history.newest() : history.after(static_cast<std::size_t>(playhead.place()) + 1);
    QString fact;
    if (auto phase = phaseOfBranch(fact)) {
        auto within = std::make_shared<SessionMap>(*map);
        within->snapshot = std::move(phase);
        map = std::move(within);
    }
    worker_.show({map, {}, history.description(), branch_->parameters()});
    model_.setMaps(parts_.shown->snapshot, map->snapshot);
    panel_->setTotals(parts_.shown->snapshot.get(), map->snapshot.get());
    OverlayContent words;
    words.stateText = tr("B: %1").arg(branchName_);
    words.stateColour = QColor(0x6a, 0x4c, 0x93);
    if (map->snapshot)
        words.facts = QStringList{tr("planes %1").arg(map->snapshot->planes.size())};
    if (!fact.isEmpty())
        words.facts.push_back(fact);
    parts_.window->secondView().setOverlay(words);
    takeSelection();
}

std::shared_ptr<const Snapshot> CompareControl::phaseOfBranch(QString& fact)
{
    const Playhead& playhead = parts_.playhead;
    if (!playhead.phase() || !parts_.shownPhase)
        return nullptr;
    const int step = playhead.snapshot()->report.step;
    const auto a = parts_.session.explained(step);
    const auto b = branch_->history().explained(step);
    if (!a || !b || *playhead.phase() >= (*a)->phases.size())
        return nullptr;
    const ComparedPhase beside = comparedPhase(**a, *playhead.phase(), **b);
    const QString phase = phaseChipWords((*a)->phases[*playhead.phase()]);
    if (beside.state == nullptr) {
        fact = tr("has no such pass: at its end");
        return nullptr;
    }
    fact = beside.isSame ? tr("after %1").arg(phase)
                         : tr("%1 is not due: after %2").arg(phase, phaseChipWords(*beside.state));
    return beside.state->snapshot;
}

void CompareControl::choosePlanes(PlaneId a, PlaneId b)
{
    parts_.selection.select(a == kNoPlane ? std::set<PlaneId>{} : std::set<PlaneId>{a});
    SceneSelection selection;
    if (b != kNoPlane)
        selection.planes.insert(b);
    parts_.window->secondView().setSelection(selection);
}

/// What is chosen in the first view has its partners chosen in the second.
void CompareControl::takeSelection()
{
    if (!branch_)
        return;
    SceneSelection selection;
    for (const PlaneId plane : parts_.selection.planes()) {
        const int row = model_.rowOfA(plane);
        if (row >= 0 && model_.planeB(row) != kNoPlane)
            selection.planes.insert(model_.planeB(row));
    }
    parts_.window->secondView().setSelection(selection);
}

/// Fig. 5: a curved wall is scanned and extracted with the simple average, and the exponential one is held against it.
void CompareControl::showExample()
{
    example_ = std::make_unique<QObject>();
    connect(&parts_.session, &ScanSession::stateChanged, example_.get(),
            [this, isExtracted = false](SessionState state) mutable {
                if (state != SessionState::Review)
                    return;
                // Who has opened something else meanwhile wants no example.
                if (parts_.session.address() != kCurvedRoom) {
                    example_.release()->deleteLater();
                    return;
                }
                if (!std::exchange(isExtracted, true)) {
                    const auto index = static_cast<std::size_t>(choiceOf("sma"));
                    Result<void> begun =
                        parts_.session.setParameters(choices(parts_.session.parameters())[index].parameters);
                    if (begun)
                        begun = parts_.session.rerun();
                    if (begun)
                        return;
                    parts_.problem(tr("compare"), begun.error());
                } else {
                    panel_->setChoice(choiceOf("ewma"));
                    run(panel_->choice());
                }
                example_.release()->deleteLater();
            });
    scan_.open(QString::fromLatin1(kCurvedRoom), true);
}

}  // namespace planewright
