// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/compare_maps.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace planewright {

namespace {

/// Beams of one slice, one after the other, that see a plane.
struct SeenBeams {
    int step = 0;
    int first = 0;
    int last = 0;
    std::size_t plane = 0;  ///< its place in the map
};

/// In order of step and beam; a beam may end one segment and begin the next.
std::vector<SeenBeams> beamsOf(const Snapshot& map)
{
    std::vector<SeenBeams> beams;
    for (std::size_t place = 0; place < map.planes.size(); ++place) {
        for (const SegmentId& id : map.planes[place]->segments) {
            const LineSegment& segment = map.segments[id];
            beams.push_back({id.step, segment.firstBeam, segment.lastBeam, place});
        }
    }
    std::sort(beams.begin(), beams.end(), [](const SeenBeams& x, const SeenBeams& y) {
        return std::tie(x.step, x.first, x.plane) < std::tie(y.step, y.first, y.plane);
    });
    return beams;
}

std::vector<std::int64_t> beamsPerPlane(const std::vector<SeenBeams>& beams, std::size_t planes)
{
    std::vector<std::int64_t> counts(planes);
    for (const SeenBeams& seen : beams)
        counts[seen.plane] += seen.last - seen.first + 1;
    return counts;
}

using CommonBeams = std::map<std::pair<std::size_t, std::size_t>, std::int64_t>;

/// Beams that a plane of A and one of B both have, by their places.
CommonBeams commonBeams(const std::vector<SeenBeams>& a, const std::vector<SeenBeams>& b)
{
    CommonBeams common;
    auto from = b.begin();
    for (const SeenBeams& seen : a) {
        // Segments of a slice follow each other, so that what ends before this one also ends before all later ones.
        while (from != b.end() && std::tie(from->step, from->last) < std::tie(seen.step, seen.first))
            ++from;
        for (auto other = from; other != b.end() && other->step == seen.step && other->first <= seen.last; ++other) {
            const int shared = std::min(seen.last, other->last) - std::max(seen.first, other->first) + 1;
            if (shared > 0)
                common[{seen.plane, other->plane}] += shared;
        }
    }
    return common;
}

ComparedPlane comparedPlane(const Plane& plane)
{
    return {plane.id, plane.normal, plane.distance};
}

struct Candidate {
    double overlap = 0.0;
    PlaneDifference difference;
    std::size_t a = 0;
    std::size_t b = 0;
};

/// The planes without a partner; `common` counts their beams with the other map's planes.
std::vector<UnpairedPlane> unpaired(const Snapshot& map, const Snapshot& other, const std::vector<bool>& isPaired,
                                    const std::vector<std::int64_t>& counts, const CommonBeams& common, bool isFirst)
{
    std::vector<UnpairedPlane> planes(map.planes.size());
    for (std::size_t place = 0; place < planes.size(); ++place)
        planes[place].plane = map.planes[place]->id;
    for (const auto& [places, beams] : common) {
        const auto [own, others] = isFirst ? places : std::pair{places.second, places.first};
        const double share = static_cast<double>(beams) / static_cast<double>(counts[own]);
        if (share > planes[own].share)
            planes[own] = {planes[own].plane, other.planes[others]->id, share};
    }
    std::vector<UnpairedPlane> left;
    for (std::size_t place = 0; place < planes.size(); ++place) {
        if (!isPaired[place])
            left.push_back(planes[place]);
    }
    return left;
}

}  // namespace

MapComparison compareMaps(const Snapshot& a, const Snapshot& b, const MapMatchLimits& limits)
{
    const std::vector<SeenBeams> beamsA = beamsOf(a);
    const std::vector<SeenBeams> beamsB = beamsOf(b);
    const std::vector<std::int64_t> countsA = beamsPerPlane(beamsA, a.planes.size());
    const std::vector<std::int64_t> countsB = beamsPerPlane(beamsB, b.planes.size());
    const CommonBeams common = commonBeams(beamsA, beamsB);

    std::vector<Candidate> candidates;
    for (const auto& [places, beams] : common) {
        const auto [placeA, placeB] = places;
        const std::int64_t all = countsA[placeA] + countsB[placeB] - beams;
        const Candidate candidate{static_cast<double>(beams) / static_cast<double>(all),
                                  differenceOf(comparedPlane(*a.planes[placeA]), comparedPlane(*b.planes[placeB])),
                                  placeA, placeB};
        if (candidate.overlap >= limits.overlap && candidate.difference.angle <= limits.apart.angle &&
            candidate.difference.distance <= limits.apart.distance)
            candidates.push_back(candidate);
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
        return std::tuple{-x.overlap, x.difference.angle, x.a, x.b} <
               std::tuple{-y.overlap, y.difference.angle, y.a, y.b};
    });

    MapComparison comparison;
    std::vector<bool> isPairedA(a.planes.size());
    std::vector<bool> isPairedB(b.planes.size());
    std::vector<PlaneDifference> differences;
    for (const Candidate& candidate : candidates) {
        if (isPairedA[candidate.a] || isPairedB[candidate.b])
            continue;
        isPairedA[candidate.a] = true;
        isPairedB[candidate.b] = true;
        comparison.pairs.push_back(
            {a.planes[candidate.a]->id, b.planes[candidate.b]->id, candidate.difference, candidate.overlap});
        differences.push_back(candidate.difference);
    }
    std::sort(comparison.pairs.begin(), comparison.pairs.end(),
              [](const PairedPlanes& x, const PairedPlanes& y) { return x.a < y.a; });
    comparison.errors = summarise(differences);
    comparison.onlyA = unpaired(a, b, isPairedA, countsA, common, true);
    comparison.onlyB = unpaired(b, a, isPairedB, countsB, common, false);
    return comparison;
}

}  // namespace planewright
