// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/reassign_segments.h"

#include <cmath>

#include <QtTest>

#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A floor 1 m below the scanner, from 1 m ahead to the wall 4 m ahead; its rows run across the view.
Sheet floorSheet()
{
    return {{-1.0, 3.0, -1.0}, {2.0, 0.0, 0.0}, {0.0, 0.1, 0.0}, 10, 0};
}

/// The wall over it, from 0.1 m above the floor.
Sheet wallSheet(int rows = 8)
{
    return {{-1.0, 4.0, -0.9}, {2.0, 0.0, 0.0}, {0.0, 0.0, 0.1}, rows, 12};
}

/// The lowest row of the wall, 20 mm over the floor.
LineSegment lowestRow()
{
    return segmentBetween(11, {-1.0, 4.0, -0.98}, {1.0, 4.0, -0.98});
}

struct Reassigning {
    Parameters parameters = lenient();
    PlaneMap map;
    Recorded recorded;

    explicit Reassigning(const std::vector<Segments>& groups)
    {
        makePlanes(map, groups, parameters.planes);
        map.step = 30;
    }
    void reassign() { reassignSegments(map, parameters, recorded.recorder); }
    std::size_t membersOf(PlaneId id) { return map.plane(id).members().size(); }
};

}  // namespace

class ReassignSegmentsTest : public QObject {
    Q_OBJECT

private slots:
    void aWallsLowestRowLeavesTheFloor();
    void bothPlanesAreExactAfterwards();
    void theOrderOfThePlanesDoesNotMatter();
    void segmentsGoToTheNearestOfAllPlanes();
    void segmentsThatPassNoOtherPlaneStay();
    void aPlaneThatKeepsTooFewSegmentsIsDissolved();
    void planesAreRefinedThoughNothingMoves();
    void movesAreExplainedByTestsThatPass();
};

void ReassignSegmentsTest::aWallsLowestRowLeavesTheFloor()
{
    Reassigning room({floorSheet().segments() + Segments{lowestRow()}, wallSheet().segments()});

    room.reassign();

    QCOMPARE(room.membersOf(0), std::size_t{10});
    QCOMPARE(room.membersOf(1), std::size_t{9});
    QCOMPARE(room.map.segments.owner(10), 1);
    QVERIFY(room.map.clusters.all().empty());
}

void ReassignSegmentsTest::bothPlanesAreExactAfterwards()
{
    Reassigning room({floorSheet().segments() + Segments{lowestRow()}, wallSheet().segments()});

    room.reassign();

    const auto below = room.map.plane(0).publish(room.map.segments);
    const auto ahead = room.map.plane(1).publish(room.map.segments);
    QVERIFY(angleBetween(below->normal, -Eigen::Vector3d::UnitZ()) < 1e-9);
    QVERIFY(std::abs(below->distance - 1.0) < 1e-9);
    QVERIFY(angleBetween(ahead->normal, Eigen::Vector3d::UnitY()) < 1e-9);
    QVERIFY(std::abs(ahead->distance - 4.0) < 1e-9);
    QCOMPARE(below->points, 300);
    QCOMPARE(ahead->points, 270);
    QVERIFY(below->rms < 1e-9);
    QVERIFY(below->fittingError < 1e-9);
    QCOMPARE(below->segments.size(), std::size_t{10});
}

void ReassignSegmentsTest::theOrderOfThePlanesDoesNotMatter()
{
    Reassigning room({floorSheet().segments() + Segments{lowestRow()}, wallSheet().segments()});
    Reassigning mirrored({wallSheet().segments(), floorSheet().segments() + Segments{lowestRow()}});

    room.reassign();
    mirrored.reassign();

    const auto there = room.map.plane(0).publish(room.map.segments);
    const auto here = mirrored.map.plane(1).publish(mirrored.map.segments);
    QVERIFY(there->segments == here->segments);
    QVERIFY(there->normal == here->normal);
    QCOMPARE(there->distance, here->distance);
}

void ReassignSegmentsTest::segmentsGoToTheNearestOfAllPlanes()
{
    // 24 mm before the wall that owns it and has followed it by 4 mm, 12 and 8 mm from two others.
    const LineSegment stray = segmentBetween(7, {-1.0, 3.972, 0.25}, {1.0, 3.972, 0.25});
    Reassigning walls({wall(6).segments() + Segments{stray}, wall(6, -0.04).segments(), wall(6, -0.02).segments()});
    const SegmentNumber number = walls.map.segments.size() - 1;
    QCOMPARE(walls.map.segments.owner(number), 0);

    walls.reassign();

    QCOMPARE(walls.map.segments.owner(number), 2);
    QCOMPARE(walls.map.plane(2).members().back(), number);
}

