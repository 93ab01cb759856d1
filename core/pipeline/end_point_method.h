// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "core/pipeline/extraction_method.h"
#include "core/planes/plane_map.h"
#include "core/segments/extract_line_segments.h"

namespace planewright {

/// The published method: planes from the end points of line segments.
class EndPointMethod : public ExtractionMethod {
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

    LineSegmentExtractor extractor_;
    SliceTrace trace_;  // of the newest slice, where decisions are told
    PlaneMap map_;
    SegmentNumber first_ = 0;  // of the newest slice
    std::vector<SegmentNumber> unassigned_;
};

}  // namespace planewright
