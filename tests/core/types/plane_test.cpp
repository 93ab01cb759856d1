// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/plane.h"

#include <cmath>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class PlaneTest : public QObject {
    Q_OBJECT

private slots:
    void aNegativeDistanceTurnsThePlaneRound();
    void aPositiveDistanceLeavesThePlaneAsItIs();
    void aPlaneThroughTheOriginLooksUpThenForwardThenRight_data();
    void aPlaneThroughTheOriginLooksUpThenForwardThenRight();
    void noComponentIsANegativeZero();
    void theTurnedPlaneHoldsTheSamePoints();
};

void PlaneTest::aNegativeDistanceTurnsThePlaneRound()
{
    Eigen::Vector3d normal{0.6, 0.0, -0.8};
    double distance = -2.0;

    makeCanonical(normal, distance);

    QVERIFY(normal == Eigen::Vector3d(-0.6, 0.0, 0.8));
    QCOMPARE(distance, 2.0);
}

void PlaneTest::aPositiveDistanceLeavesThePlaneAsItIs()
{
    Eigen::Vector3d normal{0.0, 0.0, -1.0};
    double distance = 1.25;

    makeCanonical(normal, distance);

    QVERIFY(normal == Eigen::Vector3d(0.0, 0.0, -1.0));
    QCOMPARE(distance, 1.25);
}

void PlaneTest::aPlaneThroughTheOriginLooksUpThenForwardThenRight_data()
{
    QTest::addColumn<double>("nx");
    QTest::addColumn<double>("ny");
    QTest::addColumn<double>("nz");
    QTest::addColumn<bool>("turns");
    QTest::newRow("up stays") << -0.6 << 0.0 << 0.8 << false;
    QTest::newRow("down turns") << 0.6 << 0.0 << -0.8 << true;
    QTest::newRow("forward stays") << -0.6 << 0.8 << 0.0 << false;
    QTest::newRow("backward turns") << 0.6 << -0.8 << 0.0 << true;
    QTest::newRow("right stays") << 1.0 << 0.0 << 0.0 << false;
    QTest::newRow("left turns") << -1.0 << 0.0 << 0.0 << true;
}

void PlaneTest::aPlaneThroughTheOriginLooksUpThenForwardThenRight()
{
    QFETCH(double, nx);
    QFETCH(double, ny);
    QFETCH(double, nz);
    QFETCH(bool, turns);
    const Eigen::Vector3d given{nx, ny, nz};
    for (double distance : {0.0, -0.0}) {
        Eigen::Vector3d normal = given;

        makeCanonical(normal, distance);

        QVERIFY(normal == (turns ? Eigen::Vector3d(-given) : given));
        QVERIFY(!std::signbit(distance));
    }
}

void PlaneTest::noComponentIsANegativeZero()
{
    Eigen::Vector3d normal{0.0, -0.0, -1.0};
    double distance = -3.0;

    makeCanonical(normal, distance);

    QVERIFY(!std::signbit(normal.x()));
    QVERIFY(!std::signbit(normal.y()));
}

void PlaneTest::theTurnedPlaneHoldsTheSamePoints()
{
    const Eigen::Vector3d point{1.0, 2.0, 2.0};
    Eigen::Vector3d normal = Eigen::Vector3d(-2.0, 1.0, -2.0) / 3.0;
    double distance = normal.dot(point);  // −4/3

    makeCanonical(normal, distance);

    QVERIFY(distance > 0.0);
    QVERIFY(std::abs(normal.dot(point) - distance) < 1e-15);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PlaneTest)
#include "plane_test.moc"
