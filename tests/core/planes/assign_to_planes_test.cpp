// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/assign_to_planes.h"

#include <cmath>

#include <QtTest>

#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A map with walls ahead at these distances, drawn over 6 slices.
PlaneMap mapWithWalls(const std::vector<double>& distances, const Parameters& parameters)
{
    PlaneMap map;
    std::vector<Segments> walls;
    for (const double distance : distances)
        walls.push_back(wall(6, distance - 4.0).segments());
    makePlanes(map, walls, parameters.planes);
    map.step = 6;
    return map;
}

/// A level segment whose ends are this far behind the wall 4 m ahead.
LineSegment behindTheWall(double start, double end, int step = 6)
{
    return segmentBetween(step, {-1.0, 4.0 + start, 0.3}, {1.0, 4.0 + end, 0.3});
}

AssignmentTest compareWithTheWall(const LineSegment& segment, const Parameters& parameters)
{
    const PlaneMap map = mapWithWalls({4.0}, parameters);
    return compareForAssignment(segment, map.planes[0], parameters.assignment);
}

}  // namespace

class AssignToPlanesTest : public QObject {
    Q_OBJECT

private slots:
    void fartherEndPointDecides();
    void segmentThatTouchesAWallAtARightAngleIsNotOnIt();
    void segmentThroughAWallWithinTheDistanceIsNotOnIt();
    void orthogonalityIsTheSineOfTheAngleToThePlane();
    void theSenseOfDirectionDoesNotMatter();
    void noiseOfTheFartherEndPointWidensTheDistance();
    void noiseAlongThePlaneDoesNotWidenTheDistance();
    void noiseOfTheDirectionWidensTheAngle();
    void aSegmentJoinsTheNearestPlaneOfThoseThatMatch();
    void aNearPlaneThatDoesNotMatchGivesWayToAFartherOneThatDoes();
    void segmentsThatMatchNoPlaneAreLeftOver();
    void onlySegmentsFromTheFirstOnAreTried();
    void aPlaneIsRefittedAfterEverySoManySegments();
    void assignmentIsExplainedByTestsThatPass();
    void rejectionIsExplainedByTheNearestPlane();
    void rejectionWithoutAnyPlaneHasNoTests();
};

void AssignToPlanesTest::fartherEndPointDecides()
{
    const Parameters parameters = lenient();

    const AssignmentTest far = compareWithTheWall(behindTheWall(0.001, 0.031), parameters);
    const AssignmentTest near = compareWithTheWall(behindTheWall(-0.029, 0.002), parameters);

    QVERIFY(std::abs(far.distance - 0.031) < 1e-9);
    QVERIFY(std::abs(far.distanceLimit - 0.03) < 1e-12);
    QVERIFY(!far.pass());
    QVERIFY(std::abs(near.distance - 0.029) < 1e-9);
    QVERIFY(near.pass());
}

void AssignToPlanesTest::segmentThatTouchesAWallAtARightAngleIsNotOnIt()
{
    Parameters parameters = lenient();
    parameters.assignment.orthogonality = degrees(45.0);

    const AssignmentTest test = compareWithTheWall(segmentBetween(6, {0.5, 4.0, 0.3}, {0.5, 3.0, 0.3}), parameters);

    QVERIFY(std::abs(test.distance - 1.0) < 1e-9);
    QVERIFY(std::abs(test.orthogonality - 1.0) < 1e-9);
    QVERIFY(!test.pass());
}

void AssignToPlanesTest::segmentThroughAWallWithinTheDistanceIsNotOnIt()
{
    // 50 mm long, half of it on either side: both ends are near, and yet it stands across.
    const AssignmentTest test = compareWithTheWall(segmentBetween(6, {0.5, 3.975, 0.3}, {0.5, 4.025, 0.3}), lenient());

    QVERIFY(test.distance < test.distanceLimit);
    QVERIFY(!test.pass());
}

void AssignToPlanesTest::orthogonalityIsTheSineOfTheAngleToThePlane()
{
    const auto tilted = [](double angle) {
        const Eigen::Vector3d half{0.15 * std::cos(angle), 0.15 * std::sin(angle), 0.0};
        return segmentBetween(6, Eigen::Vector3d(0.0, 4.0, 0.3) - half, Eigen::Vector3d(0.0, 4.0, 0.3) + half);
    };
    const Parameters parameters = lenient();

    const AssignmentTest within = compareWithTheWall(tilted(degrees(4.9)), parameters);
    const AssignmentTest beyond = compareWithTheWall(tilted(degrees(5.1)), parameters);

    QVERIFY(std::abs(within.orthogonality - std::sin(degrees(4.9))) < 1e-9);
    QVERIFY(within.pass());
    QVERIFY(std::abs(beyond.orthogonality - std::sin(degrees(5.1))) < 1e-9);
    QVERIFY(beyond.distance < beyond.distanceLimit);
    QVERIFY(!beyond.pass());
}

