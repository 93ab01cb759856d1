// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/board_tilt.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "tests/devices/board/board_rig.h"
#include "tests/test_program.h"

namespace planewright {

class BoardTiltTest : public QObject {
    Q_OBJECT

private slots:
    void connectingFindsOutWhoItIsAndMovesNothing();
    void nothingMovesBeforeItIsArmed();
    void aMoveEndsAtTheNearestStep();
    void homeIsLevelAndReachedSlowly_data();
    void homeIsLevelAndReachedSlowly();
    void samplesHaveTheTimeOfTheHost();
    void samplesComeAsOftenAsTheyAreAskedFor();
    void heartbeatsGoOnWhileSamplesAreTaken();
    void whenTheProgramIsKilledTheMotorStands200MillisecondsLater();
    void withoutCallsTheMotorStopsAndTheNextOneSaysWhy();
    void whatIsBeyondALimitIsRefused_data();
    void whatIsBeyondALimitIsRefused();
    void aMotorThatIsHeldMovesOnlyWhenItIsArmedAgain();
    void holdingTwiceLeavesTheTorque();
    void theMotorsStateComesOnceASecond();
    void slicesHaveTheAngleOfTheSyncEdge();
    void aSweepGivesItsSlicesInOrder();
    void aContinuousSweepGivesItsSlicesInMotion();
    void aSweepThatDoesNotFitIsRefused();
    void aStopIsInOrderAndNeedsArming();
    void itConnectsToABoardThatMoves();
    void itConnectsToABoardThatWasStoppedInAnEmergency();
    void itConnectsAgain();
    void withoutABoardThereIsNoDevice();
    void aStopEndsTheSearch();
    void anotherMountingTurnsTheOtherWay();
};

namespace {

using namespace std::chrono_literals;
using board::State;

}  // namespace

void BoardTiltTest::connectingFindsOutWhoItIsAndMovesNothing()
{
    BoardRig rig;
    QCOMPARE(rig.tilt.sample(rig.clock.now(), {}).error().code, ErrorCode::NoDevice);

    QVERIFY(rig.tilt.connect({}));

    QCOMPARE(rig.tilt.identity(), std::string("control board 454D554C41544544, firmware 1.0, RX-64"));
    QVERIFY(std::abs(rig.tilt.resolution() - kCountAngle) < 1e-12);
    QVERIFY(rig.tilt.lowest() >= degrees(10.0) && rig.tilt.lowest() < degrees(10.0) + kCountAngle);
    QVERIFY(rig.tilt.highest() <= degrees(170.0) && rig.tilt.highest() > degrees(170.0) - kCountAngle);
    QVERIFY(rig.tilt.fastest() <= degrees(120.0) && rig.tilt.fastest() > degrees(119.0));
    QVERIFY(rig.watch(1s));
    QCOMPARE(rig.pitch(), degrees(90.0));
    QCOMPARE(rig.state(), State::Unarmed);
    QCOMPARE(rig.tilt.health().trouble, std::string());
}

void BoardTiltTest::nothingMovesBeforeItIsArmed()
{
    BoardRig rig;
    QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(60.0)).error().code, ErrorCode::NoDevice);
    QCOMPARE(rig.tilt.arm({}).error().code, ErrorCode::NoDevice);
    QVERIFY(rig.tilt.connect({}));

    const auto moved = rig.tilt.moveTo(degrees(100.0), degrees(60.0));

    QCOMPARE(moved.error().code, ErrorCode::Usage);
    QVERIFY(rig.watch(1s));
    QCOMPARE(rig.pitch(), degrees(90.0));
}

void BoardTiltTest::aMoveEndsAtTheNearestStep()
{
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));

    for (const double pitch : {100.0, 100.4, 60.0, 60.13, 170.0, 10.0}) {
        QVERIFY(rig.tilt.moveTo(degrees(pitch), degrees(100.0)));
        QCOMPARE(rig.state(), State::Moving);
        const auto rest = rig.arrive();

        QVERIFY(rest);
        QVERIFY(std::abs(rest->pitch - rig.tilt.nearestPitch(degrees(pitch))) < 1e-9);
        QVERIFY(std::abs(rest->pitch - degrees(pitch)) <= kCountAngle);
        QVERIFY(std::abs(rig.pitch() - rest->pitch) < 1e-3);
    }
}

void BoardTiltTest::homeIsLevelAndReachedSlowly_data()
{
    QTest::addColumn<double>("lowest");
    QTest::addColumn<double>("home");
    QTest::newRow("level") << 10.0 << 90.0;
    QTest::newRow("level is below what it may take") << 95.0 << 95.0;
}

