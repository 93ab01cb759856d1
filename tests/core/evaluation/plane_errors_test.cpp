// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/plane_errors.h"

#include <cmath>
#include <numbers>

#include <QTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

class PlaneErrorsTest : public QObject {
    Q_OBJECT

private slots:
    void angleIsExactWhereTheArcCosineHasLostItsDigits();
    void oppositeNormalsAreTheSamePlane();
    void parallelWallsOnBothSidesAreAsFarApartAsTheyStand();
    void perpendicularPlanesAreNinetyDegreesApart();
    void summaryGivesMeanMedianAndLargest();
    void summaryOfNothingIsZero();
};

void PlaneErrorsTest::angleIsExactWhereTheArcCosineHasLostItsDigits()
{
    const double angle = 1e-9;
    const ComparedPlane a{0, {0.0, 0.0, 1.0}, 1.0};
    const ComparedPlane b{1, {std::sin(angle), 0.0, std::cos(angle)}, 1.0};

    const PlaneDifference difference = differenceOf(a, b);

    QVERIFY(std::abs(difference.angle - angle) < 1e-18);
}

void PlaneErrorsTest::oppositeNormalsAreTheSamePlane()
{
    const ComparedPlane a{0, {0.6, 0.8, 0.0}, 0.001};
    const ComparedPlane b{1, {-0.6, -0.8, 0.0}, 0.002};

    const PlaneDifference difference = differenceOf(a, b);

    QCOMPARE(difference.angle, 0.0);
    QVERIFY(std::abs(difference.distance - 0.003) < 1e-15);
}

void PlaneErrorsTest::parallelWallsOnBothSidesAreAsFarApartAsTheyStand()
{
    const ComparedPlane left{0, {-1.0, 0.0, 0.0}, 1.2};
    const ComparedPlane right{1, {1.0, 0.0, 0.0}, 1.3};

    const PlaneDifference difference = differenceOf(left, right);

    QCOMPARE(difference.angle, 0.0);
    QCOMPARE(difference.distance, 2.5);
}

void PlaneErrorsTest::perpendicularPlanesAreNinetyDegreesApart()
{
    const ComparedPlane floor{0, {0.0, 0.0, 1.0}, 1.0};
    const ComparedPlane wall{1, {0.0, 1.0, 0.0}, 1.0};

    QCOMPARE(differenceOf(floor, wall).angle, std::numbers::pi / 2.0);
}

void PlaneErrorsTest::summaryGivesMeanMedianAndLargest()
{
    const PlaneErrors even = summarise({{0.4, 1.0}, {0.1, 4.0}, {0.2, 2.0}, {0.1, 3.0}});
    const PlaneErrors odd = summarise({{0.3, 1.0}, {0.1, 9.0}, {0.2, 2.0}});

    QCOMPARE(even.count, std::size_t(4));
    QCOMPARE(even.angle.mean, 0.2);
    QCOMPARE(even.angle.median, 0.15);
    QCOMPARE(even.angle.max, 0.4);
    QCOMPARE(even.distance.median, 2.5);
    QCOMPARE(odd.angle.median, 0.2);
    QCOMPARE(odd.distance.mean, 4.0);
    QCOMPARE(odd.distance.max, 9.0);
}

void PlaneErrorsTest::summaryOfNothingIsZero()
{
    const PlaneErrors errors = summarise({});

    QCOMPARE(errors.count, std::size_t(0));
    QCOMPARE(errors.angle.max, 0.0);
    QCOMPARE(errors.distance.mean, 0.0);
}

PLANEWRIGHT_TEST(PlaneErrorsTest)
#include "plane_errors_test.moc"
