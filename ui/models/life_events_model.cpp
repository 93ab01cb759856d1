// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/life_events_model.h"

#include <algorithm>

#include "ui/models/decision_text.h"

namespace planewright {

namespace {
constexpr int kLifeColumns = 3;
}

void LifeEventsModel::setEvents(std::vector<FamilyEvent> events)
{
    if (events == events_)
        return;
    const bool goesOn = !events_.empty() && events.size() > events_.size() &&
                        std::equal(events_.begin(), events_.end(), events.begin());
    if (goesOn) {
        beginInsertRows({}, rowCount(), static_cast<int>(events.size()) - 1);
        events_ = std::move(events);
        endInsertRows();
        return;
    }
    beginResetModel();
    events_ = std::move(events);
    endResetModel();
}

QString LifeEventsModel::rowsAsText(const QModelIndexList& rows) const
{
    QString text = tr("Step\tEvent\tSegments\n");
    for (const QModelIndex& row : rows) {
        for (int column = 0; column < kLifeColumns; ++column)
            text += row.siblingAtColumn(column).data().toString() + (column + 1 < kLifeColumns ? '\t' : '\n');
    }
    return text;
}

int LifeEventsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(events_.size());
}

int LifeEventsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kLifeColumns;
}

QVariant LifeEventsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const FamilyEvent& event = events_[static_cast<std::size_t>(index.row())];
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(index.column() == 1 ? Qt::AlignLeft | Qt::AlignVCenter
                                                    : Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
        case 0:
            return stepText(event.step);
        case 1:
            return eventText(event);
        default:
            return event.segments > 0 ? QString::number(event.segments) : QStringLiteral("–");
    }
}

QVariant LifeEventsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    return section == 0 ? tr("Step") : section == 1 ? tr("Event") : tr("Segments");
}

}  // namespace planewright
