// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <QtTest>

#include "tests/devices/board/board_rig.h"
#include "tests/devices/holds.h"
#include "tests/test_program.h"

namespace planewright {

/// What the driver does when something goes wrong with a board: each fault of the emulated one.
class BoardTiltFaultsTest : public QObject {
    Q_OBJECT

private slots:
    void damageOfTheLineIsCountedAndMendedAndNoAngleIsWrong_data();
    void damageOfTheLineIsCountedAndMendedAndNoAngleIsWrong();
    void theSameSeedGivesTheSameRun();
    void aFaultBeginsAtItsStep();
    void lostEventsAreReportedAndMotionsEndNevertheless();
    void lostSlicesAreMissingByTheirNumbers();
    void whatComesLateHasItsOwnTime();
    void whenTheBoardIsSlowForLongItsAnglesHaveNoTime();
    void aBoardThatStartsAnewIsGreetedAndWaitsToBeArmed();
    void aBoardThatStartsAnewBetweenCallsIsNoticedToo();
    void aBoardThatMissesHeartbeatsSaysSo();
    void aSilentBoardIsLostAndItsMotorStands();
    void aMotorThatIsHeldByForceIsReported();
    void anAngleThatIsNotTheCommandedOneIsFound();
    void anUnpluggedBoardIsLost();
    void passingALimitIsReported();
    void aMissingSyncWireIsReported();
};

namespace {

using namespace std::chrono_literals;
using board::State;

EmulatedBoardSetup with(const char* kind, int step)
{
    EmulatedBoardSetup setup = levelBoard();
    setup.faults = {{kind, step}};
    return setup;
}

/// Connects, arms, and begins a long way.
bool isUnderWay(BoardRig& rig)
{
    return rig.tilt.connect({}) && rig.tilt.arm({}) && rig.tilt.moveTo(degrees(160.0), degrees(20.0));
}

/// Moves in steps of 1.16°, and looks at every sample: it must be true when it is, and newer than the one before.
Result<void> stepThrough(BoardRig& rig, int steps, std::chrono::nanoseconds clocks)
{
    std::chrono::nanoseconds last{0};
    for (int i = 0; i < steps; ++i) {
        if (const auto moved = rig.tilt.moveTo(degrees(30.0 + 1.16 * i), degrees(100.0)); !moved)
            return tl::unexpected(moved.error());
        bool moves = true;
        const auto begun = rig.clock.now();
        while (moves || rig.clock.now() < begun + 30ms) {
            const auto sample = rig.tilt.sample(rig.clock.now() + 1s, {});
            if (!sample)
                return tl::unexpected(sample.error());
            if (!*sample || !isTrue(rig, **sample, clocks) || (*sample)->at <= last)
                return fail(ErrorCode::Internal, "a sample is missing, wrong or out of order");
            last = (*sample)->at;
            moves = (*sample)->moving;
            if (rig.clock.now() > begun + 10s)
                return fail(ErrorCode::Internal, "a motion never ended");
        }
    }
    return {};
}

}  // namespace

void BoardTiltFaultsTest::damageOfTheLineIsCountedAndMendedAndNoAngleIsWrong_data()
{
    QTest::addColumn<QByteArray>("kind");
    QTest::addColumn<unsigned>("seed");
    QTest::addColumn<bool>("damages");
    QTest::addColumn<bool>("loses");
    for (unsigned seed = 1; seed <= 4; ++seed) {
        for (const auto& [kind, damages, loses] : {std::tuple{"board-crc", true, true},
                                                   {"board-byte-loss", true, true},
                                                   {"board-garbage", true, true},
                                                   {"board-duplicate", false, false}})
            QTest::addRow("%s %u", kind, seed) << QByteArray{kind} << seed << damages << loses;
    }
}

void BoardTiltFaultsTest::damageOfTheLineIsCountedAndMendedAndNoAngleIsWrong()
{
    QFETCH(QByteArray, kind);
    QFETCH(unsigned, seed);
    QFETCH(bool, damages);
    QFETCH(bool, loses);
    EmulatedBoardSetup setup = with(kind.constData(), 20);
    setup.seed = seed;
    BoardRig rig{setup};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));

    const auto went = stepThrough(rig, 60, 300us);

    QVERIFY2(went, went ? "" : went.error().message.c_str());
    const LinkHealth health = rig.tilt.health();
    QCOMPARE(health.corrupt > 0, damages);
    QCOMPARE(health.lost > 0, loses);
    QCOMPARE(health.trouble.empty(), !loses);
}

