// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>

#include <QSortFilterProxyModel>

#include "ui/models/row_filter.h"

namespace planewright {

/// Rows of a table that fulfil a query, sorted by their plain numbers; what is unknown comes last in either order.
class FilterProxyModel : public QSortFilterProxyModel {
    Q_OBJECT

public:
    /// The keys must live as long as this.
    explicit FilterProxyModel(std::span<const FilterKey> keys, QObject* parent = nullptr);

    /// Shows what fulfils a query; gives what is wrong with it, and then shows what it showed.
    std::optional<FilterProblem> setQuery(const QString& query);

    /// True where nothing is kept out.
    bool showsAll() const { return filter_.acceptsAll(); }

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    std::span<const FilterKey> keys_;
    RowFilter filter_;
};

}  // namespace planewright
