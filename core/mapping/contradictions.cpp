// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/contradictions.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "core/mapping/map_changes.h"

namespace planewright {

namespace {

/// By how much χ² of all sightings must fall where the one that contradicts is left out.
constexpr double kContradicts = 50.0;
/// And by how much more than where any other is left out.
constexpr double kSurely = 13.8;

/// The sightings of a plane, each where its stop stands, as seen from the middle of the first.
std::vector<UncertainPlane> seenOf(const BuildingMap& map, const MapPlane& plane)
{
    std::vector<UncertainPlane> all;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    for (const Sighting& sighting : plane.sightings) {
        const MapStop& stop = map.stops[sighting.stop];
        const ObservedPlane& seen = stop.stop->planes[sighting.plane];
        if (all.empty())
            origin = stop.pose * middleOf(seen);
        all.push_back(seenFrom(inMap(seen.parameters, stop.pose), origin));
    }
    return all;
}

/// χ² of all sightings but one about the plane that they make together: 3 degrees of freedom for each but the first.
double chiWithout(const std::vector<UncertainPlane>& seen, std::optional<std::size_t> left)
{
    std::optional<UncertainPlane> plane;
    double chi = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (i == left)
            continue;
        if (plane)
            chi += chiSquare(*plane, seen[i]);
        plane = plane ? fused(*plane, seen[i]) : seen[i];
    }
    return chi;
}

/// The sighting that contradicts all others; none where it is not sure which.
std::optional<std::size_t> contradicting(const BuildingMap& map, const MapPlane& plane)
{
    const std::vector<UncertainPlane> seen = seenOf(map, plane);
    const double ofAll = chiWithout(seen, std::nullopt);
    if (!(ofAll > kContradicts))
        return std::nullopt;
    double least = std::numeric_limits<double>::infinity();
    double next = least;
    std::size_t which = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const double chi = chiWithout(seen, i);
        next = std::min(next, std::max(chi, least));
        if (chi < least) {
            least = chi;
            which = i;
        }
    }
    const bool othersAgree = least < chiSquareLimit(3 * static_cast<int>(seen.size() - 2));
    return othersAgree && ofAll - least > kContradicts && next - least > kSurely ? std::optional(which) : std::nullopt;
}

}  // namespace

int openContradictions(BuildingMap& map)
{
    int opened = 0;
    for (std::size_t number = 0; number < map.planes.size(); ++number) {
        while (map.planes[number].sightings.size() > 2 && !isByHand(map, number)) {
            const auto which = contradicting(map, map.planes[number]);
            if (!which)
                break;
            const Sighting sighting = map.planes[number].sightings[*which];
            removeSighting(map, sighting);
            map.stops[sighting.stop].matches[sighting.plane] = {
                MatchState::Open, std::nullopt, {number}, chiSquareOf(map, sighting, number), false};
            ++opened;
        }
    }
    return opened;
}

}  // namespace planewright
