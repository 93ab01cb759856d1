// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <QAbstractTableModel>
#include <QString>

#include "ui/common/length_style.h"
#include "ui/common/palette.h"
#include "ui/common/shown_map.h"
#include "ui/models/row_filter.h"

namespace planewright {

/// The columns of the table of planes, in the order in which they stand.
enum class PlaneColumn {
    Colour,  ///< and whether it is seen, as a check mark
    Id,
    Name,
    Class,
    Nx,
    Ny,
    Nz,
    Distance,
    Heading,
    Tilt,
    Area,
    Size,
    SegmentCount,
    EndPoints,
    Error,
    Rms,
    Born,
    Changed,
    MadeOf,
    State,
    Lock
};
inline constexpr int kPlaneColumns = 21;

/// The words of a query about planes.
std::span<const FilterKey> planeFilterKeys();

/// The planes of a map as a table.
///
/// It never changes the map: what is typed or checked becomes a request, and is shown when a map with it comes. Maps
/// that follow each other touch only the rows whose plane, outline or edits are others, so that selections stay.
/// Numbers of kSortRole: metres, square metres, degrees, millimetres for RMS, steps as they are shown (from 1).
class PlanesModel : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit PlanesModel(QObject* parent = nullptr);

    /// Null shows no plane.
    void setMap(std::shared_ptr<const ShownMap> map);
    const std::shared_ptr<const ShownMap>& map() const { return map_; }

    void setColours(PlanePalette palette, Theme theme);
    void setLengthStyle(const LengthStyle& style);
    const LengthStyle& lengthStyle() const { return style_; }
    /// The fitting error from which on planes are split, empty where none is; the error's kLimitRole, and what its tip
    /// says.
    void setErrorLimit(std::optional<double> limit);

    PlaneId planeAt(int row) const;
    std::optional<int> rowOf(PlaneId plane) const;
    /// Area of a row's plane [m²], where it has been worked out.
    std::optional<double> areaAt(int row) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

signals:
    /// Another map is shown, with all its rows in place.
    void mapChanged();
    void renameRequested(planewright::PlaneId plane, const QString& name);
    void classRequested(planewright::PlaneId plane, const QString& className);
    void hideRequested(planewright::PlaneId plane, bool hidden);
    void lockRequested(planewright::PlaneId plane, bool locked);

private:
    const ShownPlane& at(int row) const { return rows_[static_cast<std::size_t>(row)]; }
    void allChanged();

    std::shared_ptr<const ShownMap> map_;
    std::vector<ShownPlane> rows_;
    PlanePalette palette_ = PlanePalette::Normal;
    Theme theme_ = Theme::Light;
    LengthStyle style_;
    std::optional<double> errorLimit_ = 4.0;
};

}  // namespace planewright
