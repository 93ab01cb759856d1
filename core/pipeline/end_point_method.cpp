// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/end_point_method.h"

#include <algorithm>
#include <utility>

#include "core/pipeline/find_segment.h"
#include "core/planes/assign_to_planes.h"
#include "core/planes/fit_planes.h"
#include "core/planes/fit_remaining_segments.h"
#include "core/planes/reassign_segments.h"
#include "core/planes/split_and_merge.h"

namespace planewright {

namespace {

std::shared_ptr<const DirectionCluster> published(GrowingCluster& cluster, const SegmentTable& table)
{
    if (!cluster.published) {
        auto shown = std::make_shared<DirectionCluster>();
        shown->id = cluster.id;
        shown->direction = cluster.direction;
        shown->segments.reserve(cluster.members.size());
        for (const auto& member : cluster.members)
            shown->segments.push_back(table[member.segment].id);
        cluster.published = std::move(shown);
    }
    return cluster.published;
}

}  // namespace

int EndPointMethod::extractLineSegments(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters,
                                        StepRecorder& recorder)
{
    map_.step = slice.step;
    trace_.clear();
    SliceTrace* const trace = recorder.explains() ? &trace_ : nullptr;
    first_ = map_.segments.append(slice.step, extractor_.extract(slice, sensor, parameters, trace));
    tellDiscarded(trace_, slice.step, recorder);
    return extractor_.echoes();
}

void EndPointMethod::assignToPlanes(const Parameters& parameters, StepRecorder& recorder)
{
    unassigned_ = planewright::assignToPlanes(first_, map_, parameters, recorder);
}

void EndPointMethod::addToClusters(const Parameters& parameters, StepRecorder& recorder)
{
    planewright::addToClusters(unassigned_, map_, parameters.clusters, recorder);
}

void EndPointMethod::fitPlanes(const Parameters& parameters, StepRecorder& recorder)
{
    planewright::fitPlanes(map_, parameters, recorder);
}

void EndPointMethod::splitAndMerge(const Parameters& parameters, StepRecorder& recorder)  // Table VII
{
    splitPlanes(map_, parameters, recorder);
    mergePlanes(map_, parameters, recorder);
    absorbPlanes(map_, parameters, recorder);
}

void EndPointMethod::fitRemainingSegments(const Parameters& parameters, StepRecorder& recorder)
{
    planewright::fitRemainingSegments(map_, parameters, recorder);
}

void EndPointMethod::finish(const Parameters& parameters, StepRecorder& recorder)
{
    map_.comparedStep = -1;
    recorder.begin(Phase::Finish, "fit");
    planewright::fitPlanes(map_, parameters, recorder, true);
    recorder.begin(Phase::Finish, "remaining");
    planewright::fitRemainingSegments(map_, parameters, recorder, true);
    recorder.begin(Phase::Finish, "split_merge");
    splitAndMerge(parameters, recorder);
    recorder.begin(Phase::Finish, "reassign");
    reassignSegments(map_, parameters, recorder);
    recorder.begin(Phase::Finish, "remaining");
    planewright::fitRemainingSegments(map_, parameters, recorder, true);
    recorder.begin(Phase::Finish, "refine");
    for (GrowingPlane& plane : map_.planes)
        plane.refineIfChanged(map_.segments, parameters.planes, map_.step);
}

void EndPointMethod::parametersChanged()
{
    map_.comparedStep = -1;
    for (GrowingCluster& cluster : map_.clusters.all()) {
        for (auto& member : cluster.members)
            member.triedStep = -1;
    }
}

std::vector<Conditions> EndPointMethod::waysOfMerging(PlaneId a, PlaneId b, const Parameters& parameters)
{
    const GrowingPlane& first = map_.plane(a);
    const GrowingPlane& second = map_.plane(b);
    return {mergeConditions(first, second, map_.segments, parameters),
            absorbConditions(first, second, map_, parameters)};
}

std::vector<Conditions> EndPointMethod::waysOfJoining(const SegmentId& segment, PlaneId plane,
                                                      const Parameters& parameters)
{
    return waysIntoPlane(numberOf(segment), map_.plane(plane), map_, parameters);
}

/// The running number of a segment; −1 where it is not there.
SegmentNumber EndPointMethod::numberOf(const SegmentId& segment) const
{
    return findSegment(segment, map_.segments.size(),
                       [this](SegmentNumber number) { return map_.segments[number].id; });
}

std::optional<PlaneId> EndPointMethod::ownerOf(const SegmentId& segment) const
{
    const SegmentNumber number = numberOf(segment);
    if (number < 0)
        return std::nullopt;
    return map_.segments.owner(number);
}

bool EndPointMethod::hasPlane(PlaneId plane) const
{
    return std::any_of(map_.planes.begin(), map_.planes.end(), [&](const auto& other) { return other.id() == plane; });
}

void EndPointMethod::count(StepCounts& counts) const
{
    double error = 0.0;
    int fitted = 0;
    for (const GrowingPlane& plane : map_.planes) {
        error += plane.error();
        fitted += static_cast<int>(plane.members().size());
    }
    counts.segments = map_.segments.size() - first_;
    counts.clustered = static_cast<int>(unassigned_.size());
    counts.assigned = counts.segments - counts.clustered;
    counts.fitted = fitted;
    counts.unfitted = map_.segments.size() - fitted;
    counts.clusters = static_cast<int>(map_.clusters.all().size());
    counts.planes = static_cast<int>(map_.planes.size());
    counts.meanError = map_.planes.empty() ? 0.0 : error / static_cast<double>(map_.planes.size());
}

void EndPointMethod::publish(Snapshot& snapshot)
{
    snapshot.segments = map_.segments.log();
    snapshot.planes.reserve(map_.planes.size());
    for (GrowingPlane& plane : map_.planes)
        snapshot.planes.push_back(plane.publish(map_.segments));
    for (GrowingCluster& cluster : map_.clusters.all())
        snapshot.clusters.push_back(published(cluster, map_.segments));
}

}  // namespace planewright
