// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/matches_model.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/types/plane_words.h"
#include "ui/models/model_roles.h"
#include "ui/models/number_text.h"

namespace planewright {

namespace {

struct MatchesHeading {
    const char* title;
    const char* tip;
};
constexpr std::array<MatchesHeading, kMatchesColumns> kMatchesHeadings{{
    {QT_TRANSLATE_NOOP("planewright::MatchesModel", "Stop"),
     QT_TRANSLATE_NOOP("planewright::MatchesModel", "The stop that saw the plane")},
    {QT_TRANSLATE_NOOP("planewright::MatchesModel", "plane"),
     QT_TRANSLATE_NOOP("planewright::MatchesModel", "As the stop's own scan names it")},
    {QT_TRANSLATE_NOOP("planewright::MatchesModel", "class"),
     QT_TRANSLATE_NOOP("planewright::MatchesModel", "Floor, ceiling, wall or other")},
    {QT_TRANSLATE_NOOP("planewright::MatchesModel", "area m²"),
     QT_TRANSLATE_NOOP("planewright::MatchesModel", "What the stop saw of it")},
    {QT_TRANSLATE_NOOP("planewright::MatchesModel", "state"),
     QT_TRANSLATE_NOOP("planewright::MatchesModel",
                       "Matched: the map had it; new: no stop before had seen it; open: it may be one of several")},
    {QT_TRANSLATE_NOOP("planewright::MatchesModel", "in map"),
     QT_TRANSLATE_NOOP("planewright::MatchesModel", "The plane of the map that it is")},
    {QT_TRANSLATE_NOOP("planewright::MatchesModel", "χ²"),
     QT_TRANSLATE_NOOP("planewright::MatchesModel",
                       "Squared difference over its uncertainty as it was matched: 3 expected, above 16 is unlikely")},
    {QT_TRANSLATE_NOOP("planewright::MatchesModel", "may be"),
     QT_TRANSLATE_NOOP("planewright::MatchesModel", "Planes of the map that an open one may be")},
}};

QString mapPlaneLabel(PlaneId plane)
{
    return QString::fromStdString(planeLabel(plane));
}

/// Nothing where a match has no such number.
std::optional<double> numberOfMatch(const ShownMatch& match, MatchesColumn column)
{
    switch (column) {
        case MatchesColumn::Stop:
            return match.stop;
        case MatchesColumn::Plane:
            return match.own.plane;
        case MatchesColumn::Area:
            return match.area;
        case MatchesColumn::MapPlane:
            return match.plane == kNoPlane ? std::nullopt : std::optional<double>(match.plane);
        case MatchesColumn::ChiSquare:
            return match.state == MatchState::Matched ? std::optional(match.chiSquare) : std::nullopt;
        default:
            return std::nullopt;
    }
}

bool isMatchesNumber(MatchesColumn column)
{
    return column == MatchesColumn::Stop || column == MatchesColumn::Area || column == MatchesColumn::ChiSquare;
}

}  // namespace

MatchesModel::MatchesModel(QObject* parent) : QAbstractTableModel(parent) {}

void MatchesModel::setBuilding(std::shared_ptr<const ShownBuilding> building)
{
    beginResetModel();
    building_ = std::move(building);
    endResetModel();
}

int MatchesModel::rowOf(const StopPlane& plane) const
{
    if (!building_)
        return -1;
    const auto& matches = building_->matches;
    const auto found = std::ranges::find_if(matches, [&](const ShownMatch& match) {
        return match.own.scan == plane.scan && match.own.plane == plane.plane;
    });
    return found == matches.end() ? -1 : static_cast<int>(found - matches.begin());
}

int MatchesModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() || !building_ ? 0 : static_cast<int>(building_->matches.size());
}

int MatchesModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kMatchesColumns;
}

QString MatchesModel::text(const ShownMatch& match, MatchesColumn column) const
{
    QStringList rivals;
    switch (column) {
        case MatchesColumn::Plane:
            return mapPlaneLabel(match.own.plane);
        case MatchesColumn::Class:
            return QString::fromStdString(match.className);
        case MatchesColumn::State: {
            const QString state = match.state == MatchState::Matched ? tr("matched")
                                  : match.state == MatchState::New   ? tr("new")
                                                                     : tr("open");
            return match.isByHand ? tr("%1 by hand").arg(state) : state;
        }
        case MatchesColumn::MapPlane:
            return match.plane == kNoPlane ? QStringLiteral("–") : mapPlaneLabel(match.plane);
        case MatchesColumn::Rivals:
            for (const PlaneId rival : match.rivals)
                rivals.push_back(mapPlaneLabel(rival));
            return rivals.join(QStringLiteral(", "));
        default:
            break;
    }
    const auto number = numberOfMatch(match, column);
    return number ? numberText(*number, column == MatchesColumn::Stop ? 0 : 2) : QStringLiteral("–");
}

QVariant MatchesModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const ShownMatch& shown = matchAt(index.row());
    const auto column = static_cast<MatchesColumn>(index.column());
    switch (role) {
        case Qt::DisplayRole:
            return text(shown, column);
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(Qt::AlignVCenter | (isMatchesNumber(column) ? Qt::AlignRight : Qt::AlignLeft));
        case kSortRole: {
            const auto number = numberOfMatch(shown, column);
            const bool isText =
                column == MatchesColumn::Class || column == MatchesColumn::State || column == MatchesColumn::Rivals;
            return number ? QVariant(*number) : isText ? QVariant(text(shown, column)) : QVariant();
        }
        case kPlainTextRole:
            return text(shown, MatchesColumn::Plane) + QLatin1Char(' ') + text(shown, MatchesColumn::Class) +
                   QLatin1Char(' ') + text(shown, MatchesColumn::State) + QLatin1Char(' ') +
                   text(shown, MatchesColumn::MapPlane);
        default:
            return {};
    }
}

QVariant MatchesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= kMatchesColumns)
        return {};
    const MatchesHeading& heading = kMatchesHeadings[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole)
        return tr(heading.title);
    if (role == Qt::ToolTipRole)
        return tr(heading.tip);
    return {};
}

}  // namespace planewright
