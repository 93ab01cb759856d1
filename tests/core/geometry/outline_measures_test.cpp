// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <QtTest>

#include "core/geometry/outline.h"
#include "core/types/angle.h"
#include "tests/core/geometry/seen_plane.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

bool comesBefore(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

Eigen::Isometry3d anyPose()
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
    pose.translation() = Eigen::Vector3d(1.0, 5.0, 2.0);
    return pose;
}

}  // namespace

class OutlineMeasuresTest : public QObject {
    Q_OBJECT

private slots:
    void noSegmentsGiveAnEmptyOutline();
    void segmentsMayRunEitherWay();
    void segmentsWithoutLengthOrFiniteEndsAreLeftOut();
    void aSingleSegmentHasNoAreaButALength();
    void ringsTurnLeftAndHolesRightSeenFromTheNormal();
    void ringsBeginAtTheirSmallestVertexAndPartsComeInOrder();
    void verticesAndCentroidLieOnThePlane();
    void theCentroidIsThatOfTheArea();
    void turningThePlaneTurnsTheOutline();
    void theOrderOfThePlanesSegmentsDoesNotMatter();
    void widthIsTheMoreLevelSide();
    void widthOfALevelPlaneIsTheLongerSide();
    void aKilometreAwayStillWorks();
    void partsAreMeasuredAsTheyAre();
};

/// 4 m × 3 m at x = 2 with a hole of 1 m², given clockwise, and a part of 1 m × 1 m beside it.
void OutlineMeasuresTest::partsAreMeasuredAsTheyAre()
{
    const auto at = [](double y, double z) { return Eigen::Vector3d(2.0, y, z); };
    const Outline::Polygon wall{{at(0.0, 3.0), at(4.0, 3.0), at(4.0, 0.0), at(0.0, 0.0)},
                                {{at(1.0, 1.0), at(2.0, 1.0), at(2.0, 2.0), at(1.0, 2.0)}}};
    const Outline::Polygon piece{{at(6.0, 0.0), at(7.0, 0.0), at(7.0, 1.0), at(6.0, 1.0)}, {}};

    const Outline outline = outlineOf({wall, piece}, Eigen::Vector3d::UnitX(), 2.0);

    QCOMPARE(outline.parts.size(), std::size_t(2));
    QVERIFY(isClose(outline.area, 12.0 - 1.0 + 1.0, 1e-12));
    // Moments: 12 · (2, 1.5) − 1 · (1.5, 1.5) + 1 · (6.5, 0.5), over 12.
    QVERIFY((outline.centroid - at(29.0 / 12.0, 17.0 / 12.0)).norm() < 1e-12);
    QVERIFY(isClose(outline.width, 7.0, 1e-12));
    QVERIFY(isClose(outline.height, 3.0, 1e-12));
    const Eigen::Vector3d a = outline.parts[0].ring[1] - outline.parts[0].ring[0];
    const Eigen::Vector3d b = outline.parts[0].ring[2] - outline.parts[0].ring[1];
    QVERIFY(a.cross(b).x() > 0.0);  // counter-clockwise seen from +n
    QVERIFY(outlineOf({}, Eigen::Vector3d::UnitX(), 2.0).parts.empty());
}

void OutlineMeasuresTest::noSegmentsGiveAnEmptyOutline()
{
    const Outline outline = SeenPlane().outline();

    QVERIFY(outline.parts.empty());
    QCOMPARE(outline.area, 0.0);
    QCOMPARE(outline.width, 0.0);
}

void OutlineMeasuresTest::aSingleSegmentHasNoAreaButALength()
{
    SeenPlane wall(wallAhead());
    wall.row(0, 0.5, {{1.0, 3.0}});

    const Outline outline = wall.outline();

    QVERIFY(outline.parts.empty());
    QCOMPARE(outline.area, 0.0);
    QVERIFY(isClose(outline.width, 2.0, 1e-12));
    QVERIFY(isClose(outline.height, 0.0, 1e-12));
    QVERIFY((outline.centroid - Eigen::Vector3d(-2.0, 4.0, 0.5)).norm() < 1e-12);
}

