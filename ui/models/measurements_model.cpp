// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/measurements_model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "core/geometry/measure_planes.h"
#include "core/types/angle.h"
#include "core/types/plane_words.h"
#include "ui/models/model_roles.h"
#include "ui/models/number_text.h"

namespace planewright {

namespace {

QString labelOf(PlaneId id)
{
    return QString::fromStdString(planeLabel(id));
}

/// Metres, degrees, or a step as it is shown.
std::optional<double> valueOf(const Measurement& measurement, MeasurementColumn column)
{
    const auto along = [&](int axis) {
        return measurement.offset ? std::optional((*measurement.offset)[axis]) : std::nullopt;
    };
    switch (column) {
        case MeasurementColumn::What:
            return std::nullopt;
        case MeasurementColumn::Distance:
            return measurement.distance;
        case MeasurementColumn::Angle:
            return measurement.angle ? std::optional(toDegrees(*measurement.angle)) : std::nullopt;
        case MeasurementColumn::Right:
            return along(0);
        case MeasurementColumn::Forward:
            return along(1);
        case MeasurementColumn::Up:
            return along(2);
        case MeasurementColumn::Step:
            return measurement.step < 0 ? std::nullopt : std::optional(measurement.step + 1.0);
    }
    return std::nullopt;
}

QString textOf(const Measurement& measurement, MeasurementColumn column, const LengthStyle& style)
{
    if (column == MeasurementColumn::What)
        return measurement.what;
    const auto value = valueOf(measurement, column);
    if (!value)
        return QStringLiteral("–");
    if (column == MeasurementColumn::Angle)
        return numberText(*value, 1);
    return column == MeasurementColumn::Step ? numberText(*value, 0) : lengthText(*value, style);
}

}  // namespace

MeasurementsModel::MeasurementsModel(QObject* parent) : QAbstractTableModel(parent) {}

void MeasurementsModel::setLengthStyle(const LengthStyle& style)
{
    style_ = style;
    if (!measurements_.empty())
        emit dataChanged(index(0, 0), index(rowCount() - 1, kMeasurementColumns - 1));
    emit headerDataChanged(Qt::Horizontal, 0, kMeasurementColumns - 1);
}

void MeasurementsModel::append(Measurement measurement)
{
    measurement.step = map_ ? map_->step : -1;
    beginInsertRows({}, rowCount(), rowCount());
    measurements_.push_back(std::move(measurement));
    endInsertRows();
}

const ShownPlane* MeasurementsModel::planeOf(PlaneId id) const
{
    if (!map_)
        return nullptr;
    const auto found = std::find_if(map_->planes.begin(), map_->planes.end(),
                                    [id](const ShownPlane& plane) { return plane.plane->id == id; });
    return found == map_->planes.end() ? nullptr : &*found;
}

Eigen::Vector3d MeasurementsModel::middleOf(const ShownPlane& plane) const
{
    if (plane.outline && !plane.outline->outline.parts.empty())
        return plane.outline->outline.centroid;
    // Until the outline is there, the foot of the middle of its segments will do.
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const SegmentId& id : plane.plane->segments)
        sum += map_->snapshot->segments[id].midpoint();
    const auto count = static_cast<double>(std::max<std::size_t>(plane.plane->segments.size(), 1));
    const Eigen::Vector3d middle = sum / count;
    return middle - distanceTo(*plane.plane, middle) * plane.plane->normal;
}

void MeasurementsModel::addPoints(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
    const Eigen::Vector3d offset = to - from;
    append({.what = QStringLiteral("Point – point"),
            .distance = offset.norm(),
            .angle = std::atan2(std::abs(offset.z()), offset.head<2>().norm()),
            .offset = offset,
            .from = from,
            .to = to});
}

bool MeasurementsModel::addPointAndPlane(const Eigen::Vector3d& point, PlaneId plane)
{
    const ShownPlane* shown = planeOf(plane);
    if (shown == nullptr)
        return false;
    const Eigen::Vector3d offset = -distanceTo(*shown->plane, point) * shown->plane->normal;
    append({.what = QStringLiteral("Point – %1").arg(labelOf(plane)),
            .distance = offset.norm(),
            .angle = {},
            .offset = offset,
            .from = point,
            .to = point + offset});
    return true;
}

bool MeasurementsModel::addPlanes(PlaneId first, PlaneId second)
{
    const ShownPlane* from = planeOf(first);
    const ShownPlane* to = planeOf(second);
    if (from == nullptr || to == nullptr)
        return false;
    const Eigen::Vector3d middle = middleOf(*from);
    const PlanePair pair = measurePlanes(*from->plane, middle, *to->plane, middleOf(*to));
    append({.what = QStringLiteral("%1 – %2").arg(labelOf(first), labelOf(second)),
            .distance = pair.distance,
            .angle = pair.angle,
            .offset = {},
            .from = middle,
            .to = pair.distance ? Eigen::Vector3d(middle - distanceTo(*to->plane, middle) * to->plane->normal)
                                : middleOf(*to)});
    return true;
}

bool MeasurementsModel::addAngle(const Eigen::Vector3d& corner, const Eigen::Vector3d& first,
                                 const Eigen::Vector3d& second)
{
    const Eigen::Vector3d a = first - corner;
    const Eigen::Vector3d b = second - corner;
    if (a.isZero() || b.isZero())
        return false;
    append({.what = QStringLiteral("Angle of three points"),
            .distance = {},
            .angle = std::atan2(a.cross(b).norm(), a.dot(b)),
            .offset = {},
            .from = first,
            .to = second});
    return true;
}

void MeasurementsModel::remove(int row)
{
    beginRemoveRows({}, row, row);
    measurements_.erase(measurements_.begin() + row);
    endRemoveRows();
}

void MeasurementsModel::clear()
{
    beginResetModel();
    measurements_.clear();
    endResetModel();
}

int MeasurementsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(measurements_.size());
}

int MeasurementsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kMeasurementColumns;
}

QVariant MeasurementsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const auto column = static_cast<MeasurementColumn>(index.column());
    const bool isText = column == MeasurementColumn::What;
    switch (role) {
        case Qt::DisplayRole:
            return textOf(at(index.row()), column, style_);
        case kSortRole: {
            if (isText)
                return at(index.row()).what;
            const auto value = valueOf(at(index.row()), column);
            return value ? QVariant(*value) : QVariant();
        }
        case kPlainTextRole:
            return at(index.row()).what;
        case Qt::TextAlignmentRole:
            return QVariant(Qt::AlignVCenter | (isText ? Qt::AlignLeft : Qt::AlignRight));
        default:
            return {};
    }
}

QVariant MeasurementsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    static constexpr std::array<const char*, kMeasurementColumns> kTitles{"Between", "Distance", "Angle°", "Right",
                                                                          "Forward", "Up",       "Step"};
    if (orientation != Qt::Horizontal || section < 0 || section >= kMeasurementColumns)
        return {};
    const auto column = static_cast<MeasurementColumn>(section);
    const bool isLength =
        column != MeasurementColumn::What && column != MeasurementColumn::Angle && column != MeasurementColumn::Step;
    if (role == Qt::DisplayRole)
        return QString::fromUtf8(kTitles[static_cast<std::size_t>(section)]) +
               (isLength ? ' ' + lengthUnit(style_) : QString{});
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignVCenter | (column == MeasurementColumn::What ? Qt::AlignLeft : Qt::AlignRight));
    return {};
}

}  // namespace planewright
