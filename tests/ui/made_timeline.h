// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <vector>

#include <QAction>

#include "core/types/angle.h"
#include "ui/panels/timeline_panel.h"

namespace planewright {

/// So many steps with numbers that wave, fits every fifth step, splits and merges every seventh, two faults, an edit,
/// and the forced last pass of a scan that is over.
inline std::vector<TimelineColumn> madeColumns(int steps, bool isWhole)
{
    std::vector<TimelineColumn> columns;
    int planes = 0;
    for (int step = 0; step < steps; ++step) {
        TimelineColumn column;
        column.step = step;
        column.tilt = degrees(10.0 + 160.0 * step / steps);
        column.points = 500 + static_cast<int>(200.0 * std::sin(0.1 * step));
        column.segments = 5 + step % 11;
        column.fits = step % 5 == 4;
        column.fitted = column.fits && step % 3 == 0 ? 1 : 0;
        column.splitsAndMerges = step % 7 == 6;
        column.splits = column.splitsAndMerges ? step % 4 : 0;
        column.planesBefore = planes;
        planes += column.fitted;
        column.planes = planes;
        if (step == 12 || step == 90)
            column.faults.push_back(QStringLiteral("step %1 was lost").arg(step));
        if (step == 34)
            column.edits.push_back(QStringLiteral("P03: named Door"));
        columns.push_back(column);
    }
    if (steps > 0 && isWhole) {
        TimelineColumn last;
        last.step = -1;
        last.fits = last.splitsAndMerges = true;
        last.merges = 4;
        last.planes = last.planesBefore = planes;
        columns.push_back(last);
    }
    return columns;
}

/// A timeline with actions of its own, which do nothing.
struct MadeTimeline {
    MadeTimeline()
    {
        QAction** const all[]{&actions.first,     &actions.back,         &actions.play,
                              &actions.forward,   &actions.last,         &actions.loop,
                              &actions.eventBack, &actions.eventForward, &actions.live};
        const char* const names[]{"first", "back",      "play",         "forward", "last",
                                  "loop",  "eventBack", "eventForward", "live"};
        for (std::size_t i = 0; i < std::size(all); ++i) {
            *all[i] = new QAction(QLatin1String(names[i]), &owner);
            (*all[i])->setObjectName(QLatin1String(names[i]));
        }
        actions.play->setCheckable(true);
        actions.loop->setCheckable(true);
        actions.live->setIconText(QStringLiteral("LIVE"));
        panel = new TimelinePanel(actions);
    }
    ~MadeTimeline() { delete panel; }
    MadeTimeline(const MadeTimeline&) = delete;
    MadeTimeline& operator=(const MadeTimeline&) = delete;

    QObject owner;
    TimelineActions actions{};
    TimelinePanel* panel = nullptr;
};

}  // namespace planewright
