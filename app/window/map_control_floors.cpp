// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <iterator>
#include <memory>
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
    if (snap->height)
        text += QObject::tr(" Its height is that of %1 of stairs, within %2 mm.")
                    .arg(countText(snap->height->surfaces, QObject::tr("surface"), QObject::tr("surfaces")))
                    .arg(1000.0 * snap->height->rms, 0, 'f', 1);
    else
        text += QObject::tr(" Its height stays: no stairs are seen from both floors near where it is now.");
    return {snap->motion * place, text};
}

/// Of a floor as it stands: its upright planes, and handles around its middle.
PlacedShape shapeOf(const MappedFloor& floor)
{
    constexpr double kUpright = 0.3;       // |n·z| at most
    constexpr double kRingOverSize = 0.3;  // radius, of the floor's longer side
    PlacedShape shape;
    Eigen::AlignedBox3d bounds;
    for (const FacedPlane& plane : facedPlanes(floor.builder.map(), floor.frame)) {
        for (const Outline::Polygon& part : plane.parts) {
            for (const Eigen::Vector3d& corner : part.ring)
                bounds.extend(corner);
            if (std::abs(plane.normal.z()) < kUpright)
                shape.rings.push_back(part.ring);
        }
    }
    if (bounds.isEmpty())
        return shape;
    shape.middle = bounds.center();
    shape.radius = std::max(1.0, kRingOverSize * bounds.sizes().head<2>().maxCoeff());
    return shape;
}

}  // namespace

/// In the view the floor has handles while its dialog is open: what one moves the other shows.
void MapControl::showHandles(const MappedFloor& floor, const Pose& there, PlaceDialog* dialog)
{
    View3d& view = parts_.window->mapView();
    const PlacedShape before = shapeOf(floor);
    const auto follow = [&view, dialog, before, back = there.inverse()] {
        view.setPlaced(moved(before, dialog->pose() * back));
    };
    follow();
    connect(dialog, &PlaceDialog::placeChanged, &view, follow);
    const auto taken = std::make_shared<Pose>(there);
    connect(&view, &View3d::handleTaken, dialog, [dialog, taken] { *taken = dialog->pose(); });
    connect(&view, &View3d::handleMoved, dialog,
            [dialog, taken](const Pose& motion) { dialog->setPlace(motion * *taken); });
    connect(dialog, &QDialog::finished, &view, [&view] { view.setPlaced(std::nullopt); });
    // A map that is made anew has other floors.
    connect(&worker_, &BuildingWorker::made, dialog, &QDialog::reject);
}

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
        dialog->offerToFit(tr("&Snap to walls and stairs of floor %1").arg(other.floor),
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
    dialog->explain(
        tr("Or drag the handles in the view: the middle shifts the floor, the knob on the ring turns it, "
           "the arrow raises it."));
    if (askBeside(dialog))
        showHandles(*floor, there, dialog);
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
