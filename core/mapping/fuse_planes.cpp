// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/fuse_planes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/mapping/map_changes.h"
#include "core/mapping/match_jointly.h"

namespace planewright {

namespace {

constexpr double kFits = 7.815;       // χ² of 3 degrees of freedom: 95 %
constexpr double kTellsApart = 0.02;  // standard deviation of the distance between two planes [m]
constexpr double kSlack = 0.05;       // of outlines, for what is left of the poses' errors [m]

/// A plane of the map, or one of a stop that is none yet.
struct Candidate {
    std::optional<std::size_t> plane;
    std::vector<Sighting> sightings;
    UncertainPlane parameters;
};

enum class Likeness { Differs, MayBeOne, IsOne };

class PlaneFuser {
public:
    PlaneFuser(BuildingMap& map, std::span<const StopExtents> extents, const StopsAround& around, double gap)
        : map_(map), extents_(extents), around_(around), gap_(gap + kSlack)
    {
    }

    int fuse()
    {
        int decided = 0;
        for (std::size_t number = 0; number < map_.planes.size(); ++number) {
            while (!map_.planes[number].sightings.empty() && !isByHand(map_, number) && fusePlane(number))
                ++decided;
        }
        for (std::size_t stop = 0; stop < map_.stops.size(); ++stop) {
            if (!map_.stops[stop].isPlaced())
                continue;
            for (std::size_t plane = 0; plane < map_.stops[stop].matches.size(); ++plane) {
                if (map_.stops[stop].matches[plane].state == MatchState::Open)
                    decided += settle({stop, plane}) ? 1 : 0;
            }
        }
        return decided;
    }

private:
    Candidate candidateOf(std::size_t plane) const
    {
        return {plane, map_.planes[plane].sightings, map_.planes[plane].parameters};
    }

    Candidate candidateOf(const Sighting& sighting) const
    {
        const MapStop& stop = map_.stops[sighting.stop];
        return {
            std::nullopt, {sighting}, inMap(stop.stop->planes[sighting.plane].parameters, stop.pose, stop.covariance)};
    }

    /// Merges a plane with one of a higher number, where that is the only one that fits.
    bool fusePlane(std::size_t number)
    {
        const auto other = onlyFit(candidateOf(number));
        if (!other || *other <= number || isByHand(map_, *other))
            return false;
        // It must be the only one from there, too.
        if (onlyFit(candidateOf(*other)) != number)
            return false;
        mergePlanes(map_, number, *other);
        markMatched(number);
        return true;
    }

    /// Decides what an open plane of a stop is.
    bool settle(const Sighting& sighting)
    {
        bool mayFit = false;
        const auto plane = onlyFit(candidateOf(sighting), &mayFit);
        MapMatch& match = map_.stops[sighting.stop].matches[sighting.plane];
        if (plane) {
            match = {MatchState::Matched, *plane, {}, chiSquareOf(map_, sighting, *plane)};
            addSighting(map_, *plane, sighting);
        } else if (!mayFit) {
            match = {MatchState::New, addPlane(map_, sighting), {}, 0.0};
        } else {
            return false;
        }
        return true;
    }

    /// The plane of the map that a candidate is, where no other may be it.
    std::optional<std::size_t> onlyFit(const Candidate& candidate, bool* mayFit = nullptr) const
    {
        std::optional<std::size_t> fit;
        bool isAlone = true;
        for (const std::size_t plane : planesAround(candidate)) {
            const Likeness likeness = compare(candidate, candidateOf(plane));
            if (likeness == Likeness::Differs)
                continue;
            isAlone = isAlone && !fit && likeness == Likeness::IsOne;
            fit = plane;
        }
        if (mayFit != nullptr)
            *mayFit = fit.has_value();
        return isAlone ? fit : std::nullopt;
    }

    std::set<std::size_t> planesAround(const Candidate& candidate) const
    {
        std::set<std::size_t> planes;
        for (const Sighting& sighting : candidate.sightings) {
            for (const std::size_t stop : around_(sighting.stop)) {
                for (const MapMatch& match : map_.stops[stop].matches) {
                    if (match.plane && match.plane != candidate.plane)
                        planes.insert(*match.plane);
                }
            }
        }
        return planes;
    }

    Likeness compare(const Candidate& a, const Candidate& b) const
    {
        if (a.parameters.normal.dot(b.parameters.normal) <= 0.0)
            return Likeness::Differs;
        const Sighting& first = a.sightings.front();
        const MapStop& stop = map_.stops[first.stop];
        const Eigen::Vector3d place = stop.pose * middleOf(stop.stop->planes[first.plane]);
        const UncertainPlane one = seenFrom(a.parameters, place);
        const UncertainPlane other = seenFrom(b.parameters, place);
        const double chi = chiSquare(one, other);
        if (chi > MatchLimits{}.gate || !isMeeting(a, b, gap_) || isSeenApart(a, b))
            return Likeness::Differs;
        const bool tells = std::sqrt(one.covariance(2, 2) + other.covariance(2, 2)) < kTellsApart;
        return chi < kFits && tells ? Likeness::IsOne : Likeness::MayBeOne;
    }

    /// True where the places meet in which two planes were seen, both laid on the first.
    bool isMeeting(const Candidate& a, const Candidate& b, double gap) const
    {
        const PlaneFrame frame(a.parameters.normal, a.parameters.distance, Eigen::Vector3d::UnitZ());
        return meet(ringsOf(a, frame), ringsOf(b, frame), gap);
    }

    std::vector<PlanarRing> ringsOf(const Candidate& candidate, const PlaneFrame& frame) const
    {
        std::vector<PlanarRing> rings;
        for (const Sighting& sighting : candidate.sightings) {
            for (PlanarRing& ring :
                 onPlane(extents_[sighting.stop][sighting.plane], map_.stops[sighting.stop].pose, frame))
                rings.push_back(std::move(ring));
        }
        return rings;
    }

    /// True where one stop saw two planes of its own: they overlap there, or differ by the numbers of one scan.
    bool isSeenApart(const Candidate& a, const Candidate& b) const
    {
        for (const Sighting& one : a.sightings) {
            for (const Sighting& other : b.sightings) {
                if (one.stop != other.stop)
                    continue;
                const auto& planes = map_.stops[one.stop].stop->planes;
                const Eigen::Vector3d middle = middleOf(planes[one.plane]);
                const UncertainPlane first = seenFrom(planes[one.plane].parameters, middle);
                const UncertainPlane second = seenFrom(planes[other.plane].parameters, middle);
                if (chiSquare(first, second) > kFits || isMeeting(candidateOf(one), candidateOf(other), 0.0))
                    return true;
            }
        }
        return false;
    }

    /// All sightings but the first of a merged plane are matches.
    void markMatched(std::size_t plane)
    {
        const std::vector<Sighting>& sightings = map_.planes[plane].sightings;
        for (std::size_t i = 1; i < sightings.size(); ++i)
            map_.stops[sightings[i].stop].matches[sightings[i].plane].state = MatchState::Matched;
    }

    BuildingMap& map_;
    std::span<const StopExtents> extents_;
    const StopsAround& around_;
    double gap_;
};

}  // namespace

int fusePlanes(BuildingMap& map, std::span<const StopExtents> extents, const StopsAround& around, double gap)
{
    return PlaneFuser(map, extents, around, gap).fuse();
}

}  // namespace planewright
