// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/assign_to_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/planes/segment_run.h"

namespace planewright {

namespace {

/// Whether a segment is of a surface that crosses a plane of few segments; one of many is settled.
bool leansOut(SegmentNumber segment, const GrowingPlane& plane, const SegmentTable& table,
              const PlaneParameters& parameters)
{
    return plane.members().size() < kSettled &&
           isContested(segment, plane.normal(), plane.distance(), table, parameters);
}

/// Why a segment that is near enough to a plane was not assigned to it.
std::vector<Test> contestedTest()
{
    return {{"contested", 1.0, Comparison::LessEqual, 0.0}};
}

}  // namespace

AssignmentTest compareForAssignment(const LineSegment& segment, const GrowingPlane& plane,
                                    const AssignmentParameters& parameters)
{
    AssignmentTest test;
    const double start = plane.distanceTo(segment.start);
    const double end = plane.distanceTo(segment.end);
    const Eigen::Matrix3d& covariance = start > end ? segment.startCovariance : segment.endCovariance;
    test.distance = std::max(start, end);
    test.orthogonality = std::abs(plane.normal().dot(segment.direction));
    test.distanceLimit =
        std::max(parameters.planeDistance,
                 parameters.planeDistanceSigmas * std::sqrt(plane.normal().dot(covariance * plane.normal())));
    test.orthogonalityLimit =
        std::max(std::sin(parameters.orthogonality), parameters.orthogonalitySigmas * segment.directionSigma);
    return test;
}

bool assignToBestPlane(SegmentNumber number, PlaneMap& map, const Parameters& parameters, StepRecorder& recorder,
                       int since)
{
    const LineSegment& segment = map.segments[number];
    const double reach = squaredReach(segment, parameters.assignment);
    GrowingPlane* best = nullptr;
    AssignmentTest bestTest;
    GrowingPlane* nearest = nullptr;  // for the explanation of what does not match
    double nearestDistance = std::numeric_limits<double>::infinity();
    for (GrowingPlane& plane : map.planes) {
        if (plane.changedStep() < since)
            continue;
        const double distance = fartherEnd(segment, plane);
        if (distance < nearestDistance) {
            nearest = &plane;
            nearestDistance = distance;
        }
        if (distance * distance >= reach || (best != nullptr && distance >= bestTest.distance))
            continue;
        const AssignmentTest test = compareForAssignment(segment, plane, parameters.assignment);
        if (test.pass() && !leansOut(number, plane, map.segments, parameters.planes)) {
            best = &plane;
            bestTest = test;
        }
    }

    if (recorder.explains()) {
        const auto describe = [](const AssignmentTest& test) {
            return std::vector<Test>{{"plane_distance", test.distance, Comparison::Less, test.distanceLimit},
                                     {"orthogonality", test.orthogonality, Comparison::Less, test.orthogonalityLimit}};
        };
        if (best != nullptr)
            recorder.decide(DecisionKind::Assign, {segment.id, PlaneRef{best->id()}}, describe(bestTest),
                            {PlaneRef{best->id()}});
        else if (nearest != nullptr) {
            const AssignmentTest test = compareForAssignment(segment, *nearest, parameters.assignment);
            recorder.decide(DecisionKind::Reject, {segment.id, PlaneRef{nearest->id()}},
                            test.pass() ? contestedTest() : describe(test));
        } else
            recorder.decide(DecisionKind::Reject, {segment.id}, {});
    }
    if (best == nullptr)
        return false;

    map.segments.owner(number) = best->id();
    best->add(number, map.segments, parameters.planes, map.step);
    if (best->addedSinceRefit() >= parameters.assignment.refitEvery)
        best->refit(map.segments, parameters.planes, map.step);
    return true;
}

std::vector<SegmentNumber> assignToPlanes(SegmentNumber first, PlaneMap& map, const Parameters& parameters,
                                          StepRecorder& recorder)
{
    std::vector<SegmentNumber> left;
    for (SegmentNumber segment = first; segment < map.segments.size(); ++segment) {
        if (!assignToBestPlane(segment, map, parameters, recorder))
            left.push_back(segment);
    }
    return left;
}

}  // namespace planewright
