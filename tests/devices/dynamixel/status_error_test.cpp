// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/status_error.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class StatusErrorTest : public QObject {
    Q_OBJECT

private slots:
    void everyBitOfOneIsAboutTheServoOrTheRequest();
    void bitsOfBothKindsComeTogether();
    void everyNumberOfTwoIsAboutTheRequest();
    void theHardwareErrorOfTwoNamesTheAlarm();
    void alarmsAreNamed();
    void alarmsGoThereAndBack();
};

namespace {

constexpr DynamixelProtocol kInOne = DynamixelProtocol::One;
constexpr DynamixelProtocol kInTwo = DynamixelProtocol::Two;

}  // namespace

void StatusErrorTest::everyBitOfOneIsAboutTheServoOrTheRequest()
{
    QVERIFY(decodeStatusError(kInOne, 0x01).alarm == (ServoAlarm{.voltage = true}));
    QVERIFY(decodeStatusError(kInOne, 0x04).alarm == (ServoAlarm{.overheating = true}));
    QVERIFY(decodeStatusError(kInOne, 0x20).alarm == (ServoAlarm{.overload = true}));
    for (const int bit : {0, 2, 5}) {
        const StatusError error = decodeStatusError(kInOne, static_cast<std::uint8_t>(1U << bit));
        QVERIFY(error.hasAlarm);
        QVERIFY(error.request == RequestFault::None);
    }
    for (const int bit : {1, 3, 6}) {
        const StatusError error = decodeStatusError(kInOne, static_cast<std::uint8_t>(1U << bit));
        QVERIFY(!error.hasAlarm);
        QVERIFY(error.request == RequestFault::Refused);
        QVERIFY(!error.refusal.empty());
    }
    QVERIFY(decodeStatusError(kInOne, 0x10).request == RequestFault::Damaged);
    QVERIFY(!decodeStatusError(kInOne, 0x10).hasAlarm);
    QVERIFY(!decodeStatusError(kInOne, 0x00).hasAlarm);
    QVERIFY(decodeStatusError(kInOne, 0x00).request == RequestFault::None);
}

void StatusErrorTest::bitsOfBothKindsComeTogether()
{
    const StatusError error = decodeStatusError(kInOne, 0x24 | 0x02 | 0x10);

    QVERIFY(error.alarm == (ServoAlarm{.overheating = true, .overload = true}));
    QVERIFY(error.request == RequestFault::Refused);
}

void StatusErrorTest::everyNumberOfTwoIsAboutTheRequest()
{
    QVERIFY(decodeStatusError(kInTwo, 0x00).request == RequestFault::None);
    for (const int number : {1, 2, 4, 5, 6, 7, 99}) {
        const StatusError error = decodeStatusError(kInTwo, static_cast<std::uint8_t>(number));
        QVERIFY(error.request == RequestFault::Refused);
        QVERIFY(!error.refusal.empty());
        QVERIFY(!error.hasAlarm);
    }
    QVERIFY(decodeStatusError(kInTwo, 3).request == RequestFault::Damaged);
    QVERIFY(decodeStatusError(kInTwo, 0x80).hasAlarm);
    QVERIFY(decodeStatusError(kInTwo, 0x80).request == RequestFault::None);
    QVERIFY(decodeStatusError(kInTwo, 0x87).request == RequestFault::Refused);
}

void StatusErrorTest::theHardwareErrorOfTwoNamesTheAlarm()
{
    QVERIFY(decodeHardwareError(0x01) == (ServoAlarm{.voltage = true}));
    QVERIFY(decodeHardwareError(0x04) == (ServoAlarm{.overheating = true}));
    QVERIFY(decodeHardwareError(0x08) == (ServoAlarm{.encoder = true}));
    QVERIFY(decodeHardwareError(0x10) == (ServoAlarm{.shock = true}));
    QVERIFY(decodeHardwareError(0x20) == (ServoAlarm{.overload = true}));
    QVERIFY(!decodeHardwareError(0x42).any());
}

void StatusErrorTest::alarmsAreNamed()
{
    QCOMPARE((ServoAlarm{.overheating = true, .overload = true}.text()), std::string{"overload, overheating"});
    QCOMPARE(ServoAlarm{}.text(), std::string{});
}

void StatusErrorTest::alarmsGoThereAndBack()
{
    const ServoAlarm all{true, true, true, true, true};
    QCOMPARE(int(alarmBits(kInOne, all)), 0x25);
    QCOMPARE(int(alarmBits(kInTwo, all)), 0x3D);
    QVERIFY(decodeHardwareError(alarmBits(kInTwo, all)) == all);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::StatusErrorTest)
#include "status_error_test.moc"
