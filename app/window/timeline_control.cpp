// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/timeline_control.h"

#include <algorithm>

#include "app/window/timeline_words.h"

namespace planewright {

namespace {

constexpr std::string_view kBookmarksKey = "bookmarks";
constexpr int kManySteps = 10;

TimelineActions timelineActions(const WindowActions& actions)
{
    return {.first = actions[QStringLiteral("actFirstStep")],
            .back = actions[QStringLiteral("actStepBack")],
            .play = actions[QStringLiteral("actPlay")],
            .forward = actions[QStringLiteral("actStepForward")],
            .last = actions[QStringLiteral("actLastStep")],
            .loop = actions[QStringLiteral("actLoop")],
            .eventBack = actions[QStringLiteral("actEventBack")],
            .eventForward = actions[QStringLiteral("actEventForward")],
            .live = actions[QStringLiteral("actLive")]};
}

}  // namespace

TimelineControl::TimelineControl(WindowParts& parts, HistoryControl& history)
    : QObject(&parts),
      parts_(parts),
      history_(history),
      player_(parts.playhead, [this](int place) { return timeAt(place); }),
      panel_(new TimelinePanel(timelineActions(parts.window->actions())))
{
    parts_.window->setPanel(QStringLiteral("dockTimeline"), panel_);
    parts_.window->actions().letKeysWorkIn(*panel_);
    connectActions();
    connectLoop();
    connectMenu();
    connect(panel_, &TimelinePanel::placeRequested, this, &TimelineControl::goTo);
    connect(panel_, &TimelinePanel::stepRequested, this, [this](int step) { goTo(parts_.playhead.placeOf(step)); });
    connect(panel_, &TimelinePanel::speedChanged, &player_, &HistoryPlayer::setSpeed);
    connect(panel_, &TimelinePanel::eventKindChanged, this, &TimelineControl::refreshActions);
    connect(&parts_.playhead, &Playhead::historyChanged, this, &TimelineControl::takeHistory);
    connect(&parts_.playhead, &Playhead::placeChanged, this, &TimelineControl::showPlace);
    connect(&parts_.playhead, &Playhead::phaseChanged, this, &TimelineControl::refreshActions);
    connect(&parts_.playhead, &Playhead::bookmarksChanged, this, [this] {
        panel_->strip().setBookmarks(parts_.playhead.bookmarks());
        refreshActions();
    });
    connect(&parts_, &WindowParts::mapShown, this, &TimelineControl::takeEdits);
    connect(&parts_.session, &ScanSession::stateChanged, this, [this] {
        showColumns();
        showPlace();
    });
    connect(&parts_.session, &ScanSession::projectChanged, this, &TimelineControl::takeProject);
    connect(&parts_.session, &ScanSession::projectBegun, this, &TimelineControl::saveBookmarks);
    connect(&parts_.session, &ScanSession::logLine, this,
            [this](LogLevel level, const QString& /*source*/, const QString& text) { hear(level, text); });
    takeProject();
    takeHistory();
}

void TimelineControl::connectActions()
{
    WindowActions& actions = parts_.window->actions();
    const auto on = [&](const char* name, auto&& call) {
        connect(actions[QLatin1String(name)], &QAction::triggered, this, call);
    };
    Playhead& playhead = parts_.playhead;
    on("actPlay", [this](bool plays) {
        if (plays)
            player_.play();
        else
            player_.pause();
        refreshActions();
    });
    connect(&player_, &HistoryPlayer::playingChanged, this, &TimelineControl::refreshActions);
    on("actStepBack", [this, &playhead] { goTo(playhead.place() - 1); });
    on("actStepForward", [this] { stepForward(); });
    on("actTenBack", [this, &playhead] { goTo(playhead.place() - kManySteps); });
    on("actTenForward", [this, &playhead] { goTo(playhead.place() + kManySteps); });
    on("actFirstStep", [this] { goTo(0); });
    on("actLastStep", [this, &playhead] { goTo(static_cast<int>(playhead.history().size()) - 1); });
    on("actLive", [this] { goToNewest(); });
    on("actEventBack", [this] { goToEvent(false); });
    on("actEventForward", [this] { goToEvent(true); });
    on("actPhaseBack", [this] { goByPhase(-1); });
    on("actPhaseForward", [this] { goByPhase(1); });
    on("actSlower", [this] { panel_->changeSpeed(-1); });
    on("actFaster", [this] { panel_->changeSpeed(1); });
    on("actBookmark", [this, &playhead] { toggleBookmark(playhead.place()); });
    on("actNextBookmark", [this] { goToNextBookmark(); });
}

void TimelineControl::connectLoop()
{
    WindowActions& actions = parts_.window->actions();
    Playhead& playhead = parts_.playhead;
    const auto newest = [&playhead] { return static_cast<int>(playhead.history().size()) - 1; };
    connect(actions[QStringLiteral("actLoop")], &QAction::triggered, this, [&playhead, newest](bool on) {
        if (on && newest() >= 0)
            playhead.setLoop(std::pair(0, newest()));
        else
            playhead.setLoop({});
    });
    connect(actions[QStringLiteral("actLoopIn")], &QAction::triggered, this, [&playhead, newest] {
        const int to = playhead.loop() ? playhead.loop()->second : newest();
        playhead.setLoop(std::pair(playhead.place(), std::max(to, playhead.place())));
    });
    connect(actions[QStringLiteral("actLoopOut")], &QAction::triggered, this, [&playhead] {
        const int from = playhead.loop() ? playhead.loop()->first : 0;
        playhead.setLoop(std::pair(std::min(from, playhead.place()), playhead.place()));
    });
    connect(panel_, &TimelinePanel::loopRequested, &playhead, &Playhead::setLoop);
    connect(&playhead, &Playhead::loopChanged, this, [this] {
        panel_->strip().setLoop(parts_.playhead.loop());
        refreshActions();
    });
}

void TimelineControl::connectMenu()
{
    auto* bookmark = new QAction(tr("&Bookmark here"), this);
    bookmark->setObjectName(QStringLiteral("actBookmarkHere"));
    connect(bookmark, &QAction::triggered, this, [this] { toggleBookmark(panel_->menuPlace()); });
    auto* save = new QAction(tr("&Export this step…"), this);
    save->setObjectName(QStringLiteral("actExportHere"));
    connect(save, &QAction::triggered, this, [this] {
        goTo(panel_->menuPlace());
        parts_.window->actions()[QStringLiteral("actExportPlanes")]->trigger();
    });
    panel_->setPlaceActions({bookmark, save});
}

/// Slices come, or those that came are being worked in.
bool TimelineControl::isGoingOn() const
{
    switch (parts_.session.state()) {
        case SessionState::Homing:
        case SessionState::Scanning:
        case SessionState::Paused:
        case SessionState::Finishing:
        case SessionState::Replaying:
        case SessionState::Fault:
            return true;
        default:
            return false;
    }
}

/// A step more is then a slice more.
bool TimelineControl::isHeldAtNewest() const
{
    const Playhead& playhead = parts_.playhead;
    return playhead.place() == static_cast<int>(playhead.history().size()) - 1 && !playhead.phase() &&
           parts_.session.refusal(SessionRequest::Step).isEmpty();
}

int TimelineControl::placeOfStep(int step) const
{
    const Playhead::History& history = parts_.playhead.history();
    if (history.empty())
        return -1;
    const int place = step == kLastPass ? static_cast<int>(history.size()) - 1 : parts_.playhead.placeOf(step);
    return place >= 0 && history[static_cast<std::size_t>(place)]->report.step == step ? place : -1;
}

/// How long it was from the slice of a place to the next. Where nobody knows, and where the scan was held, as long as
/// a turn of the mirror.
std::chrono::microseconds TimelineControl::timeAt(int place) const
{
    constexpr std::chrono::microseconds kTurn{25'000};
    constexpr std::chrono::microseconds kLongest{2'000'000};
    const std::vector<ExtractedStep>& steps = parts_.session.history();
    const auto next = static_cast<std::size_t>(place) + 1;
    if (next >= steps.size() || !steps[next].measured || !steps[next - 1].measured)
        return kTurn;
    const auto time = steps[next].measured->time - steps[next - 1].measured->time;
    return time > std::chrono::microseconds::zero() && time <= kLongest ? time : kTurn;
}

/// The end of a scan that is over is also what is newest.
void TimelineControl::goTo(int place)
{
    player_.pause();
    const int newest = static_cast<int>(parts_.playhead.history().size()) - 1;
    if (place >= newest && !isGoingOn())
        parts_.playhead.follow();
    else
        parts_.playhead.goTo(place);
}

void TimelineControl::goToNewest()
{
    player_.pause();
    parts_.playhead.follow();
}

void TimelineControl::stepForward()
{
    if (!isHeldAtNewest()) {
        goTo(parts_.playhead.place() + 1);
        return;
    }
    goToNewest();
    if (const auto taken = parts_.session.step(); !taken)
        parts_.say(QString::fromStdString(taken.error().message));
}

void TimelineControl::goToEvent(bool forward)
{
    const auto place = nextEvent(panel_->strip().columns(), parts_.playhead.bookmarks(), parts_.playhead.place(),
                                 forward, panel_->eventKind());
    if (place)
        goTo(*place);
    else
        parts_.say(forward ? tr("There is no such event after this step.")
                           : tr("There is no such event before this step."));
}

void TimelineControl::goToNextBookmark()
{
    const std::set<int>& bookmarks = parts_.playhead.bookmarks();
    if (bookmarks.empty()) {
        parts_.say(tr("There is no bookmark yet: M marks the step that is looked at."));
        return;
    }
    const auto next = bookmarks.upper_bound(parts_.playhead.place());
    goTo(next != bookmarks.end() ? *next : *bookmarks.begin());
}

void TimelineControl::goByPhase(int by)
{
    player_.pause();
    history_.goByPhase(by);
}

void TimelineControl::toggleBookmark(int place)
{
    const Playhead::History& history = parts_.playhead.history();
    if (place < 0 || place >= static_cast<int>(history.size()))
        return;
    const int step = history[static_cast<std::size_t>(place)]->report.step;
    if (bookmarkedSteps_.erase(step) == 0)
        bookmarkedSteps_.insert(step);
    parts_.playhead.toggleBookmark(place);
    saveBookmarks();
}

void TimelineControl::saveBookmarks()
{
    PwscanProject* project = parts_.session.project();
    if (project == nullptr || !project->readOnlyBecause().empty())
        return;
    const auto done =
        project->setSetting(parts_.session.scanInProject(), kBookmarksKey, textOfBookmarks(bookmarkedSteps_));
    if (!done)
        parts_.log(LogSeverity::Warning, tr("bookmarks"), QString::fromStdString(done.error().message));
}

/// Another scan: with the bookmarks of its file, and nothing of the one before.
void TimelineControl::takeProject()
{
    faults_.clear();
    bookmarkedSteps_.clear();
    if (PwscanProject* project = parts_.session.project()) {
        if (const auto events = project->events(parts_.session.scanInProject()))
            faults_ = troublesIn(*events);
        const auto text = project->setting(parts_.session.scanInProject(), kBookmarksKey);
        if (text && *text)
            bookmarkedSteps_ = bookmarkedStepsOf(**text);
    }
    showBookmarks();
}

/// Those of steps that there are by now.
void TimelineControl::showBookmarks()
{
    std::set<int> wanted;
    for (const int step : bookmarkedSteps_) {
        if (const int place = placeOfStep(step); place >= 0)
            wanted.insert(place);
    }
    const std::set<int> shown = parts_.playhead.bookmarks();
    std::set<int> changed;
    std::set_symmetric_difference(wanted.begin(), wanted.end(), shown.begin(), shown.end(),
                                  std::inserter(changed, changed.end()));
    for (const int place : changed)
        parts_.playhead.toggleBookmark(place);
}

void TimelineControl::takeHistory()
{
    const std::vector<ExtractedStep>& steps = parts_.session.history();
    const std::shared_ptr<const Snapshot> first = steps.empty() ? nullptr : steps.front().snapshot;
    if (first != first_ || steps.size() < columns_.size())
        columns_.clear();
    first_ = first;
    for (std::size_t place = columns_.size(); place < steps.size(); ++place) {
        const ExtractedStep& step = steps[place];
        const ExtractedStep* before = place > 0 ? &steps[place - 1] : nullptr;
        const ScheduleParameters schedule =
            step.parameters ? step.parameters->schedule : parts_.session.parameters().schedule;
        TimelineColumn column =
            timelineColumn(*step.snapshot, before != nullptr ? before->snapshot.get() : nullptr, schedule);
        column.faults = troublesOf(step, before);
        if (before != nullptr && step.parameters != before->parameters && step.measured)
            column.edits.push_back(tr("parameters set anew"));
        columns_.push_back(std::move(column));
    }
    editsTaken_.reset();
    showBookmarks();
    takeEdits();  // and shows them all
    showPlace();
}

/// An edit holds from the step on at which all of its planes are there.
void TimelineControl::takeEdits()
{
    const std::vector<Edit> edits = parts_.edits.inForce();
    const std::pair there(parts_.edits.all().size(), edits.size());
    if (there == editsTaken_)
        return;
    editsTaken_ = there;
    edits_.clear();
    const auto& lives = parts_.session.planeLives().lives();
    for (const Edit& edit : edits) {
        int place = -1;
        for (const PlaneId plane : edit.planes) {
            if (const auto life = lives.find(plane); life != lives.end())
                place = std::max(place, placeOfStep(life->second.bornStep()));
        }
        // Planes that edits have made are not among those of the scan.
        if (place < 0)
            place = static_cast<int>(columns_.size()) - 1;
        edits_.emplace_back(place, timelineLineOf(edit));
    }
    showColumns();
}

void TimelineControl::hear(LogLevel level, const QString& text)
{
    if (level == LogLevel::Info || !isGoingOn() || parts_.playhead.history().empty())
        return;
    faults_.emplace_back(parts_.playhead.history().back()->report.step, text);
    showColumns();
}

void TimelineControl::showColumns()
{
    std::vector<TimelineColumn> columns = columns_;
    for (const auto& [place, line] : edits_) {
        if (place >= 0 && place < static_cast<int>(columns.size()))
            columns[static_cast<std::size_t>(place)].edits.push_back(line);
    }
    for (const auto& [step, line] : faults_) {
        const int place = placeOfFault(parts_.playhead, step, !isGoingOn());
        if (place >= 0 && place < static_cast<int>(columns.size()))
            columns[static_cast<std::size_t>(place)].faults.push_back(line);
    }
    panel_->setColumns(std::move(columns), parts_.playhead.planned(), !isGoingOn());
}

void TimelineControl::showPlace()
{
    panel_->setPlace(parts_.playhead.place());
    panel_->setLooksBack(!parts_.playhead.followsNewest() && isGoingOn());
    refreshActions();
}

void TimelineControl::refreshActions()
{
    WindowActions& actions = parts_.window->actions();
    const Playhead& playhead = parts_.playhead;
    const int place = playhead.place();
    const int newest = static_cast<int>(playhead.history().size()) - 1;
    const auto enable = [&](std::initializer_list<const char*> names, bool on) {
        for (const char* name : names)
            actions[QLatin1String(name)]->setEnabled(on);
    };
    enable({"actPlay", "actLoop", "actLoopIn", "actLoopOut", "actBookmark", "actPhaseBack", "actPhaseForward",
            "actEventBack", "actEventForward", "actNextBookmark"},
           newest >= 0);
    enable({"actFirstStep", "actStepBack", "actTenBack"}, place > 0);
    // After a phase of a step comes the whole of it.
    const bool goesOn = place >= 0 && (place < newest || playhead.phase());
    enable({"actLastStep", "actTenForward"}, goesOn);
    enable({"actStepForward"}, goesOn || isHeldAtNewest());
    enable({"actLive"}, newest >= 0 && !playhead.followsNewest());
    actions[QStringLiteral("actPlay")]->setChecked(player_.isPlaying());
    actions[QStringLiteral("actLoop")]->setChecked(playhead.loop().has_value());
    actions[QStringLiteral("actLive")]->setIconText(isGoingOn() ? tr("LIVE") : tr("Newest"));
}

}  // namespace planewright
