// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/grow_track.h"

#include <cmath>
#include <vector>

#include "core/planes/track_stages.h"

namespace planewright {

namespace {

/// A plane stops growing after so many slices without a segment that fits.
constexpr int kEmptySlices = 3;

/// Takes in the free segments of a slice that face the plane's in the slices `near`, and fit it.
bool growInto(PlaneTrack& plane, int place, int towards, TrackMap& map, const Parameters& parameters, int step)
{
    const TrackedSlice& slice = map.slice(place);
    const int reach = towards < 0 ? map.lookback(place) : map.lookahead(place);
    std::vector<SegmentNumber> fitting;
    for (SegmentNumber number = slice.first; number < slice.end; ++number) {
        if (map.segment(number).owner != kNoPlane)
            continue;
        bool faces = false;
        for (int near = 1; near <= reach && !faces; ++near) {
            map.visitOverlaps(place + near * towards, map.beams(number), kOverlapMargin,
                              [&](SegmentNumber facing) { faces = faces || map.segment(facing).owner == plane.id; });
        }
        const double gate = parameters.likelihood.joinGate;
        if (faces && map.joinChi(plane, number, parameters.noise, parameters.flatnessFloor(), gate) < gate)
            fitting.push_back(number);
    }
    if (fitting.empty())
        return false;
    map.join(plane, fitting, step, parameters);
    return true;
}

}  // namespace

bool growTrack(PlaneTrack& plane, TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    const int step = map.slice(map.slices() - 1).step;
    const int first = map.segment(plane.members.front()).slice;
    const int last = map.segment(plane.members.back()).slice;
    for (int place = last - 1; place > first; --place)
        growInto(plane, place, 1, map, parameters, step);
    int empty = 0;
    for (int place = first - 1; place >= 0 && empty < kEmptySlices; --place)
        empty = growInto(plane, place, 1, map, parameters, step) ? 0 : empty + 1;
    empty = 0;
    for (int place = last + 1; place < map.slices() && empty < kEmptySlices; ++place)
        empty = growInto(plane, place, -1, map, parameters, step) ? 0 : empty + 1;
    plane.estimate.solve();
    map.stamp(plane);
    map.rebuild(plane, parameters);
    return !dropGrazing(plane, map, parameters, recorder);
}

bool dropGrazing(PlaneTrack& plane, TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    const SegmentNumber middle = plane.members[plane.members.size() / 2];
    const double mean = (map.incidence(plane.members.front(), plane.estimate) + map.incidence(middle, plane.estimate) +
                         map.incidence(plane.members.back(), plane.estimate)) /
                        3.0;
    const Test met{"incidence", mean, Comparison::GreaterEqual, std::sin(parameters.planes.minIncidence)};
    if (met.pass())
        return false;
    recorder.decide(DecisionKind::NoFit, {PlaneRef{plane.id}}, {met});
    map.dissolve(plane.id);
    return true;
}

}  // namespace planewright
