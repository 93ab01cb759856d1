// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/map_changes.h"

#include <algorithm>

#include "core/geometry/tangents.h"

namespace planewright {

namespace {

UncertainPlane sightingInMap(const BuildingMap& map, const Sighting& sighting)
{
    const MapStop& stop = map.stops[sighting.stop];
    UncertainPlane plane = inMap(stop.stop->planes[sighting.plane].parameters, stop.pose, stop.covariance);
    const UncertainPlane before = plane;
    plane.tangents = tangentsOf(plane.normal);
    plane.covariance = covarianceIn(plane, before);
    return plane;
}

}  // namespace

void mergePlanes(BuildingMap& map, std::size_t kept, std::size_t gone)
{
    MapPlane& from = map.planes[gone];
    MapPlane& to = map.planes[kept];
    for (const Sighting& sighting : from.sightings)
        map.stops[sighting.stop].matches[sighting.plane].plane = kept;
    to.sightings.insert(to.sightings.end(), from.sightings.begin(), from.sightings.end());
    to.seenThrough.insert(to.seenThrough.end(), from.seenThrough.begin(), from.seenThrough.end());
    from.sightings.clear();
    from.seenThrough.clear();
}

void moveStops(BuildingMap& map, std::span<const Vector6d> corrections)
{
    const auto motionOf = [&](std::size_t stop) {
        return Pose{rotationAbout(corrections[stop].head<3>()), corrections[stop].tail<3>()};
    };
    for (std::size_t stop = 0; stop < corrections.size(); ++stop) {
        if (!corrections[stop].isZero(0.0))
            map.stops[stop].pose = motionOf(stop) * map.stops[stop].pose;
    }
    for (MapPlane& plane : map.planes) {
        if (plane.sightings.empty() || plane.sightings.front().stop >= corrections.size() ||
            corrections[plane.sightings.front().stop].isZero(0.0))
            continue;
        plane.parameters = inMap(plane.parameters, motionOf(plane.sightings.front().stop));
    }
}

void addSighting(BuildingMap& map, std::size_t number, const Sighting& sighting)
{
    MapPlane& plane = map.planes[number];
    const UncertainPlane seen = sightingInMap(map, sighting);
    const MapStop& stop = map.stops[sighting.stop];
    const Eigen::Vector3d middle = stop.pose * middleOf(stop.stop->planes[sighting.plane]);
    const UncertainPlane both = seenFrom(fused(seenFrom(plane.parameters, middle), seenFrom(seen, middle)), -middle);
    const Eigen::Matrix3d before = covarianceIn(both, plane.parameters);
    const Eigen::Matrix3d now = covarianceIn(both, seen);
    plane.parameters = both;
    plane.parameters.covariance = before.determinant() <= now.determinant() ? before : now;
    plane.sightings.push_back(sighting);
}

std::size_t addPlane(BuildingMap& map, const Sighting& sighting)
{
    map.planes.push_back({sightingInMap(map, sighting), {sighting}, {}});
    return map.planes.size() - 1;
}

double chiSquareOf(const BuildingMap& map, const Sighting& sighting, std::size_t plane)
{
    const MapStop& stop = map.stops[sighting.stop];
    const Eigen::Vector3d middle = stop.pose * middleOf(stop.stop->planes[sighting.plane]);
    return chiSquare(seenFrom(map.planes[plane].parameters, middle), seenFrom(sightingInMap(map, sighting), middle));
}

bool isByHand(const BuildingMap& map, std::size_t plane)
{
    return std::ranges::any_of(map.planes[plane].sightings, [&](const Sighting& sighting) {
        return map.stops[sighting.stop].matches[sighting.plane].isByHand;
    });
}

void removeSighting(BuildingMap& map, const Sighting& sighting)
{
    const auto plane = map.stops[sighting.stop].matches[sighting.plane].plane;
    if (!plane)
        return;
    std::erase_if(map.planes[*plane].sightings,
                  [&](const Sighting& each) { return each.stop == sighting.stop && each.plane == sighting.plane; });
    map.stops[sighting.stop].matches[sighting.plane].plane.reset();
}

}  // namespace planewright
