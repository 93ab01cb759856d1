// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/segments_model.h"

#include <algorithm>
#include <array>

#include "core/types/plane_words.h"
#include "ui/common/same_scan.h"
#include "ui/models/number_text.h"

namespace planewright {

namespace {

using Kind = FilterKey::Kind;

constexpr int column(SegmentColumn column)
{
    return static_cast<int>(column);
}

constexpr std::array<FilterKey, 7> kSegmentKeys{{
    {"step", Kind::Number, column(SegmentColumn::Step)},
    {"state", Kind::Text, column(SegmentColumn::State)},
    {"plane", Kind::Number, column(SegmentColumn::Plane)},
    {"cluster", Kind::Number, column(SegmentColumn::Cluster)},
    {"length", Kind::Number, column(SegmentColumn::Length)},
    {"points", Kind::Number, column(SegmentColumn::Points)},
    {"rms", Kind::Number, column(SegmentColumn::Rms)},
}};

struct SegmentColumnWords {
    const char* title;
    const char* meaning;
};
constexpr std::array<SegmentColumnWords, kSegmentColumns> kSegmentWords{{
    {"ID", "Step and place in its slice"},
    {"Step", "Step at which it was seen"},
    {"State", "Fitted where it belongs to a plane"},
    {"Plane", "The plane that it belongs to"},
    {"Cluster", "The cluster that holds it while it belongs to no plane"},
    {"Length", "From end to end"},
    {"Points", "Scan points on it"},
    {"RMS mm", "Distance of its points to its line, root mean square, in millimetres"},
    {"Start", "First end point: right, forward, up"},
    {"End", "Last end point: right, forward, up"},
}};

bool isLength(SegmentColumn column)
{
    return column == SegmentColumn::Length || column == SegmentColumn::Start || column == SegmentColumn::End;
}

QString pointText(const Eigen::Vector3d& point, const LengthStyle& style)
{
    return lengthText(point.x(), style) + ' ' + lengthText(point.y(), style) + ' ' + lengthText(point.z(), style);
}

}  // namespace

std::span<const FilterKey> segmentFilterKeys()
{
    return kSegmentKeys;
}

SegmentsModel::SegmentsModel(QObject* parent) : QAbstractTableModel(parent), firstRows_{0} {}

bool SegmentsModel::goesOn(const ShownMap& next) const
{
    if (!map_ || !map_->snapshot || !next.snapshot)
        return false;
    const SegmentLog& before = map_->snapshot->segments;
    const SegmentLog& after = next.snapshot->segments;
    if (after.slices() < before.slices())
        return false;
    return before.slices() == 0 || isSameScan(*map_, next);
}

std::vector<PlaneId> SegmentsModel::planeIds() const
{
    std::vector<PlaneId> ids;
    for (const ShownPlane& plane : map_ ? map_->planes : std::vector<ShownPlane>{})
        ids.push_back(plane.plane->id);
    return ids;
}

void SegmentsModel::setMap(std::shared_ptr<const ShownMap> map)
{
    const bool isNext = map && goesOn(*map);
    std::vector<int> firstRows{0};
    if (map && map->snapshot) {
        for (std::size_t slice = 0; slice < map->snapshot->segments.slices(); ++slice)
            firstRows.push_back(firstRows.back() + static_cast<int>(map->snapshot->segments.slice(slice).size()));
    }
    const int before = firstRows_.back();
    const int after = firstRows.back();
    if (!isNext)
        beginResetModel();
    else if (after > before)
        beginInsertRows({}, before, after - 1);

    const std::vector<PlaneId> planesBefore = planeIds();
    const SegmentOwners ownersBefore = std::move(owners_);
    map_ = std::move(map);
    owners_ = map_ ? SegmentOwners(*map_) : SegmentOwners{};
    firstRows_ = std::move(firstRows);
    unfitted_ = 0;
    for (std::size_t slice = 0; slice < owners_.slices(); ++slice)
        unfitted_ += static_cast<int>(std::count(owners_.planesOf(slice).begin(), owners_.planesOf(slice).end(), -1));

    if (!isNext)
        endResetModel();
    else if (after > before)
        endInsertRows();
    if (isNext)
        tellChanges(planesBefore, ownersBefore);
    emit mapChanged();
}

void SegmentsModel::tellChanges(const std::vector<PlaneId>& planesBefore, const SegmentOwners& ownersBefore)
{
    const std::vector<PlaneId> planes = planeIds();
    const auto idOf = [](const std::vector<PlaneId>& ids, int place) {
        return place < 0 ? kNoPlane : ids[static_cast<std::size_t>(place)];
    };
    // Runs of changed rows are told at once, so that a plane that takes in a wall is no flood of signals.
    int first = -1;
    int row = 0;
    const auto flush = [&](int end) {
        if (first >= 0)
            emit dataChanged(index(first, 0), index(end - 1, kSegmentColumns - 1));
        first = -1;
    };
    for (std::size_t slice = 0; slice < ownersBefore.slices(); ++slice) {
        for (std::size_t i = 0; i < ownersBefore.planesOf(slice).size(); ++i, ++row) {
            const bool changed =
                idOf(planesBefore, ownersBefore.planeAt(slice, i)) != idOf(planes, owners_.planeAt(slice, i)) ||
                ownersBefore.clusterAt(slice, i) != owners_.clusterAt(slice, i);
            if (!changed)
                flush(row);
            else if (first < 0)
                first = row;
        }
    }
    flush(row);
}

void SegmentsModel::setLengthStyle(const LengthStyle& style)
{
    style_ = style;
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, kSegmentColumns - 1));
    emit headerDataChanged(Qt::Horizontal, 0, kSegmentColumns - 1);
}

