// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/scan_slice.h"

#include <cmath>
#include <numbers>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

class ScanSliceTest : public QObject {
    Q_OBJECT

private slots:
    void halfATurnIsPi();
    void degreesAndBackIsWhereWeWere();
    void bearingGrowsByOneStepPerBeam();
    void aStillHeadHasOneTilt();
    void aNoddingHeadTiltsLinearlyFromTheFirstBeamToTheLast();
    void aSingleBeamHasTheTiltOfItsSlice();
};

void ScanSliceTest::halfATurnIsPi()
{
    QCOMPARE(degrees(180.0), std::numbers::pi);
    QCOMPARE(toDegrees(std::numbers::pi / 2.0), 90.0);
}

void ScanSliceTest::degreesAndBackIsWhereWeWere()
{
    for (const double angle : {-359.0, -0.25, 0.0, 1.16, 45.0, 719.5})
        QVERIFY(std::abs(toDegrees(degrees(angle)) - angle) < 1e-12);
}

void ScanSliceTest::bearingGrowsByOneStepPerBeam()
{
    ScanSlice slice;
    slice.firstBearing = degrees(-45.0);
    slice.bearingStep = degrees(0.25);

    QCOMPARE(slice.bearing(0), degrees(-45.0));
    QVERIFY(std::abs(slice.bearing(720) - degrees(135.0)) < 1e-12);
}

void ScanSliceTest::aStillHeadHasOneTilt()
{
    ScanSlice slice;
    slice.tilt = degrees(60.0);
    slice.ranges = std::vector<double>(100, 1.0);

    QCOMPARE(slice.tiltAt(0), degrees(60.0));
    QCOMPARE(slice.tiltAt(99), degrees(60.0));
}

void ScanSliceTest::aNoddingHeadTiltsLinearlyFromTheFirstBeamToTheLast()
{
    ScanSlice slice;
    slice.tilt = degrees(60.0);
    slice.tiltEnd = degrees(62.0);
    slice.ranges = std::vector<double>(101, 1.0);

    QCOMPARE(slice.tiltAt(0), degrees(60.0));
    QVERIFY(std::abs(slice.tiltAt(25) - degrees(60.5)) < 1e-15);
    QVERIFY(std::abs(slice.tiltAt(100) - degrees(62.0)) < 1e-15);
}

void ScanSliceTest::aSingleBeamHasTheTiltOfItsSlice()
{
    ScanSlice slice;
    slice.tilt = degrees(60.0);
    slice.tiltEnd = degrees(62.0);
    slice.ranges = {1.0};

    QCOMPARE(slice.tiltAt(0), degrees(60.0));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScanSliceTest)
#include "scan_slice_test.moc"
