// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"

namespace planewright {

namespace {

/// Slices after which a plane that met no segment is out of sight.
constexpr int kSightSlices = 8;
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

/// Whether a plane has a segment in one of the slices about a place.
bool isInSight(const PlaneTrack& plane, int place, const TrackMap& map)
{
    const auto next =
        std::lower_bound(plane.members.begin(), plane.members.end(), place - kSightSlices,
                         [&](SegmentNumber number, int wanted) { return map.segment(number).slice < wanted; });
    return next != plane.members.end() && map.segment(*next).slice <= place + kSightSlices;
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
            plane.estimate.mayMeet(centroid, variance, gate) && isInSight(plane, place, map))
            consider(plane, number, map, parameters, floor, gate, best);
    }
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

}  // namespace

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
            JoinCandidate best;
            considerNeighbours(number, place, place - map.lookback(place), map, parameters, best);
            if (place + 1 < map.slices())
                considerNeighbours(number, place + 1, place + map.lookahead(place), map, parameters, best);
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
