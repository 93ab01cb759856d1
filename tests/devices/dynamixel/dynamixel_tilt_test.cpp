// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/dynamixel_tilt.h"

#include <limits>

#include <QtTest>

#include "devices/dynamixel/requests.h"
#include "tests/devices/dynamixel/servo_rig.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class DynamixelTiltTest : public QObject {
    Q_OBJECT

private slots:
    void connectFindsEveryModel_data();
    void connectFindsEveryModel();
    void connectWritesNothing();
    void connectStopsWhatWasLeftMoving();
    void whatMustNotMoveIsRefused_data();
    void whatMustNotMoveIsRefused();
    void aBusWithoutAServoSaysWhatToLookAt();
    void aStopEndsConnecting();
    void nothingMovesBeforeItIsArmed();
    void armingHoldsItWhereItStands_data();
    void armingHoldsItWhereItStands();
    void aShaftBeyondItsLimitsIsNotArmed();
    void aWatchdogThatHasBittenIsTurnedOff();
    void itGoesWhereItIsToldAndSaysWhenItIsThere();
    void aSampleIsTrueAtItsMoment();
    void speedsAreNeverZero();
    void whatIsBeyondALimitIsRefused();
    void aServoThatDoesNotAnswerWritesIsReadBack();
    void anotherMountingTurnsItTheOtherWay();
    void theEepromIsNeverWritten_data();
    void theEepromIsNeverWritten();
    void aDeadlineAndAStopEndASample();
    void theLinkIsCounted();
};

namespace {

bool isNear(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance;
}

}  // namespace

void DynamixelTiltTest::connectFindsEveryModel_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<QString>("identity");
    QTest::addColumn<double>("count");
    QTest::addColumn<double>("fastest");

    QTest::newRow("RX-64") << 64 << "RX-64, number 1, firmware 24" << 300.0 / 1023.0 << 120.0;
    QTest::newRow("AX-12") << 12 << "AX-12, number 1, firmware 24" << 300.0 / 1023.0 << 120.0;
    QTest::newRow("MX-28") << 29 << "MX-28, number 1, firmware 36" << 360.0 / 4096.0 << 120.0;
    QTest::newRow("XM430") << 1020 << "XM430-W350, number 1, firmware 45" << 360.0 / 4096.0 << 120.0;
}

void DynamixelTiltTest::connectFindsEveryModel()
{
    QFETCH(int, model);
    QFETCH(QString, identity);
    QFETCH(double, count);
    QFETCH(double, fastest);
    ServoRig rig{emulated(static_cast<std::uint16_t>(model))};

    const auto connected = rig.tilt->connect({});

    QVERIFY2(connected, connected ? "" : connected.error().message.c_str());
    QCOMPARE(QString::fromStdString(rig.tilt->identity()), identity);
    QVERIFY(isNear(rig.tilt->resolution(), degrees(count), 1e-12));
    QVERIFY(isNear(rig.tilt->lowest(), degrees(-80.0), 1e-12));
    QVERIFY(isNear(rig.tilt->highest(), degrees(80.0), 1e-12));
    QVERIFY(isNear(rig.tilt->fastest(), degrees(fastest), 1e-12));
    QVERIFY(rig.tilt->motor().trouble.empty());
    QVERIFY(rig.tilt->motor().temperature == 38.0);
    // Moves and arrives, with each of them.
    QVERIFY(rig.tilt->arm({}));
    QVERIFY(rig.tilt->moveTo(degrees(20.0), degrees(60.0)));
    const auto arrived = rig.arrive();
    QVERIFY2(arrived, arrived ? "" : arrived.error().message.c_str());
    QVERIFY(isNear(arrived->pitch, degrees(20.0), 0.51 * degrees(count)));
}

void DynamixelTiltTest::connectWritesNothing()
{
    for (const std::uint16_t model : std::initializer_list<std::uint16_t>{64, 1020}) {
        ServoRig rig{emulated(model)};

        QVERIFY(rig.tilt->connect({}));

        QVERIFY(!rig.link->written().empty());
        for (const WrittenRequest& request : rig.link->written())
            QVERIFY(request.packet.code == 0x01 || request.packet.code == 0x02);
    }
}

