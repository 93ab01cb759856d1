// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_motor.h"

#include <cmath>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class EmulatedMotorTest : public QObject {
    Q_OBJECT

private slots:
    void standsWhereItIs();
    void aLongWayIsATrapezoidOfSpeed();
    void aShortWayIsATriangleOfSpeed();
    void itGoesDownAsItGoesUp();
    void aNewGoalFartherOnIsReachedWithoutAStop();
    void aMotorThatIsFasterThanItMayBeSlowsDown();
    void aGoalBehindItMakesItBrakeFirst();
    void aGoalTooNearToStopAtIsOvershotAndComeBackTo();
    void aStopTakesTheTimeOfItsBrakes();
    void aBlockedMotorStandsAtOnce();
    void itSwingsAboutItsGoal();
    void thePastStaysWhatItWas();
    void itNeverJumps();
    void goingToWhereItIsTakesNoTime();
};

namespace {

/// 10 rad/s² and no swinging, so that a formula by hand is the whole truth.
constexpr MotorDynamics kRigid{10.0, 0.0, std::chrono::milliseconds{20}, std::chrono::milliseconds{8}};

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-7;  // moments are whole nanoseconds
}

}  // namespace

void EmulatedMotorTest::standsWhereItIs()
{
    const EmulatedMotor motor{0.7, kRigid};

    for (const auto at : {0s, 1s, 3600s}) {
        QCOMPARE(motor.angle(at), 0.7);
        QCOMPARE(motor.speed(at), 0.0);
        QVERIFY(!motor.isMoving(at));
    }
}

void EmulatedMotorTest::aLongWayIsATrapezoidOfSpeed()
{
    // 1 rad at 2 rad/s: 0.2 s and 0.2 rad to speed, 0.3 s over 0.6 rad, 0.2 s and 0.2 rad to a stop.
    EmulatedMotor motor{0.0, kRigid};

    motor.goTo(1.0, 2.0, 10s);

    QVERIFY(isNear(motor.angle(10s), 0.0));
    QVERIFY(isNear(motor.angle(10s + 100ms), 0.05));
    QVERIFY(isNear(motor.speed(10s + 100ms), 1.0));
    QVERIFY(isNear(motor.angle(10s + 200ms), 0.2));
    QVERIFY(isNear(motor.angle(10s + 350ms), 0.5));
    QVERIFY(isNear(motor.speed(10s + 350ms), 2.0));
    QVERIFY(isNear(motor.angle(10s + 500ms), 0.8));
    QVERIFY(isNear(motor.angle(10s + 600ms), 0.95));
    QVERIFY(isNear(motor.speed(10s + 600ms), 1.0));
    QVERIFY(motor.isMoving(10s + 699ms));
    QVERIFY(!motor.isMoving(10s + 701ms));
    QCOMPARE(motor.angle(10s + 701ms), 1.0);
    QCOMPARE(motor.angle(1h), 1.0);
}

void EmulatedMotorTest::aShortWayIsATriangleOfSpeed()
{
    // 0.1 rad never reaches 2 rad/s: 0.1 s up to 1 rad/s and 0.1 s down.
    EmulatedMotor motor{0.0, kRigid};

    motor.goTo(0.1, 2.0, 0s);

    QVERIFY(isNear(motor.angle(100ms), 0.05));
    QVERIFY(isNear(motor.speed(100ms), 1.0));
    QVERIFY(isNear(motor.angle(150ms), 0.0875));
    QVERIFY(motor.isMoving(199ms));
    QVERIFY(!motor.isMoving(201ms));
}

void EmulatedMotorTest::itGoesDownAsItGoesUp()
{
    EmulatedMotor up{0.0, kRigid};
    EmulatedMotor down{0.0, kRigid};
    up.goTo(1.0, 2.0, 0s);
    down.goTo(-1.0, 2.0, 0s);

    for (int i = 0; i < 80; ++i) {
        QCOMPARE(up.angle(i * 10ms), -down.angle(i * 10ms));
        QCOMPARE(up.speed(i * 10ms), -down.speed(i * 10ms));
    }
}