void BoardTiltFaultsTest::theSameSeedGivesTheSameRun()
{
    const auto run = [](unsigned seed) {
        EmulatedBoardSetup setup = with("board-garbage", 0);
        setup.seed = seed;
        BoardRig rig{setup};
        std::vector<std::uint64_t> counters;
        if (rig.tilt.connect({}) && rig.watch(2s))
            counters = {rig.tilt.health().good, rig.tilt.health().corrupt, rig.tilt.health().lost};
        return counters;
    };

    QCOMPARE(run(5).size(), std::size_t(3));
    QCOMPARE(run(5), run(5));
    QVERIFY(run(5) != run(6));
}

void BoardTiltFaultsTest::aFaultBeginsAtItsStep()
{
    BoardRig rig{with("board-unplug", 80)};
    QVERIFY(isUnderWay(rig));

    QVERIFY(rig.watch(1900ms));
    QVERIFY(!rig.watch(200ms));

    QVERIFY(std::chrono::abs(rig.clock.now() - 2s) < 60ms);
}

void BoardTiltFaultsTest::lostEventsAreReportedAndMotionsEndNevertheless()
{
    BoardRig rig{with("board-lost-event", 0)};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));

    const auto went = stepThrough(rig, 60, 300us);

    QVERIFY2(went, went ? "" : went.error().message.c_str());
    const LinkHealth health = rig.tilt.health();
    QVERIFY(health.lost > 10);
    QCOMPARE(health.corrupt, std::uint64_t(0));
    QVERIFY(holds(health.trouble, "lost"));
}

void BoardTiltFaultsTest::lostSlicesAreMissingByTheirNumbers()
{
    BoardTiltOptions options = BoardRig::level();
    options.positionRate = 1;  // nearly all events are slices then
    BoardRig rig{with("board-lost-event", 0), options};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));

    QVERIFY(rig.tilt.sweep({degrees(40.0), degrees(110.0), degrees(1.16), 60, degrees(100.0), true, 0}));
    QVERIFY(rig.watch(4s));

    const std::vector<BoardSlice> slices = rig.tilt.takeSliceEvents();
    QVERIFY(slices.size() >= 52 && slices.size() < 60);
    for (std::size_t i = 1; i < slices.size(); ++i) {
        QVERIFY(slices[i].number > slices[i - 1].number);
        const auto between = (slices[i].number - slices[i - 1].number) * 25ms;
        QVERIFY(std::chrono::abs(slices[i].at - slices[i - 1].at - between) < 1ms);
    }
}

void BoardTiltFaultsTest::whatComesLateHasItsOwnTime()
{
    BoardRig rig{with("board-delay", 120)};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.watch(4s));
    QVERIFY(rig.tilt.arm({}));

    const auto went = stepThrough(rig, 20, 500us);

    QVERIFY2(went, went ? "" : went.error().message.c_str());
    QVERIFY(rig.tilt.health().late > 50);
    QVERIFY(rig.tilt.health().lost > 0);  // replies that came in time for a second try only
}

void BoardTiltFaultsTest::whenTheBoardIsSlowForLongItsAnglesHaveNoTime()
{
    BoardRig rig{with("board-delay", 120)};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.watch(60s));
    QCOMPARE(rig.tilt.health().trouble, std::string());

    const auto from = rig.clock.now();
    const auto samples = rig.watch(80s);

    // The quick heartbeats of before count for a minute. Then a second without an angle is one too many.
    QVERIFY(!samples);
    QVERIFY(rig.clock.now() - from < 75s);
    QCOMPARE(samples.error().code, ErrorCode::DeviceLost);
    QVERIFY2(holds(samples.error().message, "answers too slowly: its answers take 80 ms"),
             samples.error().message.c_str());
    QVERIFY(holds(samples.error().message, "must be known to 5 ms"));
    QVERIFY(holds(samples.error().message, "connect it to the computer directly"));
    QVERIFY(holds(rig.tilt.health().trouble, "slowly"));
    const auto again = rig.clock.now();
    QCOMPARE(rig.watch(10s).error().code, ErrorCode::DeviceLost);
    QVERIFY(rig.clock.now() - again >= 1s && rig.clock.now() - again < 1100ms);
}

