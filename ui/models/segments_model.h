// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <QAbstractTableModel>

#include "ui/common/length_style.h"
#include "ui/common/segment_owners.h"
#include "ui/common/shown_map.h"
#include "ui/models/row_filter.h"

namespace planewright {

enum class SegmentColumn { Id, Step, State, Plane, Cluster, Length, Points, Rms, Start, End };
inline constexpr int kSegmentColumns = 10;

/// The words of a query about segments; `state:unfitted` are those of no plane.
std::span<const FilterKey> segmentFilterKeys();

/// The line segments of a map as a table, slice after slice in bearing order.
///
/// A map that goes on where the one before was adds rows, and rows change where segments changed hands. Numbers of
/// kSortRole: metres, millimetres for RMS, steps as they are shown (from 1).
class SegmentsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit SegmentsModel(QObject* parent = nullptr);

    void setMap(std::shared_ptr<const ShownMap> map);
    const std::shared_ptr<const ShownMap>& map() const { return map_; }
    void setLengthStyle(const LengthStyle& style);

    const SegmentId& segmentAt(int row) const { return segment(row).id; }
    std::optional<int> rowOf(const SegmentId& id) const;
    /// Segments of no plane.
    int unfitted() const { return unfitted_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    /// map() is another.
    void mapChanged();

private:
    struct Place {
        std::size_t slice = 0;
        std::size_t index = 0;
    };
    Place placeOf(int row) const;
    const LineSegment& segment(int row) const;
    PlaneId planeOf(const Place& place) const;
    QString textOf(int row, SegmentColumn column) const;
    QVariant valueOf(int row, SegmentColumn column) const;
    bool goesOn(const ShownMap& next) const;
    void tellChanges(const std::vector<PlaneId>& planesBefore, const SegmentOwners& ownersBefore);
    std::vector<PlaneId> planeIds() const;

    std::shared_ptr<const ShownMap> map_;
    SegmentOwners owners_;
    std::vector<int> firstRows_;  ///< of each slice, and the number of rows at the end
    int unfitted_ = 0;
    LengthStyle style_;
};

}  // namespace planewright