void ReassignSegmentsTest::segmentsThatPassNoOtherPlaneStay()
{
    // Its farther end is 25 mm off its own wall, and nearer to a plane that it crosses at 90°.
    const LineSegment stub = segmentBetween(7, {0.0, 4.025, 0.7}, {0.02, 4.025, 0.7});
    const Sheet side{{0.01, 3.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 0.1}, 6, 0};
    Reassigning corner({wall(6).segments(), side.segments(), {stub}});
    const SegmentNumber number = corner.map.segments.size() - 1;
    corner.map.planes.pop_back();
    corner.map.segments.owner(number) = 0;
    corner.map.planes[0].add(number, corner.map.segments, corner.parameters.planes, 8);

    corner.reassign();

    QVERIFY(corner.map.planes[1].distanceTo(stub.end) < corner.map.planes[0].distanceTo(stub.end));
    QCOMPARE(corner.map.segments.owner(number), 0);
    QVERIFY(corner.recorded.report.decisions.empty());
}

void ReassignSegmentsTest::aPlaneThatKeepsTooFewSegmentsIsDissolved()
{
    // Of five rows of a wall and its skirting three go to the wall, and two do not make a plane.
    const Segments skirting{segmentBetween(0, {-1.0, 3.96, 0.0}, {1.0, 3.96, 0.0}),
                            segmentBetween(1, {-1.0, 3.96, 0.1}, {1.0, 3.96, 0.1})};
    const Sheet upper = wall(3, 0.001, 2);
    Reassigning room({wall(9).segments(), skirting + upper.segments()});

    room.reassign();

    QVERIFY((planeIds(room.map) == std::vector<PlaneId>{0}));
    QCOMPARE(room.map.planes[0].members().size(), std::size_t{12});
    const auto clustered = clusteredSegments(room.map);
    QCOMPARE(clustered.size(), std::size_t{2});
    for (const SegmentNumber number : clustered) {
        QCOMPARE(room.map.segments.owner(number), kNoPlane);
        QCOMPARE(room.map.segments[number].start.y(), 3.96);
    }
}

void ReassignSegmentsTest::planesAreRefinedThoughNothingMoves()
{
    Reassigning room({wall(8).segments()});
    GrowingPlane& plane = room.map.planes[0];
    const LineSegment off = segmentBetween(9, {-1.0, 4.02, 0.9}, {1.0, 4.02, 0.9});
    const SegmentNumber number = append(room.map.segments, {off})[0];
    room.map.segments.owner(number) = 0;
    plane.add(number, room.map.segments, room.parameters.planes, 9);

    room.reassign();

    const PlaneFit expected = [&] {
        PlaneFit start;
        start.normal = Eigen::Vector3d::UnitY();
        start.distance = 4.0;
        return refinePlane(start, endPointsOf(plane.members(), room.map.segments), room.parameters.planes);
    }();
    QVERIFY(room.recorded.report.decisions.empty());
    QCOMPARE(plane.members().size(), std::size_t{9});
    QCOMPARE(plane.addedSinceRefit(), 0);
    QVERIFY(angleBetween(plane.normal(), expected.normal) < 1e-7);
    QVERIFY(std::abs(plane.distance() - expected.distance) < 1e-7);
}

void ReassignSegmentsTest::movesAreExplainedByTestsThatPass()
{
    Reassigning room({floorSheet().segments() + Segments{lowestRow()}, wallSheet().segments()});
    const double before = room.map.planes[0].distanceTo(lowestRow().start);

    room.reassign();

    const auto decisions = room.recorded.decisions(DecisionKind::Assign);
    QCOMPARE(decisions.size(), std::size_t{1});
    QVERIFY(segmentOf(decisions[0].operands[0]) == (SegmentId{11, 0}));
    QCOMPARE(planeOf(decisions[0].operands[1]), 0);
    QCOMPARE(planeOf(decisions[0].result[0]), 1);
    QVERIFY(allPass(decisions[0].tests));
    QVERIFY(std::abs(testOf(decisions[0].tests, "plane_distance").value) < 1e-9);
    QVERIFY(std::abs(testOf(decisions[0].tests, "plane_distance").limit - before) < 1e-9);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ReassignSegmentsTest)
#include "reassign_segments_test.moc"