void AssignToPlanesTest::theSenseOfDirectionDoesNotMatter()
{
    LineSegment segment = behindTheWall(0.01, 0.02);
    const AssignmentTest there = compareWithTheWall(segment, lenient());
    std::swap(segment.start, segment.end);
    segment.direction = -segment.direction;

    const AssignmentTest back = compareWithTheWall(segment, lenient());

    QCOMPARE(back.distance, there.distance);
    QCOMPARE(back.orthogonality, there.orthogonality);
}

void AssignToPlanesTest::noiseOfTheFartherEndPointWidensTheDistance()
{
    Parameters parameters = lenient();
    parameters.assignment.planeDistanceSigmas = 3.0;
    LineSegment segment = behindTheWall(0.01, 0.05);
    segment.startCovariance = 0.1 * 0.1 * Eigen::Matrix3d::Identity();
    segment.endCovariance = 0.02 * 0.02 * Eigen::Matrix3d::Identity();

    const AssignmentTest test = compareWithTheWall(segment, parameters);

    QVERIFY(std::abs(test.distanceLimit - 0.06) < 1e-9);
    QVERIFY(test.pass());
}

void AssignToPlanesTest::noiseAlongThePlaneDoesNotWidenTheDistance()
{
    Parameters parameters = lenient();
    parameters.assignment.planeDistanceSigmas = 3.0;
    LineSegment segment = behindTheWall(0.01, 0.05);
    segment.endCovariance = Eigen::Vector3d(1.0, 0.0, 1.0).asDiagonal();

    const AssignmentTest test = compareWithTheWall(segment, parameters);

    QVERIFY(std::abs(test.distanceLimit - 0.03) < 1e-6);
    QVERIFY(!test.pass());
}

void AssignToPlanesTest::noiseOfTheDirectionWidensTheAngle()
{
    Parameters parameters = lenient();
    parameters.assignment.orthogonalitySigmas = 3.0;
    LineSegment segment = behindTheWall(0.0, 0.0);
    segment.directionSigma = 0.1;

    const AssignmentTest wide = compareWithTheWall(segment, parameters);
    segment.directionSigma = 0.001;
    const AssignmentTest narrow = compareWithTheWall(segment, parameters);

    QVERIFY(std::abs(wide.orthogonalityLimit - 0.3) < 1e-12);
    QVERIFY(std::abs(narrow.orthogonalityLimit - std::sin(degrees(5.0))) < 1e-12);
}

void AssignToPlanesTest::aSegmentJoinsTheNearestPlaneOfThoseThatMatch()
{
    const Parameters parameters = lenient();
    Recorded recorded;
    PlaneMap map = mapWithWalls({4.0, 4.02, 4.04}, parameters);
    const SegmentNumber number = append(map.segments, {behindTheWall(0.018, 0.018)})[0];

    const bool assigned = assignToBestPlane(number, map, parameters, recorded.recorder);

    QVERIFY(assigned);
    QCOMPARE(map.segments.owner(number), 1);
    QCOMPARE(map.planes[1].members().size(), std::size_t{7});
    QCOMPARE(map.planes[1].members().back(), number);
    QCOMPARE(map.planes[0].members().size(), std::size_t{6});
    QCOMPARE(map.planes[2].members().size(), std::size_t{6});
}

void AssignToPlanesTest::aNearPlaneThatDoesNotMatchGivesWayToAFartherOneThatDoes()
{
    // At 60° to the wall through its middle, and 4 mm below the segment's own plane.
    const Parameters parameters = lenient();
    Recorded recorded;
    PlaneMap map;
    const Eigen::Vector3d slope{std::cos(degrees(60.0)), std::sin(degrees(60.0)), 0.0};
    const Eigen::Vector3d across{-slope.y(), slope.x(), 0.0};
    const Eigen::Vector3d middle{0.0, 4.0, 0.3};
    const Sheet oblique{middle - slope + 0.004 * across, 2.0 * slope, {0.0, 0.0, 0.1}, 6, 0};
    makePlanes(map, {wall(6).segments(), oblique.segments()}, parameters.planes);
    const SegmentNumber number =
        append(map.segments, {segmentBetween(6, middle - 0.002 * slope, middle + 0.002 * slope)})[0];

    const bool assigned = assignToBestPlane(number, map, parameters, recorded.recorder);

    QVERIFY(map.planes[0].distanceTo(middle + 0.002 * slope) < map.planes[1].distanceTo(middle + 0.002 * slope));
    QVERIFY(assigned);
    QCOMPARE(map.segments.owner(number), 1);
}

void AssignToPlanesTest::segmentsThatMatchNoPlaneAreLeftOver()
{
    const Parameters parameters = lenient();
    Recorded recorded;
    PlaneMap map = mapWithWalls({4.0}, parameters);
    const auto numbers =
        append(map.segments, {behindTheWall(0.5, 0.5), behindTheWall(0.01, 0.01), behindTheWall(-0.2, 0.2)});

    const auto left = assignToPlanes(numbers[0], map, parameters, recorded.recorder);

    QVERIFY((left == std::vector<SegmentNumber>{numbers[0], numbers[2]}));
    QCOMPARE(map.segments.owner(numbers[0]), kNoPlane);
    QCOMPARE(map.segments.owner(numbers[1]), 0);
    QCOMPARE(map.segments.owner(numbers[2]), kNoPlane);
    QCOMPARE(map.planes[0].members().size(), std::size_t{7});
}

