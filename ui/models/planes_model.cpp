// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/planes_model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QColor>

#include "core/types/plane_words.h"
#include "ui/common/same_scan.h"
#include "ui/models/number_text.h"
#include "ui/models/plane_cells_text.h"

namespace planewright {

namespace {

using Kind = FilterKey::Kind;

constexpr int column(PlaneColumn column)
{
    return static_cast<int>(column);
}

constexpr std::array<FilterKey, 22> kPlaneKeys{{
    {"id", Kind::Number, column(PlaneColumn::Id)},
    {"name", Kind::Text, column(PlaneColumn::Name)},
    {"class", Kind::Text, column(PlaneColumn::Class)},
    {"nx", Kind::Number, column(PlaneColumn::Nx)},
    {"ny", Kind::Number, column(PlaneColumn::Ny)},
    {"nz", Kind::Number, column(PlaneColumn::Nz)},
    {"d", Kind::Number, column(PlaneColumn::Distance)},
    {"heading", Kind::Number, column(PlaneColumn::Heading)},
    {"tilt", Kind::Number, column(PlaneColumn::Tilt)},
    {"area", Kind::Number, column(PlaneColumn::Area)},
    {"width", Kind::Number, column(PlaneColumn::Size)},
    {"height", Kind::Number, column(PlaneColumn::Size), kSecondSortRole},
    {"segments", Kind::Number, column(PlaneColumn::SegmentCount)},
    {"endpoints", Kind::Number, column(PlaneColumn::EndPoints)},
    {"E", Kind::Number, column(PlaneColumn::Error)},
    {"rms", Kind::Number, column(PlaneColumn::Rms)},
    {"born", Kind::Number, column(PlaneColumn::Born)},
    {"changed", Kind::Number, column(PlaneColumn::Changed)},
    {"lineage", Kind::Text, column(PlaneColumn::MadeOf)},
    {"state", Kind::Text, column(PlaneColumn::State)},
    {"hidden", Kind::Number, column(PlaneColumn::Colour)},
    {"locked", Kind::Number, column(PlaneColumn::Lock)},
}};

bool isText(PlaneColumn column)
{
    return column == PlaneColumn::Id || column == PlaneColumn::Name || column == PlaneColumn::Class ||
           column == PlaneColumn::MadeOf || column == PlaneColumn::State || column == PlaneColumn::Lock;
}

/// True where nothing of a row is another, given the same id.
bool isSameRow(const ShownPlane& a, const ShownPlane& b, bool sameScan)
{
    const bool samePlane = a.plane == b.plane || (sameScan && a.plane->revision == b.plane->revision);
    return samePlane && a.name == b.name && a.className == b.className && a.hidden == b.hidden &&
           a.locked == b.locked && a.outline == b.outline;
}

/// What a fitting error says, and what the method makes of it.
QString errorTip(double error, std::optional<double> limit)
{
    const QString meaning =
        PlanesModel::tr("Its segments lie off the plane by %1 times what the noise alone gives (the square root of E).")
            .arg(numberText(std::sqrt(error), 1));
    if (limit)
        return meaning + QLatin1Char(' ') +
               PlanesModel::tr("A plane above %1 is not made, and is split if it grew to it.").arg(*limit);
    return meaning + QLatin1Char(' ') +
           PlanesModel::tr(
               "E alone splits no plane: the estimator by likelihood tests each segment when it joins, takes "
               "the worst ones out of planes of at most 60 segments in the last pass, and makes the plane's "
               "uncertainty larger where E is above 1.");
}

}  // namespace

std::span<const FilterKey> planeFilterKeys()
{
    return kPlaneKeys;
}

PlanesModel::PlanesModel(QObject* parent) : QAbstractTableModel(parent) {}

void PlanesModel::setMap(std::shared_ptr<const ShownMap> map)
{
    const bool sameScan = map && map_ && isSameScan(*map, *map_);
    map_ = std::move(map);
    static const std::vector<ShownPlane> kNone;
    const std::vector<ShownPlane>& planes = map_ ? map_->planes : kNone;

    // Both are in order of id: walk along them together.
    std::size_t row = 0;
    for (const ShownPlane& plane : planes) {
        std::size_t gone = row;
        while (gone < rows_.size() && rows_[gone].plane->id < plane.plane->id)
            ++gone;
        if (gone > row) {
            beginRemoveRows({}, static_cast<int>(row), static_cast<int>(gone) - 1);
            rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(row),
                        rows_.begin() + static_cast<std::ptrdiff_t>(gone));
            endRemoveRows();
        }
        const auto at = static_cast<int>(row);
        if (row == rows_.size() || rows_[row].plane->id != plane.plane->id) {
            beginInsertRows({}, at, at);
            rows_.insert(rows_.begin() + at, plane);
            endInsertRows();
        } else if (!isSameRow(rows_[row], plane, sameScan)) {
            rows_[row] = plane;
            emit dataChanged(index(at, 0), index(at, kPlaneColumns - 1));
        }
        ++row;
    }
    if (row < rows_.size()) {
        beginRemoveRows({}, static_cast<int>(row), static_cast<int>(rows_.size()) - 1);
        rows_.resize(row);
        endRemoveRows();
    }
    emit mapChanged();
}