void DynamixelTiltTest::connectStopsWhatWasLeftMoving()
{
    ServoRig rig;
    // A program before this one has sent it away and died.
    rig.servo->receive(
        encodePacket(DynamixelProtocol::One, writeRequest(DynamixelProtocol::One, 1, 30, littleEndian(0x0064'02BC, 4))),
        0ns);
    rig.servo->takeOutput(100ms);
    rig.clock.advance(100ms);

    QVERIFY(rig.tilt->connect({}));

    const double here = rig.truth(rig.clock.now());
    QVERIFY(here > degrees(3.0) && here < degrees(25.0));
    QVERIFY(isNear(rig.truth(rig.clock.now() + 5s), here, degrees(2.0)));
    QVERIFY(!rig.tilt->moveTo(0.0, 0.5));
}

void DynamixelTiltTest::whatMustNotMoveIsRefused_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("address");
    QTest::addColumn<int>("value");
    QTest::addColumn<QString>("words");

    QTest::newRow("wheel") << 64 << 8 << 0 << "RX-64,both of its angle limits are 0,address 6,connect again";
    QTest::newRow("locked") << 64 << 47 << 1 << "locked,power off and on";
    QTest::newRow("answers pings alone") << 64 << 16 << 0 << "status return level is 0";
    QTest::newRow("unknown model") << 64 << 0 << 4711 << "number 4711,RX-64";
    QTest::newRow("2.0: wheel") << 1020 << 11 << 1 << "operating mode 1,set address 11 to 3";
    QTest::newRow("2.0: answers pings alone") << 1020 << 68 << 0 << "status return level is 0";
}

void DynamixelTiltTest::whatMustNotMoveIsRefused()
{
    QFETCH(int, model);
    QFETCH(int, address);
    QFETCH(int, value);
    QFETCH(QString, words);
    ServoRig rig{withRegister(emulated(static_cast<std::uint16_t>(model)), static_cast<std::uint16_t>(address),
                              static_cast<std::uint32_t>(value))};

    const auto connected = rig.tilt->connect({});

    QVERIFY(!connected);
    QCOMPARE(connected.error().code, ErrorCode::NoDevice);
    for (const QString& word : words.split(','))
        QVERIFY2(says(connected.error().message, {word.toStdString()}), connected.error().message.c_str());
    QVERIFY(says(connected.error().message, {"bus: servo 1"}));
    QCOMPARE(rig.tilt->arm({}).error().code, ErrorCode::Usage);
    QVERIFY(!rig.tilt->moveTo(0.0, 0.1));
    for (const WrittenRequest& request : rig.link->written())
        QVERIFY(request.packet.code != kWrite);
}

void DynamixelTiltTest::aBusWithoutAServoSaysWhatToLookAt()
{
    EmulatedServoSettings settings;
    settings.ids = {5};
    DynamixelOptions options;
    options.id = 9;
    ServoRig rig{settings, {}, options};

    const auto connected = rig.tilt->connect({});

    QVERIFY(!connected);
    QCOMPARE(connected.error().code, ErrorCode::NoDevice);
    QVERIFY(says(connected.error().message, {"servo 9", "57142 baud", "1.0", "2.0", "power"}));
    // Old answers are let pass for 50 ms; then two pings of 1.0 and two of 2.0, each for as long as its bytes, the
    // adapter, 10 ms and 150 ms of patience take.
    QVERIFY(rig.clock.now() < 900ms);
}

void DynamixelTiltTest::aStopEndsConnecting()
{
    ServoRig rig;
    std::stop_source stop;
    stop.request_stop();

    const auto connected = rig.tilt->connect(stop.get_token());

    QVERIFY(!connected);
    QCOMPARE(connected.error().code, ErrorCode::Interrupted);
}

void DynamixelTiltTest::nothingMovesBeforeItIsArmed()
{
    ServoRig rig;
    QCOMPARE(rig.tilt->moveTo(0.1, 0.1).error().code, ErrorCode::Usage);
    QCOMPARE(rig.tilt->arm({}).error().code, ErrorCode::Usage);
    QVERIFY(!rig.sample());
    QVERIFY(rig.tilt->connect({}));

    const auto moved = rig.tilt->moveTo(0.1, 0.1);

    QVERIFY(!moved);
    QCOMPARE(moved.error().code, ErrorCode::Usage);
    QVERIFY(says(moved.error().message, {"not armed"}));
    // Angles are measured all the same.
    QVERIFY(isNear(rig.sample().value().value().pitch, 0.0, degrees(0.15)));
}

void DynamixelTiltTest::armingHoldsItWhereItStands_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("goalAddress");
    QTest::addColumn<int>("goal");

    QTest::newRow("RX-64") << 64 << 30 << 900;
    QTest::newRow("XM430") << 1020 << 116 << 3900;
}

void DynamixelTiltTest::armingHoldsItWhereItStands()
{
    QFETCH(int, model);
    QFETCH(int, goalAddress);
    QFETCH(int, goal);
    EmulatedServoSettings settings = emulated(static_cast<std::uint16_t>(model));
    settings.pitch = degrees(-25.0);
    // The goal that it remembers is far away: torque alone would make it jump there.
    ServoRig rig{withRegister(settings, static_cast<std::uint16_t>(goalAddress), static_cast<std::uint32_t>(goal))};
    QVERIFY(rig.tilt->connect({}));
    const auto began = rig.clock.now();

    QVERIFY(rig.tilt->arm({}));

    for (int i = 0; i < 100; ++i)
        QVERIFY(isNear(rig.truth(began + i * 20ms), degrees(-25.0), degrees(0.15)));
    // Goal first, then torque.
    std::vector<int> addresses;
    for (const WrittenRequest& request : rig.link->written()) {
        if (request.packet.code == kWrite)
            addresses.push_back(request.packet.parameters[0]);
    }
    const auto torque = std::find(addresses.begin(), addresses.end(), model == 64 ? 24 : 64);
    QVERIFY(torque != addresses.end());
    QVERIFY(std::find(addresses.begin(), torque, goalAddress) != torque);
}

void DynamixelTiltTest::aShaftBeyondItsLimitsIsNotArmed()
{
    EmulatedServoSettings settings;
    settings.pitch = degrees(-60.0);
    ServoRig rig{withRegister(settings, 6, 400)};
    QVERIFY(rig.tilt->connect({}));

    const auto armed = rig.tilt->arm({});

    QVERIFY(!armed);
    QVERIFY(says(armed.error().message, {"-60.1°", "by hand"}));
    QVERIFY(isNear(rig.truth(rig.clock.now() + 1s), degrees(-60.0), 1e-9));
}

void DynamixelTiltTest::aWatchdogThatHasBittenIsTurnedOff()
{
    ServoRig rig{withRegister(emulated(1020), 98, 255)};

    QVERIFY(rig.ready());

    QVERIFY(rig.tilt->moveTo(degrees(10.0), 1.0));
    QVERIFY(rig.arrive());
    // An older firmware has none, and is not asked for it.
    ServoRig old{withRegister(emulated(1020), 6, 37)};
    QVERIFY(old.ready());
    for (const WrittenRequest& request : old.link->written())
        QVERIFY(request.packet.code != kWrite || request.packet.parameters[0] != 98);
}

void DynamixelTiltTest::itGoesWhereItIsToldAndSaysWhenItIsThere()
{
    ServoRig rig;
    QVERIFY(rig.ready());
    const auto began = rig.clock.now();

    QVERIFY(rig.tilt->moveTo(degrees(30.0), degrees(60.0)));
    const auto first = rig.sample();
    const auto arrived = rig.arrive();

    QVERIFY(first.value().value().moving);
    QVERIFY(arrived);
    // 102 counts are 29.91°, the nearest; 90 units are 59.94°/s.
    QVERIFY(isNear(arrived->pitch, 102 * degrees(300.0) / 1023.0, 1e-9));
    QVERIFY(isNear(rig.tilt->nearestPitch(degrees(30.0)), arrived->pitch, 1e-12));
    const double seconds = std::chrono::duration<double>(arrived->at - began).count();
    QVERIFY(seconds > 29.91 / 59.94 && seconds < 29.91 / 59.94 + 0.1);
    QVERIFY(isNear(rig.truth(rig.clock.now()), arrived->pitch, degrees(0.15)));
}

void DynamixelTiltTest::aSampleIsTrueAtItsMoment()
{
    for (const std::uint16_t model : std::initializer_list<std::uint16_t>{64, 1020}) {
        ServoRig rig{emulated(model)};
        QVERIFY(rig.ready());
        QVERIFY(rig.tilt->moveTo(degrees(70.0), degrees(100.0)));
        int moving = 0;
        for (int i = 0; i < 150; ++i) {
            const auto sample = rig.sample().value().value();
            moving += sample.moving ? 1 : 0;
            // The moment is known to half of the return delay, 0.25 ms, and the angle to half a count.
            const double bound = 0.5 * rig.tilt->resolution() + degrees(100.0) * 0.26e-3;
            QVERIFY(isNear(sample.pitch, rig.truth(sample.at), bound));
            QVERIFY(sample.at < rig.clock.now());
        }
        QVERIFY(moving > 50);
    }
}

void DynamixelTiltTest::speedsAreNeverZero()
{
    ServoRig rig;
    QVERIFY(rig.ready());
    rig.link->forget();

    QVERIFY(rig.tilt->moveTo(degrees(2.0), 1e-6));
    QVERIFY(rig.tilt->moveTo(degrees(2.0), degrees(66.7)));

    std::vector<std::uint32_t> speeds;
    for (const WrittenRequest& request : rig.link->written()) {
        if (request.packet.code == kWrite)
            speeds.push_back(fromLittleEndian(std::span{request.packet.parameters}.subspan(3, 2)));
    }
    QVERIFY(speeds == (std::vector<std::uint32_t>{1, 100}));
}

void DynamixelTiltTest::whatIsBeyondALimitIsRefused()
{
    ServoRig rig;
    QVERIFY(rig.ready());
    rig.link->forget();
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

    for (const auto& [pitch, speed] : std::vector<std::pair<double, double>>{{degrees(80.1), 1.0},
                                                                             {degrees(-80.1), 1.0},
                                                                             {kNaN, 1.0},
                                                                             {0.0, 0.0},
                                                                             {0.0, -1.0},
                                                                             {0.0, degrees(121.0)},
                                                                             {0.0, kNaN}}) {
        const auto moved = rig.tilt->moveTo(pitch, speed);
        QVERIFY(!moved);
        QCOMPARE(moved.error().code, ErrorCode::Usage);
        QVERIFY(says(moved.error().message, {"°"}));
    }
    QVERIFY(rig.link->written().empty());
    QVERIFY(rig.tilt->moveTo(degrees(80.0), degrees(120.0)));
    QVERIFY(rig.arrive());
}

void DynamixelTiltTest::aServoThatDoesNotAnswerWritesIsReadBack()
{
    for (const auto& [model, address] : std::vector<std::pair<std::uint16_t, std::uint16_t>>{{64, 16}, {1020, 68}}) {
        ServoRig rig{withRegister(emulated(model), address, 1)};

        QVERIFY(rig.ready());
        QVERIFY(rig.tilt->moveTo(degrees(10.0), degrees(60.0)));
        QVERIFY(rig.arrive());
        QVERIFY(rig.tilt->moveTo(degrees(-10.0), degrees(30.0)));
        rig.sample().value();
        QVERIFY(rig.tilt->hold());

        const double here = rig.truth(rig.clock.now());
        QVERIFY(here > degrees(5.0));
        QVERIFY(isNear(rig.truth(rig.clock.now() + 3s), here, degrees(1.0)));
        QCOMPARE(rig.tilt->health().lost, std::uint64_t(0));
    }
}

void DynamixelTiltTest::anotherMountingTurnsItTheOtherWay()
{
    DynamixelOptions options;
    options.mounting = {degrees(5.0), -1.0, 1.01, degrees(-60.0), degrees(60.0), 2.0};
    ServoRig rig{{}, {}, options};
    QVERIFY(rig.ready());

    QVERIFY(rig.tilt->moveTo(degrees(35.0), 1.0));
    const auto arrived = rig.arrive();

    QVERIFY(arrived);
    QVERIFY(isNear(arrived->pitch, degrees(35.0), 0.51 * rig.tilt->resolution()));
    QVERIFY(isNear(rig.truth(rig.clock.now()), arrived->pitch, degrees(0.15)));
    QVERIFY(isNear(rig.tilt->resolution(), 1.01 * degrees(300.0) / 1023.0, 1e-12));
}

void DynamixelTiltTest::theEepromIsNeverWritten_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("firstRam");

    QTest::newRow("RX-64") << 64 << 24;
    QTest::newRow("XM430") << 1020 << 64;
}

