// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/servo_angles.h"

#include <limits>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/devices/dynamixel/rx64.h"
#include "tests/test_program.h"

namespace planewright {

class ServoAnglesTest : public QObject {
    Q_OBJECT

private slots:
    void theMiddleIsTheZeroPitch();
    void aCountIsThreeHundredDegreesOver1023();
    void signAndScaleTurnAndStretch();
    void theNearestCountIsTheNearest();
    void theNarrowerLimitsHold();
    void limitsThatAreWholeCountsAreReached();
    void speedsAreNeverZeroAndNeverFaster();
};

namespace {

ServoAngles angles(const TiltMounting& mounting, int lowest = 0, int highest = 1023)
{
    return {rx64(), mounting, lowest, highest, 1023};
}

constexpr TiltMounting kPlain{0.0, 1.0, 1.0, degrees(-90.0), degrees(90.0), degrees(60.0)};

}  // namespace

void ServoAnglesTest::theMiddleIsTheZeroPitch()
{
    TiltMounting mounting = kPlain;
    mounting.zeroPitch = degrees(12.5);

    QCOMPARE(angles(mounting).pitch(512), degrees(12.5));
    QCOMPARE(angles(mounting).counts(degrees(12.5)), 512.0);
}

void ServoAnglesTest::aCountIsThreeHundredDegreesOver1023()
{
    // 341 counts are a third of 300°; four counts are the publication's step, rounded there to 1.16°.
    QVERIFY(std::abs(angles(kPlain).pitch(512 + 341) - degrees(100.0)) < 1e-12);
    QVERIFY(std::abs(4.0 * angles(kPlain).resolution() - degrees(1200.0 / 1023.0)) < 1e-15);
}

void ServoAnglesTest::signAndScaleTurnAndStretch()
{
    TiltMounting mounting = kPlain;
    mounting.sign = -1.0;
    mounting.scale = 1.023;  // 0.3° a count

    QVERIFY(std::abs(angles(mounting).pitch(522) - degrees(-3.0)) < 1e-12);
    QVERIFY(std::abs(angles(mounting).resolution() - degrees(0.3)) < 1e-12);
    QCOMPARE(angles(mounting).nearestCount(degrees(3.1)), 502);
}

void ServoAnglesTest::theNearestCountIsTheNearest()
{
    const ServoAngles a = angles(kPlain);
    const double count = a.resolution();

    QCOMPARE(a.nearestCount(10.4 * count), 522);
    QCOMPARE(a.nearestCount(10.6 * count), 523);
    QCOMPARE(a.nearestCount(-10.6 * count), 501);
}

void ServoAnglesTest::theNarrowerLimitsHold()
{
    const ServoAngles a = angles(kPlain, 500, 1000);

    // Below by the servo: 12 counts under the middle; above by the mounting: 90° are 306.9 counts.
    QVERIFY(std::abs(a.lowestPitch() - -12.0 * a.resolution()) < 1e-12);
    QCOMPARE(a.highestPitch(), degrees(90.0));
    QCOMPARE(a.nearestCount(-10.0), 500);
    QCOMPARE(a.nearestCount(10.0), 512 + 306);
    QVERIFY(a.allows(degrees(90.0)));
    QVERIFY(!a.allows(degrees(90.1)));
    QVERIFY(!a.allows(-12.1 * a.resolution()));
    TiltMounting far = kPlain;
    far.zeroPitch = degrees(300.0);
    QVERIFY(angles(far).isEmpty());
    QVERIFY(!angles(far).allows(0.0));
    TiltMounting open = kPlain;
    open.lowest = -std::numeric_limits<double>::infinity();
    QCOMPARE(angles(open).lowestCount(), 0);
}

void ServoAnglesTest::limitsThatAreWholeCountsAreReached()
{
    TiltMounting mounting = kPlain;
    mounting.lowest = -100 * degrees(300.0) / 1023.0;
    mounting.highest = 100 * degrees(300.0) / 1023.0;
    for (const double sign : {1.0, -1.0}) {
        mounting.sign = sign;
        QCOMPARE(angles(mounting).lowestCount(), 412);
        QCOMPARE(angles(mounting).highestCount(), 612);
    }
}

void ServoAnglesTest::speedsAreNeverZeroAndNeverFaster()
{
    const ServoAngles a = angles(kPlain);
    const double unit = degrees(0.111 * 6.0);  // 1 rpm = 6°/s

    QVERIFY(std::abs(a.speedOf(1) - unit) < 1e-12);
    QCOMPARE(a.speedValue(1e-9), 1);
    QCOMPARE(a.speedValue(0.0), 1);
    QCOMPARE(a.speedValue(70.9 * unit), 70);
    QCOMPARE(a.speedValue(70.0 * unit), 70);
    QCOMPARE(a.speedValue(1e9), 1023);
    QCOMPARE(a.fastest(), degrees(60.0));
    TiltMounting fast = kPlain;
    fast.fastest = 100.0;
    QVERIFY(std::abs(angles(fast).fastest() - 1023 * unit) < 1e-9);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ServoAnglesTest)
#include "servo_angles_test.moc"
