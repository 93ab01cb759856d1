// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_servo.h"

#include <cmath>

#include <QtTest>

#include "core/types/angle.h"
#include "devices/dynamixel/requests.h"
#include "tests/devices/dynamixel/hex_bytes.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class EmulatedServoTest : public QObject {
    Q_OBJECT

private slots:
    void packetsOfTheManualAreAnsweredAsThere();
    void bytesTakeTheirTimeOnTheLine();
    void aDamagedRequestIsNotAnswered();
    void memoryIsOfRamOrEeprom_data();
    void memoryIsOfRamOrEeprom();
    void aGoalBringsTheTorqueAndMovesTheShaft();
    void speedZeroIsAsFastAsPossible();
    void theShaftGoesOnWhenNobodyTalksToIt();
    void registeredGoalsWaitForTheAction();
    void oneRequestMovesTwoServos();
    void theReturnLevelKeepsItQuiet();
    void theLockLastsAsLongAsThePower();
    void anAlarmTurnsItOffForGood();
    void servosOfTwoAnswerInTurn();
    void twoProtectsItsEepromAndNamesWhatIsWrong();
    void aShutdownOfTwoEndsWithARestart();
    void mountingAndScaleMakeThePitch();
    void faultsComeAtTheirTurnOfTheLaser();
    void everyFaultHasASentence();
    void whatCannotBeIsRefused();
    void theSameSeedMakesTheSameFaults();
};

namespace {

constexpr DynamixelProtocol kOne = DynamixelProtocol::One;
constexpr DynamixelProtocol kTwo = DynamixelProtocol::Two;

/// A bus, and a host that asks and waits.
struct Bench {
    explicit Bench(const EmulatedServoSettings& settings, std::vector<FaultAt> faults = {})
        : protocol(settings.model == 1020 ? kTwo : kOne)
    {
        auto made = EmulatedServo::make(settings, faults);
        Q_ASSERT(made);
        servo = *made;
    }

    std::vector<std::uint8_t> ask(std::span<const std::uint8_t> bytes)
    {
        servo->receive(bytes, now);
        now += 100ms;
        std::vector<std::uint8_t> answer;
        for (const EmulatedOutput& output : servo->takeOutput(now))
            answer.insert(answer.end(), output.bytes.begin(), output.bytes.end());
        return answer;
    }
    std::string askHex(const std::string& hex) { return hexText(ask(hexBytes(hex))); }

    std::vector<DynamixelStatus> statuses(const DynamixelPacket& request)
    {
        std::vector<DynamixelStatus> all;
        for (const DynamixelPacket& packet : PacketParser{protocol}.push(ask(encodePacket(protocol, request))))
            all.push_back(statusOf(protocol, packet).value());
        return all;
    }
    DynamixelStatus status(const DynamixelPacket& request)
    {
        const auto all = statuses(request);
        return all.size() == 1 ? all[0] : DynamixelStatus{0xEE, 0xEE, {}};
    }
    int error(const DynamixelPacket& request) { return status(request).error; }
    std::uint32_t read(std::uint16_t address, std::uint16_t size, std::uint8_t id = 1)
    {
        return fromLittleEndian(status(readRequest(protocol, id, address, size)).data);
    }
    int write(std::uint16_t address, std::uint32_t value, int size, std::uint8_t id = 1)
    {
        return error(writeRequest(protocol, id, address, littleEndian(value, size)));
    }

    DynamixelProtocol protocol;
    std::shared_ptr<EmulatedServo> servo;
    std::chrono::nanoseconds now{0};
};

EmulatedServoSettings rx64()
{
    return {};
}

EmulatedServoSettings xm430()
{
    EmulatedServoSettings settings;
    settings.model = 1020;
    return settings;
}

}  // namespace

