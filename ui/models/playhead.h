// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <QObject>

#include "core/types/snapshot.h"

namespace planewright {

/// Which moment of a scan is looked at: one for the timeline, the inspector, the charts and the 3D view.
///
/// Moments are places in the history of a scan: one for each step in their order, and a last one for the forced last
/// pass. Within a step that is looked at, a phase may be chosen. Who looks back stays where he is while the scan goes
/// on.
class Playhead : public QObject {
    Q_OBJECT

public:
    using History = std::vector<std::shared_ptr<const Snapshot>>;

    explicit Playhead(QObject* parent = nullptr);

    /// The steps of a scan so far; where they do not go on from those before, everything begins anew. `planned`: steps
    /// that there will be, 0 where nobody knows.
    void setHistory(History history, int planned);
    const History& history() const { return history_; }
    int planned() const { return planned_; }

    /// −1 without steps.
    int place() const { return place_; }
    bool followsNewest() const { return followsNewest_; }
    /// What was after the step of place(); null without steps.
    std::shared_ptr<const Snapshot> snapshot() const;
    /// The place of a step, or of the last one before it; −1 where there is none.
    int placeOf(int step) const;

    /// The nearest place that there is; looking at the newest does not follow it.
    void goTo(int place);
    void follow();

    /// A phase of the step that is looked at, by its number among those that were due; empty: all of the step.
    std::optional<std::size_t> phase() const { return phase_; }
    void showPhase(std::optional<std::size_t> phase);

    /// First and last place that are played again and again; empty for none.
    std::optional<std::pair<int, int>> loop() const { return loop_; }
    void setLoop(std::optional<std::pair<int, int>> loop);

    /// Places that somebody wants to find again.
    const std::set<int>& bookmarks() const { return bookmarks_; }
    void toggleBookmark(int place);

signals:
    /// history() has grown or begun anew.
    void historyChanged();
    /// Another place is looked at, or the same place of a scan that begins anew, or it follows the newest now, or no
    /// more.
    void placeChanged(int place);
    void phaseChanged();
    void loopChanged();
    void bookmarksChanged();

private:
    void look(int place, bool followsNewest);

    History history_;
    int planned_ = 0;
    int place_ = -1;
    bool followsNewest_ = true;
    std::optional<std::size_t> phase_;
    std::optional<std::pair<int, int>> loop_;
    std::set<int> bookmarks_;
};

}  // namespace planewright