void OutlineMeasuresTest::ringsTurnLeftAndHolesRightSeenFromTheNormal()
{
    for (const Eigen::Isometry3d& pose : {wallAhead(), anyPose(), Eigen::Isometry3d(Eigen::Isometry3d::Identity())}) {
        const SeenPlane wall = wallWithWindow(pose);

        const Outline outline = wall.outline();

        QVERIFY(areaSeenFrom(wall.plane.normal, outline.parts[0].ring) > 0.0);
        QVERIFY(areaSeenFrom(wall.plane.normal, outline.parts[0].holes[0]) < 0.0);
    }
}

void OutlineMeasuresTest::ringsBeginAtTheirSmallestVertexAndPartsComeInOrder()
{
    SeenPlane wall(anyPose());
    for (int k = 0; k <= 20; ++k) {
        if (k >= 6 && k <= 14)
            wall.row(k, 0.1 * k, {{0.0, 1.0}, {2.0, 3.0}, {4.0, 5.0}, {6.0, 7.0}});
        else
            wall.row(k, 0.1 * k, {{0.0, 3.0}, {4.0, 5.0}, {6.0, 7.0}});
    }

    const Outline outline = wall.outline();

    QCOMPARE(outline.parts.size(), std::size_t(3));
    for (const Outline::Polygon& part : outline.parts) {
        QCOMPARE(std::ranges::min_element(part.ring, comesBefore) - part.ring.begin(), 0);
        for (const auto& hole : part.holes)
            QCOMPARE(std::ranges::min_element(hole, comesBefore) - hole.begin(), 0);
    }
    QVERIFY(comesBefore(outline.parts[0].ring[0], outline.parts[1].ring[0]));
    QVERIFY(comesBefore(outline.parts[1].ring[0], outline.parts[2].ring[0]));
}

void OutlineMeasuresTest::verticesAndCentroidLieOnThePlane()
{
    const SeenPlane wall = wallWithWindow(anyPose());
    const auto offset = [&](const Eigen::Vector3d& p) {
        return std::abs(wall.plane.normal.dot(p) - wall.plane.distance);
    };

    const Outline outline = wall.outline();

    QVERIFY(offset(outline.centroid) < 1e-12);
    for (const Eigen::Vector3d& vertex : outline.parts[0].ring)
        QVERIFY(offset(vertex) < 1e-12);
    for (const Eigen::Vector3d& vertex : outline.parts[0].holes[0])
        QVERIFY(offset(vertex) < 1e-12);
}

void OutlineMeasuresTest::theCentroidIsThatOfTheArea()
{
    SeenPlane l(anyPose());
    for (int k = 0; k <= 20; ++k)
        l.row(k, 0.1 * k, {{0.0, k <= 10 ? 3.0 : 1.0}});

    const Outline outline = l.outline();

    // 3 m × 1 m about (1.5, 0.5) and 1 m × 1 m about (0.5, 1.5).
    const Eigen::Vector3d expected = l.pose * Eigen::Vector3d((3.0 * 1.5 + 0.5) / 4.0, (3.0 * 0.5 + 1.5) / 4.0, 0.0);
    QVERIFY((outline.centroid - expected).norm() < kGrid);
}

void OutlineMeasuresTest::turningThePlaneTurnsTheOutline()
{
    const SeenPlane level = wallWithWindow(Eigen::Isometry3d::Identity());
    const SeenPlane turned = wallWithWindow(anyPose());

    const Outline a = level.outline();
    const Outline b = turned.outline();

    QVERIFY(isClose(a.area, b.area));
    QVERIFY((anyPose() * a.centroid - b.centroid).norm() < kGrid);
    QCOMPARE(a.parts[0].ring.size(), b.parts[0].ring.size());
    for (const Eigen::Vector3d& vertex : a.parts[0].ring) {
        const Eigen::Vector3d image = anyPose() * vertex;
        QVERIFY(
            std::ranges::any_of(b.parts[0].ring, [&](const auto& other) { return (other - image).norm() < kGrid; }));
    }
}