void EmulatedServoTest::packetsOfTheManualAreAnsweredAsThere()
{
    Bench bench{rx64()};

    QCOMPARE(bench.askHex("FF FF 01 02 01 FB"), std::string{"FF FF 01 02 00 FC"});
    QCOMPARE(bench.askHex("FF FF 01 04 03 18 01 DE"), std::string{"FF FF 01 02 00 FC"});
    QCOMPARE(bench.askHex("FF FF 01 05 03 1E 00 02 D6"), std::string{"FF FF 01 02 00 FC"});
    QCOMPARE(bench.askHex("FF FF 01 04 02 24 0B C9"),
             std::string{"FF FF 01 0D 00 00 02 00 00 40 00 94 26 00 00 00 F5"});
    QCOMPARE(bench.askHex("FF FF 01 04 02 00 03 F5"), std::string{"FF FF 01 05 00 40 00 18 A1"});
    QCOMPARE(bench.askHex("FF FF 01 05 03 22 FF 03 D2"), std::string{"FF FF 01 02 00 FC"});
    QCOMPARE(bench.askHex("FF FF FE 02 01 FE"), std::string{});

    Bench hot{rx64(), {{"servo-overload", 0}, {"servo-overheat", 0}}};
    QCOMPARE(hot.askHex("FF FF 01 02 01 FB"), std::string{"FF FF 01 02 24 D8"});

    EmulatedServoSettings two = xm430();
    two.registers = {{0, 1030}, {6, 38}};
    two.pitch = (166 - 2048) * degrees(360.0) / 4096.0;
    Bench xm{two};
    QCOMPARE(xm.askHex("FF FF FD 00 01 07 00 02 84 00 04 00 1D 15"),
             std::string{"FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0"});
    QCOMPARE(xm.askHex("FF FF FD 00 01 06 00 03 40 00 01 DB 66"), std::string{"FF FF FD 00 01 04 00 55 00 A1 0C"});
}

void EmulatedServoTest::bytesTakeTheirTimeOnTheLine()
{
    // 57142 baud: 175 µs a byte. Eight bytes there, 500 µs of return delay, 17 bytes back.
    Bench bench{rx64()};
    const auto byte = std::chrono::nanoseconds{std::int64_t{10} * 1'000'000'000 / 57'142};
    bench.servo->receive(hexBytes("FF FF 01 04 02 24 0B C9"), 0ns);

    QVERIFY(bench.servo->takeOutput(8 * byte + 500us + 17 * byte - 10us).empty());
    const auto output = bench.servo->takeOutput(10ms);

    QCOMPARE(output.size(), std::size_t(1));
    QVERIFY(std::chrono::abs(output[0].at - (8 * byte + 500us + 17 * byte)) < 1us);
    QVERIFY(!bench.servo->nextOutput());

    // Bytes that are handed over together leave one after the other.
    bench.servo->receive(hexBytes("FF FF 01 02 01 FB"), 20ms);
    bench.servo->receive(hexBytes("FF FF 01 02 01 FB"), 20ms);
    const auto both = bench.servo->takeOutput(1s);
    QCOMPARE(both.size(), std::size_t(2));
    QVERIFY(std::chrono::abs(both[1].at - both[0].at - 6 * byte) < 1us);
}

void EmulatedServoTest::aDamagedRequestIsNotAnswered()
{
    Bench bench{rx64()};

    QCOMPARE(bench.askHex("FF FF 01 02 01 FA"), std::string{});
    QCOMPARE(bench.askHex("01 FF FF 01 02 01 FB"), std::string{"FF FF 01 02 00 FC"});
}

void EmulatedServoTest::memoryIsOfRamOrEeprom_data()
{
    QTest::addColumn<int>("address");
    QTest::addColumn<int>("size");
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("error");

    QTest::newRow("model is read only") << 0 << 2 << 64 << 0x08;
    QTest::newRow("position is read only") << 36 << 2 << 512 << 0x08;
    QTest::newRow("a gap") << 10 << 1 << 0 << 0x08;
    QTest::newRow("behind the end") << 50 << 1 << 0 << 0x08;
    QTest::newRow("torque 2") << 24 << 1 << 2 << 0x08;
    QTest::newRow("goal 1024") << 30 << 2 << 1024 << 0x08;
    QTest::newRow("goal beyond the limits") << 30 << 2 << 100 << 0x02;
    QTest::newRow("goal within the limits") << 30 << 2 << 700 << 0x00;
    QTest::newRow("speed") << 32 << 2 << 1023 << 0x00;
    QTest::newRow("return delay") << 5 << 1 << 0 << 0x00;
    QTest::newRow("limit") << 6 << 2 << 300 << 0x00;
    QTest::newRow("return level 3") << 16 << 1 << 3 << 0x08;
}

void EmulatedServoTest::memoryIsOfRamOrEeprom()
{
    QFETCH(int, address);
    QFETCH(int, size);
    QFETCH(int, value);
    QFETCH(int, error);
    EmulatedServoSettings settings = rx64();
    settings.registers = {{6, 200}};
    Bench bench{settings};
    const auto place = static_cast<std::uint16_t>(address);

    QCOMPARE(bench.write(place, static_cast<std::uint32_t>(value), size), error);

    if (error == 0)
        QCOMPARE(bench.read(place, static_cast<std::uint16_t>(size)), std::uint32_t(value));
    QCOMPARE(bench.error(readRequest(kOne, 1, 48, 3)), 0x08);
    QCOMPARE(bench.error({1, 0x77, {}}), 0x40);
}

