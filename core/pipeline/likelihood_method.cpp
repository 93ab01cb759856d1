// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/likelihood_method.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"

namespace planewright {

namespace {

/// Slices whose leftover segments get another chance every few steps.
constexpr int kRemainingSlices = 6;

}  // namespace

int LikelihoodMethod::extractLineSegments(const ScanSlice& slice, const SensorModel& sensor,
                                          const Parameters& parameters)
{
    sensor_ = sensor;
    noise_ = parameters.noise;
    fresh_.clear();
    extractor_.extract(slice, sensor, parameters, fresh_);
    map_.append(slice, sensor, fresh_);
    return extractor_.echoes();
}

void LikelihoodMethod::assignToPlanes(const Parameters& parameters, StepRecorder& recorder)
{
    unassigned_ = joinTracks(map_, parameters, recorder);
}

void LikelihoodMethod::addToClusters(const Parameters& parameters, StepRecorder& recorder)
{
    for (const SegmentNumber number : unassigned_) {
        const auto joined = map_.clusters.add(number, directionOf(number, map_), parameters.clusters);
        if (recorder.explains())
            recorder.decide(
                DecisionKind::Cluster, {idOf(number, map_)},
                {{"similarity", joined.similarity, Comparison::Greater, std::cos(parameters.clusters.directionLimit)}},
                {ClusterRef{joined.cluster}});
    }
}

void LikelihoodMethod::fitPlanes(const Parameters& parameters, StepRecorder& recorder)
{
    seedTracks(map_, seededSlices_, parameters, recorder);
    seededSlices_ = map_.slices();
    dropOwnedFromClusters();
}

void LikelihoodMethod::splitAndMerge(const Parameters& parameters, StepRecorder& recorder)
{
    mergeTracks(map_, parameters, recorder);
}

void LikelihoodMethod::fitRemainingSegments(const Parameters& parameters, StepRecorder& recorder)
{
    joinRemaining(map_, map_.slices() - kRemainingSlices, parameters, recorder);
    dropOwnedFromClusters();
}

void LikelihoodMethod::finish(const Parameters& parameters, StepRecorder& recorder)
{
    if (map_.slices() == 0)
        return;
    mergeTracks(map_, parameters, recorder);
    splitTracks(map_, parameters, recorder);
    thinTracks(map_, parameters, recorder);
    seedTracks(map_, 0, parameters, recorder);
    joinRemaining(map_, 0, parameters, recorder);
    mergeTracks(map_, parameters, recorder);
    thinTracks(map_, parameters, recorder);
    dropUnfounded(map_, parameters, recorder);
    seedPairs(map_, parameters, recorder);
    mergeTracks(map_, parameters, recorder);
    joinRemaining(map_, 0, parameters, recorder);
    thinTracks(map_, parameters, recorder);
    dropUnfounded(map_, parameters, recorder);
    refineTracks(map_, parameters);
    dropOwnedFromClusters();
}

void LikelihoodMethod::dropOwnedFromClusters()
{
    map_.clusters.remove([this](SegmentNumber number) { return map_.segment(number).owner != kNoPlane; });
}

void LikelihoodMethod::parametersChanged()
{
    for (PlaneTrack& plane : map_.planes())
        plane.comparedAt = 0;
}

void LikelihoodMethod::count(StepCounts& counts) const
{
    double error = 0.0;
    int fitted = 0;
    for (const PlaneTrack& plane : map_.planes()) {
        error += meanErrorOf(plane);
        fitted += static_cast<int>(plane.members.size());
    }
    counts.segments = static_cast<int>(fresh_.size());
    counts.clustered = static_cast<int>(unassigned_.size());
    counts.assigned = counts.segments - counts.clustered;
    counts.fitted = fitted;
    counts.unfitted = map_.segments() - fitted;
    counts.clusters = static_cast<int>(map_.clusters.all().size());
    counts.planes = static_cast<int>(map_.planes().size());
    counts.meanError = map_.planes().empty() ? 0.0 : error / static_cast<double>(map_.planes().size());
}

void LikelihoodMethod::publish(Snapshot& snapshot)
{
    for (auto place = static_cast<int>(log_.slices()); place < map_.slices(); ++place)
        log_.append(map_.slice(place).step, std::make_shared<const Segments>(segmentsOf(place, map_, sensor_, noise_)));
    snapshot.segments = log_;
    snapshot.planes.reserve(map_.planes().size());
    for (PlaneTrack& plane : map_.planes())
        snapshot.planes.push_back(publishedPlane(plane, map_));
    for (GrowingCluster& cluster : map_.clusters.all())
        snapshot.clusters.push_back(publishedCluster(cluster, map_));
}

}  // namespace planewright
