// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/plane_angles.h"

#include <numbers>

#include <QTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

class PlaneAnglesTest : public QObject {
    Q_OBJECT

private slots:
    void aFloorIsLevelAndAWallUpright();
    void headingsTurnClockwiseFromStraightAhead();
    void aLevelPlaneHasNoHeading();
};

void PlaneAnglesTest::aFloorIsLevelAndAWallUpright()
{
    QCOMPARE(planeTilt({0.0, 0.0, -1.0}), 0.0);
    QCOMPARE(planeTilt({0.6, 0.8, 0.0}), std::numbers::pi / 2.0);
    QVERIFY(std::abs(planeTilt({0.5, 0.0, std::sqrt(0.75)}) - degrees(30.0)) < 1e-12);
}

void PlaneAnglesTest::headingsTurnClockwiseFromStraightAhead()
{
    QCOMPARE(*planeHeading({0.0, 1.0, 0.0}), 0.0);
    QCOMPARE(*planeHeading({1.0, 0.0, 0.0}), degrees(90.0));
    QCOMPARE(*planeHeading({0.0, -1.0, 0.0}), degrees(180.0));
    QCOMPARE(*planeHeading({-1.0, 0.0, 0.0}), degrees(270.0));
}

void PlaneAnglesTest::aLevelPlaneHasNoHeading()
{
    QVERIFY(!planeHeading({std::sin(degrees(0.9)), 0.0, std::cos(degrees(0.9))}));
    QVERIFY(planeHeading({std::sin(degrees(1.1)), 0.0, std::cos(degrees(1.1))}));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PlaneAnglesTest)
#include "plane_angles_test.moc"