void EmulatedServoTest::aGoalBringsTheTorqueAndMovesTheShaft()
{
    Bench bench{rx64()};
    QCOMPARE(bench.read(24, 1), std::uint32_t(0));

    // 300 counts at 100 units: 87.98° at 66.6°/s. The eleven bytes take 1.9 ms, and the way to full speed costs half of
    // the 19.4 ms that it takes at 60 rad/s².
    bench.servo->receive(encodePacket(kOne, writeRequest(kOne, 1, 30, hexBytes("2C 03 64 00"))), bench.now);
    const auto began = bench.now;
    const double way = 300 * degrees(300.0) / 1023.0;
    const double speed = degrees(66.6);

    QVERIFY(std::abs(bench.servo->pitchAt(began + 500ms) - (0.5 - 0.0019 - 0.0097) * speed) < degrees(0.02));
    QVERIFY(std::abs(bench.servo->pitchAt(began + 2s) - way) < 1e-4);
    bench.now = began + 3s;
    bench.servo->takeOutput(bench.now);
    QCOMPARE(bench.read(24, 1), std::uint32_t(1));
    QCOMPARE(bench.read(36, 2), std::uint32_t(812));
    QCOMPARE(bench.read(46, 1), std::uint32_t(0));
    bench.write(30, 512, 2);
    QCOMPARE(bench.read(46, 1), std::uint32_t(1));
    const std::uint32_t down = bench.read(38, 2);
    QCOMPARE(down & 0x400, std::uint32_t(0x400));
    QVERIFY(std::abs(int(down & 0x3FF) - 100) <= 1);
    bench.write(24, 0, 1);
    const double free = bench.servo->pitchAt(bench.now);
    QCOMPARE(bench.servo->pitchAt(bench.now + 1s), free);
}

void EmulatedServoTest::speedZeroIsAsFastAsPossible()
{
    Bench bench{rx64()};

    bench.servo->receive(encodePacket(kOne, writeRequest(kOne, 1, 30, hexBytes("FF 03 00 00"))), 0ns);

    // 64 rpm are 384°/s: 150° take less than half a second.
    QVERIFY(bench.servo->pitchAt(200ms) > degrees(40.0));
    QVERIFY(std::abs(bench.servo->pitchAt(600ms) - degrees(511.0 * 300.0 / 1023.0)) < 1e-3);
}

void EmulatedServoTest::theShaftGoesOnWhenNobodyTalksToIt()
{
    Bench bench{rx64(), {}};
    bench.servo->receive(encodePacket(kOne, writeRequest(kOne, 1, 30, hexBytes("2C 03 64 00"))), 0ns);

    QVERIFY(std::abs(bench.servo->pitchAt(1h) - 300 * degrees(300.0) / 1023.0) < 1e-9);
}

void EmulatedServoTest::registeredGoalsWaitForTheAction()
{
    Bench bench{rx64()};

    QCOMPARE(bench.error(actionRequest(1)), 0x40);
    QCOMPARE(bench.askHex("FF FF 01 05 04 1E F4 01 E2"), std::string{"FF FF 01 02 00 FC"});
    QCOMPARE(bench.read(44, 1), std::uint32_t(1));
    QCOMPARE(bench.read(30, 2), std::uint32_t(512));
    QCOMPARE(bench.askHex("FF FF FE 02 05 FA"), std::string{});
    QCOMPARE(bench.read(30, 2), std::uint32_t(500));
    QCOMPARE(bench.read(44, 1), std::uint32_t(0));
}

void EmulatedServoTest::oneRequestMovesTwoServos()
{
    EmulatedServoSettings settings = rx64();
    settings.ids = {0, 1};
    Bench bench{settings};

    QCOMPARE(bench.askHex("FF FF FE 0E 83 1E 04 00 10 00 50 01 01 20 02 60 03 67"), std::string{});

    QCOMPARE(bench.read(30, 2, 0), std::uint32_t(0x010));
    QCOMPARE(bench.read(32, 2, 0), std::uint32_t(0x150));
    QCOMPARE(bench.read(30, 2, 1), std::uint32_t(0x220));
    QCOMPARE(bench.read(32, 2, 1), std::uint32_t(0x360));
}

