// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/outline.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/core/geometry/seen_plane.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

double deterministicUniform(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

}  // namespace

class OutlineTest : public QObject {
    Q_OBJECT

private slots:
    void aWallIsTheRectangleOfItsSegments();
    void anLKeepsItsCorner();
    void aWindowIsAHole();
    void aDoorIsANotch();
    void partsFarApartStayApart();
    void aSlantedBorderIsNotCutIntoSteps();
    void aSideWallSeenInAFanReachesItsFloorLine();
    void aFloorSeenInAFanIsItsSector();
    void segmentsThatCrossGiveBothTriangles();
    void slicesThatComeOutOfOrderLeaveNoHole();
    void interlacedSlicesWithRaggedEndsGiveOnePart();
    void aPartMissedInTwoSlicesIsBridged();
    void aPartMissedInManyFineSlicesIsBridgedWhileTheGapIsSmall();
    void anOpeningOverThreeSlicesIsNotBridged();
    void everyThirdSliceOfARecordingIsNoGap();
    void twoSegmentsGiveAStrip();
    void withoutAnOverlapTheHullStandsIn();
    void manyPiecesInFewSlicesAreStripsToo();
    void rowsThatCrossAtRightAnglesAreNotNeighbours();
    void aPartThatEndsStaysEnded();
    void aSliverBesideAWallIsLeftOut();
    void aStepBesideAnotherOneIsNotSlanted();
};

void OutlineTest::aWallIsTheRectangleOfItsSegments()
{
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 20; ++k)
        wall.row(k, 0.1 * k - 1.0, {{-1.5, 1.5}});

    const Outline outline = wall.outline();

    QCOMPARE(outline.parts.size(), std::size_t(1));
    QCOMPARE(outline.parts[0].ring.size(), std::size_t(4));
    QVERIFY(outline.parts[0].holes.empty());
    QVERIFY(isClose(outline.area, 6.0));
    QVERIFY(isClose(outline.width, 3.0));
    QVERIFY(isClose(outline.height, 2.0));
    QVERIFY((outline.centroid - Eigen::Vector3d(0.0, 4.0, 0.0)).norm() < kGrid);
}

void OutlineTest::anLKeepsItsCorner()
{
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 20; ++k)
        wall.row(k, 0.1 * k, {{0.0, k <= 10 ? 3.0 : 1.0}});

    const Outline outline = wall.outline();

    // Rows at 1.0 (3 m long) and at 1.1 (1 m long): what both cover is 1 m wide. The hull would have 5 m².
    QCOMPARE(outline.parts.size(), std::size_t(1));
    QCOMPARE(outline.parts[0].ring.size(), std::size_t(6));
    QVERIFY(isClose(outline.area, 3.0 * 1.0 + 1.0 * 1.0));
    QVERIFY(isClose(outline.width, 3.0));
    QVERIFY(isClose(outline.height, 2.0));
}

void OutlineTest::aWindowIsAHole()
{
    const Outline outline = wallWithWindow(wallAhead()).outline();

    // The whole rows beside the window are at 0.5 and 1.5; between them nothing was seen from x = 1 to 2.
    QCOMPARE(outline.parts.size(), std::size_t(1));
    QCOMPARE(outline.parts[0].holes.size(), std::size_t(1));
    QCOMPARE(outline.parts[0].holes[0].size(), std::size_t(4));
    QVERIFY(isClose(outline.area, 3.0 * 2.0 - 1.0 * 1.0));
    QVERIFY(isClose(areaSeenFrom(wallAhead().linear().col(2), outline.parts[0].holes[0]), -1.0));
}

void OutlineTest::aDoorIsANotch()
{
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 20; ++k) {
        if (k <= 15)
            wall.row(k, 0.1 * k, {{0.0, 1.0}, {1.9, 3.0}});
        else
            wall.row(k, 0.1 * k, {{0.0, 3.0}});
    }

    const Outline outline = wall.outline();

    QCOMPARE(outline.parts.size(), std::size_t(1));
    QVERIFY(outline.parts[0].holes.empty());
    QCOMPARE(outline.parts[0].ring.size(), std::size_t(8));
    QVERIFY(isClose(outline.area, 3.0 * 2.0 - 0.9 * 1.6));
}

void OutlineTest::partsFarApartStayApart()
{
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 10; ++k)
        wall.row(k, 0.1 * k, {{0.0, 1.0}, {2.0, 3.5}});

    const Outline outline = wall.outline();

    QCOMPARE(outline.parts.size(), std::size_t(2));
    QVERIFY(isClose(outline.area, 1.0 + 1.5));
    QVERIFY(isClose(outline.width, 3.5));
}

void OutlineTest::aSlantedBorderIsNotCutIntoSteps()
{
    // A triangle whose right side runs out by 0.5 m per row, five times as far as the rows are apart.
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 10; ++k)
        wall.row(k, 0.1 * k, {{0.0, 0.5 + 0.5 * k}});

    const Outline outline = wall.outline();

    QVERIFY(isClose(outline.area, 0.5 * (0.5 + 5.5) * 1.0));
    QCOMPARE(outline.parts[0].ring.size(), std::size_t(4));
}

