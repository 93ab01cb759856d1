// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "app/mapping/snap_floor.h"
#include "app/window/asking.h"
#include "app/window/map_control.h"
#include "app/window/place_dialog.h"
#include "ui/models/number_text.h"

namespace planewright {

namespace {

/// Where a stop comes to stand, and its floor with it, when the floor snaps to the walls of another; and what is to be
/// said of it. `back` leads from the stop to the floor's frame.
std::pair<Pose, QString> snapped(const MappedFloor& floor, const MappedFloor& other, const Pose& back,
                                 const Pose& place)
{
    const auto snap =
        snapFloor(facedPlanes(floor.builder.map(), place * back), facedPlanes(other.builder.map(), other.frame));
    if (!snap)
        return {place, QString::fromStdString(snap.error().message)};
    QString text = QObject::tr("%1 over walls of floor %2, within %3 mm.")
                       .arg(countText(snap->walls, QObject::tr("wall"), QObject::tr("walls")))
                       .arg(other.floor)
                       .arg(1000.0 * snap->rms, 0, 'f', 1);
    if (!snap->isFixed)
        text += QObject::tr(" They fix not all of its place: along them it stays as it was.");
    return {snap->motion * place, text};
}

}  // namespace

void MapControl::askFloor(int number)
{
    const auto& floors = map_->floors;
    const auto floor = std::ranges::find(floors, number, &MappedFloor::floor);
    if (floor == floors.end())
        return;
    const auto& stops = floor->builder.map().stops;
    const auto stop = std::ranges::find_if(stops, &MapStop::isPlaced);
    if (stop == stops.end())
        return;
    const int of = stop->stop->id;
    const StopScan& scan = map_->stops[static_cast<std::size_t>(of)];
    const Pose there = floor->frame * stop->pose;
    const bool isByHand = isPlacedByHand(number);
    auto* dialog = new PlaceDialog({QStringLiteral("floor"), tr("Place floor %1 by its stop %2").arg(number).arg(of),
                                    tr("&The stop is here in the building")},
                                   isByHand ? std::optional(there) : std::nullopt, there, parts_.window.get());
    if (floors.size() > 1) {
        const MappedFloor& other = floor == floors.begin() ? floors[1] : *std::prev(floor);
        dialog->offerToFit(tr("&Snap to the walls of floor %1").arg(other.floor),
                           [map = map_, &mapped = *floor, &other, back = stop->pose.inverse()](const Pose& place) {
                               return snapped(mapped, other, back, place);
                           });
    }
    connect(dialog, &QDialog::accepted, this, [this, scan = scan.scan, dialog] {
        MapEdit placed;
        placed.kind = MapEdit::Kind::Floor;
        placed.scan = scan;
        placed.place = dialog->place();
        edit(placed);
    });
    ask(dialog);
}

bool MapControl::isPlacedByHand(int floor) const
{
    std::vector<StopEdit> edits;
    for (const MapEdit& edit : parts_.mapEdits.inForce())
        edits.push_back({parts_.session.project()->path(), edit});
    return std::ranges::any_of(floorsByHand(map_->stops, edits), [&](const auto& placed) {
        return map_->stops[static_cast<std::size_t>(placed.first)].floor == floor;
    });
}

}  // namespace planewright
