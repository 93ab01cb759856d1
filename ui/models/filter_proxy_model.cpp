// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/filter_proxy_model.h"

namespace planewright {

FilterProxyModel::FilterProxyModel(std::span<const FilterKey> keys, QObject* parent)
    : QSortFilterProxyModel(parent), keys_(keys)
{
    setSortRole(kSortRole);
    setSortCaseSensitivity(Qt::CaseInsensitive);
    setDynamicSortFilter(true);
}

std::optional<FilterProblem> FilterProxyModel::setQuery(const QString& query)
{
    auto problem = filter_.setQuery(query, keys_);
    if (!problem)
        invalidateFilter();
    return problem;
}

bool FilterProxyModel::filterAcceptsRow(int row, const QModelIndex& parent) const
{
    return filter_.acceptsAll() || filter_.accepts(*sourceModel(), row, parent);
}

bool FilterProxyModel::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
    const bool leftKnown = left.data(kSortRole).isValid();
    const bool rightKnown = right.data(kSortRole).isValid();
    if (leftKnown && rightKnown)
        return QSortFilterProxyModel::lessThan(left, right);
    return sortOrder() == Qt::AscendingOrder ? leftKnown && !rightKnown : !leftKnown && rightKnown;
}

}  // namespace planewright
