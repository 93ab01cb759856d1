// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <QObject>

#include "app/window/history_control.h"
#include "app/window/history_player.h"
#include "app/window/window_parts.h"
#include "ui/panels/timeline_panel.h"

namespace planewright {

/// The timeline and its keys: goes through the steps of a scan, plays them, finds events, keeps bookmarks.
///
/// A scan that runs never waits for whoever looks back. Bookmarks are steps, and a setting of the `.pwscan`.
class TimelineControl : public QObject {
    Q_OBJECT

public:
    TimelineControl(WindowParts& parts, HistoryControl& history);

    TimelinePanel& panel() { return *panel_; }
    HistoryPlayer& player() { return player_; }

private:
    void connectActions();
    void connectLoop();
    void connectMenu();

    // What the user asks for; each ends playing.
    void goTo(int place);
    void goToNewest();
    void stepForward();
    void goToEvent(bool forward);
    void goToNextBookmark();
    void goByPhase(int by);
    void toggleBookmark(int place);

    // What there is to be shown.
    void takeHistory();
    void takeEdits();
    void takeProject();
    void showColumns();
    void showPlace();
    void refreshActions();
    void hear(LogLevel level, const QString& text);

    bool isGoingOn() const;
    bool isHeldAtNewest() const;
    /// The place of a step, −1 for the forced last pass; −1 where there is none.
    int placeOfStep(int step) const;
    std::chrono::microseconds timeAt(int place) const;
    void showBookmarks();
    void saveBookmarks();

    WindowParts& parts_;
    HistoryControl& history_;
    HistoryPlayer player_;
    TimelinePanel* panel_;
    std::vector<TimelineColumn> columns_;          ///< as the history says
    std::shared_ptr<const Snapshot> first_;        ///< of these
    std::vector<std::pair<int, QString>> faults_;  ///< told of while the scan went on, or by its file, with their steps
    /// How many there were, and how many of them in force.
    std::optional<std::pair<std::size_t, std::size_t>> editsTaken_;
    std::vector<std::pair<int, QString>> edits_;  ///< with their places
    std::set<int> bookmarkedSteps_;
};

}  // namespace planewright
