// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/fit_planes.h"

#include <algorithm>

#include "core/planes/plane_search.h"

namespace planewright {

namespace {

/// N_c: whether a cluster is large enough to be searched, in segments and in slices.
std::vector<Test> searchTests(const GrowingCluster& cluster, const SegmentTable& table,
                              const PlaneParameters& parameters)
{
    std::vector<int> steps;
    for (const auto& member : cluster.members)
        steps.push_back(table[member.segment].id.step);
    std::sort(steps.begin(), steps.end());
    const auto slices = std::unique(steps.begin(), steps.end()) - steps.begin();
    return {{"cluster_segments", static_cast<double>(cluster.members.size()), Comparison::GreaterEqual,
             static_cast<double>(parameters.minClusterSegments)},
            {"cluster_slices", static_cast<double>(slices), Comparison::GreaterEqual,
             static_cast<double>(parameters.minClusterSlices)}};
}

void explainFailures(const GrowingCluster& cluster, const PlaneMap& map, std::vector<FailedHypothesis> failures,
                     StepRecorder& recorder)
{
    for (FailedHypothesis& failure : failures)
        recorder.decide(DecisionKind::NoFit, {ClusterRef{cluster.id}, map.segments[failure.seed].id},
                        std::move(failure.tests));
}

/// Searches one cluster until it gives no more planes.
void searchCluster(GrowingCluster& cluster, PlaneMap& map, const PlaneParameters& parameters, StepRecorder& recorder)
{
    const auto tests = searchTests(cluster, map.segments, parameters);
    if (!std::all_of(tests.begin(), tests.end(), [](const Test& test) { return test.pass(); })) {
        recorder.decide(DecisionKind::NoFit, {ClusterRef{cluster.id}}, tests);
        return;
    }
    while (true) {
        std::vector<Candidate> candidates;
        for (const auto& member : cluster.members) {
            if (map.segments.owner(member.segment) == kNoPlane)
                candidates.push_back({member.segment, !member.searched});
        }
        std::vector<FailedHypothesis> failures;
        auto found = findPlane(candidates, map.segments, parameters, recorder.explains() ? &failures : nullptr);
        explainFailures(cluster, map, std::move(failures), recorder);
        if (!found)
            break;
        const GrowingPlane& plane = map.makePlane(found->fit, std::move(found->members), parameters);
        if (recorder.explains())
            recorder.decide(DecisionKind::Fit, {ClusterRef{cluster.id}}, std::move(found->tests),
                            {PlaneRef{plane.id()}});
    }
    for (auto& member : cluster.members)
        member.searched = true;
}

}  // namespace

void fitPlanes(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder, bool everySegment)
{
    for (GrowingCluster& cluster : map.clusters.all()) {
        if (everySegment) {
            for (auto& member : cluster.members)
                member.searched = false;
        }
        const bool anyNew = std::any_of(cluster.members.begin(), cluster.members.end(),
                                        [](const auto& member) { return !member.searched; });
        if (anyNew)
            searchCluster(cluster, map, parameters.planes, recorder);
    }
    map.removeOwnedFromClusters();
}

}  // namespace planewright