/// By HOME: the board goes to where it was told to when it was connected.
void BoardTiltTest::homeIsLevelAndReachedSlowly()
{
    QFETCH(double, lowest);
    QFETCH(double, home);
    EmulatedBoardSetup setup = levelBoard();
    setup.startPitch = degrees(130.0);
    BoardTiltOptions options = BoardRig::level();
    options.mounting.lowest = degrees(lowest);
    BoardRig rig{setup, options};
    QVERIFY(rig.tilt.connect({}));
    QCOMPARE(rig.tilt.goHome().error().code, ErrorCode::Usage);  // not armed
    QVERIFY(rig.tilt.arm({}));
    const auto begun = rig.clock.now();

    QVERIFY(rig.tilt.goHome());
    const auto rest = rig.arrive();

    QVERIFY(rest);
    QVERIFY(std::abs(rest->pitch - degrees(home)) <= kCountAngle);
    QVERIFY(std::abs(rig.pitch() - rest->pitch) < 1e-3);
    // At 20° a second, and a little time to gain speed and to settle.
    const double seconds = std::chrono::duration<double>(rig.clock.now() - begun).count();
    const double way = (130.0 - home) / 20.0;
    QVERIFY2(seconds > way && seconds < way + 0.5, qPrintable(QString::number(seconds)));
}

void BoardTiltTest::samplesHaveTheTimeOfTheHost()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.clockDrift = -200e-6;
    setup.bootAt = -3600s;
    BoardRig rig{setup};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));

    int samples = 0;
    for (const double goal : {160.0, 20.0, 160.0, 20.0, 160.0}) {
        QVERIFY(rig.tilt.moveTo(degrees(goal), degrees(50.0)));
        std::chrono::nanoseconds last{0};
        const auto seen = rig.watch(2s);
        QVERIFY(seen);
        for (const TiltSample& sample : *seen) {
            QVERIFY(sample.at > last);
            last = sample.at;
            // The first seconds give no line yet: 200 millionths of 2 s are 0.4 ms.
            QVERIFY(isTrue(rig, sample, sample.at > 4s ? 100us : 500us));
            ++samples;
        }
    }

    QVERIFY(samples > 1900);
    QCOMPARE(rig.tilt.health().late, std::uint64_t(0));
}

void BoardTiltTest::samplesComeAsOftenAsTheyAreAskedFor()
{
    BoardTiltOptions options = BoardRig::level();
    options.positionRate = 200;
    BoardRig rig{levelBoard(), options};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.watch(1s));

    const auto samples = rig.watch(1s);

    QVERIFY(std::abs(static_cast<int>(samples->size()) - 200) <= 1);
    // And 20 heartbeats and a status.
    QVERIFY(std::abs(rig.tilt.health().rate - 221.0) <= 2.0);
    QCOMPARE(rig.tilt.health().lost + rig.tilt.health().corrupt, std::uint64_t(0));
}

void BoardTiltTest::heartbeatsGoOnWhileSamplesAreTaken()
{
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(20.0), degrees(120.0)));
    QVERIFY(rig.arrive());

    QVERIFY(rig.tilt.moveTo(degrees(160.0), degrees(5.0)));
    QVERIFY(rig.watch(27s));
    QCOMPARE(rig.state(), State::Moving);
    QVERIFY(rig.watch(5s));

    QCOMPARE(rig.state(), State::Armed);
}

void BoardTiltTest::whenTheProgramIsKilledTheMotorStands200MillisecondsLater()
{
    for (const auto when : {300ms, 310ms, 320ms, 330ms, 340ms, 350ms}) {
        BoardRig rig;
        QVERIFY(rig.tilt.connect({}));
        QVERIFY(rig.tilt.arm({}));
        QVERIFY(rig.tilt.moveTo(degrees(170.0), rig.tilt.fastest()));
        QVERIFY(rig.watch(when));

        const auto killed = rig.clock.now();  // nothing is called any more

        QVERIFY(rig.pitchAt(killed + 90ms) > rig.pitchAt(killed + 80ms));
        const double rest = rig.pitchAt(killed + 200ms);
        for (const auto later : {250ms, 1000ms, 5000ms})
            QCOMPARE(rig.pitchAt(killed + later), rest);
        QVERIFY(rest < degrees(169.0));
        QCOMPARE(rig.board->torque(), 1000);
    }
}

