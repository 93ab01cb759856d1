// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/map_results.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "core/geometry/tangents.h"
#include "core/mapping/uncertain_plane.h"

namespace planewright {

namespace {

/// The word that most of the stops which saw a plane have for it, by area; of equal ones the first in the alphabet.
std::string wordOfMost(const std::map<std::string, double>& words)
{
    std::string most;
    double area = 0.0;
    for (const auto& [word, share] : words) {
        if (!word.empty() && share > area) {
            most = word;
            area = share;
        }
    }
    return most;
}

/// Turns a plane round where its d is negative; its tangents with it, so that the covariance of d changes sign.
void makeCanonical(UncertainPlane& plane)
{
    const Eigen::Vector3d normal = plane.normal;
    planewright::makeCanonical(plane.normal, plane.distance);
    if (plane.normal.dot(normal) > 0.0)
        return;
    plane.tangents = -plane.tangents;
    plane.covariance.topRightCorner<2, 1>() *= -1.0;
    plane.covariance.bottomLeftCorner<1, 2>() *= -1.0;
}

}  // namespace

std::vector<FloorScans> floorsOf(std::span<const StopScan> stops)
{
    std::map<int, std::vector<std::size_t>> byFloor;
    for (std::size_t i = 0; i < stops.size(); ++i)
        byFloor[stops[i].floor].push_back(i);
    std::vector<FloorScans> floors;
    for (auto& [floor, numbers] : byFloor)
        floors.push_back({floor, std::move(numbers)});
    return floors;
}

Result<Stop> stopOf(const StopScan& scan, int number, const StopScan* before)
{
    Stop stop;
    stop.id = number;
    for (const PlaneResult& plane : scan.planes) {
        if ((plane.plane->covariance.diagonal().array() <= 0.0).any())
            return fail(ErrorCode::Unreadable, scan.name + ": plane " + std::to_string(plane.plane->id) +
                                                   " has no covariance; extract with the preset precise");
        stop.planes.push_back(observedPlane(*plane.plane, plane.outline));
    }
    if (before != nullptr && before->odometry && scan.odometry) {
        const Pose motion = before->odometry->inverse() * *scan.odometry;
        stop.odometry = Motion{motion, odometryCovariance(motion, {})};
    }
    return stop;
}

std::vector<PlaneResult> mapPlaneResults(const BuildingMap& map, std::span<const StopScan> stops, const Pose& frame,
                                         PlaneId firstId)
{
    std::vector<PlaneResult> results;
    for (const MapPlane& mapped : map.planes) {
        if (mapped.sightings.empty())
            continue;
        std::map<std::string, double> names;
        std::map<std::string, double> classes;
        PlaneResult& result = results.emplace_back();
        auto plane = std::make_shared<Plane>();
        plane->id = firstId + static_cast<PlaneId>(results.size()) - 1;
        for (const Sighting& sighting : mapped.sightings) {
            const auto number = static_cast<std::size_t>(map.stops[sighting.stop].stop->id);
            const PlaneResult& seen = stops[number].planes[sighting.plane];
            names[seen.name] += seen.outline.area;
            classes[seen.className] += seen.outline.area;
            plane->points += seen.plane->points;
            result.stops.push_back(static_cast<int>(number));
        }
        std::ranges::sort(result.stops);
        result.stops.erase(std::unique(result.stops.begin(), result.stops.end()), result.stops.end());
        UncertainPlane parameters = inMap(mapped.parameters, frame);
        makeCanonical(parameters);
        plane->normal = parameters.normal;
        plane->distance = parameters.distance;
        plane->covariance = parameters.covariance;
        plane->tangents = parameters.tangents;
        std::vector<Outline::Polygon> parts = fusedOutline(map, mapped);
        for (Outline::Polygon& part : parts) {
            for (Eigen::Vector3d& corner : part.ring)
                corner = frame * corner;
            for (auto& hole : part.holes) {
                for (Eigen::Vector3d& corner : hole)
                    corner = frame * corner;
            }
        }
        result.outline = outlineOf(parts, plane->normal, plane->distance);
        result.name = wordOfMost(names);
        result.className = wordOfMost(classes);
        result.plane = std::move(plane);
    }
    return results;
}

}  // namespace planewright