void OutlineMeasuresTest::theOrderOfThePlanesSegmentsDoesNotMatter()
{
    SeenPlane wall = wallWithWindow(anyPose());
    const Outline sorted = wall.outline();
    std::ranges::reverse(wall.plane.segments);

    const Outline reversed = wall.outline();

    QVERIFY(sorted.parts[0].ring == reversed.parts[0].ring);
    QVERIFY(sorted.parts[0].holes == reversed.parts[0].holes);
    QCOMPARE(sorted.area, reversed.area);
}

void OutlineMeasuresTest::widthIsTheMoreLevelSide()
{
    SeenPlane tall(wallAhead());
    for (int k = 0; k <= 30; ++k)
        tall.row(k, 0.1 * k, {{0.0, 1.0}});
    SeenPlane scannedUpright(wallAhead());
    for (int k = 0; k <= 10; ++k)
        scannedUpright.slice(k, {{0.1 * k, 0.0, 0.1 * k, 3.0}});

    for (const SeenPlane* wall : {&tall, &scannedUpright}) {
        const Outline outline = wall->outline();
        QVERIFY(isClose(outline.width, 1.0));
        QVERIFY(isClose(outline.height, 3.0));
    }
}

void OutlineMeasuresTest::widthOfALevelPlaneIsTheLongerSide()
{
    // A table tilted by 3° along its short side.
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(degrees(3.0), Eigen::Vector3d::UnitY()).toRotationMatrix();
    pose.translation() = Eigen::Vector3d(0.0, 1.0, 0.5);
    SeenPlane table(pose);
    for (int k = 0; k <= 20; ++k)
        table.row(k, 0.1 * k, {{0.0, 1.2}});

    const Outline outline = table.outline();

    QVERIFY(isClose(outline.width, 2.0));
    QVERIFY(isClose(outline.height, 1.2));
}

void OutlineMeasuresTest::aKilometreAwayStillWorks()
{
    Eigen::Isometry3d pose = wallAhead();
    pose.translation() = Eigen::Vector3d(1000.0, 1000.0, 1000.0);
    SeenPlane wall(pose);
    for (int k = 0; k <= 20; ++k)
        wall.row(k, 5.0 * k, {{-1000.0, 1000.0}});

    const Outline outline = wall.outline();

    QVERIFY(std::abs(outline.area - 200000.0) < 1.0);
    QVERIFY(isClose(outline.width, 2000.0, 1e-3));
}

void OutlineMeasuresTest::segmentsWithoutLengthOrFiniteEndsAreLeftOut()
{
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 10; ++k)
        wall.slice(k, {{0.0, 0.1 * k, 2.0, 0.1 * k},
                       {7.0, 0.1 * k, std::numeric_limits<double>::quiet_NaN(), 0.1 * k},
                       {1.0, 0.1 * k, 1.0, 0.1 * k}});

    const Outline outline = wall.outline();

    QVERIFY(isClose(outline.area, 2.0));
    QVERIFY(isClose(outline.width, 2.0));
}

void OutlineMeasuresTest::segmentsMayRunEitherWay()
{
    SeenPlane wall(wallAhead());
    for (int k = 0; k <= 10; ++k) {
        if (k % 2 == 0)
            wall.slice(k, {{0.0, 0.1 * k, 2.0, 0.1 * k}, {4.0, 0.1 * k, 3.0, 0.1 * k}});
        else
            wall.slice(k, {{4.0, 0.1 * k, 3.0, 0.1 * k}, {2.0, 0.1 * k, 0.0, 0.1 * k}});
    }

    const Outline outline = wall.outline();

    QCOMPARE(outline.parts.size(), std::size_t(2));
    QVERIFY(isClose(outline.area, 3.0));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::OutlineMeasuresTest)
#include "outline_measures_test.moc"