void BoardTiltTest::withoutCallsTheMotorStopsAndTheNextOneSaysWhy()
{
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(160.0), degrees(20.0)));
    QVERIFY(rig.watch(500ms));

    rig.clock.advance(1s);
    const auto samples = rig.watch(1s);

    QVERIFY(!samples);
    QCOMPARE(samples.error().code, ErrorCode::NeedsOperator);
    QVERIFY(samples.error().message.find("heartbeat") != std::string::npos);
    QVERIFY(samples.error().message.find("emulated board") != std::string::npos);
    QVERIFY(rig.pitch() < degrees(90.0 + 20.0 * 0.8));
    QVERIFY(rig.watch(1s));  // it said so once
    const auto moved = rig.tilt.moveTo(degrees(100.0), degrees(20.0));
    QCOMPARE(moved.error().code, ErrorCode::NeedsOperator);
    QVERIFY(!rig.tilt.health().trouble.empty());

    QVERIFY(rig.tilt.arm({}));
    QCOMPARE(rig.tilt.health().trouble, std::string());
    QVERIFY(rig.tilt.moveTo(degrees(100.0), degrees(20.0)));
    QVERIFY(rig.arrive());
}

void BoardTiltTest::whatIsBeyondALimitIsRefused_data()
{
    QTest::addColumn<double>("pitch");
    QTest::addColumn<double>("speed");
    QTest::newRow("too low") << 9.0 << 60.0;
    QTest::newRow("too high") << 171.0 << 60.0;
    QTest::newRow("nowhere") << std::numeric_limits<double>::quiet_NaN() << 60.0;
    QTest::newRow("endless") << std::numeric_limits<double>::infinity() << 60.0;
    QTest::newRow("too fast") << 100.0 << 121.0;
    QTest::newRow("standing") << 100.0 << 0.0;
    QTest::newRow("backwards") << 100.0 << -10.0;
    QTest::newRow("no speed") << 100.0 << std::numeric_limits<double>::quiet_NaN();
}

void BoardTiltTest::whatIsBeyondALimitIsRefused()
{
    QFETCH(double, pitch);
    QFETCH(double, speed);
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));

    const auto moved = rig.tilt.moveTo(degrees(pitch), degrees(speed));

    QCOMPARE(moved.error().code, ErrorCode::Usage);
    QVERIFY(rig.watch(500ms));
    QCOMPARE(rig.pitch(), degrees(90.0));
    QCOMPARE(rig.state(), State::Armed);
}

void BoardTiltTest::aMotorThatIsHeldMovesOnlyWhenItIsArmedAgain()
{
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(160.0), degrees(100.0)));
    QVERIFY(rig.watch(200ms));
    const auto before = rig.clock.now();

    QVERIFY(rig.tilt.hold());

    QVERIFY(rig.clock.now() - before < 2ms);  // one round trip
    QCOMPARE(rig.state(), State::Estopped);
    QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(20.0)).error().code, ErrorCode::Interrupted);
    const auto samples = rig.watch(1s);
    QVERIFY(samples);
    QVERIFY(!samples->back().moving);
    QVERIFY(std::abs(samples->back().pitch - rig.pitchAt(before + 50ms)) < kCountAngle);

    QVERIFY(rig.tilt.arm({}));
    QCOMPARE(rig.board->torque(), 1000);
    QVERIFY(rig.tilt.moveTo(degrees(100.0), degrees(20.0)));
    QVERIFY(std::abs(rig.arrive()->pitch - degrees(100.0)) < kCountAngle);
}

void BoardTiltTest::holdingTwiceLeavesTheTorque()
{
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));

    for (int i = 0; i < 5; ++i)
        QVERIFY(rig.tilt.hold());

    QCOMPARE(rig.board->torque(), 300);
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.hold());
    QCOMPARE(rig.board->torque(), 300);
}

void BoardTiltTest::theMotorsStateComesOnceASecond()
{
    BoardRig rig;
    QCOMPARE(rig.tilt.motor().voltage, 0.0);
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));
    QCOMPARE(rig.tilt.motor().voltage, 14.8);
    QCOMPARE(rig.tilt.motor().temperature.value(), 38.0);
    QCOMPARE(rig.tilt.motor().load, 0.06);

    QVERIFY(rig.tilt.moveTo(degrees(160.0), degrees(20.0)));
    QVERIFY(rig.watch(1100ms));

    QCOMPARE(rig.tilt.motor().load, 0.25);
    QCOMPARE(rig.tilt.motor().trouble, std::string());
}

