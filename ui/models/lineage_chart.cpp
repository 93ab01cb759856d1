// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/lineage_chart.h"

#include <algorithm>

#include <QStringList>

#include "core/types/plane_words.h"

namespace planewright {

namespace {

QString labels(const std::vector<PlaneId>& planes)
{
    QStringList texts;
    for (const PlaneId plane : planes)
        texts << QString::fromStdString(planeLabel(plane));
    return texts.join(QStringLiteral(", "));
}

/// Whether the other planes of an event tell of it themselves: a part's parents tell of the split, and what went into
/// a plane tells of the merger.
bool isToldByOthers(const LifeEvent& event, PlaneId plane, const PlaneLives& lives)
{
    if (event.kind != LifeEventKind::SplitFrom && event.kind != LifeEventKind::MergedFrom)
        return false;
    return std::any_of(event.others.begin(), event.others.end(), [&](PlaneId other) {
        const auto life = lives.lives().find(other);
        return life != lives.lives().end() &&
               std::any_of(life->second.events.begin(), life->second.events.end(), [&](const LifeEvent& theirs) {
                   const bool leadsOn = theirs.kind == LifeEventKind::SplitInto ||
                                        theirs.kind == LifeEventKind::TakenApart ||
                                        theirs.kind == LifeEventKind::MergedInto;
                   return leadsOn && theirs.step == event.step &&
                          std::find(theirs.others.begin(), theirs.others.end(), plane) != theirs.others.end();
               });
    });
}

bool endsLife(LifeEventKind kind)
{
    return kind == LifeEventKind::MergedInto || kind == LifeEventKind::TakenApart || kind == LifeEventKind::Deleted;
}

/// How many segments a plane has after a step.
int sizeAt(const PlaneLife& life, int step, const LineageChart& chart)
{
    int segments = 0;
    for (const PlaneLife::Size& size : life.sizes) {
        if (chart.momentOf(size.step) <= chart.momentOf(step))
            segments = size.segments;
    }
    return segments;
}

LifeBar barOfLife(const PlaneLife& life, const LineageChart& chart)
{
    LifeBar bar{life.id, chart.momentOf(life.bornStep()), chart.lastMoment(), life.isOver, life.sizes};
    for (PlaneLife::Size& size : bar.sizes)
        size.step = chart.momentOf(size.step);
    if (life.isOver)
        bar.last = chart.momentOf(life.events.back().step);
    return bar;
}

void addJoints(LineageChart& chart)
{
    for (std::size_t i = 0; i < chart.events.size(); ++i) {
        const FamilyEvent& event = chart.events[i];
        const auto own = chart.barOf(event.plane);
        for (const PlaneId other : event.others) {
            const auto theirs = chart.barOf(other);
            if (!own || !theirs)
                continue;
            const bool comesFrom = event.kind == LifeEventKind::SplitFrom || event.kind == LifeEventKind::MergedFrom;
            chart.joints.push_back({static_cast<int>(comesFrom ? *theirs : *own),
                                    static_cast<int>(comesFrom ? *own : *theirs), chart.momentOf(event.step), i});
        }
    }
}

}  // namespace

std::optional<std::size_t> LineageChart::barOf(PlaneId plane) const
{
    const auto bar =
        std::find_if(bars.begin(), bars.end(), [plane](const LifeBar& candidate) { return candidate.plane == plane; });
    if (bar == bars.end())
        return std::nullopt;
    return static_cast<std::size_t>(bar - bars.begin());
}

LineageChart lineageChart(const PlaneLives& lives, const std::vector<PlaneId>& family, int newestStep, bool hasLastPass)
{
    LineageChart chart;
    chart.newestStep = newestStep;
    chart.hasLastPass = hasLastPass;
    for (const PlaneId plane : family) {
        const auto found = lives.lives().find(plane);
        if (found == lives.lives().end())
            continue;
        const PlaneLife& life = found->second;
        chart.bars.push_back(barOfLife(life, chart));
        for (const PlaneLife::Size& size : life.sizes)
            chart.mostSegments = std::max(chart.mostSegments, size.segments);
        for (const LifeEvent& event : life.events) {
            if (!isToldByOthers(event, plane, lives))
                chart.events.push_back({plane, event.kind, event.step, event.order, event.others, event.from,
                                        endsLife(event.kind) ? 0 : sizeAt(life, event.step, chart)});
        }
    }
    std::stable_sort(chart.events.begin(), chart.events.end(), [&](const FamilyEvent& a, const FamilyEvent& b) {
        return std::pair{chart.momentOf(a.step), a.order} < std::pair{chart.momentOf(b.step), b.order};
    });
    addJoints(chart);
    return chart;
}

QString eventText(const FamilyEvent& event)
{
    const QString plane = QString::fromStdString(planeLabel(event.plane));
    const QString others = labels(event.others);
    switch (event.kind) {
        case LifeEventKind::Fitted: {
            QStringList clusters;
            for (const ClusterId cluster : event.from)
                clusters << QStringLiteral("C%1").arg(cluster);
            return clusters.isEmpty() ? QStringLiteral("%1 fitted").arg(plane)
                                      : QStringLiteral("%1 fitted from %2").arg(plane, clusters.join(", "));
        }
        case LifeEventKind::SplitFrom:
            return QStringLiteral("%1 split from %2").arg(plane, others);
        case LifeEventKind::SplitInto:
            return QStringLiteral("%1 splits off %2").arg(plane, others);
        case LifeEventKind::MergedFrom:
            return QStringLiteral("%1 takes in %2").arg(plane, others);
        case LifeEventKind::MergedInto:
            return QStringLiteral("%1 merged into %2").arg(plane, others);
        case LifeEventKind::TakenApart:
            return QStringLiteral("%1 taken apart into %2").arg(plane, others);
        case LifeEventKind::Deleted:
            break;
    }
    return QStringLiteral("%1 given up").arg(plane);
}

}  // namespace planewright
