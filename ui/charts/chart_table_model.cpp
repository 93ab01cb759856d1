// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/charts/chart_table_model.h"

#include <utility>

namespace planewright {

void ChartTableModel::setTable(ChartTable table)
{
    const std::size_t before = table_.rows.size();
    if (table.headings != table_.headings || table.rows.size() < before || before == 0) {
        beginResetModel();
        table_ = std::move(table);
        endResetModel();
        return;
    }
    const bool grows = table.rows.size() > before;
    if (grows)
        beginInsertRows({}, static_cast<int>(before), static_cast<int>(table.rows.size()) - 1);
    table_ = std::move(table);
    if (grows)
        endInsertRows();
    emit dataChanged(index(0, 0), index(static_cast<int>(before) - 1, columnCount() - 1));
}

int ChartTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(table_.rows.size());
}

int ChartTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(table_.headings.size());
}

QVariant ChartTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == Qt::DisplayRole)
        return QString::fromStdString(
            table_.rows[static_cast<std::size_t>(index.row())][static_cast<std::size_t>(index.column())]);
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant ChartTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && role == Qt::DisplayRole)
        return QString::fromStdString(table_.headings[static_cast<std::size_t>(section)]);
    return {};
}

}  // namespace planewright
