// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"
#include "core/types/angle.h"
#include "core/types/square.h"

namespace planewright {

namespace {

using Part = std::vector<SegmentNumber>;

/// A part of fewer segments has no plane of its own to be compared.
constexpr std::size_t kSegmentsOfPart = 3;

/// Which members of a plane hang together, by the place of another one of the same part.
class Joined {
public:
    explicit Joined(std::size_t count) : next_(count) { std::iota(next_.begin(), next_.end(), std::size_t{0}); }

    std::size_t root(std::size_t member)
    {
        while (next_[member] != member)
            member = next_[member] = next_[next_[member]];
        return member;
    }
    void join(std::size_t a, std::size_t b) { next_[root(a)] = root(b); }

private:
    std::vector<std::size_t> next_;
};

/// The parts of a plane that lie apart from each other: farther than planes that are side by side, so that a gap in
/// what was seen of a surface makes no two of it. Those of few points come first.
std::vector<Part> partsOf(const PlaneTrack& plane, const TrackMap& map)
{
    Joined joined(plane.members.size());
    for (std::size_t i = 0; i < plane.members.size(); ++i) {
        const SegmentNumber number = plane.members[i];
        const int place = map.segment(number).slice;
        for (int other = std::max(0, place - 2 * map.lookback(place)); other <= place; ++other) {
            map.visitOverlaps(other, map.beams(number), kSideMargin, [&](SegmentNumber s) {
                if (s >= number || map.segment(s).owner != plane.id)
                    return;
                const auto found = std::lower_bound(plane.members.begin(), plane.members.end(), s);
                joined.join(i, static_cast<std::size_t>(found - plane.members.begin()));
            });
        }
    }
    std::vector<Part> parts(plane.members.size());
    for (std::size_t i = 0; i < plane.members.size(); ++i)
        parts[joined.root(i)].push_back(plane.members[i]);
    std::erase_if(parts, [](const Part& part) { return part.empty(); });
    const auto pointsOf = [&](const Part& part) {
        return std::accumulate(part.begin(), part.end(), 0, [&](int sum, SegmentNumber number) {
            return sum + map.segment(number).statistics.points;
        });
    };
    std::stable_sort(parts.begin(), parts.end(),
                     [&](const Part& a, const Part& b) { return pointsOf(a) < pointsOf(b); });
    return parts;
}

/// Some members of a plane as a plane of their own; none where they do not determine one.
std::optional<PlaneTrack> trackOf(const PlaneTrack& plane, Part members, TrackMap& map, const Parameters& parameters)
{
    PlaneTrack track = plane;
    track.members = std::move(members);
    if (track.members.size() < kSegmentsOfPart || !map.rebuild(track, parameters))
        return std::nullopt;
    return track;
}

/// The largest χ² at which two planes are rather one than another that lies there by chance, where so many do
/// (likelihood.chance-planes): p(one) = exp(-χ² / 2) / ((2π)^1.5 √|S|) by their covariance S.
double chanceGate(double determinant, double chancePlanes)
{
    const double density = chancePlanes / square(degrees(1.0));  // [1/(rad² m)]
    return -2.0 * std::log(std::pow(2.0 * std::numbers::pi, 1.5) * density) - std::log(determinant);
}

/// Whether a part of a plane and its other segments are two planes; none where either has too few segments.
std::optional<Test> apartTest(const PlaneTrack& plane, const PlaneTrack& part, TrackMap& map,
                              const Parameters& parameters, double chancePlanes)
{
    Part others;
    std::ranges::set_difference(plane.members, part.members, std::back_inserter(others));
    const std::optional<PlaneTrack> rest = trackOf(plane, std::move(others), map, parameters);
    if (!rest)
        return std::nullopt;
    const double floor = 0.5 * parameters.flatnessFloor();
    const PlaneDisparity disparity =
        part.estimate.disparity(rest->estimate, floor, 1.0, scatterOf(part), scatterOf(*rest));
    const double gate =
        chancePlanes > 0.0 ? chanceGate(disparity.determinant, chancePlanes) : parameters.likelihood.mergeGate;
    return Test{"parts_chi2", disparity.chi, Comparison::Greater, std::min(gate, parameters.likelihood.mergeGate)};
}

void splitParts(TrackMap& map, const Parameters& parameters, double chancePlanes, StepRecorder& recorder)
{
    const int step = map.slice(map.slices() - 1).step;
    const std::size_t planes = map.planes().size();  // those that are made on the way are parts
    for (std::size_t i = 0; i < planes; ++i) {
        const PlaneId id = map.planes()[i].id;
        const std::vector<Part> parts = partsOf(map.planes()[i], map);
        for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
            const std::optional<PlaneTrack> part = trackOf(map.plane(id), parts[k], map, parameters);
            const std::optional<Test> apart =
                part ? apartTest(map.plane(id), *part, map, parameters, chancePlanes) : std::nullopt;
            if (!apart || !apart->pass())
                continue;
            PlaneTrack* own = map.makePlane(parts[k], part->estimate, step, parameters);
            if (own == nullptr)
                continue;
            own->lineage = {Lineage::Kind::Split, {id}};
            recorder.decide(DecisionKind::Split, {PlaneRef{id}}, {*apart}, {PlaneRef{id}, PlaneRef{own->id}});
            ++recorder.counts().splits;
            for (PlaneTrack* rest : map.collectMembers(std::vector{id}, step))
                map.rebuild(*rest, parameters);
        }
    }
}

}  // namespace

void splitParts(TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    splitParts(map, parameters, 0.0, recorder);
    // What chance decides comes second: planes keep the numbers that they have without it.
    if (parameters.likelihood.chancePlanes > 0.0)
        splitParts(map, parameters, parameters.likelihood.chancePlanes, recorder);
}

}  // namespace planewright
