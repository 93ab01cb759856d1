// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/board_scale.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

class BoardScaleTest : public QObject {
    Q_OBJECT

private slots:
    void countsStandForAnglesAboutTheMiddle();
    void aServoThatIsMountedTheOtherWayCountsBackwards();
    void limitsAreRoundedInwards();
    void limitsEndWhereTheServoEnds();
    void theSpeedLimitIsInCountsASecond();
    void whatIsNoMountingIsRefused_data();
    void whatIsNoMountingIsRefused();
    void whatIsNoServoIsRefused();
};

namespace {

using board::HelloReply;
using board::Scale;

constexpr double kCount = degrees(300.0) / 1023.0;

HelloReply rx64()
{
    HelloReply board;
    board.proto = 1;
    board.servoModel = 64;
    board.highest = 1023;
    board.middle = 512;
    board.spanMdeg = 300'000;
    return board;
}

TiltMounting level()
{
    return {degrees(90.0), 1.0, 1.0, degrees(10.0), degrees(170.0), degrees(120.0)};
}

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-9;
}

}  // namespace

void BoardScaleTest::countsStandForAnglesAboutTheMiddle()
{
    const Scale scale = Scale::of(rx64(), level()).value();

    QVERIFY(isNear(scale.pitch(512), degrees(90.0)));
    QVERIFY(isNear(scale.pitch(516), degrees(90.0) + 4 * kCount));
    QVERIFY(isNear(scale.counts(degrees(90.0) - 10 * kCount), 502.0));
    QVERIFY(isNear(scale.step(), kCount));
    QCOMPARE(scale.nearest(degrees(90.0) + 2.4 * kCount), 514);
    QCOMPARE(scale.nearest(degrees(90.0) + 2.6 * kCount), 515);
}

void BoardScaleTest::aServoThatIsMountedTheOtherWayCountsBackwards()
{
    TiltMounting mounting = level();
    mounting.sign = -1.0;
    mounting.scale = 1.02;

    const Scale scale = Scale::of(rx64(), mounting).value();

    QVERIFY(isNear(scale.pitch(522), degrees(90.0) - 10 * 1.02 * kCount));
    QCOMPARE(scale.nearest(degrees(90.0) - 1.02 * kCount), 513);
    QVERIFY(scale.low() < scale.high());
    QVERIFY(isNear(scale.lowest(), scale.pitch(scale.high())));
    QVERIFY(scale.lowest() >= degrees(10.0) && scale.lowest() < degrees(10.0) + scale.step());
    QVERIFY(scale.highest() <= degrees(170.0) && scale.highest() > degrees(170.0) - scale.step());
}

void BoardScaleTest::limitsAreRoundedInwards()
{
    TiltMounting mounting = level();
    mounting.lowest = mounting.zeroPitch - 100.3 * kCount;
    mounting.highest = mounting.zeroPitch + 50.0 * kCount;

    const Scale scale = Scale::of(rx64(), mounting).value();

    QCOMPARE(scale.low(), 412);
    QCOMPARE(scale.high(), 562);
    QCOMPARE(scale.nearest(degrees(-90.0)), 412);
    QCOMPARE(scale.nearest(degrees(400.0)), 562);
}

void BoardScaleTest::limitsEndWhereTheServoEnds()
{
    TiltMounting mounting = level();
    mounting.lowest = degrees(-300.0);
    mounting.highest = degrees(300.0);

    const Scale scale = Scale::of(rx64(), mounting).value();

    QCOMPARE(scale.low(), 0);
    QCOMPARE(scale.high(), 1023);
}

void BoardScaleTest::theSpeedLimitIsInCountsASecond()
{
    TiltMounting mounting = level();
    mounting.fastest = 250.7 * kCount;
    QCOMPARE(Scale::of(rx64(), mounting).value().topSpeed(), 250);
    mounting.fastest = 0.01 * kCount;
    QCOMPARE(Scale::of(rx64(), mounting).value().topSpeed(), 1);
    mounting.fastest = 900.0;
    QCOMPARE(Scale::of(rx64(), mounting).value().topSpeed(), 65535);
}

void BoardScaleTest::whatIsNoMountingIsRefused_data()
{
    QTest::addColumn<double>("sign");
    QTest::addColumn<double>("scale");
    QTest::addColumn<double>("lowest");
    QTest::addColumn<double>("highest");
    QTest::addColumn<double>("fastest");
    QTest::newRow("sign") << 0.5 << 1.0 << 0.0 << 1.0 << 1.0;
    QTest::newRow("scale") << 1.0 << 0.0 << 0.0 << 1.0 << 1.0;
    QTest::newRow("limits") << 1.0 << 1.0 << 1.0 << 1.0 << 1.0;
    QTest::newRow("speed") << 1.0 << 1.0 << 0.0 << 1.0 << 0.0;
    QTest::newRow("no number") << 1.0 << 1.0 << 0.0 << std::numeric_limits<double>::quiet_NaN() << 1.0;
    QTest::newRow("out of reach") << 1.0 << 1.0 << 20.0 << 21.0 << 1.0;
}

void BoardScaleTest::whatIsNoMountingIsRefused()
{
    QFETCH(double, sign);
    QFETCH(double, scale);
    QFETCH(double, lowest);
    QFETCH(double, highest);
    QFETCH(double, fastest);

    const Result<Scale> none = Scale::of(rx64(), {0.5, sign, scale, lowest, highest, fastest});

    QVERIFY(!none);
    QCOMPARE(none.error().code, ErrorCode::Usage);
}

void BoardScaleTest::whatIsNoServoIsRefused()
{
    HelloReply none = rx64();
    none.highest = 0;
    QCOMPARE(Scale::of(none, level()).error().code, ErrorCode::NoDevice);
    HelloReply offCentre = rx64();
    offCentre.middle = 2000;
    QCOMPARE(Scale::of(offCentre, level()).error().code, ErrorCode::NoDevice);
    HelloReply wide = rx64();
    wide.spanMdeg = 0xFFFFFFFF;
    QCOMPARE(Scale::of(wide, level()).error().code, ErrorCode::NoDevice);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::BoardScaleTest)
#include "board_scale_test.moc"