void BoardTiltFaultsTest::aBoardThatStartsAnewIsGreetedAndWaitsToBeArmed()
{
    BoardRig rig{with("board-reset", 80)};
    QVERIFY(isUnderWay(rig));

    const auto samples = rig.watch(3s);

    QVERIFY(!samples);
    QCOMPARE(samples.error().code, ErrorCode::NeedsOperator);
    QVERIFY(holds(samples.error().message, "started anew"));
    QVERIFY(holds(samples.error().message, "watchdog"));
    QVERIFY(std::chrono::abs(rig.clock.now() - 2s) < 100ms);
    QCOMPARE(rig.state(), State::Unarmed);
    // It tells angles again, and does not move.
    const auto after = rig.watch(1s);
    QVERIFY(after);
    QVERIFY(after->size() > 90);
    QVERIFY(!after->back().moving);
    for (const TiltSample& sample : *after)
        QVERIFY(isTrue(rig, sample, 300us));
    QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(20.0)).error().code, ErrorCode::NeedsOperator);
    QVERIFY(holds(rig.tilt.health().trouble, "started anew"));

    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(100.0), degrees(20.0)));
    QVERIFY(rig.arrive());
    QCOMPARE(rig.tilt.health().trouble, std::string());
}

void BoardTiltFaultsTest::aBoardThatStartsAnewBetweenCallsIsNoticedToo()
{
    BoardRig rig{with("board-reset", 80)};
    QVERIFY(isUnderWay(rig));
    rig.clock.advance(10s);

    const auto moved = rig.tilt.moveTo(degrees(100.0), degrees(20.0));
    QVERIFY(!moved);
    QVERIFY2(moved.error().code == ErrorCode::NeedsOperator, moved.error().message.c_str());
    QVERIFY(rig.tilt.arm({}));

    QVERIFY(rig.tilt.moveTo(degrees(100.0), degrees(20.0)));
    QVERIFY(rig.arrive());
}

void BoardTiltFaultsTest::aBoardThatMissesHeartbeatsSaysSo()
{
    BoardRig rig{with("board-watchdog", 80)};
    QVERIFY(isUnderWay(rig));

    const auto samples = rig.watch(3s);

    QVERIFY(!samples);
    QVERIFY(holds(samples.error().message, "heartbeat"));
    QVERIFY(std::chrono::abs(rig.clock.now() - 2s) < 100ms);
    QCOMPARE(rig.state(), State::Stopped);
    const double rest = rig.pitch();
    QVERIFY(rig.watch(1s));
    QVERIFY(std::abs(rig.pitch() - rest) < 0.02);
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(100.0), degrees(20.0)));
    QVERIFY(rig.arrive());
}

void BoardTiltFaultsTest::aSilentBoardIsLostAndItsMotorStands()
{
    BoardRig rig{with("board-silent", 80)};
    QVERIFY(isUnderWay(rig));

    const auto samples = rig.watch(3s);

    QVERIFY(!samples);
    QCOMPARE(samples.error().code, ErrorCode::DeviceLost);
    QVERIFY(rig.clock.now() < 2400ms);
    const double last = rig.pitchAt(rig.clock.now() + 200ms);
    QCOMPARE(rig.pitchAt(rig.clock.now() + 1s), last);
    QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(20.0)).error().code, ErrorCode::DeviceLost);
    QCOMPARE(rig.tilt.hold().error().code, ErrorCode::DeviceLost);
    QCOMPARE(rig.tilt.arm({}).error().code, ErrorCode::DeviceLost);
    QCOMPARE(rig.tilt.connect({}).error().code, ErrorCode::NoDevice);
    QVERIFY(!rig.tilt.health().trouble.empty());
}

