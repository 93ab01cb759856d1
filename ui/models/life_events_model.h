// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QAbstractTableModel>

#include "ui/models/lineage_chart.h"

namespace planewright {

/// The events of a family of planes as a table: step, what happened, segments.
class LifeEventsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    /// Rows stay what they are where the events begin as those before.
    void setEvents(std::vector<FamilyEvent> events);
    const std::vector<FamilyEvent>& events() const { return events_; }

    /// Rows as tab-separated text with headings.
    QString rowsAsText(const QModelIndexList& rows) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::vector<FamilyEvent> events_;
};

}  // namespace planewright
