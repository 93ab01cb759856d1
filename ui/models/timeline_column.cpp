// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/timeline_column.h"

#include <algorithm>

#include <QCoreApplication>

#include "ui/models/number_text.h"

namespace planewright {

namespace {

QString timelineWords(const char* text)
{
    return QCoreApplication::translate("Timeline", text);
}

QString counted(int count, const char* one, const char* many)
{
    return count == 1 ? timelineWords(one) : timelineWords(many).arg(count);
}

/// What happened to the planes of a place, as far as it did.
QStringList happenedAt(const TimelineColumn& column)
{
    QStringList happened;
    if (column.fitted > 0)
        happened.push_back(counted(column.fitted, "1 plane fitted", "%1 planes fitted"));
    if (column.splits > 0)
        happened.push_back(counted(column.splits, "1 split", "%1 splits"));
    if (column.merges > 0)
        happened.push_back(counted(column.merges, "1 merge", "%1 merges"));
    if (happened.empty() && column.fits)
        happened.push_back(timelineWords("fit without a new plane"));
    if (column.operations() == 0 && column.splitsAndMerges)
        happened.push_back(timelineWords("nothing to split or merge"));
    return happened;
}

}  // namespace

TimelineColumn timelineColumn(const Snapshot& now, const Snapshot* before, const ScheduleParameters& schedule)
{
    const StepReport& report = now.report;
    TimelineColumn column;
    column.step = report.step;
    column.tilt = report.tilt;
    column.points = report.counts.returns;
    column.segments = report.counts.segments;
    column.planes = report.counts.planes;
    column.planesBefore = before != nullptr ? before->report.counts.planes : 0;
    const bool isLastPass = report.step < 0;
    column.fits = isLastPass || schedule.fitsPlanesAt(report.step);
    column.splitsAndMerges = isLastPass || schedule.splitsAndMergesAt(report.step);
    // What is split off another is a plane of its own by then.
    column.fitted =
        static_cast<int>(std::count_if(report.decisions.begin(), report.decisions.end(), [](const Decision& decision) {
            return decision.kind == DecisionKind::Fit && decision.phase != Phase::SplitMerge;
        }));
    column.splits = report.counts.splits;
    column.merges = report.counts.merges;
    return column;
}

bool hasEvent(const TimelineColumn& column, bool bookmarked, TimelineEvent kind)
{
    switch (kind) {
        case TimelineEvent::Any:
            return bookmarked || column.fitted > 0 || column.operations() > 0 || !column.faults.empty() ||
                   !column.edits.empty();
        case TimelineEvent::Fits:
            return column.fitted > 0;
        case TimelineEvent::SplitsAndMerges:
            return column.operations() > 0;
        case TimelineEvent::Faults:
            return !column.faults.empty();
        case TimelineEvent::Edits:
            return !column.edits.empty();
        case TimelineEvent::Bookmarks:
            return bookmarked;
    }
    return false;
}

std::optional<int> nextEvent(std::span<const TimelineColumn> columns, const std::set<int>& bookmarks, int from,
                             bool forward, TimelineEvent kind)
{
    const int by = forward ? 1 : -1;
    for (int place = from + by; place >= 0 && place < static_cast<int>(columns.size()); place += by) {
        if (hasEvent(columns[static_cast<std::size_t>(place)], bookmarks.contains(place), kind))
            return place;
    }
    return std::nullopt;
}

QString timelineTip(const TimelineColumn& column, bool bookmarked, int planned)
{
    QStringList lines;
    if (column.step < 0)
        lines.push_back(timelineWords("Last pass over all segments"));
    else
        lines.push_back((planned > 0 ? timelineWords("Step %1 of %2").arg(column.step + 1).arg(planned)
                                     : timelineWords("Step %1").arg(column.step + 1)) +
                        QStringLiteral(", φ %1°").arg(angleText(column.tilt)));
    if (column.step >= 0)
        lines.push_back(counted(column.points, "1 return", "%1 returns") + QStringLiteral(", ") +
                        counted(column.segments, "1 segment", "%1 segments"));
    const int more = column.planes - column.planesBefore;
    lines.push_back(counted(column.planes, "1 plane", "%1 planes") +
                    (more == 0 ? QString() : QStringLiteral(" (%1%2)").arg(more > 0 ? "+" : "−").arg(std::abs(more))));
    lines += happenedAt(column);
    for (const QString& fault : column.faults)
        lines.push_back(QStringLiteral("▲ ") + fault);
    for (const QString& edit : column.edits)
        lines.push_back(QStringLiteral("✎ ") + edit);
    if (bookmarked)
        lines.push_back(timelineWords("Bookmark"));
    return lines.join(QLatin1Char('\n'));
}

}  // namespace planewright
