// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/assign_to_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

Test contestedTest(bool leans)
{
    return {"contested", leans ? 1.0 : 0.0, Comparison::LessEqual, 0.0};
}

std::vector<Test> matchTests(const AssignmentTest& test)
{
    return {{"plane_distance", test.distance, Comparison::Less, test.distanceLimit},
            {"orthogonality", test.orthogonality, Comparison::Less, test.orthogonalityLimit}};
}

/// The plane that a segment is assigned to, if one matches, and that nearest to it.
struct BestPlane {
    GrowingPlane* best = nullptr;
    AssignmentTest test;
    GrowingPlane* nearest = nullptr;  // for the explanation of what does not match
};

BestPlane bestPlane(SegmentNumber number, PlaneMap& map, const Parameters& parameters, int since,
                    PlaneId without = kNoPlane)
{
    const LineSegment& segment = map.segments[number];
    const double reach = squaredReach(segment, parameters.assignment);
    BestPlane found;
    double nearestDistance = std::numeric_limits<double>::infinity();
    for (GrowingPlane& plane : map.planes) {
        if (plane.changedStep() < since || plane.id() == without)
            continue;
        const double distance = fartherEnd(segment, plane);
        if (distance < nearestDistance) {
            found.nearest = &plane;
            nearestDistance = distance;
        }
        if (distance * distance >= reach || (found.best != nullptr && distance >= found.test.distance))
            continue;
        const AssignmentTest test = compareForAssignment(segment, plane, parameters.assignment);
        if (test.pass() && !leansOut(number, plane, map.segments, parameters.planes)) {
            found.best = &plane;
            found.test = test;
        }
    }
    return found;
}

void explainAssignment(const LineSegment& segment, const BestPlane& found, const Parameters& parameters,
                       StepRecorder& recorder)
{
    const auto& [best, bestTest, nearest] = found;
    if (best != nullptr)
        recorder.decide(DecisionKind::Assign, {segment.id, PlaneRef{best->id()}}, matchTests(bestTest),
                        {PlaneRef{best->id()}});
    else if (nearest != nullptr) {
        const AssignmentTest test = compareForAssignment(segment, *nearest, parameters.assignment);
        recorder.decide(DecisionKind::Reject, {segment.id, PlaneRef{nearest->id()}},
                        test.pass() ? std::vector{contestedTest(true)} : matchTests(test));
    } else
        recorder.decide(DecisionKind::Reject, {segment.id}, {});
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
    const BestPlane found = bestPlane(number, map, parameters, since);
    if (recorder.explains())
        explainAssignment(map.segments[number], found, parameters, recorder);
    GrowingPlane* best = found.best;
    if (best == nullptr)
        return false;

    map.segments.owner(number) = best->id();
    best->add(number, map.segments, parameters.planes, map.step);
    if (best->addedSinceRefit() >= parameters.assignment.refitEvery)
        best->refit(map.segments, parameters.planes, map.step);
    return true;
}

std::vector<Conditions> waysIntoPlane(SegmentNumber number, const GrowingPlane& plane, PlaneMap& map,
                                      const Parameters& parameters)
{
    const LineSegment& segment = map.segments[number];
    const PlaneId owner = map.segments.owner(number);
    const AssignmentTest test = compareForAssignment(segment, plane, parameters.assignment);
    const bool isElsewhere = owner != kNoPlane && owner != plane.id();

    std::vector<Conditions> ways{{"assign", matchTests(test)}};
    std::vector<Test>& tests = ways.front().tests;
    tests.push_back(contestedTest(leansOut(number, plane, map.segments, parameters.planes)));
    if (isElsewhere)
        tests.push_back({"in_other_plane", 1.0, Comparison::LessEqual, 0.0});
    // Of planes at the same distance the one that was made first takes the segment.
    const BestPlane other = bestPlane(number, map, parameters, -1, plane.id());
    if (other.best != nullptr)
        tests.push_back({"distance_of_next", test.distance,
                         plane.id() < other.best->id() ? Comparison::LessEqual : Comparison::Less,
                         other.test.distance});
    if (isElsewhere) {
        Conditions moves{"reassign", {{"distance_of_own", test.distance, Comparison::Less, 0.0}}};
        moves.tests.front().limit = fartherEnd(segment, map.plane(owner));
        const std::vector<Test> matches = matchTests(test);
        moves.tests.insert(moves.tests.end(), matches.begin(), matches.end());
        ways.push_back(std::move(moves));
    }
    return ways;
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
