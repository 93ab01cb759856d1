// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <set>
#include <span>

#include <QString>
#include <QStringList>

#include "core/params/parameters.h"
#include "core/types/snapshot.h"

namespace planewright {

/// What the timeline shows of one place of the history.
struct TimelineColumn {
    int step = 0;                  ///< from 0; −1 for the forced last pass
    double tilt = 0.0;             ///< φ of its slice [rad]
    int points = 0;                ///< echoes of its slice
    int segments = 0;              ///< line segments of its slice
    int planes = 0;                ///< that there are after it
    int planesBefore = 0;          ///< that there were before it
    bool fits = false;             ///< planes were due to be fitted
    int fitted = 0;                ///< planes that this gave
    bool splitsAndMerges = false;  ///< planes were due to be split and merged
    int splits = 0;
    int merges = 0;
    QStringList faults;  ///< what went wrong at it, a sentence each
    QStringList edits;   ///< what the user has said that holds from it on, a line each

    int operations() const { return splits + merges; }
};

/// The numbers of a place; `before` is the one before it, null for the first. Faults and edits are added by others.
TimelineColumn timelineColumn(const Snapshot& now, const Snapshot* before, const ScheduleParameters& schedule);

/// What may be looked for from place to place.
enum class TimelineEvent { Any, Fits, SplitsAndMerges, Faults, Edits, Bookmarks };

/// Whether a place has what is looked for: of fits those that gave a plane, of splits and merges those that were made.
bool hasEvent(const TimelineColumn& column, bool bookmarked, TimelineEvent kind);

/// The next place with such an event after `from`, or before it where `forward` is false; nothing where there is none.
std::optional<int> nextEvent(std::span<const TimelineColumn> columns, const std::set<int>& bookmarks, int from,
                             bool forward, TimelineEvent kind);

/// All that is known of a place, in lines for people; steps count from 1 there. `planned` steps, 0 where nobody knows.
QString timelineTip(const TimelineColumn& column, bool bookmarked, int planned);

}  // namespace planewright
