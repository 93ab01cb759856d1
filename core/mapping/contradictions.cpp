// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/contradictions.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/mapping/map_changes.h"

namespace planewright {

namespace {

/// Groups of sightings whose planes are farther apart than this χ² are of several surfaces.
constexpr double kContradicts = 50.0;
/// By how much less χ² of a sighting to its own group is than to any other.
constexpr double kSurely = 13.8;
/// χ² to the plane of all: a plane all of whose sightings are nearer has no two groups.
constexpr double kDoubtful = 12.0;
/// So many sightings are grouped one by one; of more, those that are near to the plane of all begin as one group.
constexpr std::size_t kOneByOne = 64;

/// Sightings that agree, by their places in the plane's list, and the plane that they make together.
struct SightingGroup {
    std::vector<std::size_t> members;
    UncertainPlane plane;
};

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

/// The plane of some sightings, and their χ² about it: 3 degrees of freedom for each but the first.
std::pair<UncertainPlane, double> fusedOf(const std::vector<UncertainPlane>& seen,
                                          const std::vector<std::size_t>& members)
{
    UncertainPlane plane = seen[members.front()];
    double chi = 0.0;
    for (std::size_t i = 1; i < members.size(); ++i) {
        chi += chiSquare(plane, seen[members[i]]);
        plane = fused(plane, seen[members[i]]);
    }
    return {plane, chi};
}

/// Where grouping begins: with each sighting alone, as far as they are few. None where nothing is doubtful, or too
/// much.
std::vector<SightingGroup> firstGroups(const std::vector<UncertainPlane>& seen)
{
    std::vector<std::size_t> all(seen.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const UncertainPlane plane = fusedOf(seen, all).first;
    std::vector<std::size_t> near;
    std::vector<std::size_t> doubtful;
    for (const std::size_t i : all)
        (chiSquare(plane, seen[i]) < kDoubtful ? near : doubtful).push_back(i);
    std::vector<SightingGroup> groups;
    if (doubtful.empty() || doubtful.size() > kOneByOne)
        return groups;
    const bool isMany = seen.size() > kOneByOne;
    if (isMany)
        groups.push_back({near, fusedOf(seen, near).first});
    for (const std::size_t i : isMany ? doubtful : all)
        groups.push_back({{i}, seen[i]});
    return groups;
}

/// The largest first, of equally large ones the one that saw the plane first.
void sortBySize(std::vector<SightingGroup>& groups)
{
    std::ranges::sort(groups, [](const SightingGroup& a, const SightingGroup& b) {
        return std::pair(b.members.size(), a.members.front()) < std::pair(a.members.size(), b.members.front());
    });
}

/// The two groups that are nearest to each other.
struct NearestGroups {
    std::size_t first = 0;
    std::size_t second = 0;
    double chi = std::numeric_limits<double>::infinity();
};

/// `chis` has a row for each group, of what it is apart from each before it.
NearestGroups nearestOf(const std::vector<std::vector<double>>& chis)
{
    NearestGroups nearest;
    for (std::size_t a = 0; a < chis.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            if (chis[a][b] < nearest.chi)
                nearest = {b, a, chis[a][b]};
        }
    }
    return nearest;
}

/// Joins the two groups that are nearest to each other until all that are left contradict each other.
std::vector<SightingGroup> groupsOf(const std::vector<UncertainPlane>& seen)
{
    std::vector<SightingGroup> groups = firstGroups(seen);
    const auto apart = [&](std::size_t a, std::size_t b) { return chiSquare(groups[a].plane, groups[b].plane); };
    std::vector<std::vector<double>> chis(groups.size());
    for (std::size_t a = 0; a < groups.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b)
            chis[a].push_back(apart(a, b));
    }
    for (NearestGroups nearest = nearestOf(chis); nearest.chi < kContradicts; nearest = nearestOf(chis)) {
        const std::size_t kept = nearest.first;
        const std::size_t gone = nearest.second;
        std::vector<std::size_t>& members = groups[kept].members;
        members.insert(members.end(), groups[gone].members.begin(), groups[gone].members.end());
        groups[kept].plane = fused(groups[kept].plane, groups[gone].plane);
        const auto at = static_cast<std::ptrdiff_t>(gone);
        groups.erase(groups.begin() + at);
        chis.erase(chis.begin() + at);
        for (std::size_t a = gone; a < groups.size(); ++a)
            chis[a].erase(chis[a].begin() + at);
        for (std::size_t a = 0; a < groups.size(); ++a) {
            if (a != kept)
                chis[std::max(a, kept)][std::min(a, kept)] = apart(a, kept);
        }
    }
    for (SightingGroup& group : groups)
        std::ranges::sort(group.members);
    sortBySize(groups);
    return groups;
}

/// Takes the sightings out of their groups that might as well be of another one.
std::vector<std::size_t> takeUnsure(std::vector<SightingGroup>& groups, const std::vector<UncertainPlane>& seen)
{
    std::vector<std::size_t> unsure;
    std::vector<std::vector<std::size_t>> sure(groups.size());
    for (std::size_t own = 0; own < groups.size(); ++own) {
        for (const std::size_t i : groups[own].members) {
            const double chi = chiSquare(groups[own].plane, seen[i]);
            bool isSure = true;
            for (std::size_t other = 0; other < groups.size(); ++other)
                isSure = isSure && (other == own || chiSquare(groups[other].plane, seen[i]) > chi + kSurely);
            (isSure ? sure[own] : unsure).push_back(i);
        }
    }
    for (std::size_t own = 0; own < groups.size(); ++own)
        groups[own].members = std::move(sure[own]);
    std::erase_if(groups, [](const SightingGroup& group) { return group.members.empty(); });
    sortBySize(groups);
    return unsure;
}

/// True where there is a largest group, and all sightings of each group agree.
bool doAgree(const std::vector<SightingGroup>& groups, const std::vector<UncertainPlane>& seen)
{
    return groups.size() > 1 && groups.front().members.size() > 1 &&
           std::ranges::all_of(groups, [&](const SightingGroup& group) {
               const int freedom = 3 * (static_cast<int>(group.members.size()) - 1);
               return freedom == 0 || fusedOf(seen, group.members).second < chiSquareLimit(freedom);
           });
}

void leaveOpen(BuildingMap& map, const Sighting& sighting, std::vector<std::size_t> rivals)
{
    removeSighting(map, sighting);
    const double chi = chiSquareOf(map, sighting, rivals.front());
    map.stops[sighting.stop].matches[sighting.plane] = {MatchState::Open, std::nullopt, std::move(rivals), chi, false};
}

/// Makes sightings a plane of their own, and gives its number.
std::size_t makePlane(BuildingMap& map, const std::vector<Sighting>& group)
{
    for (const Sighting& sighting : group)
        removeSighting(map, sighting);
    const std::size_t own = addPlane(map, group.front());
    map.stops[group.front().stop].matches[group.front().plane] = {MatchState::New, own, {}, 0.0, false};
    for (std::size_t i = 1; i < group.size(); ++i) {
        map.stops[group[i].stop].matches[group[i].plane] = {
            MatchState::Matched, own, {}, chiSquareOf(map, group[i], own), false};
        addSighting(map, own, group[i]);
    }
    return own;
}

/// Divides a plane, and says how many sightings left it.
int divide(BuildingMap& map, std::size_t number)
{
    const std::vector<Sighting> sightings = map.planes[number].sightings;
    const std::vector<UncertainPlane> seen = seenOf(map, map.planes[number]);
    std::vector<SightingGroup> groups = groupsOf(seen);
    if (groups.size() < 2)
        return 0;
    const std::vector<std::size_t> unsure = takeUnsure(groups, seen);
    if (!doAgree(groups, seen))
        return 0;
    std::vector<std::size_t> planes{number};
    for (std::size_t k = 1; k < groups.size(); ++k) {
        std::vector<Sighting> group;
        for (const std::size_t i : groups[k].members)
            group.push_back(sightings[i]);
        if (group.size() > 1)
            planes.push_back(makePlane(map, group));
        else
            leaveOpen(map, group.front(), {number});
    }
    for (const std::size_t i : unsure)
        leaveOpen(map, sightings[i], planes);
    // The stop that saw it first may have been another one.
    const Sighting& first = map.planes[number].sightings.front();
    map.stops[first.stop].matches[first.plane].state = MatchState::New;
    return static_cast<int>(sightings.size() - map.planes[number].sightings.size());
}

}  // namespace

int divideContradictions(BuildingMap& map)
{
    int moved = 0;
    const std::size_t planes = map.planes.size();  // those that are made on the way agree
    for (std::size_t number = 0; number < planes; ++number) {
        if (map.planes[number].sightings.size() > 2 && !isByHand(map, number))
            moved += divide(map, number);
    }
    return moved;
}

}  // namespace planewright
