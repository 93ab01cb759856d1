// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/pipeline/extraction_method.h"
#include "core/planes/track_map.h"
#include "core/segments/extract_statistics.h"

namespace planewright {

/// Planes by maximum likelihood from the statistics of line segments, with one pitch error a slice.
class LikelihoodMethod : public ExtractionMethod {
public:
    int extractLineSegments(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters) override;
    void assignToPlanes(const Parameters& parameters, StepRecorder& recorder) override;
    void addToClusters(const Parameters& parameters, StepRecorder& recorder) override;
    void fitPlanes(const Parameters& parameters, StepRecorder& recorder) override;
    void splitAndMerge(const Parameters& parameters, StepRecorder& recorder) override;
    void fitRemainingSegments(const Parameters& parameters, StepRecorder& recorder) override;
    void finish(const Parameters& parameters, StepRecorder& recorder) override;
    void parametersChanged() override;
    void count(StepCounts& counts) const override;
    void publish(Snapshot& snapshot) override;

private:
    void dropOwnedFromClusters();

    StatisticsExtractor extractor_;
    std::vector<SegmentStatistics> fresh_;  // of the newest slice
    TrackMap map_;
    std::vector<SegmentNumber> unassigned_;
    int seededSlices_ = 0;  // of which all segments have had their chance to make a plane
    SensorModel sensor_;
    NoiseParameters noise_;
    SegmentLog log_;  // of the slices that a snapshot has shown
};

}  // namespace planewright
