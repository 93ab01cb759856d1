// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/plane_extractor.h"

#include <utility>

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

PlaneExtractor::PlaneExtractor(const SensorModel& sensor, const Parameters& parameters, ExtractionOptions options)
    : sensor_(sensor), parameters_(parameters), options_(std::move(options))
{
}

std::shared_ptr<const Snapshot> PlaneExtractor::step(const ScanSlice& slice)  // Table I
{
    map_.step = slice.step;
    StepReport report;
    report.step = slice.step;
    report.tilt = slice.tilt;
    StepRecorder recorder(report, options_.clock, options_.explain);

    recorder.begin(Phase::Extract);
    const SegmentNumber first = map_.segments.append(slice.step, extractor_.extract(slice, sensor_, parameters_));
    recorder.begin(Phase::Assign);
    const auto unassigned = assignToPlanes(first, map_, parameters_, recorder);
    recorder.begin(Phase::Cluster);
    addToClusters(unassigned, map_, parameters_.clusters, recorder);

    if (parameters_.schedule.fitsPlanesAt(slice.step)) {
        recorder.begin(Phase::Fit);
        fitPlanes(map_, parameters_, recorder);
    }
    if (parameters_.schedule.splitsAndMergesAt(slice.step)) {
        recorder.begin(Phase::SplitMerge);
        splitAndMerge(recorder);
    }
    if (parameters_.schedule.fitsRemainingAt(slice.step)) {
        recorder.begin(Phase::Remaining);
        fitRemainingSegments(map_, parameters_, recorder);
    }
    recorder.end();

    report.counts.returns = extractor_.echoes();
    report.counts.segments = map_.segments.size() - first;
    report.counts.clustered = static_cast<int>(unassigned.size());
    report.counts.assigned = report.counts.segments - report.counts.clustered;
    return makeSnapshot(std::move(report));
}

std::shared_ptr<const Snapshot> PlaneExtractor::finish()
{
    StepReport report;
    report.step = -1;
    StepRecorder recorder(report, options_.clock, options_.explain);
    recorder.begin(Phase::Finish);
    fitPlanes(map_, parameters_, recorder, true);
    fitRemainingSegments(map_, parameters_, recorder);
    splitAndMerge(recorder);
    reassignSegments(map_, parameters_, recorder);
    fitRemainingSegments(map_, parameters_, recorder);
    for (GrowingPlane& plane : map_.planes)
        plane.refine(map_.segments, parameters_.planes, map_.step);
    recorder.end();
    return makeSnapshot(std::move(report));
}

void PlaneExtractor::splitAndMerge(StepRecorder& recorder)  // Table VII
{
    splitPlanes(map_, parameters_, recorder);
    mergePlanes(map_, parameters_, recorder);
    absorbPlanes(map_, parameters_, recorder);
}

std::shared_ptr<const Snapshot> PlaneExtractor::makeSnapshot(StepReport report)
{
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->segments = map_.segments.log();
    double error = 0.0;
    int fitted = 0;
    for (GrowingPlane& plane : map_.planes) {
        snapshot->planes.push_back(plane.publish(map_.segments));
        error += plane.error();
        fitted += static_cast<int>(plane.members().size());
    }
    for (GrowingCluster& cluster : map_.clusters.all())
        snapshot->clusters.push_back(published(cluster, map_.segments));

    report.counts.fitted = fitted;
    report.counts.unfitted = map_.segments.size() - fitted;
    report.counts.clusters = static_cast<int>(snapshot->clusters.size());
    report.counts.planes = static_cast<int>(snapshot->planes.size());
    report.counts.meanError = map_.planes.empty() ? 0.0 : error / static_cast<double>(map_.planes.size());
    snapshot->report = std::move(report);
    return snapshot;
}

}  // namespace planewright