void DynamixelTiltTest::theEepromIsNeverWritten()
{
    QFETCH(int, model);
    QFETCH(int, firstRam);
    ServoRig rig{emulated(static_cast<std::uint16_t>(model)), {{"servo-overload", 10}}};
    QVERIFY(rig.ready());
    QVERIFY(rig.tilt->moveTo(degrees(10.0), 1.0));
    QVERIFY(rig.arrive());
    rig.turn = 10;
    QVERIFY(!rig.arrive());
    QVERIFY(rig.tilt->recover({}));
    QVERIFY(rig.tilt->arm({}));
    QVERIFY(rig.tilt->moveTo(degrees(-10.0), 1.0));
    QVERIFY(rig.tilt->hold());

    int writes = 0;
    for (const WrittenRequest& request : rig.link->written()) {
        const auto& parameters = request.packet.parameters;
        if (request.packet.code == kWrite) {
            ++writes;
            QVERIFY(parameters[0] >= firstRam);
        } else if (request.packet.code == 0x02 && model == 64) {
            QVERIFY(parameters[1] != 2);  // its answer would look like itself
        } else {
            QVERIFY(request.packet.code == 0x01 || request.packet.code == 0x02 || request.packet.code == 0x08);
        }
    }
    QVERIFY(writes > 5);
}

