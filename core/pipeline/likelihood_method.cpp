// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/likelihood_method.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/pipeline/find_segment.h"
#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"

namespace planewright {

namespace {

/// Slices whose leftover segments get another chance every few steps.
constexpr int kRemainingSlices = 6;
/// Slices whose planes have had time to settle are that far back.
constexpr int kSettledSlices = 5;
/// Range noise is estimated anew when there are so many times the samples.
constexpr double kSampleGrowth = 1.1;
/// Ranges that scatter by less than what was told over this are of a finer scanner in a smaller scene.
constexpr double kFiner = 2.0;

}  // namespace

int LikelihoodMethod::extractLineSegments(const ScanSlice& slice, const SensorModel& sensor,
                                          const Parameters& parameters, StepRecorder& recorder)
{
    sensor_ = sensor;
    if (parameters.noise.estimated)
        rangeNoise_.add(slice, sensor, parameters.noise);
    adapt(parameters);
    fresh_.clear();
    trace_.clear();
    extractor_.extract(slice, sensor, inUse_, fresh_, recorder.explains() ? &trace_ : nullptr);
    tellDiscarded(trace_, slice.step, recorder);
    map_.append(slice, sensor, fresh_);
    return extractor_.echoes();
}

/// Takes over the parameters, with the noise as far as the scan has told it.
void LikelihoodMethod::adapt(const Parameters& parameters)
{
    inUse_ = parameters;
    map_.parametersChanged();
    if (!parameters.noise.estimated) {
        fineness_ = 1.0;
        return;
    }
    if (static_cast<double>(rangeNoise_.samples()) >= kSampleGrowth * static_cast<double>(estimatedAt_)) {
        estimatedAt_ = rangeNoise_.samples();
        rangeFound_ = rangeNoise_.estimate(parameters.noise);
        fineness_ = std::min(1.0, kFiner * rangeNoise_.share(rangeFound_, parameters.noise));
    }
    inUse_.noise = rangeFound_;
    inUse_.noise.pitch = pitchNoise_.estimate(parameters.noise.pitch);
    inUse_.makeFiner(fineness_);
}

/// The last fit knows no flatness floor, and what that kept out of the pitch noise is noise to it: covariances would be
/// too small without it, while decisions on what is a plane are better made with less.
void LikelihoodMethod::adaptLastFit(const Parameters& parameters)
{
    if (!parameters.noise.estimated)
        return;
    PitchNoise ofPlanes;
    ofPlanes.add(map_, map_.slices(), inUse_.noise, inUse_.noise.systematic);
    inUse_.noise.pitch = ofPlanes.estimate(parameters.noise.pitch);
    map_.parametersChanged();
}

void LikelihoodMethod::assignToPlanes(const Parameters&, StepRecorder& recorder)
{
    unassigned_ = joinTracks(map_, inUse_, recorder);
}

void LikelihoodMethod::addToClusters(const Parameters&, StepRecorder& recorder)
{
    addToClusters(unassigned_, recorder);
}

void LikelihoodMethod::addToClusters(const std::vector<SegmentNumber>& segments, StepRecorder& recorder)
{
    for (const SegmentNumber number : segments) {
        const auto joined = map_.clusters.add(number, directionOf(number, map_), inUse_.clusters);
        if (recorder.explains())
            recorder.decide(
                DecisionKind::Cluster, {idOf(number, map_)},
                {{"similarity", joined.similarity, Comparison::Greater, std::cos(inUse_.clusters.directionLimit)}},
                {ClusterRef{joined.cluster}});
    }
}

void LikelihoodMethod::fitPlanes(const Parameters&, StepRecorder& recorder)
{
    if (inUse_.noise.estimated)
        pitchNoise_.add(map_, map_.slices() - kSettledSlices, inUse_.noise, inUse_.flatnessFloor());
    dropYoungGrazing(map_, inUse_, recorder);
    seedTracks(map_, seededSlices_, inUse_, recorder);
    seededSlices_ = map_.slices();
    settleClusters(recorder);
}

void LikelihoodMethod::splitAndMerge(const Parameters&, StepRecorder& recorder)
{
    mergeTracks(map_, inUse_, recorder);
}

void LikelihoodMethod::fitRemainingSegments(const Parameters&, StepRecorder& recorder)
{
    joinRemaining(map_, map_.slices() - kRemainingSlices, inUse_, recorder);
    settleClusters(recorder);
}

void LikelihoodMethod::finish(const Parameters& parameters, StepRecorder& recorder)
{
    if (map_.slices() == 0)
        return;
    const auto pass = [&](std::string_view name) {
        settleClusters(recorder);
        recorder.begin(Phase::Finish, name);
    };
    recorder.begin(Phase::Finish, "merge");
    pitchNoise_.add(map_, map_.slices(), inUse_.noise, inUse_.flatnessFloor());
    adapt(parameters);
    mergeTracks(map_, inUse_, recorder);
    pass("split");
    splitTracks(map_, inUse_, recorder);
    pass("split_contested");
    splitContested(map_, inUse_, recorder);
    pass("thin");
    thinTracks(map_, inUse_, recorder);
    pass("fit");
    seedTracks(map_, 0, inUse_, recorder);
    pass("remaining");
    joinRemaining(map_, 0, inUse_, recorder);
    pass("merge");
    mergeTracks(map_, inUse_, recorder);
    pass("thin");
    thinTracks(map_, inUse_, recorder);
    pass("drop_unfounded");
    dropUnfounded(map_, inUse_, recorder);
    pass("fit_pairs");
    seedPairs(map_, inUse_, recorder);
    pass("merge");
    mergeTracks(map_, inUse_, recorder);
    pass("remaining");
    joinRemaining(map_, 0, inUse_, recorder);
    pass("thin");
    thinTracks(map_, inUse_, recorder);
    pass("split_contested");
    splitContested(map_, inUse_, recorder);
    pass("split_parts");
    splitParts(map_, inUse_, recorder);
    pass("settle_decisive");
    settleDecisive(map_, inUse_, recorder);
    pass("drop_unfounded");
    dropUnfounded(map_, inUse_, recorder);
    pass("refine");
    adaptLastFit(parameters);
    refineTracks(map_, inUse_);
    settleClusters(recorder);
}

/// Clusters hold the segments that belong to no plane, those too that have just lost theirs.
void LikelihoodMethod::settleClusters(StepRecorder& recorder)
{
    addToClusters(map_.settleClusters(), recorder);
}

void LikelihoodMethod::parametersChanged()
{
    for (PlaneTrack& plane : map_.planes())
        plane.comparedAt = plane.contestedAt = 0;
    estimatedAt_ = 0;
}

std::vector<Conditions> LikelihoodMethod::waysOfMerging(PlaneId a, PlaneId b, const Parameters&)
{
    return {mergeConditions(map_.plane(a), map_.plane(b), map_, inUse_)};
}

std::vector<Conditions> LikelihoodMethod::waysOfJoining(const SegmentId& segment, PlaneId plane, const Parameters&)
{
    return waysIntoTrack(numberOf(segment), map_.plane(plane), map_, inUse_);
}

/// The running number of a segment; −1 where it is not there.
SegmentNumber LikelihoodMethod::numberOf(const SegmentId& segment) const
{
    return findSegment(segment, map_.segments(), [this](SegmentNumber number) { return idOf(number, map_); });
}

std::optional<PlaneId> LikelihoodMethod::ownerOf(const SegmentId& segment) const
{
    const SegmentNumber number = numberOf(segment);
    if (number < 0)
        return std::nullopt;
    return map_.segment(number).owner;
}

bool LikelihoodMethod::hasPlane(PlaneId plane) const
{
    return std::any_of(map_.planes().begin(), map_.planes().end(),
                       [&](const PlaneTrack& other) { return other.id == plane; });
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
    const auto shown = static_cast<int>(log_.slices());
    // Slices that are shown together share one owner: a request to the heap less for each.
    const auto fresh = std::make_shared<Segments[]>(static_cast<std::size_t>(map_.slices() - shown));
    for (int place = shown; place < map_.slices(); ++place) {
        Segments& segments = fresh[place - shown];
        segments = segmentsOf(place, map_, sensor_, inUse_.noise);
        log_.append(map_.slice(place).step, std::shared_ptr<const Segments>(fresh, &segments));
    }
    snapshot.segments = log_;
    snapshot.noise = {inUse_.noise.rangeConstant, inUse_.noise.rangeProportional, inUse_.noise.pitch,
                      inUse_.noise.estimated, fineness_};
    snapshot.planes.reserve(map_.planes().size());
    for (PlaneTrack& plane : map_.planes())
        snapshot.planes.push_back(publishedPlane(plane, map_));
    for (GrowingCluster& cluster : map_.clusters.all())
        snapshot.clusters.push_back(publishedCluster(cluster, map_));
}

}  // namespace planewright