void BoardTiltTest::slicesHaveTheAngleOfTheSyncEdge()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.clockDrift = 30e-6;
    BoardRig rig{setup};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(160.0), degrees(20.0)));

    for (unsigned number = 0; number < 20; ++number) {
        QVERIFY(rig.tilt.trigger(number));
        QVERIFY(rig.watch(60ms));
    }

    const std::vector<BoardSlice> slices = rig.tilt.takeSliceEvents();
    QCOMPARE(slices.size(), std::size_t(20));
    for (unsigned number = 0; number < 20; ++number) {
        const BoardSlice& slice = slices[number];
        QCOMPARE(slice.number, number);
        const auto sinceEdge = (slice.at - 3ms + 12500us) % 25ms - 12500us;
        QVERIFY(std::chrono::abs(sinceEdge) < 150us);
        QVERIFY(isTrue(rig, {slice.at, slice.pitch, true}, 150us));
        QVERIFY(std::abs(slice.pitchAtEnd - rig.pitchAt(slice.at + 18'750us)) < kCountAngle);
        QVERIFY(!slice.isSuspect);
    }
    QVERIFY(rig.tilt.takeSliceEvents().empty());
}

void BoardTiltTest::aSweepGivesItsSlicesInOrder()
{
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));
    BoardSweep plan{degrees(80.0), degrees(120.0), degrees(1.16), 30, degrees(100.0), false, 5};

    QVERIFY(rig.tilt.sweep(plan));
    QCOMPARE(rig.state(), State::Sweeping);
    QVERIFY(rig.watch(5s));

    QCOMPARE(rig.state(), State::Armed);
    const std::vector<BoardSlice> slices = rig.tilt.takeSliceEvents();
    QCOMPARE(slices.size(), std::size_t(30));
    for (std::size_t i = 0; i < slices.size(); ++i) {
        QCOMPARE(slices[i].number, 5U + static_cast<unsigned>(i));
        // Steps of 1.16 degrees are four counts.
        const double wanted = rig.tilt.nearestPitch(plan.first) + 4.0 * static_cast<double>(i) * kCountAngle;
        QVERIFY(std::abs(slices[i].pitch - wanted) < 2.1 * kCountAngle);
        QVERIFY(std::abs(slices[i].pitchAtEnd - slices[i].pitch) < 1.1 * kCountAngle);
    }
}

void BoardTiltTest::aContinuousSweepGivesItsSlicesInMotion()
{
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));

    QVERIFY(rig.tilt.sweep({degrees(80.0), degrees(120.0), degrees(1.16), 30, degrees(100.0), true, 0}));
    QVERIFY(rig.watch(3s));

    const std::vector<BoardSlice> slices = rig.tilt.takeSliceEvents();
    QCOMPARE(slices.size(), std::size_t(30));
    for (std::size_t i = 1; i < slices.size(); ++i) {
        QVERIFY(std::chrono::abs(slices[i].at - slices[i - 1].at - 25ms) < 100us);
        QVERIFY(isTrue(rig, {slices[i].at, slices[i].pitch, true}, 150us));
        QVERIFY(slices[i].pitchAtEnd > slices[i].pitch);
    }
}

void BoardTiltTest::aSweepThatDoesNotFitIsRefused()
{
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));
    BoardSweep plan{degrees(80.0), degrees(120.0), degrees(1.16), 30, degrees(100.0), false, 0};
    QCOMPARE(rig.tilt.sweep(plan).error().code, ErrorCode::Usage);  // not armed
    QVERIFY(rig.tilt.arm({}));

    for (const auto& change : std::vector<std::function<void(BoardSweep&)>>{
             [](BoardSweep& p) { p.slices = 36; }, [](BoardSweep& p) { p.slices = 0; },
             [](BoardSweep& p) { p.step = 0.0; }, [](BoardSweep& p) { p.step = -1.0; },
             [](BoardSweep& p) { p.step = std::numeric_limits<double>::quiet_NaN(); },
             [](BoardSweep& p) { p.last = degrees(175.0); }, [](BoardSweep& p) { p.speed = 0.0; }}) {
        BoardSweep wrong = plan;
        change(wrong);
        QCOMPARE(rig.tilt.sweep(wrong).error().code, ErrorCode::Usage);
    }
    QCOMPARE(rig.state(), State::Armed);
    QVERIFY(rig.tilt.sweep(plan));
}