void EmulatedMotorTest::aNewGoalFartherOnIsReachedWithoutAStop()
{
    EmulatedMotor motor{0.0, kRigid};
    motor.goTo(1.0, 2.0, 0s);

    // At 0.3 s it is at 0.4 rad with 2 rad/s; 1.6 rad more: 1.4 rad in 0.7 s and 0.2 s to a stop.
    motor.goTo(2.0, 2.0, 300ms);

    QVERIFY(isNear(motor.speed(600ms), 2.0));
    QVERIFY(isNear(motor.angle(600ms), 1.0));
    QVERIFY(isNear(motor.angle(1s), 1.8));
    QVERIFY(!motor.isMoving(1201ms));
    QVERIFY(isNear(motor.angle(1200ms), 2.0));
}

void EmulatedMotorTest::aMotorThatIsFasterThanItMayBeSlowsDown()
{
    EmulatedMotor motor{0.0, kRigid};
    motor.goTo(2.0, 2.0, 0s);

    // At 0.3 s at 0.4 rad with 2 rad/s. Down to 1 rad/s: 0.1 s, 0.15 rad. Stopping takes 0.1 s, 0.05 rad. The other
    // 1.4 rad take 1.4 s.
    motor.goTo(2.0, 1.0, 300ms);

    QVERIFY(isNear(motor.angle(400ms), 0.55));
    QVERIFY(isNear(motor.speed(400ms), 1.0));
    QVERIFY(isNear(motor.speed(1s), 1.0));
    QVERIFY(isNear(motor.angle(1s), 1.15));
    QVERIFY(isNear(motor.angle(1800ms), 1.95));
    QVERIFY(isNear(motor.angle(1900ms), 2.0));
    QVERIFY(motor.isMoving(1899ms));
    QVERIFY(!motor.isMoving(1901ms));
}

void EmulatedMotorTest::aGoalBehindItMakesItBrakeFirst()
{
    EmulatedMotor motor{0.0, kRigid};
    motor.goTo(1.0, 2.0, 0s);

    // At 0.3 s at 0.4 rad with 2 rad/s: stops at 0.6 rad at 0.5 s, then 0.6 rad back: 0.2 s, 0.1 s, 0.2 s.
    motor.goTo(0.0, 2.0, 300ms);

    QVERIFY(isNear(motor.angle(400ms), 0.55));
    QVERIFY(isNear(motor.angle(500ms), 0.6));
    QVERIFY(isNear(motor.speed(500ms), 0.0));
    QVERIFY(isNear(motor.angle(700ms), 0.4));
    QVERIFY(isNear(motor.speed(700ms), -2.0));
    QVERIFY(isNear(motor.angle(800ms), 0.2));
    QVERIFY(isNear(motor.angle(1s), 0.0));
    QVERIFY(!motor.isMoving(1001ms));
}

void EmulatedMotorTest::aGoalTooNearToStopAtIsOvershotAndComeBackTo()
{
    EmulatedMotor motor{0.0, kRigid};
    motor.goTo(1.0, 2.0, 0s);

    // At 0.3 s at 0.4 rad it cannot stop before 0.6 rad; from there 0.1 rad back takes 0.1 s up and 0.1 s down.
    motor.goTo(0.5, 2.0, 300ms);

    QVERIFY(isNear(motor.angle(500ms), 0.6));
    QVERIFY(isNear(motor.angle(600ms), 0.55));
    QVERIFY(isNear(motor.angle(700ms), 0.5));
    QVERIFY(!motor.isMoving(701ms));
}

