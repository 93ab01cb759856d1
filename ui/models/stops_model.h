// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include <QAbstractTableModel>

#include "ui/common/shown_building.h"

namespace planewright {

enum class StopsColumn { Stop, Scan, Floor, X, Y, Z, Sigma, Matched, New, Open, RestsOn };
inline constexpr int kStopsColumns = 11;

/// The stops of a map, in their order: where each is, how well that is known and what it rests on. Those that were
/// taken out come last.
class StopsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit StopsModel(QObject* parent = nullptr);

    /// Null: there is no map.
    void setBuilding(std::shared_ptr<const ShownBuilding> building);
    const ShownStop& stop(int row) const { return building_->stops[static_cast<std::size_t>(row)]; }
    /// The row of a scan; −1 where it is not there.
    int rowOfScan(int scan) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::shared_ptr<const ShownBuilding> building_;
};

}  // namespace planewright
