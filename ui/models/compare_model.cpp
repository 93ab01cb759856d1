// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/compare_model.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/types/angle.h"
#include "core/types/plane_words.h"
#include "ui/models/model_roles.h"
#include "ui/models/number_text.h"

namespace planewright {

namespace {

struct CompareHeading {
    const char* title;
    const char* tip;
};
constexpr std::array<CompareHeading, kCompareColumns> kCompareHeadings{{
    {QT_TRANSLATE_NOOP("planewright::CompareModel", "What"),
     QT_TRANSLATE_NOOP("planewright::CompareModel", "Who has it")},
    {QT_TRANSLATE_NOOP("planewright::CompareModel", "A"),
     QT_TRANSLATE_NOOP("planewright::CompareModel", "Plane of A; in brackets the one that has most of B's plane")},
    {QT_TRANSLATE_NOOP("planewright::CompareModel", "B"),
     QT_TRANSLATE_NOOP("planewright::CompareModel", "Plane of B; in brackets the one that has most of A's plane")},
    {QT_TRANSLATE_NOOP("planewright::CompareModel", "overlap %"),
     QT_TRANSLATE_NOOP("planewright::CompareModel",
                       "Share of common beams in all beams of both planes; of a plane "
                       "without a partner, of its beams that the one in brackets has")},
    {QT_TRANSLATE_NOOP("planewright::CompareModel", "angle °"),
     QT_TRANSLATE_NOOP("planewright::CompareModel", "Between the normals")},
    {QT_TRANSLATE_NOOP("planewright::CompareModel", "Δd mm"),
     QT_TRANSLATE_NOOP("planewright::CompareModel", "Difference of the distances from the scanner")},
    {QT_TRANSLATE_NOOP("planewright::CompareModel", "seg. A"),
     QT_TRANSLATE_NOOP("planewright::CompareModel", "Line segments on the plane of A")},
    {QT_TRANSLATE_NOOP("planewright::CompareModel", "seg. B"),
     QT_TRANSLATE_NOOP("planewright::CompareModel", "Line segments on the plane of B")},
    {QT_TRANSLATE_NOOP("planewright::CompareModel", "E of A"),
     QT_TRANSLATE_NOOP("planewright::CompareModel", "Fitting error of the plane of A")},
    {QT_TRANSLATE_NOOP("planewright::CompareModel", "E of B"),
     QT_TRANSLATE_NOOP("planewright::CompareModel", "Fitting error of the plane of B")},
}};

const Plane* planeIn(const Snapshot& map, PlaneId id)
{
    const auto found = std::lower_bound(map.planes.begin(), map.planes.end(), id,
                                        [](const auto& plane, PlaneId wanted) { return plane->id < wanted; });
    return found != map.planes.end() && (*found)->id == id ? found->get() : nullptr;
}

std::optional<double> segmentsOf(const Plane* plane)
{
    return plane != nullptr ? std::optional(static_cast<double>(plane->segments.size())) : std::nullopt;
}

std::optional<double> errorOf(const Plane* plane)
{
    return plane != nullptr ? std::optional(plane->fittingError) : std::nullopt;
}

}  // namespace

CompareModel::CompareModel(QObject* parent) : QAbstractTableModel(parent) {}

void CompareModel::setMaps(std::shared_ptr<const Snapshot> a, std::shared_ptr<const Snapshot> b)
{
    if (a == a_ && b == b_)
        return;
    beginResetModel();
    a_ = std::move(a);
    b_ = std::move(b);
    rows_.clear();
    comparison_ = a_ && b_ ? compareMaps(*a_, *b_) : MapComparison{};
    for (const PairedPlanes& pair : comparison_.pairs)
        rows_.push_back({pair.a, pair.b, &pair, nullptr, planeIn(*a_, pair.a), planeIn(*b_, pair.b)});
    for (const UnpairedPlane& single : comparison_.onlyA)
        rows_.push_back({single.plane, kNoPlane, nullptr, &single, planeIn(*a_, single.plane), nullptr});
    for (const UnpairedPlane& single : comparison_.onlyB)
        rows_.push_back({kNoPlane, single.plane, nullptr, &single, nullptr, planeIn(*b_, single.plane)});
    endResetModel();
}

int CompareModel::rowOfA(PlaneId plane) const
{
    const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.a == plane; });
    return plane == kNoPlane || found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int CompareModel::rowOfB(PlaneId plane) const
{
    const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.b == plane; });
    return plane == kNoPlane || found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int CompareModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int CompareModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kCompareColumns;
}

