// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/measure_planes.h"

#include <QTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

class MeasurePlanesTest : public QObject {
    Q_OBJECT

private slots:
    void aPointBeyondAPlaneHasAPositiveDistance();
    void facingWallsAreAsFarApartAsTheRoomIsWide();
    void planesAtAnAngleHaveNoDistance();
    void nearlyParallelPlanesAreMeasuredAtTheirMiddles();
};

namespace {

Plane plane(const Eigen::Vector3d& normal, double distance)
{
    Plane made;
    made.normal = normal;
    made.distance = distance;
    return made;
}

}  // namespace

void MeasurePlanesTest::aPointBeyondAPlaneHasAPositiveDistance()
{
    const Plane wall = plane({0.0, 1.0, 0.0}, 3.0);

    QCOMPARE(distanceTo(wall, {7.0, 5.0, -1.0}), 2.0);
    QCOMPARE(distanceTo(wall, {0.0, 0.0, 0.0}), -3.0);
}

void MeasurePlanesTest::facingWallsAreAsFarApartAsTheRoomIsWide()
{
    const PlanePair pair = measurePlanes(plane({1.0, 0.0, 0.0}, 1.5), {1.5, 2.0, 0.0},  //
                                         plane({-1.0, 0.0, 0.0}, 0.9), {-0.9, 4.0, 1.0});

    QCOMPARE(pair.angle, 0.0);
    QVERIFY(std::abs(*pair.distance - 2.4) < 1e-12);
}

void MeasurePlanesTest::planesAtAnAngleHaveNoDistance()
{
    const PlanePair pair = measurePlanes(plane({1.0, 0.0, 0.0}, 1.0), {1.0, 0.0, 0.0},  //
                                         plane({-0.6, 0.8, 0.0}, 2.0), {-1.2, 1.6, 0.0});

    QVERIFY(std::abs(pair.angle - std::acos(0.6)) < 1e-12);
    QVERIFY(!pair.distance);
}

void MeasurePlanesTest::nearlyParallelPlanesAreMeasuredAtTheirMiddles()
{
    // A door leaf that stands 2° open in front of its wall at y = 3: its middle, 0.4 m from the hinge, is off by
    // 0.4 sin 2°; the wall's middle at the hinge's height is off by nothing.
    const double turn = degrees(2.0);
    const Plane wall = plane({0.0, 1.0, 0.0}, 3.0);
    const Plane leaf = plane({std::sin(turn), std::cos(turn), 0.0}, 3.0 * std::cos(turn));
    const Eigen::Vector3d leafMiddle{0.4 * std::cos(turn), 3.0 - 0.4 * std::sin(turn), 0.0};

    const PlanePair pair = measurePlanes(wall, {0.0, 3.0, 0.0}, leaf, leafMiddle);

    QVERIFY(std::abs(pair.angle - turn) < 1e-12);
    QVERIFY(std::abs(*pair.distance - 0.2 * std::sin(turn)) < 1e-12);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MeasurePlanesTest)
#include "measure_planes_test.moc"