void AssignToPlanesTest::onlySegmentsFromTheFirstOnAreTried()
{
    const Parameters parameters = lenient();
    Recorded recorded;
    PlaneMap map = mapWithWalls({4.0}, parameters);
    const auto numbers = append(map.segments, {behindTheWall(0.0, 0.0, 6), behindTheWall(0.0, 0.0, 7)});

    const auto left = assignToPlanes(numbers[1], map, parameters, recorded.recorder);

    QVERIFY(left.empty());
    QCOMPARE(map.segments.owner(numbers[0]), kNoPlane);
    QCOMPARE(map.segments.owner(numbers[1]), 0);
}

void AssignToPlanesTest::aPlaneIsRefittedAfterEverySoManySegments()
{
    // Segments 10 mm behind the wall: each refit pulls the plane towards them, and nothing does in between.
    Parameters parameters = lenient();
    parameters.assignment.refitEvery = 3;
    Recorded recorded;
    PlaneMap map = mapWithWalls({4.0}, parameters);
    const GrowingPlane& plane = map.planes[0];
    double before = plane.distance();
    for (int added = 1; added <= 9; ++added) {
        map.step = 5 + added;
        append(map.segments, {behindTheWall(0.01, 0.01, map.step)});

        assignToPlanes(map.segments.size() - 1, map, parameters, recorded.recorder);

        QCOMPARE(plane.addedSinceRefit(), added % 3);
        QCOMPARE(plane.distance() != before, added % 3 == 0);
        QCOMPARE(plane.changedStep(), map.step);
        before = plane.distance();
    }
}

void AssignToPlanesTest::assignmentIsExplainedByTestsThatPass()
{
    const Parameters parameters = lenient();
    Recorded recorded;
    PlaneMap map = mapWithWalls({4.0}, parameters);
    const SegmentNumber number = append(map.segments, {behindTheWall(0.01, 0.02)})[0];

    assignToBestPlane(number, map, parameters, recorded.recorder);

    QCOMPARE(recorded.report.decisions.size(), std::size_t{1});
    const Decision& decision = recorded.report.decisions[0];
    QVERIFY(decision.kind == DecisionKind::Assign);
    QVERIFY(segmentOf(decision.operands[0]) == (SegmentId{6, 0}));
    QCOMPARE(planeOf(decision.operands[1]), 0);
    QCOMPARE(planeOf(decision.result[0]), 0);
    QVERIFY(allPass(decision.tests));
    QVERIFY(std::abs(testOf(decision.tests, "plane_distance").value - 0.02) < 1e-9);
    QVERIFY(std::abs(testOf(decision.tests, "plane_distance").limit - 0.03) < 1e-12);
    QVERIFY(std::abs(testOf(decision.tests, "orthogonality").value - 0.01 / std::hypot(2.0, 0.01)) < 1e-9);
}

void AssignToPlanesTest::rejectionIsExplainedByTheNearestPlane()
{
    const Parameters parameters = lenient();
    Recorded recorded;
    PlaneMap map = mapWithWalls({4.0, 4.5}, parameters);
    const SegmentNumber number = append(map.segments, {behindTheWall(0.4, 0.4)})[0];

    const bool assigned = assignToBestPlane(number, map, parameters, recorded.recorder);

    QVERIFY(!assigned);
    QCOMPARE(recorded.report.decisions.size(), std::size_t{1});
    const Decision& decision = recorded.report.decisions[0];
    QVERIFY(decision.kind == DecisionKind::Reject);
    QCOMPARE(planeOf(decision.operands[1]), 1);
    QVERIFY(failed(decision.tests) == std::vector<std::string_view>{"plane_distance"});
    QVERIFY(std::abs(testOf(decision.tests, "plane_distance").value - 0.1) < 1e-9);
    QVERIFY(decision.result.empty());
}

void AssignToPlanesTest::rejectionWithoutAnyPlaneHasNoTests()
{
    Recorded recorded;
    PlaneMap map;
    append(map.segments, {behindTheWall(0.0, 0.0)});

    const bool assigned = assignToBestPlane(0, map, lenient(), recorded.recorder);

    QVERIFY(!assigned);
    QCOMPARE(recorded.report.decisions.size(), std::size_t{1});
    QVERIFY(recorded.report.decisions[0].kind == DecisionKind::Reject);
    QCOMPARE(recorded.report.decisions[0].operands.size(), std::size_t{1});
    QVERIFY(recorded.report.decisions[0].tests.empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::AssignToPlanesTest)
#include "assign_to_planes_test.moc"