void DynamixelTiltTest::aDeadlineAndAStopEndASample()
{
    ServoRig rig;
    QVERIFY(rig.ready());
    rig.link->forget();
    const auto now = rig.clock.now();
    std::stop_source stop;
    stop.request_stop();

    QVERIFY(!rig.tilt->sample(now, {}).value());
    QVERIFY(!rig.tilt->sample(now + 1s, stop.get_token()).value());
    QVERIFY(rig.clock.now() == now);
    QVERIFY(rig.link->written().empty());
    QVERIFY(rig.tilt->sample(now + 1s, {}).value());
}

void DynamixelTiltTest::theLinkIsCounted()
{
    ServoRig rig;
    QVERIFY(rig.ready());
    const std::uint64_t before = rig.tilt->health().good;

    const auto until = rig.clock.now() + 2s;
    int samples = 0;
    while (rig.clock.now() < until)
        samples += rig.sample().value().has_value() ? 1 : 0;

    const LinkHealth health = rig.tilt->health();
    QCOMPARE(health.good - before, std::uint64_t(samples));
    QCOMPARE(health.lost + health.corrupt + health.late, std::uint64_t(0));
    // 25 bytes of 175 µs and 500 µs: 4.9 ms a round trip.
    QVERIFY(std::abs(health.rate - 205.0) < 3.0);
    QVERIFY(health.trouble.empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DynamixelTiltTest)
#include "dynamixel_tilt_test.moc"