void EmulatedMotorTest::aStopTakesTheTimeOfItsBrakes()
{
    for (const double way : {1.0, -1.0}) {
        EmulatedMotor motor{0.0, kRigid};
        motor.goTo(way, 2.0, 0s);

        motor.stop(300ms);

        QVERIFY(isNear(motor.angle(400ms), way * 0.55));
        QVERIFY(motor.isMoving(499ms));
        QVERIFY(!motor.isMoving(501ms));
        QVERIFY(isNear(motor.angle(1h), way * 0.6));
    }
}

void EmulatedMotorTest::aBlockedMotorStandsAtOnce()
{
    EmulatedMotor motor{0.0, kRigid};
    motor.goTo(1.0, 2.0, 0s);

    motor.block(300ms);

    QVERIFY(isNear(motor.angle(300ms), 0.4));
    QVERIFY(isNear(motor.angle(1h), 0.4));
    QVERIFY(!motor.isMoving(300ms));
    motor.goTo(0.5, 2.0, 2h);
    QVERIFY(isNear(motor.angle(3h), 0.5));
}

void EmulatedMotorTest::itSwingsAboutItsGoal()
{
    // At full speed the swing begins with all of the overshoot; its first top comes after a quarter of its period.
    MotorDynamics dynamics = kRigid;
    dynamics.overshoot = 0.003;
    EmulatedMotor motor{0.0, dynamics};
    motor.goTo(1.0, 2.0, 0s);

    const double top = 0.003 * std::exp(-5.0 / 8.0);
    QVERIFY(isNear(motor.angle(700ms), 1.0));
    QVERIFY(isNear(motor.angle(705ms), 1.0 + top));
    QVERIFY(isNear(motor.angle(715ms), 1.0 - 0.003 * std::exp(-15.0 / 8.0)));
    QVERIFY(std::abs(motor.angle(800ms) - 1.0) < 0.003 * std::exp(-12.0));
    QVERIFY(!motor.isMoving(705ms));
}

void EmulatedMotorTest::thePastStaysWhatItWas()
{
    EmulatedMotor motor{0.0, kRigid};
    motor.goTo(1.0, 2.0, 1s);
    const EmulatedMotor before = motor;

    motor.goTo(-1.0, 1.0, 1s + 300ms);
    motor.stop(1s + 600ms);
    motor.block(1s + 650ms);

    for (int i = 0; i < 130; ++i) {
        QCOMPARE(motor.angle(i * 10ms), before.angle(i * 10ms));
        QCOMPARE(motor.isMoving(i * 10ms), before.isMoving(i * 10ms));
    }
    QVERIFY(!motor.isMoving(500ms));
    QVERIFY(motor.isMoving(1100ms));
}

void EmulatedMotorTest::itNeverJumps()
{
    // Goals come at any moment of a motion; the angle never changes faster than the fastest speed.
    EmulatedMotor motor{0.0};
    std::uint32_t state = 12345;
    const auto random = [&state] {
        state = state * 1664525 + 1013904223;
        return (state >> 8) / double(1 << 24);
    };
    double last = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const auto now = i * 5ms;
        if (i % 7 == 0)
            motor.goTo(2.0 * random() - 1.0, 0.1 + 4.9 * random(), now);
        if (i % 97 == 0)
            motor.stop(now);
        const double angle = motor.angle(now);
        // 5 rad/s, and the swing of 3 mrad at 50 Hz.
        QVERIFY(std::abs(angle - last) <= 5.0 * 0.005 + 0.006);
        QVERIFY(std::abs(motor.speed(now)) <= 5.0 + 1e-6);
        last = angle;
    }
}

void EmulatedMotorTest::goingToWhereItIsTakesNoTime()
{
    EmulatedMotor motor{0.3, kRigid};

    motor.goTo(0.3, 1.0, 1s);

    QVERIFY(!motor.isMoving(1s));
    QCOMPARE(motor.angle(1s), 0.3);
    QCOMPARE(motor.angle(2s), 0.3);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::EmulatedMotorTest)
#include "emulated_motor_test.moc"
