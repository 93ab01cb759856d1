// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/shown_building_of.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/mapping/stop_words.h"
#include "core/geometry/triangulate.h"
#include "core/mapping/uncertain_plane.h"

namespace planewright {

namespace {

/// The numbers that planes of a floor's map have over all floors; kNoPlane for those that were merged into others.
std::vector<PlaneId> planeIds(const BuildingMap& map, PlaneId& next)
{
    std::vector<PlaneId> ids;
    for (const MapPlane& plane : map.planes)
        ids.push_back(plane.sightings.empty() ? kNoPlane : next++);
    return ids;
}

int countOf(const MapStop& stop, MatchState state)
{
    return static_cast<int>(std::ranges::count(stop.matches, state, &MapMatch::state));
}

ShownStop shownStop(const MapStop& stop, const StopScan& scan, const MappedFloor& floor)
{
    ShownStop shown;
    shown.number = stop.stop->id;
    shown.scan = scan.scan;
    shown.name = scan.name;
    shown.floor = floor.floor;
    shown.isPlaced = stop.isPlaced();
    shown.pose = floor.frame * stop.pose;
    shown.told = scan.odometry;
    const auto variances = stop.covariance.diagonal();
    shown.sigmaShift = std::sqrt(variances.tail<3>().maxCoeff());
    shown.sigmaTurn = std::sqrt(variances.head<3>().maxCoeff());
    shown.trust = trustText(stop.trust);
    shown.warning = warningOf(stop);
    shown.matched = countOf(stop, MatchState::Matched);
    shown.fresh = countOf(stop, MatchState::New);
    shown.open = countOf(stop, MatchState::Open);
    return shown;
}

/// The way by odometry alone begins where the floor's first stop with odometry is.
void addRawWay(std::vector<ShownStop>& stops, std::size_t from)
{
    const auto first = std::find_if(stops.begin() + static_cast<std::ptrdiff_t>(from), stops.end(),
                                    [](const ShownStop& stop) { return stop.isPlaced && stop.told; });
    if (first == stops.end())
        return;
    const Pose toBuilding = first->pose * first->told->inverse();
    for (std::size_t i = from; i < stops.size(); ++i) {
        if (stops[i].told)
            stops[i].raw = toBuilding * *stops[i].told;
    }
}

void addMatches(const MapStop& stop, const StopScan& scan, const std::vector<PlaneId>& ids,
                std::span<const MapEdit> edits, ShownBuilding& building)
{
    if (!stop.isPlaced())
        return;
    for (std::size_t i = 0; i < stop.matches.size(); ++i) {
        const MapMatch& match = stop.matches[i];
        const PlaneResult& seen = scan.planes[i];
        ShownMatch& shown = building.matches.emplace_back();
        shown.stop = stop.stop->id;
        shown.own = {scan.scan, seen.plane->id};
        shown.className = seen.className;
        shown.area = seen.outline.area;
        shown.state = match.state;
        shown.plane = match.plane ? ids[*match.plane] : kNoPlane;
        shown.chiSquare = match.chiSquare;
        for (const std::size_t rival : match.rivals) {
            if (ids[rival] != kNoPlane)
                shown.rivals.push_back(ids[rival]);
        }
        shown.isByHand = std::ranges::any_of(edits, [&](const MapEdit& edit) {
            return edit.kind == MapEdit::Kind::Match && edit.scan == scan.scan && edit.plane == seen.plane->id;
        });
    }
}

/// How well the place of a plane in its middle is known [m].
double sigmaOf(const PlaneResult& plane)
{
    const UncertainPlane parameters{plane.plane->normal, plane.plane->distance, plane.plane->covariance,
                                    plane.plane->tangents};
    return std::sqrt(std::max(seenFrom(parameters, plane.outline.centroid).covariance(2, 2), 0.0));
}

void addFloor(const BuiltMap& built, const MappedFloor& floor, std::span<const MapEdit> edits, PlaneId& next,
              ShownBuilding& building)
{
    const BuildingMap& map = floor.builder.map();
    const std::vector<PlaneId> ids = planeIds(map, next);
    const std::size_t firstStop = building.stops.size();
    for (const MapStop& stop : map.stops) {
        const StopScan& scan = built.stops[static_cast<std::size_t>(stop.stop->id)];
        building.stops.push_back(shownStop(stop, scan, floor));
        addMatches(stop, scan, ids, edits, building);
    }
    addRawWay(building.stops, firstStop);
    for (const MapPlane& plane : map.planes) {
        if (plane.sightings.empty())
            continue;
        ShownMapPlane& shown = building.planes.emplace_back();
        shown.floor = floor.floor;
        shown.firstStop = map.stops[plane.sightings.front().stop].stop->id;
        shown.sigma = sigmaOf(built.planes[building.planes.size() - 1]);
        for (const Sighting& sighting : plane.sightings) {
            const MapStop& stop = map.stops[sighting.stop];
            shown.seenBy.push_back(
                {built.stops[static_cast<std::size_t>(stop.stop->id)].scan, stop.stop->planes[sighting.plane].id});
        }
    }
    building.floors.push_back(floor.floor);
}

}  // namespace

std::shared_ptr<const ShownMap> shownMapOf(const BuiltMap& built, std::span<const StopInput> omitted,
                                           std::span<const MapEdit> edits, std::size_t allStops)
{
    auto building = std::make_shared<ShownBuilding>();
    PlaneId next = 0;
    for (const MappedFloor& floor : built.floors)
        addFloor(built, floor, edits, next, *building);
    std::ranges::stable_sort(building->stops, {}, &ShownStop::number);
    std::ranges::stable_sort(building->matches, {}, &ShownMatch::stop);
    for (const StopInput& input : omitted) {
        ShownStop& stop = building->stops.emplace_back();
        stop.scan = input.choice.scan.value_or(0);
        stop.name = input.name;
        stop.floor = input.floor;
        stop.told = input.odometry;
    }
    building->allStops = static_cast<int>(allStops);

    auto map = std::make_shared<ShownMap>();
    for (const PlaneResult& plane : built.planes) {
        auto filled = std::make_shared<FilledOutline>();
        filled->outline = plane.outline;
        filled->triangles = triangulate(plane.outline, plane.plane->normal);
        map->planes.push_back({plane.plane, plane.name, plane.className, false, false, std::move(filled)});
    }
    map->finished = true;
    map->building = std::move(building);
    return map;
}

}  // namespace planewright
