// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/picking.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class PickingTest : public QObject {
    Q_OBJECT

private slots:
    void aRayThroughATriangleMeetsItFromBothSides();
    void aRayBesideATriangleMeetsNothing();
    void aTriangleBehindIsNotMet();
    void aRayInTheTrianglesPlaneMeetsNothing();
    void aPointIsPassedAtItsDistance();
    void aSegmentIsPassedWhereItComesNearest();
    void aSegmentsEndsAreItsLimits();
    void aSegmentAlongTheRayIsPassedAtItsStart();
};

namespace {

const Triangle kTriangle{Eigen::Vector3d{0.0, 4.0, 0.0}, Eigen::Vector3d{2.0, 4.0, 0.0},
                         Eigen::Vector3d{0.0, 4.0, 2.0}};

Ray rayAt(const Eigen::Vector3d& origin, const Eigen::Vector3d& towards)
{
    return {origin, (towards - origin).normalized()};
}

}  // namespace

void PickingTest::aRayThroughATriangleMeetsItFromBothSides()
{
    const auto front = hit(rayAt({0.5, 0.0, 0.5}, {0.5, 1.0, 0.5}), kTriangle);
    const auto back = hit(rayAt({0.5, 10.0, 0.5}, {0.5, 9.0, 0.5}), kTriangle);

    QVERIFY(front && back);
    QCOMPARE(*front, 4.0);
    QCOMPARE(*back, 6.0);
}

void PickingTest::aRayBesideATriangleMeetsNothing()
{
    for (const Eigen::Vector3d& beside :
         {Eigen::Vector3d{1.1, 4.0, 1.1}, Eigen::Vector3d{-0.01, 4.0, 1.0}, Eigen::Vector3d{1.0, 4.0, -0.01}})
        QVERIFY(!hit(rayAt(Eigen::Vector3d::Zero(), beside), kTriangle));
}

void PickingTest::aTriangleBehindIsNotMet()
{
    QVERIFY(!hit(rayAt({0.5, 5.0, 0.5}, {0.5, 6.0, 0.5}), kTriangle));
}

void PickingTest::aRayInTheTrianglesPlaneMeetsNothing()
{
    QVERIFY(!hit(rayAt({-1.0, 4.0, 0.5}, {1.0, 4.0, 0.5}), kTriangle));
}

void PickingTest::aPointIsPassedAtItsDistance()
{
    const Ray ray = rayAt({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0});

    const auto passing = pass(ray, Eigen::Vector3d{0.3, 2.0, 0.4});

    QVERIFY(passing);
    QCOMPARE(passing->along, 2.0);
    QCOMPARE(passing->aside, 0.5);
    QCOMPARE(passing->seen(false), 0.25);
    QCOMPARE(passing->seen(true), 0.5);
    QVERIFY(!pass(ray, Eigen::Vector3d{0.0, -1.0, 0.0}));
}

void PickingTest::aSegmentIsPassedWhereItComesNearest()
{
    const Ray ray = rayAt({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0});

    // From 1 m left to 3 m right, rising from y = 2 to 6, 0.2 m above: above the ray a quarter of the way along.
    const auto passing = pass(ray, {-1.0, 2.0, 0.2}, {3.0, 6.0, 0.2});

    QVERIFY(passing);
    QCOMPARE(passing->along, 3.0);
    QVERIFY(std::abs(passing->aside - 0.2) < 1e-12);
}

void PickingTest::aSegmentsEndsAreItsLimits()
{
    const Ray ray = rayAt({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0});

    const auto passing = pass(ray, {1.0, 5.0, 0.0}, {2.0, 5.0, 0.0});

    QVERIFY(passing);
    QCOMPARE(passing->along, 5.0);
    QCOMPARE(passing->aside, 1.0);
}

void PickingTest::aSegmentAlongTheRayIsPassedAtItsStart()
{
    const Ray ray = rayAt({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0});

    const auto passing = pass(ray, {0.0, 2.0, 0.0}, {0.0, 7.0, 0.0});

    QVERIFY(passing);
    QCOMPARE(passing->along, 2.0);
    QCOMPARE(passing->aside, 0.0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PickingTest)
#include "picking_test.moc"
