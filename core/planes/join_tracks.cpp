// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/planes/parallel_planes.h"
#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"

namespace planewright {

namespace {

/// Slices after which a plane that met no segment is out of sight.
constexpr int kSightSlices = 8;
/// χ² (2 degrees of freedom) up to which a plane counts as parallel to another: 99 %.
constexpr double kSameDirection = 9.2;
/// A χ² so small that no other plane needs to be looked at.
constexpr double kCertain = 4.0;

struct JoinCandidate {
    PlaneTrack* plane = nullptr;
    double chi = 0.0;
    double gate = 0.0;
};

void consider(PlaneTrack& plane, SegmentNumber number, TrackMap& map, const Parameters& parameters, double floor,
              double gate, JoinCandidate& best)
{
    if (best.plane == &plane || map.holds(plane, map.segment(number).left))
        return;
    const double limit = best.plane == nullptr ? gate : std::min(gate, best.chi);
    const double chi = map.joinChi(plane, number, parameters.noise, floor, limit);
    if (chi < gate && (best.plane == nullptr || chi < best.chi))
        best = {&plane, chi, gate};
}

/// The plane that a segment fits best among those of the segments it faces in the slices from `from` to `to`.
void considerNeighbours(SegmentNumber number, int from, int to, TrackMap& map, const Parameters& parameters,
                        JoinCandidate& best)
{
    const BeamSpan beams = map.beams(number);
    const int step = to < from ? -1 : 1;
    for (int place = from; place != to + step; place += step) {
        map.visitOverlaps(place, beams, kOverlapMargin, [&](SegmentNumber other) {
            const PlaneId owner = map.segment(other).owner;
            if (owner != kNoPlane)
                consider(map.plane(owner), number, map, parameters, parameters.flatnessFloor(),
                         parameters.likelihood.joinGate, best);
        });
        if (best.plane != nullptr && best.chi < kCertain)
            return;
    }
}

/// How many slices a place is away from the nearest slice in which a plane has a segment.
int slicesAway(const PlaneTrack& plane, int place, const TrackMap& map)
{
    const auto next =
        std::lower_bound(plane.members.begin(), plane.members.end(), place,
                         [&](SegmentNumber number, int wanted) { return map.segment(number).slice < wanted; });
    int away = std::numeric_limits<int>::max();
    if (next != plane.members.end())
        away = map.segment(*next).slice - place;
    if (next != plane.members.begin())
        away = std::min(away, place - map.segment(*(next - 1)).slice);
    return away;
}

bool isInSight(const PlaneTrack& plane, int place, const TrackMap& map)
{
    return slicesAway(plane, place, map) <= kSightSlices;
}

/// Whether a plane with a segment besides would be parallel to a plane that is known.
bool turnsParallel(PlaneTrack& plane, SegmentNumber number, TrackMap& map, const Parameters& parameters)
{
    PlaneEstimate joined = plane.estimate;
    const SegmentStatistics* const one = &map.segment(number).statistics;
    joined.accumulate(map.seenIn(plane, map.segment(number).slice), std::span{&one, 1}, parameters.noise,
                      parameters.noise.systematic, 1.0);
    return joined.solve() && parallelChi(joined, map, kSurelyParallel, kSurelyParallel, plane.id) < kSameDirection;
}

/// Whether a plane tells where a segment that it does not face must be: as well as the segment itself does. Where it
/// does not, any segment fits, and it is the segment that would tell the plane's direction; then rooms must have planes
/// of that direction: the lintels of two doors are level, while the jambs of opposite doors are no plane. Where ranges
/// err together, variances do not tell that.
bool tellsPlaceOf(SegmentNumber number, double variance, PlaneTrack& plane, const Eigen::Vector3d& centroid,
                  TrackMap& map, const Parameters& parameters)
{
    return parameters.noise.systematic > 0.0 || plane.estimate.varianceAt(centroid) < variance ||
           turnsParallel(plane, number, map, parameters);
}

/// A plane that is known well and was seen lately may be joined without facing it: across a door, behind a pillar.
void considerKnown(SegmentNumber number, TrackMap& map, const Parameters& parameters, JoinCandidate& best)
{
    const int place = map.segment(number).slice;
    const double known = parameters.likelihood.knownAngle * parameters.likelihood.knownAngle;
    const double gate = parameters.likelihood.apartGate;
    const double floor = 0.5 * parameters.flatnessFloor();
    const Eigen::Vector3d centroid = map.centroid(number);
    const double variance = mostVariance(map.segment(number).statistics, centroid, parameters.noise, floor);
    for (PlaneTrack& plane : map.planes()) {
        if (!map.holds(plane, map.segment(number).left) && plane.estimate.normalVariance() < known &&
            plane.estimate.mayMeet(centroid, variance, gate) && isInSight(plane, place, map)) {
            JoinCandidate better = best;
            consider(plane, number, map, parameters, floor, gate, better);
            if (better.plane != best.plane && tellsPlaceOf(number, variance, plane, centroid, map, parameters))
                best = better;
        }
    }
}

/// The plane of the segments around one that it fits best.
JoinCandidate bestFacing(SegmentNumber number, TrackMap& map, const Parameters& parameters)
{
    const int place = map.segment(number).slice;
    JoinCandidate best;
    considerNeighbours(number, place, place - map.lookback(place), map, parameters, best);
    if (place + 1 < map.slices())
        considerNeighbours(number, place + 1, place + map.lookahead(place), map, parameters, best);
    return best;
}

/// Whether a segment faces one of a plane in the slices around it.
bool faces(SegmentNumber number, PlaneId plane, const TrackMap& map)
{
    const int place = map.segment(number).slice;
    bool found = false;
    for (int other = place - map.lookback(place); other <= place + map.lookahead(place) && !found; ++other)
        map.visitOverlaps(other, map.beams(number), kOverlapMargin, [&](SegmentNumber facing) {
            found = found || (facing != number && map.segment(facing).owner == plane);
        });
    return found;
}

void explain(SegmentNumber number, const JoinCandidate& best, const TrackMap& map, StepRecorder& recorder)
{
    if (!recorder.explains())
        return;
    if (best.plane == nullptr)
        recorder.decide(DecisionKind::Reject, {idOf(number, map)}, {});
    else
        recorder.decide(DecisionKind::Assign, {idOf(number, map), PlaneRef{best.plane->id}},
                        {{"join_chi2", best.chi, Comparison::Less, best.gate}}, {PlaneRef{best.plane->id}});
}

/// Whether a segment in reach of a plane fits it, and better than another does.
void askFit(SegmentNumber number, PlaneTrack& plane, double floor, double gate, const JoinCandidate& rival,
            TrackMap& map, const Parameters& parameters, std::vector<Test>& tests)
{
    tests.push_back(
        {"steepness", map.seenIn(plane, map.segment(number).slice).steepness, Comparison::Greater, kLeastSteepness});
    if (!tests.back().pass())
        return;
    const double chi = map.joinChi(plane, number, parameters.noise, floor);
    tests.push_back({"join_chi2", chi, Comparison::Less, gate});
    if (rival.plane != nullptr && rival.plane != &plane)
        tests.push_back({"rival_chi2", chi, Comparison::Less, rival.chi});
}

}  // namespace

std::vector<Conditions> waysIntoTrack(SegmentNumber number, PlaneTrack& plane, TrackMap& map,
                                      const Parameters& parameters)
{
    TrackedSegment& segment = map.segment(number);
    // Planes that did not fit it before are asked again.
    const std::int64_t left = std::exchange(segment.left, -1);
    const JoinCandidate facing = bestFacing(number, map, parameters);
    JoinCandidate known;
    considerKnown(number, map, parameters, known);
    segment.left = left;

    std::vector<Conditions> ways{{"join_facing", {}}, {"join_known", {}}};
    const bool isElsewhere = segment.owner != kNoPlane && segment.owner != plane.id;
    if (isElsewhere) {
        for (Conditions& way : ways)
            way.tests.push_back({"in_other_plane", 1.0, Comparison::LessEqual, 0.0});
    }
    const double floor = parameters.flatnessFloor();
    std::vector<Test>& nearby = ways[0].tests;
    nearby.push_back({"facing", faces(number, plane.id, map) ? 1.0 : 0.0, Comparison::GreaterEqual, 1.0});
    if (facing.plane != nullptr && facing.plane != &plane && facing.chi < kCertain)
        nearby.push_back({"certain_elsewhere", facing.chi, Comparison::GreaterEqual, kCertain});
    askFit(number, plane, floor, parameters.likelihood.joinGate, facing, map, parameters, nearby);

    const double knownAngle = parameters.likelihood.knownAngle;
    std::vector<Test>& afar = ways[1].tests;
    afar.push_back({"fits_facing_plane", facing.plane != nullptr ? 1.0 : 0.0, Comparison::LessEqual, 0.0});
    afar.push_back({"normal_variance", plane.estimate.normalVariance(), Comparison::Less, knownAngle * knownAngle});
    afar.push_back({"slices_away", static_cast<double>(slicesAway(plane, segment.slice, map)), Comparison::LessEqual,
                    static_cast<double>(kSightSlices)});
    const Eigen::Vector3d centroid = map.centroid(number);
    const double variance = mostVariance(segment.statistics, centroid, parameters.noise, 0.5 * floor);
    const Test placed{"place_sigma", std::sqrt(plane.estimate.varianceAt(centroid)), Comparison::Less,
                      std::sqrt(variance)};
    if (parameters.noise.systematic <= 0.0 && (placed.pass() || !turnsParallel(plane, number, map, parameters)))
        afar.push_back(placed);
    askFit(number, plane, 0.5 * floor, parameters.likelihood.apartGate, known, map, parameters, afar);
    if (isElsewhere)
        ways.push_back(wayToMove(number, plane, map, parameters));
    return ways;
}

const std::vector<SegmentNumber>& joinTracks(TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    const int place = map.slices() - 1;
    const int back = map.lookback(place);
    const TrackedSlice& slice = map.slice(place);
    auto& [joined, together, left] = map.joining;
    joined.clear();
    left.clear();
    for (SegmentNumber number = slice.first; number < slice.end; ++number) {
        JoinCandidate best;
        if (place > 0)
            considerNeighbours(number, place - 1, place - back, map, parameters, best);
        if (best.plane == nullptr)
            considerKnown(number, map, parameters, best);
        explain(number, best, map, recorder);
        if (best.plane == nullptr)
            left.push_back(number);
        else
            joined.emplace_back(best.plane->id, number);
    }
    // The segments of a plane join it together: they share the slice's pitch error.
    std::sort(joined.begin(), joined.end());
    for (auto next = joined.cbegin(); next != joined.cend();) {
        const PlaneId id = next->first;
        together.clear();
        for (; next != joined.cend() && next->first == id; ++next)
            together.push_back(next->second);
        map.join(map.plane(id), together, slice.step, parameters);
    }
    return left;
}

void joinRemaining(TrackMap& map, int firstSlice, const Parameters& parameters, StepRecorder& recorder)
{
    const int step = map.slice(map.slices() - 1).step;
    for (int place = std::max(0, firstSlice); place < map.slices(); ++place) {
        const TrackedSlice& slice = map.slice(place);
        for (SegmentNumber number = slice.first; number < slice.end; ++number) {
            if (map.segment(number).owner != kNoPlane)
                continue;
            JoinCandidate best = bestFacing(number, map, parameters);
            if (best.plane == nullptr)
                considerKnown(number, map, parameters, best);
            if (best.plane == nullptr) {
                map.segment(number).left = map.moment();
                continue;
            }
            explain(number, best, map, recorder);
            map.join(*best.plane, std::span{&number, 1}, step, parameters);
        }
    }
}

}  // namespace planewright
