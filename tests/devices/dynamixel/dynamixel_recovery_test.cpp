// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QtTest>

#include "devices/dynamixel/requests.h"
#include "tests/devices/dynamixel/moving_servo.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

/// A servo that an alarm has turned off is turned on again by a person, and by nothing else.
class DynamixelRecoveryTest : public QObject {
    Q_OBJECT

private slots:
    void recoverySetsTheTorqueLimitAndTheGoalWhereItStands();
    void recoveryWaitsUntilItIsCoolEnough();
    void recoveryIsRefusedASecondTime();
    void recoveryOfTwoRestartsTheServo();
    void aSupplyThatIsBackNeedsNoRecovery();
};

void DynamixelRecoveryTest::recoverySetsTheTorqueLimitAndTheGoalWhereItStands()
{
    Moving rig{"servo-overload", withRegister({}, 14, 900)};
    QVERIFY(!rig.sample());
    const double there = rig.truth(rig.clock.now());
    rig.link->forget();

    VERIFY_DONE(rig.tilt->recover({}));

    std::vector<std::string> writes;
    for (const DynamixelPacket& write : rig.writes())
        writes.push_back(hexText(write.parameters));
    QCOMPARE(writes.size(), std::size_t(4));
    QCOMPARE(writes[0], std::string{"20 01 00"});  // the slowest speed, goal, torque limit 900, torque
    QCOMPARE(writes[1].substr(0, 2), std::string{"1E"});
    QCOMPARE(writes[2], std::string{"22 84 03"});
    QCOMPARE(writes[3], std::string{"18 01"});
    QVERIFY(std::abs(rig.truth(rig.clock.now() + 2s) - there) < degrees(0.3));
    QVERIFY(rig.tilt->motor().trouble.empty());
    QVERIFY(!rig.tilt->moveTo(degrees(10.0), 1.0));
    VERIFY_DONE(rig.tilt->arm({}));
    VERIFY_DONE(rig.tilt->moveTo(degrees(10.0), 1.0));
    VERIFY_DONE(rig.arrive());
}

void DynamixelRecoveryTest::recoveryWaitsUntilItIsCoolEnough()
{
    Moving rig{"servo-overheat"};
    QVERIFY(!rig.sample());
    rig.link->forget();

    // 82 °C at the beginning, 1 °C less every second; from 80 °C it must fall below 70.
    rig.clock.advance(11s);
    const auto early = rig.tilt->recover({});
    QVERIFY(!early);
    VERIFY_SAYS(early.error().message, {"too warm", "below 70 °C"});
    QVERIFY(rig.writes().empty());
    rig.clock.advance(3s);
    VERIFY_DONE(rig.tilt->recover({}));
    VERIFY_DONE(rig.tilt->arm({}));
}

void DynamixelRecoveryTest::recoveryIsRefusedASecondTime()
{
    Moving rig{"servo-overload"};
    QVERIFY(!rig.sample());
    VERIFY_DONE(rig.tilt->recover({}));
    {
        // The load is still there.
        const std::scoped_lock lock(*rig.mutex);
        rig.servo->receive(
            encodePacket(DynamixelProtocol::One, writeRequest(DynamixelProtocol::One, 1, 34, littleEndian(0, 2))),
            rig.clock.now());
    }
    rig.clock.advance(100ms);
    QVERIFY(!rig.tilt->arm({}));

    const auto again = rig.tilt->recover({});

    QVERIFY(!again);
    VERIFY_SAYS(again.error().message, {"recovered before", "connect again"});
    VERIFY_DONE(rig.tilt->connect({}));
    VERIFY_DONE(rig.tilt->recover({}));
}

void DynamixelRecoveryTest::recoveryOfTwoRestartsTheServo()
{
    Moving rig{"servo-overload", emulated(1020)};
    QVERIFY(!rig.sample());
    QVERIFY(!rig.tilt->arm({}));
    rig.link->forget();
    const double there = rig.truth(rig.clock.now());

    VERIFY_DONE(rig.tilt->recover({}));

    QVERIFY(rig.writes().empty());
    int reboots = 0;
    for (const WrittenRequest& request : rig.link->written())
        reboots += request.packet.code == 0x08 ? 1 : 0;
    QCOMPARE(reboots, 1);
    VERIFY_DONE(rig.tilt->arm({}));
    QVERIFY(std::abs(rig.truth(rig.clock.now() + 1s) - there) < degrees(0.3));
    VERIFY_DONE(rig.tilt->moveTo(degrees(10.0), 1.0));
    VERIFY_DONE(rig.arrive());
}

void DynamixelRecoveryTest::aSupplyThatIsBackNeedsNoRecovery()
{
    // Below its limit by 0.2 V until the limit is set lower.
    Moving rig{"servo-voltage"};
    QVERIFY(!rig.sample());
    const auto early = rig.tilt->recover({});
    QVERIFY(!early);
    VERIFY_SAYS(early.error().message, {"wrong supply", "5.8 V"});
    {
        const std::scoped_lock lock(*rig.mutex);
        rig.servo->receive(
            encodePacket(DynamixelProtocol::One, writeRequest(DynamixelProtocol::One, 1, 12, littleEndian(50, 1))),
            rig.clock.now());
    }
    rig.clock.advance(100ms);

    QVERIFY(rig.sample());
    QVERIFY(!rig.tilt->moveTo(0.0, 1.0));
    VERIFY_DONE(rig.tilt->arm({}));
    VERIFY_DONE(rig.tilt->moveTo(0.0, 1.0));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DynamixelRecoveryTest)
#include "dynamixel_recovery_test.moc"
