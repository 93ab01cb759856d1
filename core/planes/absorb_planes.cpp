// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <optional>

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
                  const Parameters& parameters)
{
    const auto total = static_cast<double>(plane.members().size());
    const double allowed = (1.0 - parameters.planes.mergeShare) * total;
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

/// The larger plane that covers most of a plane, if any covers enough.
std::optional<std::size_t> coverOf(std::size_t place, const PlaneMap& map, const Parameters& parameters,
                                   std::vector<Test>& tests)
{
    const GrowingPlane& plane = map.planes[place];
    std::optional<std::size_t> cover;
    double best = 0.0;
    for (std::size_t i = 0; i < map.planes.size(); ++i) {
        const GrowingPlane& other = map.planes[i];
        if (i == place || other.members().size() <= plane.members().size() || plane.changedStep() < map.comparedStep)
            continue;
        const double share = sharedPart(plane, other, map, parameters);
        if (share < parameters.planes.mergeShare || share <= best)
            continue;
        const double gap = inPlaneGap(plane, other, map.segments, parameters.planes.mergeGap);
        if (gap > parameters.planes.mergeGap)
            continue;
        const double contested =
            contestedShare(plane.members(), other.normal(), other.distance(), map.segments, parameters.planes);
        if (contested > parameters.planes.maxContested)
            continue;
        best = share;
        cover = i;
        tests = {{"shared_segments", share, Comparison::GreaterEqual, parameters.planes.mergeShare},
                 {"in_plane_gap", gap, Comparison::LessEqual, parameters.planes.mergeGap},
                 {"contested", contested, Comparison::LessEqual, parameters.planes.maxContested}};
    }
    return cover;
}

}  // namespace

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
