// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/planes/assign_to_planes.h"
#include "core/planes/segment_run.h"
#include "core/planes/split_and_merge.h"

namespace planewright {

namespace {

bool fits(SegmentNumber segment, const GrowingPlane& plane, const PlaneMap& map, const Parameters& parameters)
{
    const LineSegment& compared = map.segments[segment];
    const double distance = fartherEnd(compared, plane);
    return distance * distance < squaredReach(compared, parameters.assignment) &&
           compareForAssignment(compared, plane, parameters.assignment).pass();
}

/// Share of a plane's segments that fit another plane, or 0 once it cannot reach the share asked for.
double sharedPart(const GrowingPlane& plane, const GrowingPlane& other, const PlaneMap& map,
                  const Parameters& parameters, double asked)
{
    const auto total = static_cast<double>(plane.members().size());
    const double allowed = (1.0 - asked) * total;
    double strangers = 0.0;
    for (const SegmentNumber segment : plane.members()) {
        if (!fits(segment, other, map, parameters)) {
            strangers += 1.0;
            if (strangers > allowed)
                return 0.0;
        }
    }
    return (total - strangers) / total;
}

bool isLarger(const GrowingPlane& other, const GrowingPlane& plane)
{
    return other.members().size() > plane.members().size();
}

/// Asks whether a plane covers another, of whose segments it shares this part, until a condition fails or all are
/// asked.
std::vector<Test> coverTests(const GrowingPlane& plane, const GrowingPlane& other, double share, const PlaneMap& map,
                             const Parameters& parameters, bool all)
{
    std::vector<Test> tests;
    const auto goesOn = [&](const Test& test) {
        tests.push_back(test);
        return all || test.pass();
    };
    if (goesOn({"shared_segments", share, Comparison::GreaterEqual, parameters.planes.mergeShare}) &&
        goesOn({"in_plane_gap", inPlaneGap(plane, other, map.segments, parameters.planes.mergeGap),
                Comparison::LessEqual, parameters.planes.mergeGap}))
        goesOn({"contested",
                contestedShare(plane.members(), other.normal(), other.distance(), map.segments, parameters.planes),
                Comparison::LessEqual, parameters.planes.maxContested});
    return tests;
}

/// The larger plane that covers most of a plane, if any covers enough.
std::optional<std::size_t> coverOf(std::size_t place, const PlaneMap& map, const Parameters& parameters,
                                   std::vector<Test>& tests)
{
    const GrowingPlane& plane = map.planes[place];
    std::optional<std::size_t> cover;
    double best = 0.0;
    for (std::size_t i = 0; i < map.planes.size(); ++i) {
        const GrowingPlane& other = map.planes[i];
        if (i == place || !isLarger(other, plane) || plane.changedStep() < map.comparedStep)
            continue;
        const double share = sharedPart(plane, other, map, parameters, parameters.planes.mergeShare);
        if (share <= best)
            continue;
        std::vector<Test> asked = coverTests(plane, other, share, map, parameters, false);
        if (!asked.back().pass())
            continue;
        best = share;
        cover = i;
        tests = std::move(asked);
    }
    return cover;
}

}  // namespace

Conditions absorbConditions(const GrowingPlane& a, const GrowingPlane& b, const PlaneMap& map,
                            const Parameters& parameters)
{
    // Of two that are as large the one that was made first is asked, in whichever order they come.
    const bool isSecond = isLarger(b, a) || (!isLarger(a, b) && b.id() < a.id());
    const GrowingPlane& larger = isSecond ? b : a;
    const GrowingPlane& plane = isSecond ? a : b;
    Conditions way{"absorb",
                   {{"segments", static_cast<double>(larger.members().size()), Comparison::Greater,
                     static_cast<double>(plane.members().size())}}};
    const double share = sharedPart(plane, larger, map, parameters, 0.0);
    const std::vector<Test> tests = coverTests(plane, larger, share, map, parameters, true);
    way.tests.insert(way.tests.end(), tests.begin(), tests.end());
    return way;
}

void absorbPlanes(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    for (std::size_t place = 0; place < map.planes.size();) {
        std::vector<Test> tests;
        const auto cover = coverOf(place, map, parameters, tests);
        if (!cover) {
            ++place;
            continue;
        }
        GrowingPlane& larger = map.planes[*cover];
        const PlaneId largerId = larger.id();
        const PlaneId smallerId = map.planes[place].id();
        std::vector<SegmentNumber> strangers;
        for (const SegmentNumber segment : map.planes[place].members()) {
            const bool belongs = fits(segment, larger, map, parameters);
            map.segments.owner(segment) = belongs ? largerId : kNoPlane;
            if (belongs)
                larger.add(segment, map.segments, parameters.planes, map.step);
            else
                strangers.push_back(segment);
        }
        larger.refine(map.segments, parameters.planes, map.step);
        larger.setLineage({Lineage::Kind::Merged, {std::min(largerId, smallerId), std::max(largerId, smallerId)}});
        ++recorder.counts().merges;
        recorder.decide(DecisionKind::Merge, {PlaneRef{largerId}, PlaneRef{smallerId}}, std::move(tests),
                        {PlaneRef{largerId}});
        map.planes.erase(map.planes.begin() + static_cast<std::ptrdiff_t>(place));
        addToClusters(strangers, map, parameters.clusters, recorder);
        place = 0;
    }
    map.comparedStep = map.step;
}

}  // namespace planewright
