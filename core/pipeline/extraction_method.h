// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"
#include "core/types/scan_slice.h"
#include "core/types/snapshot.h"
#include "core/types/step_recorder.h"
#include "core/types/why_not.h"

namespace planewright {

/// The lines of Table I as one way of estimating planes fills them in; PlaneExtractor says when each is due.
class ExtractionMethod {
public:
    ExtractionMethod() = default;
    ExtractionMethod(const ExtractionMethod&) = delete;
    ExtractionMethod& operator=(const ExtractionMethod&) = delete;
    virtual ~ExtractionMethod() = default;

    /// Line 5: the segments of a new slice. Gives the number of beams with an echo.
    virtual int extractLineSegments(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters,
                                    StepRecorder& recorder) = 0;
    /// Line 6: segments of the slice that lie on a known plane join it.
    virtual void assignToPlanes(const Parameters& parameters, StepRecorder& recorder) = 0;
    /// Line 7: the rest is grouped by direction.
    virtual void addToClusters(const Parameters& parameters, StepRecorder& recorder) = 0;
    /// Line 8: planes of segments that belong to none.
    virtual void fitPlanes(const Parameters& parameters, StepRecorder& recorder) = 0;
    /// Line 9: planes that grew wrong, planes that are one.
    virtual void splitAndMerge(const Parameters& parameters, StepRecorder& recorder) = 0;
    /// Line 10: a second chance for leftover segments.
    virtual void fitRemainingSegments(const Parameters& parameters, StepRecorder& recorder) = 0;
    /// The forced last pass, after which nothing waits for a later step. It begins each of its passes with the
    /// recorder.
    virtual void finish(const Parameters& parameters, StepRecorder& recorder) = 0;

    /// Called when the parameters change between steps: verdicts kept from before no longer hold.
    virtual void parametersChanged() = 0;

    /// The ways in which two planes may become one, and in which a segment may come to a plane, as things are, by
    /// their numbers, which must be there. They answer, and change nothing that is decided later.
    virtual std::vector<Conditions> waysOfMerging(PlaneId a, PlaneId b, const Parameters& parameters) = 0;
    virtual std::vector<Conditions> waysOfJoining(const SegmentId& segment, PlaneId plane,
                                                  const Parameters& parameters) = 0;
    /// The plane that a segment belongs to; kNoPlane where it belongs to none. Nothing where it is not there.
    virtual std::optional<PlaneId> ownerOf(const SegmentId& segment) const = 0;
    virtual bool hasPlane(PlaneId plane) const = 0;

    /// Totals of the state as it is: segments, fitted, unfitted, clusters, planes, mean error; and of the newest slice:
    /// segments, assigned, clustered.
    virtual void count(StepCounts& counts) const = 0;
    /// Puts segments, planes and clusters into a snapshot; what did not change is shared with the one before.
    virtual void publish(Snapshot& snapshot) = 0;
};

/// The method of these parameters (`method.estimator`).
std::unique_ptr<ExtractionMethod> makeMethod(const Parameters& parameters);

}  // namespace planewright