void OutlineTest::aSideWallSeenInAFanReachesItsFloorLine()
{
    // Rays 2° apart from a point 1 m above the floor; the wall ends 10 m away. x is forward, y up.
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 44; ++k) {
        const double down = degrees(89.0 - 2.0 * k);
        const double reach = std::min(10.0 / std::cos(down), 1.0 / std::sin(down));
        wall.slice(k, {{0.0, 0.0, reach * std::cos(down), -reach * std::sin(down)}});
    }

    const Outline outline = wall.outline();

    // From the ray 1° beside the vertical to the ray 1° below the level: the rectangle without two triangles. The ray
    // before the corner and the one after it enclose another one that nobody saw.
    const double beforeCorner = 1.0 / std::tan(degrees(7.0));
    const double unseenCorner = 0.5 * (10.0 - beforeCorner) * (1.0 - 10.0 * std::tan(degrees(5.0)));
    const double expected = 10.0 - 0.5 * std::tan(degrees(1.0)) - 0.5 * 100.0 * std::tan(degrees(1.0)) - unseenCorner;
    QCOMPARE(outline.parts.size(), std::size_t(1));
    QVERIFY2(isClose(outline.area, expected, 0.005), qPrintable(QString::number(outline.area)));
}

void OutlineTest::aFloorSeenInAFanIsItsSector()
{
    // Radial segments from 1 m to 3 m, 3° apart over 90°: a polygon of 30 trapezoids.
    SeenPlane floor;
    for (int k = 0; k <= 30; ++k) {
        const double a = degrees(3.0 * k);
        floor.slice(k, {{std::cos(a), std::sin(a), 3.0 * std::cos(a), 3.0 * std::sin(a)}});
    }

    const Outline outline = floor.outline();

    QCOMPARE(outline.parts.size(), std::size_t(1));
    QVERIFY(isClose(outline.area, 30.0 * 0.5 * (9.0 - 1.0) * std::sin(degrees(3.0)), 2e-3));
}

void OutlineTest::segmentsThatCrossGiveBothTriangles()
{
    SeenPlane floor;
    floor.slice(0, {{-1.0, -0.1, 1.0, 0.1}});
    floor.slice(1, {{-1.0, 0.1, 1.0, -0.1}});

    const Outline outline = floor.outline();

    QVERIFY2(isClose(outline.area, 2.0 * 0.5 * 1.0 * 0.2, 5e-3), qPrintable(QString::number(outline.area)));
}

void OutlineTest::slicesThatComeOutOfOrderLeaveNoHole()
{
    SeenPlane wall(wallAhead());
    const std::vector<int> order{0, 2, 1, 4, 3, 5, 7, 6, 8, 10, 9};
    for (std::size_t k = 0; k < order.size(); ++k)
        wall.row(static_cast<int>(k), 0.1 * order[k], {{0.0, 2.0}});

    const Outline outline = wall.outline();

    QCOMPARE(outline.parts.size(), std::size_t(1));
    QCOMPARE(outline.parts[0].ring.size(), std::size_t(4));
    QVERIFY(isClose(outline.area, 2.0));
}

void OutlineTest::interlacedSlicesWithRaggedEndsGiveOnePart()
{
    // Four slices at nearly the same pitch see the wall with beams 8 cm apart, shifted by 2 cm from slice to slice.
    SeenPlane wall(wallAhead());
    std::mt19937_64 random(7);
    for (int k = 0; k < 120; ++k) {
        const double shift = 0.02 * (k % 4);
        const double y = 0.05 * std::floor(k / 4.0) + 0.002 * deterministicUniform(random);
        wall.row(k, y, {{shift, 2.92 + shift}});
    }

    const Outline outline = wall.outline();

    QCOMPARE(outline.parts.size(), std::size_t(1));
    QVERIFY(outline.parts[0].holes.empty());
    const double least = 2.86 * 1.448;
    const double most = 2.98 * 1.452;
    QVERIFY(outline.area > least && outline.area < most);
}

void OutlineTest::aPartMissedInTwoSlicesIsBridged()
{
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 20; ++k) {
        if (k == 9 || k == 10)
            wall.row(k, 0.1 * k, {{0.0, 1.0}, {1.5, 3.0}});
        else if (k == 15)
            wall.slice(k, {});
        else
            wall.row(k, 0.1 * k, {{0.0, 3.0}});
    }

    const Outline outline = wall.outline();

    QCOMPARE(outline.parts.size(), std::size_t(1));
    QVERIFY(outline.parts[0].holes.empty());
    QVERIFY(isClose(outline.area, 6.0));
}