SegmentsModel::Place SegmentsModel::placeOf(int row) const
{
    const auto next = std::upper_bound(firstRows_.begin(), firstRows_.end(), row);
    const auto slice = static_cast<std::size_t>(next - firstRows_.begin()) - 1;
    return {slice, static_cast<std::size_t>(row - firstRows_[slice])};
}

const LineSegment& SegmentsModel::segment(int row) const
{
    const Place place = placeOf(row);
    return map_->snapshot->segments.slice(place.slice)[place.index];
}

PlaneId SegmentsModel::planeOf(const Place& place) const
{
    const int plane = owners_.planeAt(place.slice, place.index);
    return plane < 0 ? kNoPlane : map_->planes[static_cast<std::size_t>(plane)].plane->id;
}

std::optional<int> SegmentsModel::rowOf(const SegmentId& id) const
{
    if (!map_ || !map_->snapshot)
        return std::nullopt;
    const SegmentLog& log = map_->snapshot->segments;
    const std::size_t slice = log.find(id.step);
    if (slice == log.slices() || id.index < 0 || static_cast<std::size_t>(id.index) >= log.slice(slice).size())
        return std::nullopt;
    return firstRows_[slice] + id.index;
}

int SegmentsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : firstRows_.back();
}

int SegmentsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kSegmentColumns;
}

QVariant SegmentsModel::valueOf(int row, SegmentColumn column) const
{
    const Place place = placeOf(row);
    const LineSegment& line = segment(row);
    const PlaneId plane = planeOf(place);
    switch (column) {
        case SegmentColumn::Id:
            return row;
        case SegmentColumn::Step:
            return line.id.step + 1;
        case SegmentColumn::State:
            return plane == kNoPlane ? QStringLiteral("unfitted") : QStringLiteral("fitted");
        case SegmentColumn::Plane:
            return plane == kNoPlane ? QVariant() : QVariant(plane);
        case SegmentColumn::Cluster: {
            const ClusterId cluster = owners_.clusterAt(place.slice, place.index);
            return cluster == kNoCluster ? QVariant() : QVariant(cluster);
        }
        case SegmentColumn::Length:
            return line.length();
        case SegmentColumn::Points:
            return line.points;
        case SegmentColumn::Rms:
            return kMillimetres * line.rms;
        case SegmentColumn::Start:
            return line.start.z();
        case SegmentColumn::End:
            return line.end.z();
    }
    return {};
}

QString SegmentsModel::textOf(int row, SegmentColumn column) const
{
    const LineSegment& line = segment(row);
    const QVariant value = valueOf(row, column);
    switch (column) {
        case SegmentColumn::Id:
            return QString::fromStdString(segmentLabel(line.id));
        case SegmentColumn::Plane:
            return value.isValid() ? QString::fromStdString(planeLabel(value.toInt())) : QStringLiteral("–");
        case SegmentColumn::Cluster:
            return value.isValid() ? 'C' + value.toString() : QStringLiteral("–");
        case SegmentColumn::Length:
            return lengthText(line.length(), style_);
        case SegmentColumn::Rms:
            return numberText(value.toDouble(), 1);
        case SegmentColumn::Start:
            return pointText(line.start, style_);
        case SegmentColumn::End:
            return pointText(line.end, style_);
        default:
            return value.toString();
    }
}

QVariant SegmentsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const auto column = static_cast<SegmentColumn>(index.column());
    switch (role) {
        case Qt::DisplayRole:
            return textOf(index.row(), column);
        case kSortRole:
            return valueOf(index.row(), column);
        case kPlainTextRole:
            return textOf(index.row(), SegmentColumn::Id) + ' ' + textOf(index.row(), SegmentColumn::State) + ' ' +
                   textOf(index.row(), SegmentColumn::Plane) + ' ' + textOf(index.row(), SegmentColumn::Cluster);
        case Qt::TextAlignmentRole:
            return QVariant(Qt::AlignVCenter | (column == SegmentColumn::State ? Qt::AlignLeft : Qt::AlignRight));
        default:
            return {};
    }
}

QVariant SegmentsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= kSegmentColumns)
        return {};
    const auto column = static_cast<SegmentColumn>(section);
    const SegmentColumnWords& words = kSegmentWords[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole)
        return QString::fromUtf8(words.title) + (isLength(column) ? ' ' + lengthUnit(style_) : QString{});
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
        return QString::fromUtf8(words.meaning);
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignVCenter | (column == SegmentColumn::State ? Qt::AlignLeft : Qt::AlignRight));
    return {};
}

}  // namespace planewright