void EmulatedServoTest::theReturnLevelKeepsItQuiet()
{
    for (const std::uint32_t level : {0U, 1U, 2U}) {
        EmulatedServoSettings settings = rx64();
        settings.registers = {{16, level}};
        Bench bench{settings};
        QCOMPARE(bench.statuses(pingRequest(1)).size(), std::size_t(1));
        QCOMPARE(bench.statuses(readRequest(kOne, 1, 36, 11)).size(), std::size_t(level >= 1 ? 1 : 0));
        QCOMPARE(bench.statuses(writeRequest(kOne, 1, 24, hexBytes("01"))).size(), std::size_t(level >= 2 ? 1 : 0));
    }
}

void EmulatedServoTest::theLockLastsAsLongAsThePower()
{
    Bench bench{rx64()};

    QCOMPARE(bench.write(47, 1, 1), 0);
    bench.write(47, 0, 1);
    bench.write(5, 7, 1);

    QCOMPARE(bench.read(47, 1), std::uint32_t(1));
    QCOMPARE(bench.read(5, 1), std::uint32_t(250));
    QCOMPARE(bench.write(32, 99, 2), 0);
    QCOMPARE(bench.read(32, 2), std::uint32_t(99));
}

void EmulatedServoTest::anAlarmTurnsItOffForGood()
{
    EmulatedServoSettings settings = rx64();
    settings.registers = {{14, 800}};
    Bench bench{settings, {{"servo-overheat", 0}}};

    bench.write(24, 1, 1);
    QCOMPARE(bench.error(pingRequest(1)), 0x04);
    QCOMPARE(bench.read(34, 2), std::uint32_t(0));
    bench.write(30, 600, 2);
    QCOMPARE(bench.read(46, 1), std::uint32_t(0));
    // It cools by a degree a second; below 80 °C the alarm is over and the torque limit still 0.
    bench.now += 5s;
    QCOMPARE(bench.error(pingRequest(1)), 0x00);
    QCOMPARE(bench.read(34, 2), std::uint32_t(0));
    QCOMPARE(bench.write(34, 800, 2), 0x00);
    bench.now += 2s;
    QCOMPARE(bench.read(36, 2), std::uint32_t(600));
}

void EmulatedServoTest::servosOfTwoAnswerInTurn()
{
    EmulatedServoSettings settings = xm430();
    settings.ids = {2, 1};
    Bench bench{settings};

    const auto pinged = bench.statuses(pingRequest(kBroadcastId));
    QCOMPARE(pinged.size(), std::size_t(2));
    QVERIFY(pinged[0] == (DynamixelStatus{1, 0, {0xFC, 0x03, 45}}));
    QVERIFY(pinged[1] == (DynamixelStatus{2, 0, {0xFC, 0x03, 45}}));
    const std::vector<std::uint8_t> ids{2, 1};
    const auto read = bench.statuses(syncReadRequest(132, 4, ids));
    QCOMPARE(read.size(), std::size_t(2));
    QVERIFY(read[0] == (DynamixelStatus{2, 0, {0, 8, 0, 0}}));
    const std::vector<SyncWriteData> goals{{1, hexBytes("00 04 00 00")}, {2, hexBytes("00 05 00 00")}};
    bench.statuses(syncWriteRequest(kTwo, 116, 4, goals));
    QCOMPARE(bench.read(116, 4, 1), std::uint32_t(1024));
    QCOMPARE(bench.read(116, 4, 2), std::uint32_t(1280));
}

void EmulatedServoTest::twoProtectsItsEepromAndNamesWhatIsWrong()
{
    EmulatedServoSettings settings = xm430();
    settings.registers = {{52, 1000}};
    Bench bench{settings};

    QCOMPARE(bench.write(116, 5000, 4), 0x04);
    QCOMPARE(bench.write(116, 900, 4), 0x06);
    QCOMPARE(bench.write(116, 2000, 2), 0x05);
    QCOMPARE(bench.write(132, 2000, 4), 0x07);
    QCOMPARE(bench.write(14, 0, 1), 0x07);
    QCOMPARE(bench.error(readRequest(kTwo, 1, 14, 1)), 0x07);
    QCOMPARE(bench.error({1, 0x77, {}}), 0x02);
    QCOMPARE(bench.write(9, 10, 1), 0x00);
    // A goal brings no torque here; with torque the EEPROM is closed.
    QCOMPARE(bench.write(116, 2000, 4), 0x00);
    QCOMPARE(bench.read(64, 1), std::uint32_t(0));
    QCOMPARE(bench.write(64, 1, 1), 0x00);
    QCOMPARE(bench.write(9, 20, 1), 0x07);
    bench.now += 1s;
    QCOMPARE(bench.read(132, 4), std::uint32_t(2000));
}

