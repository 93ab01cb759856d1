// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include <QAbstractTableModel>

#include "ui/common/shown_building.h"

namespace planewright {

enum class MatchesColumn { Stop, Plane, Class, Area, State, MapPlane, ChiSquare, Rivals };
inline constexpr int kMatchesColumns = 8;

/// What each plane of each stop is in the map, and how far it was from that.
class MatchesModel : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit MatchesModel(QObject* parent = nullptr);

    /// Null: there is no map.
    void setBuilding(std::shared_ptr<const ShownBuilding> building);
    const ShownMatch& matchAt(int row) const { return building_->matches[static_cast<std::size_t>(row)]; }
    /// The row of a stop's plane; −1 where it is not there.
    int rowOf(const StopPlane& plane) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(const ShownMatch& match, MatchesColumn column) const;

    std::shared_ptr<const ShownBuilding> building_;
};

}  // namespace planewright
