// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/servo_state.h"

#include <numbers>
#include <set>

#include <QtTest>

#include "core/types/angle.h"
#include "devices/dynamixel/servo_checks.h"
#include "tests/devices/dynamixel/hex_bytes.h"
#include "tests/devices/dynamixel/rx64.h"
#include "tests/test_program.h"

namespace planewright {

class ServoStateTest : public QObject {
    Q_OBJECT

private slots:
    void modelsAreFoundByProtocolAndNumber();
    void everyTableReadsWhatItDecodes();
    void theStateOfTheManualIsDecoded();
    void bitTenIsADirection();
    void theStateOfTwoIsDecoded();
    void turnsOfTwoAreLeftOutWithoutTorque();
    void settingsOfAnRx64AreDecoded();
    void aTorqueLimitOfZeroIsAShutdown();
    void whatMustNotMoveIsRefused_data();
    void whatMustNotMoveIsRefused();
    void aMountingThatCannotBeIsRefused();
};

namespace {

const DynamixelModel& model(DynamixelProtocol protocol, std::uint16_t number)
{
    const DynamixelModel* found = findDynamixelModel(protocol, number);
    Q_ASSERT(found != nullptr);
    return *found;
}

const DynamixelModel& xm430()
{
    return model(DynamixelProtocol::Two, 1020);
}

/// A servo as it leaves its factory.
RegisterImage factoryImage(const DynamixelModel& kind)
{
    RegisterImage image;
    if (kind.protocol == DynamixelProtocol::One) {
        image.store(0, hexBytes("40 00 18 01 22 FA 00 00"));
        image.store(8, std::vector<std::uint8_t>{static_cast<std::uint8_t>(kind.highestCount & 0xFF),
                                                 static_cast<std::uint8_t>(kind.highestCount >> 8)});
        image.store(10, hexBytes("00 50 3C BE FF 03 02 24 24"));
        image.store(26, hexBytes("01 01 20 20"));
        image.store(34, hexBytes("FF 03"));
    } else {
        image.store(0, hexBytes("FC 03 00 00 00 00 2D 01 01 FA 00 03 FF 02"));
        image.store(31, hexBytes("50 A0 00 5F 00"));
        image.store(44, hexBytes("5E 01 00 00 FF 0F 00 00 00 00 00 00"));
        image.store(63, hexBytes("34"));
        image.store(68, hexBytes("02 00 00"));
    }
    return image;
}

}  // namespace

void ServoStateTest::modelsAreFoundByProtocolAndNumber()
{
    const auto name = [](DynamixelProtocol protocol, std::uint16_t number) { return model(protocol, number).name; };
    QVERIFY(name(DynamixelProtocol::One, 64) == "RX-64");
    QVERIFY(name(DynamixelProtocol::One, 12) == "AX-12");
    QVERIFY(name(DynamixelProtocol::One, 29) == "MX-28");
    QVERIFY(name(DynamixelProtocol::One, 310) == "MX-64");
    QVERIFY(name(DynamixelProtocol::One, 320) == "MX-106");
    QVERIFY(name(DynamixelProtocol::Two, 30) == "MX-28(2.0)");
    QVERIFY(name(DynamixelProtocol::Two, 1020) == "XM430-W350");
    QVERIFY(name(DynamixelProtocol::Two, 1030) == "XM430-W210");
    QVERIFY(findDynamixelModel(DynamixelProtocol::Two, 64) == nullptr);
    QVERIFY(findDynamixelModel(DynamixelProtocol::One, 4711) == nullptr);
    QVERIFY(knownDynamixelModels().find("RX-64") != std::string::npos);
    QVERIFY(std::abs(rx64().countAngle - degrees(0.293255)) < degrees(1e-6));
    QVERIFY(std::abs(xm430().countAngle - degrees(0.087890625)) < 1e-15);
}

void ServoStateTest::everyTableReadsWhatItDecodes()
{
    for (const DynamixelModel& kind : dynamixelModels()) {
        const ControlTable& t = *kind.table;
        std::set<int> read;
        const auto note = [&](ServoRegion region) {
            for (int i = 0; i < region.count; ++i)
                read.insert(region.first + i);
            QVERIFY(region.count != 2 || kind.protocol == DynamixelProtocol::Two);
        };
        for (const ServoRegion region : t.settings)
            note(region);
        for (const ServoRegion region : t.drive)
            note(region);
        note(t.state);
        for (const ServoRegister& place : {t.model,
                                           t.firmware,
                                           t.returnDelay,
                                           t.driveMode,
                                           t.operatingMode,
                                           t.lowestGoal,
                                           t.highestGoal,
                                           t.temperatureLimit,
                                           t.lowestVoltage,
                                           t.highestVoltage,
                                           t.maxTorque,
                                           t.returnLevel,
                                           t.shutdown,
                                           t.speedLimit,
                                           t.torqueEnable,
                                           t.goal,
                                           t.speed,
                                           t.marginClockwise,
                                           t.marginCounterClockwise,
                                           t.torqueLimit,
                                           t.hardwareError,
                                           t.position,
                                           t.presentSpeed,
                                           t.load,
                                           t.voltage,
                                           t.temperature,
                                           t.moving,
                                           t.lock,
                                           t.torqueMode}) {
            for (int i = 0; i < place.size; ++i)
                QVERIFY2(read.contains(place.address + i), qPrintable(QString::number(place.address + i)));
        }
        QVERIFY(t.goal.address >= t.motion.first && t.goal.address + t.goal.size <= t.motion.first + t.motion.count);
        QVERIFY(t.speed.address >= t.motion.first && t.speed.address + t.speed.size <= t.motion.first + t.motion.count);
    }
}

void ServoStateTest::theStateOfTheManualIsDecoded()
{
    RegisterImage image;
    image.store(36, hexBytes("00 02 00 00 40 00 94 26 00 00 00"));

    const ServoState state = decodeState(rx64(), image, true);

    QCOMPARE(state.position, 512);
    QCOMPARE(state.speed, 0.0);
    QCOMPARE(state.load, 64.0 / 1023.0);
    QVERIFY(std::abs(state.voltage - 14.8) < 1e-12);
    QCOMPARE(state.temperature, 38.0);
    QVERIFY(!state.moving);
}

void ServoStateTest::bitTenIsADirection()
{
    RegisterImage image;
    image.store(36, hexBytes("00 02 64 04 FF 07 94 26 00 00 01"));

    const ServoState state = decodeState(rx64(), image, true);

    QVERIFY(std::abs(state.speed + 100.0 * 0.111 * 2.0 * std::numbers::pi / 60.0) < 1e-12);
    QCOMPARE(state.load, -1.0);
    QVERIFY(state.moving);
}

void ServoStateTest::theStateOfTwoIsDecoded()
{
    RegisterImage image;
    //               122 123 PWM   load  speed -10   position    trajectories            voltage
    image.store(122, hexBytes("01 00 00 00 57 FE F6 FF FF FF A6 00 00 00 00 00 00 00 00 00 00 00 78 00 29"));

    const ServoState state = decodeState(xm430(), image, true);

    QCOMPARE(state.position, 166);
    QVERIFY(std::abs(state.speed + 10.0 * 0.229 * 2.0 * std::numbers::pi / 60.0) < 1e-12);
    QVERIFY(std::abs(state.load - -425.0 / 1193.0) < 1e-12);
    QVERIFY(std::abs(state.voltage - 12.0) < 1e-12);
    QCOMPARE(state.temperature, 41.0);
    QVERIFY(state.moving);
}

void ServoStateTest::turnsOfTwoAreLeftOutWithoutTorque()
{
    const auto position = [](const char* hex, bool withTurns) {
        RegisterImage image;
        image.store(132, hexBytes(hex));
        return decodeState(xm430(), image, withTurns).position;
    };
    QCOMPARE(position("94 11 00 00", false), 4500 - 4096);
    QCOMPARE(position("FE FF FF FF", false), 4094);
    QCOMPARE(position("94 11 00 00", true), 4500);
    QCOMPARE(position("FE FF FF FF", true), -2);
}

void ServoStateTest::settingsOfAnRx64AreDecoded()
{
    const ServoSettings settings = decodeSettings(rx64(), factoryImage(rx64()));

    QCOMPARE(settings.firmware, 24);
    QCOMPARE(settings.lowestGoal, 0);
    QCOMPARE(settings.highestGoal, 1023);
    QCOMPARE(settings.mostSpeed, 1023);
    QCOMPARE(settings.returnLevel, 2);
    QVERIFY(settings.returnDelay == std::chrono::microseconds{500});
    QCOMPARE(settings.temperatureLimit, 80.0);
    QVERIFY(std::abs(settings.lowestVoltage - 6.0) < 1e-12);
    QVERIFY(std::abs(settings.highestVoltage - 19.0) < 1e-12);
    QCOMPARE(settings.maxTorque, 1023);
    QVERIFY(settings.shutdown == (ServoAlarm{.overheating = true, .overload = true}));
    QCOMPARE(settings.tolerance, 2);
    QCOMPARE(decodeSettings(xm430(), factoryImage(xm430())).mostSpeed, 350);
}

void ServoStateTest::aTorqueLimitOfZeroIsAShutdown()
{
    RegisterImage image = factoryImage(rx64());
    QVERIFY(!decodeDrive(rx64(), image).isShutDown);
    image.store(34, hexBytes("00 00"));
    QVERIFY(decodeDrive(rx64(), image).isShutDown);

    RegisterImage two = factoryImage(xm430());
    QVERIFY(!decodeDrive(xm430(), two).isShutDown);
    two.store(70, hexBytes("20"));
    QVERIFY(decodeDrive(xm430(), two).isShutDown);
    QVERIFY(decodeDrive(xm430(), two).alarm == (ServoAlarm{.overload = true}));
}

void ServoStateTest::whatMustNotMoveIsRefused_data()
{
    QTest::addColumn<int>("protocol");
    QTest::addColumn<int>("number");
    QTest::addColumn<int>("address");
    QTest::addColumn<QString>("bytes");
    QTest::addColumn<QString>("says");

    QTest::newRow("an RX-64 as it comes") << 1 << 64 << 0 << "40 00"
                                          << "";
    QTest::newRow("wheel") << 1 << 64 << 6 << "00 00 00 00"
                           << "both of its angle limits are 0";
    QTest::newRow("limits crossed") << 1 << 64 << 6 << "00 03 00 02"
                                    << "the wrong way round";
    QTest::newRow("several turns") << 1 << 29 << 6 << "FF 0F FF 0F"
                                   << "several turns";
    QTest::newRow("locked") << 1 << 64 << 47 << "01"
                            << "locked";
    QTest::newRow("torque mode") << 1 << 310 << 70 << "01"
                                 << "torque and no position";
    QTest::newRow("no answers") << 1 << 64 << 16 << "00"
                                << "answers no reads";
    QTest::newRow("an XM430 as it comes") << 2 << 1020 << 11 << "03"
                                          << "";
    QTest::newRow("2.0: wheel") << 2 << 1020 << 11 << "01"
                                << "operating mode 1";
    QTest::newRow("2.0: slave") << 2 << 1020 << 10 << "02"
                                << "slave";
    QTest::newRow("2.0: times for speeds") << 2 << 1020 << 10 << "05"
                                           << "time of a motion";
    QTest::newRow("2.0: reverse is fine") << 2 << 1020 << 10 << "01"
                                          << "";
    QTest::newRow("2.0: no speed") << 2 << 1020 << 44 << "00 00 00 00"
                                   << "speed limit 0";
    QTest::newRow("2.0: limits 0") << 2 << 1020 << 48 << "00 00 00 00 00 00 00 00"
                                   << "both of its angle limits are 0";
}

void ServoStateTest::whatMustNotMoveIsRefused()
{
    QFETCH(int, protocol);
    QFETCH(int, number);
    QFETCH(int, address);
    QFETCH(QString, bytes);
    QFETCH(QString, says);
    const DynamixelModel& kind =
        model(protocol == 1 ? DynamixelProtocol::One : DynamixelProtocol::Two, static_cast<std::uint16_t>(number));
    RegisterImage image = factoryImage(kind);
    image.store(static_cast<std::uint16_t>(address), hexBytes(bytes.toStdString()));

    const auto reason = reasonNotToMove(kind, image);

    QCOMPARE(reason.has_value(), !says.isEmpty());
    QVERIFY2(!reason || reason->find(says.toStdString()) != std::string::npos,
             qPrintable(QString::fromStdString(reason.value_or(""))));
}

void ServoStateTest::aMountingThatCannotBeIsRefused()
{
    const TiltMounting sound{0.0, -1.0, 1.02, -1.0, 1.0, 0.8};
    QVERIFY(!faultOf(sound));
    const auto with = [&](double TiltMounting::*member, double value) {
        TiltMounting mounting = sound;
        mounting.*member = value;
        return faultOf(mounting).has_value();
    };
    QVERIFY(with(&TiltMounting::sign, 0.0));
    QVERIFY(with(&TiltMounting::sign, -2.0));
    QVERIFY(with(&TiltMounting::scale, 0.0));
    QVERIFY(with(&TiltMounting::scale, -1.0));
    QVERIFY(with(&TiltMounting::lowest, 1.0));
    QVERIFY(with(&TiltMounting::fastest, 0.0));
    QVERIFY(with(&TiltMounting::zeroPitch, std::numeric_limits<double>::quiet_NaN()));
    QVERIFY(with(&TiltMounting::highest, std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ServoStateTest)
#include "servo_state_test.moc"