void PlanesModel::allChanged()
{
    if (!rows_.empty())
        emit dataChanged(index(0, 0), index(static_cast<int>(rows_.size()) - 1, kPlaneColumns - 1));
}

void PlanesModel::setColours(PlanePalette palette, Theme theme)
{
    palette_ = palette;
    theme_ = theme;
    allChanged();
}

void PlanesModel::setLengthStyle(const LengthStyle& style)
{
    style_ = style;
    allChanged();
    emit headerDataChanged(Qt::Horizontal, 0, kPlaneColumns - 1);
}

void PlanesModel::setErrorLimit(std::optional<double> limit)
{
    errorLimit_ = limit;
    allChanged();
}

PlaneId PlanesModel::planeAt(int row) const
{
    return at(row).plane->id;
}

std::optional<int> PlanesModel::rowOf(PlaneId plane) const
{
    const auto found = std::lower_bound(rows_.begin(), rows_.end(), plane,
                                        [](const ShownPlane& row, PlaneId id) { return row.plane->id < id; });
    if (found == rows_.end() || found->plane->id != plane)
        return std::nullopt;
    return static_cast<int>(found - rows_.begin());
}

std::optional<double> PlanesModel::areaAt(int row) const
{
    return at(row).outline ? std::optional(at(row).outline->outline.area) : std::nullopt;
}

int PlanesModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int PlanesModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kPlaneColumns;
}

QVariant PlanesModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const ShownPlane& shown = at(index.row());
    const auto column = static_cast<PlaneColumn>(index.column());
    switch (role) {
        case Qt::DisplayRole:
            return planeCellText(shown, column, style_);
        case Qt::EditRole:
            return column == PlaneColumn::Name || column == PlaneColumn::Class ? planeCellValue(shown, column)
                                                                               : QVariant();
        case kSortRole:
            return planeCellValue(shown, column);
        case kSecondSortRole:
            return column == PlaneColumn::Size && shown.outline ? QVariant(shown.outline->outline.height) : QVariant();
        case kLimitRole:
            return column == PlaneColumn::Error && errorLimit_ ? QVariant(*errorLimit_) : QVariant();
        case Qt::ToolTipRole:
            return column == PlaneColumn::Error ? QVariant(errorTip(shown.plane->fittingError, errorLimit_))
                                                : QVariant();
        case kPlainTextRole:
            return QString::fromStdString(planeLabel(shown.plane->id) + ' ' + shown.name + ' ' + shown.className + ' ' +
                                          planeState(*shown.plane) + ' ' + lineageText(*shown.plane));
        case Qt::DecorationRole:
            if (column == PlaneColumn::Colour) {
                const Rgb colour = planeColour(shown.plane->id, palette_, theme_);
                return QColor(colour.red, colour.green, colour.blue);
            }
            return {};
        case Qt::CheckStateRole:
            if (column == PlaneColumn::Colour)
                return shown.hidden ? Qt::Unchecked : Qt::Checked;
            if (column == PlaneColumn::Lock)
                return shown.locked ? Qt::Checked : Qt::Unchecked;
            return {};
        case Qt::TextAlignmentRole:
            return QVariant(Qt::AlignVCenter | (isText(column) ? Qt::AlignLeft : Qt::AlignRight));
        case Qt::AccessibleTextRole:
            if (column == PlaneColumn::Colour)
                return shown.hidden ? QStringLiteral("hidden") : QStringLiteral("shown");
            if (column == PlaneColumn::Lock)
                return shown.locked ? QStringLiteral("locked") : QStringLiteral("not locked");
            return planeColumnTitle(column, style_) + ' ' + planeCellText(shown, column, style_);
        default:
            return {};
    }
}

QVariant PlanesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= kPlaneColumns)
        return {};
    const auto column = static_cast<PlaneColumn>(section);
    if (role == Qt::DisplayRole)
        return planeColumnTitle(column, style_);
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
        return planeColumnMeaning(column);
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignVCenter | (isText(column) ? Qt::AlignLeft : Qt::AlignRight));
    return {};
}

Qt::ItemFlags PlanesModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    const auto column = static_cast<PlaneColumn>(index.column());
    if (column == PlaneColumn::Name || column == PlaneColumn::Class)
        flags |= Qt::ItemIsEditable;
    if (column == PlaneColumn::Colour || column == PlaneColumn::Lock)
        flags |= Qt::ItemIsUserCheckable;
    return flags;
}

bool PlanesModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return false;
    const ShownPlane& shown = at(index.row());
    const PlaneId plane = shown.plane->id;
    const auto column = static_cast<PlaneColumn>(index.column());
    const bool checked = value.toInt() == Qt::Checked;
    if (role == Qt::EditRole && column == PlaneColumn::Name && value.toString() != planeCellValue(shown, column))
        emit renameRequested(plane, value.toString());
    else if (role == Qt::EditRole && column == PlaneColumn::Class && value.toString() != planeCellValue(shown, column))
        emit classRequested(plane, value.toString());
    else if (role == Qt::CheckStateRole && column == PlaneColumn::Colour)
        emit hideRequested(plane, !checked);
    else if (role == Qt::CheckStateRole && column == PlaneColumn::Lock)
        emit lockRequested(plane, checked);
    return false;
}

}  // namespace planewright