void BoardTiltFaultsTest::aMotorThatIsHeldByForceIsReported()
{
    BoardRig rig{with("board-stall", 80)};
    QVERIFY(isUnderWay(rig));

    const auto samples = rig.watch(3s);

    QVERIFY(!samples);
    QVERIFY(holds(samples.error().message, "something holds it"));
    QVERIFY(rig.clock.now() > 2250ms && rig.clock.now() < 2400ms);
    QCOMPARE(rig.state(), State::Fault);
    QVERIFY(rig.watch(1100ms));
    QVERIFY(holds(rig.tilt.motor().trouble, "something holds it"));
    QCOMPARE(rig.tilt.arm({}).error().code, ErrorCode::NeedsOperator);
    QCOMPARE(rig.state(), State::Fault);
    QVERIFY(rig.tilt.recover({}));
    QCOMPARE(rig.state(), State::Unarmed);
    QVERIFY(rig.tilt.arm({}));
    QCOMPARE(rig.state(), State::Armed);
    QVERIFY(rig.tilt.moveTo(degrees(30.0), degrees(20.0)));
    QVERIFY(!rig.watch(1s));
}

void BoardTiltFaultsTest::anAngleThatIsNotTheCommandedOneIsFound()
{
    BoardRig rig{with("board-wrong-angle", 0)};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(100.0), degrees(60.0)));

    const auto samples = rig.watch(1s);

    QVERIFY(!samples);
    QCOMPARE(samples.error().code, ErrorCode::NeedsOperator);
    QVERIFY(holds(samples.error().message, "11.73°"));  // 40 counts
    QVERIFY(!rig.tilt.moveTo(degrees(110.0), degrees(60.0)));
}

void BoardTiltFaultsTest::anUnpluggedBoardIsLost()
{
    BoardRig rig{with("board-unplug", 80)};
    QVERIFY(isUnderWay(rig));

    const auto samples = rig.watch(3s);

    QCOMPARE(samples.error().code, ErrorCode::DeviceLost);
    QVERIFY(holds(samples.error().message, "plug"));
    QCOMPARE(rig.tilt.hold().error().code, ErrorCode::DeviceLost);
    QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(20.0)).error().code, ErrorCode::DeviceLost);
    QCOMPARE(rig.tilt.connect({}).error().code, ErrorCode::DeviceLost);
    // A board that has lost its USB power does not count: here it goes on, and stops by its watchdog.
    const double rest = rig.pitchAt(rig.clock.now() + 250ms);
    QCOMPARE(rig.pitchAt(rig.clock.now() + 3s), rest);
}

void BoardTiltFaultsTest::passingALimitIsReported()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.dynamics.overshoot = 0.1;
    BoardRig rig{setup};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(170.0), degrees(119.0)));

    const auto samples = rig.watch(2s);

    QVERIFY(!samples);
    QVERIFY(holds(samples.error().message, "limit"));
    QCOMPARE(rig.state(), State::Stopped);
}

void BoardTiltFaultsTest::aMissingSyncWireIsReported()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.nextEdge = nullptr;
    BoardRig rig{setup};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));

    QVERIFY(rig.tilt.trigger(1));
    QCOMPARE(rig.tilt.trigger(2).error().code, ErrorCode::Usage);
    QVERIFY(rig.watch(1100ms));
    QVERIFY(holds(rig.tilt.health().trouble, "sync"));
    QCOMPARE(rig.state(), State::Armed);
    QVERIFY(rig.tilt.sweep({degrees(80.0), degrees(120.0), degrees(1.16), 30, degrees(100.0), false, 0}));
    const auto samples = rig.watch(3s);

    QVERIFY(!samples);
    QVERIFY(holds(samples.error().message, "sync"));
    QVERIFY(rig.tilt.takeSliceEvents().empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::BoardTiltFaultsTest)
#include "board_tilt_faults_test.moc"
