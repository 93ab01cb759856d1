// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/stops_model.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "ui/models/model_roles.h"
#include "ui/models/number_text.h"

namespace planewright {

namespace {

struct StopsHeading {
    const char* title;
    const char* tip;
};
constexpr std::array<StopsHeading, kStopsColumns> kStopsHeadings{{
    {QT_TRANSLATE_NOOP("planewright::StopsModel", "Stop"),
     QT_TRANSLATE_NOOP("planewright::StopsModel", "Its place on the way, from 0")},
    {QT_TRANSLATE_NOOP("planewright::StopsModel", "scan"),
     QT_TRANSLATE_NOOP("planewright::StopsModel", "Its scan in the file")},
    {QT_TRANSLATE_NOOP("planewright::StopsModel", "floor"),
     QT_TRANSLATE_NOOP("planewright::StopsModel", "The floor of the building")},
    {QT_TRANSLATE_NOOP("planewright::StopsModel", "x m"),
     QT_TRANSLATE_NOOP("planewright::StopsModel", "Where it is in the map: right of the first stop")},
    {QT_TRANSLATE_NOOP("planewright::StopsModel", "y m"),
     QT_TRANSLATE_NOOP("planewright::StopsModel", "Where it is in the map: ahead of the first stop")},
    {QT_TRANSLATE_NOOP("planewright::StopsModel", "z m"),
     QT_TRANSLATE_NOOP("planewright::StopsModel", "Where it is in the map: above the first stop")},
    {QT_TRANSLATE_NOOP("planewright::StopsModel", "σ mm"),
     QT_TRANSLATE_NOOP("planewright::StopsModel", "Standard deviation of its place in the worst direction")},
    {QT_TRANSLATE_NOOP("planewright::StopsModel", "matched"),
     QT_TRANSLATE_NOOP("planewright::StopsModel", "Planes that the map had")},
    {QT_TRANSLATE_NOOP("planewright::StopsModel", "new"),
     QT_TRANSLATE_NOOP("planewright::StopsModel", "Planes that no stop before had seen")},
    {QT_TRANSLATE_NOOP("planewright::StopsModel", "open"),
     QT_TRANSLATE_NOOP("planewright::StopsModel", "Planes that may be one of several, and are not used")},
    {QT_TRANSLATE_NOOP("planewright::StopsModel", "rests on"),
     QT_TRANSLATE_NOOP("planewright::StopsModel", "What tells its place")},
}};

bool isStopsWord(StopsColumn column)
{
    return column == StopsColumn::RestsOn;
}

/// Nothing where a stop has no such number.
std::optional<double> numberOfStop(const ShownStop& stop, StopsColumn column)
{
    switch (column) {
        case StopsColumn::Stop:
            return stop.isOmitted() ? std::nullopt : std::optional<double>(stop.number);
        case StopsColumn::Scan:
            return stop.scan;
        case StopsColumn::Floor:
            return stop.floor;
        default:
            break;
    }
    if (!stop.isPlaced)
        return std::nullopt;
    switch (column) {
        case StopsColumn::X:
            return stop.pose.translation.x();
        case StopsColumn::Y:
            return stop.pose.translation.y();
        case StopsColumn::Z:
            return stop.pose.translation.z();
        case StopsColumn::Sigma:
            return kMillimetres * stop.sigmaShift;
        case StopsColumn::Matched:
            return stop.matched;
        case StopsColumn::New:
            return stop.fresh;
        case StopsColumn::Open:
            return stop.open;
        default:
            return std::nullopt;
    }
}

int decimalsOfStop(StopsColumn column)
{
    switch (column) {
        case StopsColumn::X:
        case StopsColumn::Y:
        case StopsColumn::Z:
            return 3;
        case StopsColumn::Sigma:
            return 1;
        default:
            return 0;
    }
}

}  // namespace

StopsModel::StopsModel(QObject* parent) : QAbstractTableModel(parent) {}

void StopsModel::setBuilding(std::shared_ptr<const ShownBuilding> building)
{
    beginResetModel();
    building_ = std::move(building);
    endResetModel();
}

int StopsModel::rowOfScan(int scan) const
{
    if (!building_)
        return -1;
    const auto found = std::ranges::find(building_->stops, scan, &ShownStop::scan);
    return found == building_->stops.end() ? -1 : static_cast<int>(found - building_->stops.begin());
}

int StopsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() || !building_ ? 0 : static_cast<int>(building_->stops.size());
}

int StopsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kStopsColumns;
}

QVariant StopsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const ShownStop& shown = stop(index.row());
    const auto column = static_cast<StopsColumn>(index.column());
    const auto number = numberOfStop(shown, column);
    const QString restsOn = shown.isOmitted() ? tr("taken out") : QString::fromStdString(shown.trust);
    switch (role) {
        case Qt::DisplayRole:
            if (isStopsWord(column))
                return shown.warning.empty() || shown.isOmitted() ? restsOn : QStringLiteral("⚠ ") + restsOn;
            return number ? numberText(*number, decimalsOfStop(column)) : QStringLiteral("–");
        case Qt::ToolTipRole:
            return QString::fromStdString(shown.warning.empty() ? shown.name : shown.name + ": " + shown.warning);
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(Qt::AlignVCenter | (isStopsWord(column) ? Qt::AlignLeft : Qt::AlignRight));
        case kSortRole:
            if (isStopsWord(column))
                return restsOn;
            return number ? QVariant(*number) : QVariant();
        case kPlainTextRole:
            return QString::fromStdString(shown.name) + QLatin1Char(' ') + restsOn;
        default:
            return {};
    }
}

QVariant StopsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= kStopsColumns)
        return {};
    const StopsHeading& heading = kStopsHeadings[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole)
        return tr(heading.title);
    if (role == Qt::ToolTipRole)
        return tr(heading.tip);
    return {};
}

}  // namespace planewright
