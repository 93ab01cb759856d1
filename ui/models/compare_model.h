// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include <QAbstractTableModel>

#include "core/evaluation/compare_maps.h"
#include "core/types/snapshot.h"

namespace planewright {

enum class CompareColumn { What, A, B, Overlap, Angle, Distance, SegmentsA, SegmentsB, ErrorA, ErrorB };
inline constexpr int kCompareColumns = 10;

/// What two extractions of the same slices have in common, plane by plane: pairs first, then what only one of them has.
class CompareModel : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit CompareModel(QObject* parent = nullptr);

    /// Two maps at the same step; without one of them there is nothing to compare.
    void setMaps(std::shared_ptr<const Snapshot> a, std::shared_ptr<const Snapshot> b);
    const MapComparison& comparison() const { return comparison_; }

    /// The planes of a row; kNoPlane where a map has none.
    PlaneId planeA(int row) const { return rows_[static_cast<std::size_t>(row)].a; }
    PlaneId planeB(int row) const { return rows_[static_cast<std::size_t>(row)].b; }
    /// The row of a plane of A, or of one of B; −1 where there is none.
    int rowOfA(PlaneId plane) const;
    int rowOfB(PlaneId plane) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        PlaneId a = kNoPlane;
        PlaneId b = kNoPlane;
        const PairedPlanes* pair = nullptr;
        const UnpairedPlane* single = nullptr;
        const Plane* planeA = nullptr;
        const Plane* planeB = nullptr;
    };
    QString text(const Row& row, CompareColumn column) const;

    std::shared_ptr<const Snapshot> a_;
    std::shared_ptr<const Snapshot> b_;
    MapComparison comparison_;
    std::vector<Row> rows_;
};

}  // namespace planewright