void OutlineTest::aPartMissedInManyFineSlicesIsBridgedWhileTheGapIsSmall()
{
    // Rows 1 cm apart; from x = 1 to 2 the wall is missed over 14 cm, below the shortest segment.
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 100; ++k) {
        if (k > 50 && k < 64)
            wall.row(k, 0.01 * k, {{0.0, 1.0}, {2.0, 3.0}});
        else
            wall.row(k, 0.01 * k, {{0.0, 3.0}});
    }

    QVERIFY(isClose(wall.outline().area, 3.0));
}

void OutlineTest::anOpeningOverThreeSlicesIsNotBridged()
{
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 20; ++k) {
        if (k >= 8 && k <= 10)
            wall.row(k, 0.1 * k, {{0.0, 1.0}, {2.0, 3.0}});
        else
            wall.row(k, 0.1 * k, {{0.0, 3.0}});
    }

    QVERIFY(isClose(wall.outline().area, 6.0 - 0.4));
}

void OutlineTest::everyThirdSliceOfARecordingIsNoGap()
{
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 10; ++k)
        wall.row(9 * k, 0.2 * k, {{0.0, 3.0}});

    QVERIFY(isClose(wall.outline().area, 6.0));
}

void OutlineTest::twoSegmentsGiveAStrip()
{
    SeenPlane wall(wallAhead());
    wall.row(3, 0.0, {{0.0, 2.0}});
    wall.row(4, 0.2, {{1.0, 4.0}});

    const Outline outline = wall.outline();

    // They overlap by 1 m; their ends are too far apart to be joined.
    QVERIFY(isClose(outline.area, 0.2));
    QVERIFY(isClose(outline.width, 1.0));
    QVERIFY(isClose(outline.height, 0.2));
}

void OutlineTest::withoutAnOverlapTheHullStandsIn()
{
    SeenPlane wall(wallAhead());
    wall.row(0, 0.0, {{0.0, 1.0}});
    wall.row(1, 1.0, {{2.0, 3.0}});

    const Outline outline = wall.outline();

    QCOMPARE(outline.parts.size(), std::size_t(1));
    QCOMPARE(outline.parts[0].ring.size(), std::size_t(4));
    QVERIFY(isClose(outline.area, 1.0));
    QVERIFY((outline.centroid - Eigen::Vector3d(-1.5, 4.0, 0.5)).norm() < kGrid);
}

void OutlineTest::manyPiecesInFewSlicesAreStripsToo()
{
    SeenPlane fence(wallAhead());
    for (int k = 0; k <= 3; ++k) {
        std::vector<std::pair<double, double>> boards;
        boards.reserve(50);
        for (int i = 0; i < 50; ++i)
            boards.emplace_back(0.6 * i, 0.6 * i + 0.4);
        fence.row(k, 0.1 * k, boards);
    }

    const Outline outline = fence.outline();

    QCOMPARE(outline.parts.size(), std::size_t(50));
    QVERIFY(isClose(outline.area, 50 * 0.4 * 0.3));
    QVERIFY(isClose(outline.width, 49 * 0.6 + 0.4));
}

void OutlineTest::rowsThatCrossAtRightAnglesAreNotNeighbours()
{
    SeenPlane floor;
    floor.row(0, 0.0, {{-1.0, 1.0}});
    floor.row(1, 0.2, {{-1.0, 1.0}});
    floor.slice(2, {{0.0, 0.3, 0.0, 2.3}});

    QVERIFY(isClose(floor.outline().area, 0.4));
}

void OutlineTest::aPartThatEndsStaysEnded()
{
    // The left half of the wall is 1 m high; a shelf hangs 5 m above it, many slices later.
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 60; ++k) {
        if (k <= 10)
            wall.row(k, 0.1 * k, {{0.0, 2.0}});
        else if (k < 50)
            wall.row(k, 0.1 * k, {{1.0, 2.0}});
        else
            wall.row(k, 0.1 * k, {{0.0, 0.5}, {1.0, 2.0}});
    }

    QVERIFY(isClose(wall.outline().area, 6.0 + 1.0 + 0.5));
}

void OutlineTest::aSliverBesideAWallIsLeftOut()
{
    // Beside the wall two segments overlap by 1 cm in rows 5 cm apart: 5 cm².
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 20; ++k) {
        if (k == 8)
            wall.row(k, 0.05 * k, {{0.0, 2.0}, {3.0, 3.5}});
        else if (k == 9)
            wall.row(k, 0.05 * k, {{0.0, 2.0}, {3.49, 4.0}});
        else
            wall.row(k, 0.05 * k, {{0.0, 2.0}});
    }

    const Outline outline = wall.outline();

    QCOMPARE(outline.parts.size(), std::size_t(1));
    QVERIFY(isClose(outline.area, 2.0));
}

void OutlineTest::aStepBesideAnotherOneIsNotSlanted()
{
    // Upwards the wall grows from 1 m to 3 m at one row and shrinks back at the row after next.
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 10; ++k)
        wall.row(k, 0.1 * k, {{0.0, k >= 4 && k <= 6 ? 3.0 : 1.0}});

    QVERIFY(isClose(wall.outline().area, 1.0 + 2.0 * 0.2));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::OutlineTest)
#include "outline_test.moc"