void EmulatedServoTest::aShutdownOfTwoEndsWithARestart()
{
    Bench bench{xm430(), {{"servo-overload", 0}}};

    bench.write(64, 1, 1);
    QCOMPARE(bench.error(pingRequest(1)), 0x80);
    QCOMPARE(bench.read(70, 1), std::uint32_t(0x20));
    QCOMPARE(bench.read(64, 1), std::uint32_t(0));
    QCOMPARE(bench.error(rebootRequest(1)), 0x80);
    QVERIFY(bench.statuses(pingRequest(1)).empty());
    bench.now += 200ms;
    QCOMPARE(bench.error(pingRequest(1)), 0x00);
    QCOMPARE(bench.read(70, 1), std::uint32_t(0));
}

void EmulatedServoTest::mountingAndScaleMakeThePitch()
{
    EmulatedServoSettings settings = rx64();
    settings.mounting = {degrees(10.0), -1.0, 1.02, -1.0, 1.0, 1.0};
    settings.pitch = degrees(10.0) - 100.25 * 1.02 * degrees(300.0) / 1023.0;
    Bench bench{settings};

    QVERIFY(std::abs(bench.servo->pitchAt(0ns) - settings.pitch) < 1e-12);
    QCOMPARE(bench.read(36, 2), std::uint32_t(612));
}

void EmulatedServoTest::faultsComeAtTheirTurnOfTheLaser()
{
    int turn = 0;
    const std::vector<FaultAt> faults{{"servo-silent", 40}};
    const auto servo =
        EmulatedServo::make(rx64(), faults, [&turn](std::chrono::nanoseconds /*now*/) { return turn; }).value();
    const auto answers = [&](std::chrono::nanoseconds now) {
        servo->receive(hexBytes("FF FF 01 02 01 FB"), now);
        return !servo->takeOutput(now + 100ms).empty();
    };

    QVERIFY(answers(0s));
    turn = 39;
    QVERIFY(answers(1s));
    turn = 40;
    QVERIFY(!answers(2s));
    turn = 0;
    QVERIFY(!answers(3s));

    // Without a laser only what is wrong from the beginning.
    const auto alone = EmulatedServo::make(rx64(), faults).value();
    alone->receive(hexBytes("FF FF 01 02 01 FB"), 0s);
    QVERIFY(!alone->takeOutput(1h).empty());
}

void EmulatedServoTest::everyFaultHasASentence()
{
    QCOMPARE(servoFaultKinds().size(), std::size_t(20));
    for (const ServoFaultKind& kind : servoFaultKinds()) {
        QVERIFY(kind.kind.starts_with("servo-"));
        QVERIFY(kind.sentence.ends_with("."));
        const std::vector<FaultAt> faults{{std::string{kind.kind}, 0}};
        QVERIFY(EmulatedServo::make(rx64(), faults));
        QVERIFY(EmulatedServo::make(xm430(), faults));
    }
}

void EmulatedServoTest::whatCannotBeIsRefused()
{
    const std::vector<FaultAt> unknown{{"servo-explodes", 0}};
    const auto made = EmulatedServo::make(rx64(), unknown);
    QVERIFY(!made);
    QCOMPARE(made.error().code, ErrorCode::Usage);
    for (const ServoFaultKind& kind : servoFaultKinds())
        QVERIFY(made.error().message.find(kind.kind) != std::string::npos);

    const std::vector<FaultAt> early{{"servo-stall", -1}};
    QVERIFY(!EmulatedServo::make(rx64(), early));
    EmulatedServoSettings settings;
    settings.model = 4711;
    QVERIFY(!EmulatedServo::make(settings));
    settings = {};
    settings.ids = {};
    QVERIFY(!EmulatedServo::make(settings));
    settings.ids = {1, 1};
    QVERIFY(!EmulatedServo::make(settings));
    settings = {};
    settings.pitch = 3.0;
    QVERIFY(!EmulatedServo::make(settings));
}

void EmulatedServoTest::theSameSeedMakesTheSameFaults()
{
    const auto talk = [](std::uint64_t seed) {
        EmulatedServoSettings settings;
        settings.seed = seed;
        Bench bench{settings, {{"servo-byte-loss", 0}, {"servo-slow", 0}}};
        std::string all;
        for (int i = 0; i < 300; ++i)
            all += bench.askHex("FF FF 01 04 02 24 0B C9") + "\n";
        return all;
    };
    QCOMPARE(talk(3), talk(3));
    QVERIFY(talk(3) != talk(4));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::EmulatedServoTest)
#include "emulated_servo_test.moc"