namespace {

/// Per cent, degrees, millimetres or counts, as the heading says; nothing where a row has none.
std::optional<double> numberOf(CompareColumn column, const PairedPlanes* pair, const UnpairedPlane* single,
                               const Plane* a, const Plane* b)
{
    switch (column) {
        case CompareColumn::What:
        case CompareColumn::A:
        case CompareColumn::B:
            break;
        case CompareColumn::Overlap:
            return 100.0 * (pair != nullptr ? pair->overlap : single->share);
        case CompareColumn::Angle:
            return pair != nullptr ? std::optional(toDegrees(pair->difference.angle)) : std::nullopt;
        case CompareColumn::Distance:
            return pair != nullptr ? std::optional(kMillimetres * pair->difference.distance) : std::nullopt;
        case CompareColumn::SegmentsA:
            return segmentsOf(a);
        case CompareColumn::SegmentsB:
            return segmentsOf(b);
        case CompareColumn::ErrorA:
            return errorOf(a);
        case CompareColumn::ErrorB:
            return errorOf(b);
    }
    return std::nullopt;
}

int decimalsOf(CompareColumn column)
{
    switch (column) {
        case CompareColumn::Angle:
            return 3;
        case CompareColumn::ErrorA:
        case CompareColumn::ErrorB:
            return 2;
        case CompareColumn::Distance:
            return 1;
        default:
            return 0;
    }
}

QString compareLabel(PlaneId plane, const UnpairedPlane* single)
{
    if (plane != kNoPlane)
        return QString::fromStdString(planeLabel(plane));
    if (single == nullptr || single->nearest == kNoPlane)
        return QStringLiteral("–");
    return QStringLiteral("(%1)").arg(QString::fromStdString(planeLabel(single->nearest)));
}

}  // namespace

QString CompareModel::text(const Row& row, CompareColumn column) const
{
    switch (column) {
        case CompareColumn::What:
            return row.pair != nullptr ? tr("both") : row.a != kNoPlane ? tr("only A") : tr("only B");
        case CompareColumn::A:
            return compareLabel(row.a, row.single);
        case CompareColumn::B:
            return compareLabel(row.b, row.single);
        default:
            break;
    }
    const auto number = numberOf(column, row.pair, row.single, row.planeA, row.planeB);
    return number ? numberText(*number, decimalsOf(column)) : QStringLiteral("–");
}

QVariant CompareModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    const auto column = static_cast<CompareColumn>(index.column());
    const bool isWord = column == CompareColumn::What || column == CompareColumn::A || column == CompareColumn::B;
    switch (role) {
        case Qt::DisplayRole:
            return text(row, column);
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(Qt::AlignVCenter | (isWord ? Qt::AlignLeft : Qt::AlignRight));
        case kSortRole: {
            if (isWord)
                return text(row, column);
            const auto number = numberOf(column, row.pair, row.single, row.planeA, row.planeB);
            return number ? QVariant(*number) : QVariant();
        }
        case kPlainTextRole:
            return text(row, CompareColumn::What) + QLatin1Char(' ') + text(row, CompareColumn::A) + QLatin1Char(' ') +
                   text(row, CompareColumn::B);
        default:
            return {};
    }
}

QVariant CompareModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= kCompareColumns)
        return {};
    const CompareHeading& heading = kCompareHeadings[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole)
        return tr(heading.title);
    if (role == Qt::ToolTipRole)
        return tr(heading.tip);
    return {};
}

}  // namespace planewright
