// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "core/pipeline/extraction_method.h"
#include "core/planes/pitch_noise.h"
#include "core/planes/track_map.h"
#include "core/segments/extract_statistics.h"
#include "core/segments/range_noise.h"

namespace planewright {

/// Planes by maximum likelihood from the statistics of line segments, with one pitch error a slice.
class LikelihoodMethod : public ExtractionMethod {
public:
    int extractLineSegments(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters,
                            StepRecorder& recorder) override;
    void assignToPlanes(const Parameters& parameters, StepRecorder& recorder) override;
    void addToClusters(const Parameters& parameters, StepRecorder& recorder) override;
    void fitPlanes(const Parameters& parameters, StepRecorder& recorder) override;
    void splitAndMerge(const Parameters& parameters, StepRecorder& recorder) override;
    void fitRemainingSegments(const Parameters& parameters, StepRecorder& recorder) override;
    void finish(const Parameters& parameters, StepRecorder& recorder) override;
    void parametersChanged() override;
    std::vector<Conditions> waysOfMerging(PlaneId a, PlaneId b, const Parameters& parameters) override;
    std::vector<Conditions> waysOfJoining(const SegmentId& segment, PlaneId plane,
                                          const Parameters& parameters) override;
    std::optional<PlaneId> ownerOf(const SegmentId& segment) const override;
    bool hasPlane(PlaneId plane) const override;
    void count(StepCounts& counts) const override;
    void publish(Snapshot& snapshot) override;

private:
    SegmentNumber numberOf(const SegmentId& segment) const;
    void addToClusters(const std::vector<SegmentNumber>& segments, StepRecorder& recorder);
    void settleClusters(StepRecorder& recorder);
    void adapt(const Parameters& parameters);
    void adaptLastFit(const Parameters& parameters);

    RangeNoise rangeNoise_;
    NoiseParameters rangeFound_;
    double fineness_ = 1.0;         // 1 where ranges scatter as told
    std::int64_t estimatedAt_ = 0;  // samples of range noise when it was estimated last
    PitchNoise pitchNoise_;
    Parameters inUse_;  // those of the step, with the noise that the scan has told: stages read these
    StatisticsExtractor extractor_;
    SliceTrace trace_;                      // of the newest slice, where decisions are told
    std::vector<SegmentStatistics> fresh_;  // of the newest slice
    TrackMap map_;
    std::vector<SegmentNumber> unassigned_;
    int seededSlices_ = 0;  // of which all segments have had their chance to make a plane
    SensorModel sensor_;
    SegmentLog log_;  // of the slices that a snapshot has shown
};

}  // namespace planewright