void BoardTiltTest::aStopIsInOrderAndNeedsArming()
{
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(160.0), degrees(20.0)));
    QVERIFY(rig.watch(500ms));

    QVERIFY(rig.tilt.stop());

    QCOMPARE(rig.state(), State::Stopped);
    const auto samples = rig.watch(500ms);
    QVERIFY(samples);
    QVERIFY(!samples->back().moving);
    QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(20.0)).error().code, ErrorCode::Usage);
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(100.0), degrees(20.0)));
}

void BoardTiltTest::itConnectsToABoardThatMoves()
{
    BoardRig rig;
    const auto say = [&](std::uint16_t seq, const board::Message& message) {
        rig.board->receive(encodeFrame(board::toFrame(seq, message)), rig.clock.now());
        rig.clock.advance(1ms);
    };
    // A program that was killed: its last request half sent, its motor under way.
    say(1, board::Hello{});
    say(2, board::SetConfig{BoardHost::config(200)});
    say(3, board::Arm{1});
    say(4, board::Move{800, 100, 1, 0});
    rig.clock.advance(50ms);
    const std::vector<std::uint8_t> half{0x05, 0x01, 0x06};
    rig.board->receive(half, rig.clock.now());

    const auto connected = rig.tilt.connect({});
    QVERIFY2(connected, connected.error().message.c_str());

    QCOMPARE(rig.state(), State::Unarmed);
    QVERIFY(rig.watch(1s));
    QVERIFY(rig.pitch() < degrees(90.0) + 12 * kCountAngle);
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(100.0), degrees(20.0)));
    QVERIFY(rig.arrive());
}

void BoardTiltTest::itConnectsToABoardThatWasStoppedInAnEmergency()
{
    BoardRig rig;
    rig.board->receive(encodeFrame(board::toFrame(1, board::Estop{})), rig.clock.now());
    rig.clock.advance(1ms);
    QCOMPARE(rig.state(), State::Estopped);
    QVERIFY(rig.tilt.connect({}));
    const int torque = rig.board->torque();

    QVERIFY(rig.tilt.hold());

    QVERIFY(torque > 0);
    QCOMPARE(rig.board->torque(), torque);
    const auto armed = rig.tilt.arm({});  // who has stopped it may have a hand in it
    QCOMPARE(armed.error().code, ErrorCode::NeedsOperator);
    QVERIFY(armed.error().message.find("recover it") != std::string::npos);
    QCOMPARE(rig.state(), State::Estopped);
    QVERIFY(rig.tilt.recover({}));
    QCOMPARE(rig.state(), State::Unarmed);
    QVERIFY(rig.tilt.arm({}));
    QCOMPARE(rig.state(), State::Armed);
}

void BoardTiltTest::itConnectsAgain()
{
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.watch(300ms));

    QVERIFY(rig.tilt.connect({}));

    QCOMPARE(rig.state(), State::Unarmed);
    QVERIFY(rig.watch(300ms));
    QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(20.0)).error().code, ErrorCode::Usage);
}

void BoardTiltTest::withoutABoardThereIsNoDevice()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.faults = {{"board-silent", 0}};
    BoardRig rig{setup};

    const auto connected = rig.tilt.connect({});

    QCOMPARE(connected.error().code, ErrorCode::NoDevice);
    QVERIFY(connected.error().message.find("NTB/1") != std::string::npos);
    QVERIFY(rig.clock.now() == 2s);
}

void BoardTiltTest::aStopEndsTheSearch()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.faults = {{"board-silent", 0}};
    BoardRig rig{setup};
    std::stop_source stop;
    stop.request_stop();

    QCOMPARE(rig.tilt.connect(stop.get_token()).error().code, ErrorCode::Interrupted);

    QVERIFY(rig.clock.now() < 1s);
}

void BoardTiltTest::anotherMountingTurnsTheOtherWay()
{
    EmulatedBoardSetup setup = levelBoard();
    BoardTiltOptions options = BoardRig::level();
    setup.mounting.sign = options.mounting.sign = -1.0;
    setup.mounting.scale = options.mounting.scale = 1.03;
    BoardRig rig{setup, options};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));

    QVERIFY(rig.tilt.moveTo(degrees(120.0), degrees(60.0)));
    const auto rest = rig.arrive();

    QVERIFY(rest);
    QVERIFY(std::abs(rest->pitch - degrees(120.0)) < kCountAngle);
    QVERIFY(std::abs(rig.pitch() - rest->pitch) < 1e-3);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::BoardTiltTest)
#include "board_tilt_test.moc"
