// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/pipeline/extraction_method.h"
#include "core/planes/plane_map.h"
#include "core/segments/extract_line_segments.h"

namespace planewright {

/// The published method: planes from the end points of line segments.
class EndPointMethod : public ExtractionMethod {
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
    LineSegmentExtractor extractor_;
    PlaneMap map_;
    SegmentNumber first_ = 0;  // of the newest slice
    std::vector<SegmentNumber> unassigned_;
};

}  // namespace planewright
