// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_board.h"

#include <cmath>

#include <QtTest>

#include "tests/devices/emulated/board_host.h"
#include "tests/test_program.h"

namespace planewright {

class EmulatedBoardTest : public QObject {
    Q_OBJECT

private slots:
    void itIntroducesItself();
    void aMoveTakesTheTimeOfItsWayAndIsReported();
    void aMoveThatIsToSettleIsReportedLater();
    void theServoCanBeMountedTheOtherWay();
    void itMeasuresInWholeCounts();
    void whenTheHostFallsSilentTheMotorStands200MillisecondsLater_data();
    void whenTheHostFallsSilentTheMotorStands200MillisecondsLater();
    void aStopOfTheWatchdogIsToldWhenTheHostIsHeardAgain();
    void anEmergencyStopTakesTheTorqueOnlyWhenItIsAnotherOne();
    void aRequestThatComesTwiceIsDoneOnce();
    void onlyTheLastTwoRepliesAreKept();
    void aNewSessionForgetsTheRepliesAndDisarms();
    void positionsComeAsOftenAsTheyAreAskedFor();
    void eventsAreCountedFrom8000OnWithEveryHello();
    void aTriggeredSliceHasTheAngleOfTheEdge();
    void withoutTheSyncWireThereIsAFault();
    void aSweepStopsForEverySlice();
    void aSweepDownwardsIsOneToo();
    void aContinuousSweepMovesOneStepATurn();
    void whatHoldsTheMotorIsAFault();
    void passingALimitStopsIt();
    void itsClockDrifts();
    void statusTellsWhatWasLost();
    void edgesComeEveryPeriod();
    void faultsOfNoKindAreRefusedWithThoseThatThereAre();
};

namespace {

using namespace board;
using namespace std::chrono_literals;

double pitchOf(int counts)
{
    return degrees(90.0) + (counts - 512) * kCountAngle;
}

bool isClose(double a, double b, double tolerance = 1e-9)
{
    return std::abs(a - b) < tolerance;
}

}  // namespace

void EmulatedBoardTest::itIntroducesItself()
{
    BoardHost host{levelBoard()};

    const auto reply = host.get<HelloReply>(Hello{});

    QCOMPARE(int(reply.proto), 1);
    QCOMPARE(int(reply.servoModel), 64);
    QCOMPARE(int(reply.highest), 1023);
    QCOMPARE(int(reply.middle), 512);
    QCOMPARE(reply.spanMdeg, 300'000U);
    QCOMPARE(reply.capabilities, 63U);
    QCOMPARE(int(reply.reset), 0);
}

void EmulatedBoardTest::aMoveTakesTheTimeOfItsWayAndIsReported()
{
    BoardHost host{levelBoard()};
    host.greetAndArm();

    const auto begun = host.get<MoveReply>(Move{712, 200, 0, 0});
    QCOMPARE(int(begun.pos), 512);
    QCOMPARE(int(begun.expectedMs), 1000);
    QCOMPARE(host.board().state(), State::Moving);
    host.wait(990ms);
    QVERIFY(host.all<ArrivedEvent>().empty());
    host.wait(40ms);

    const auto arrived = host.all<ArrivedEvent>();
    QCOMPARE(arrived.size(), std::size_t(1));
    QCOMPARE(int(arrived[0].goal), 712);
    QVERIFY(std::abs(arrived[0].pos - 712) <= 2);
    QCOMPARE(int(arrived[0].request), 4);  // after HELLO, SET_CONFIG and ARM
    QCOMPARE(host.board().state(), State::Armed);
    host.wait(100ms);
    QVERIFY(isClose(host.pitch(), pitchOf(712), 1e-4));
}

void EmulatedBoardTest::aMoveThatIsToSettleIsReportedLater()
{
    BoardHost now{levelBoard()};
    BoardHost settled{levelBoard()};
    for (BoardHost* host : {&now, &settled})
        host->greetAndArm();

    now.get<MoveReply>(Move{522, 100, 0, 0});
    settled.get<MoveReply>(Move{522, 100, 1, 60});
    now.wait(400ms);
    settled.wait(400ms);

    const auto later = static_cast<double>(settled.all<ArrivedEvent>().at(0).atUs) -
                       static_cast<double>(now.all<ArrivedEvent>().at(0).atUs);
    QVERIFY(later >= 59'000 && later <= 62'000);
}

void EmulatedBoardTest::theServoCanBeMountedTheOtherWay()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.mounting.sign = -1.0;
    setup.mounting.scale = 1.01;
    BoardHost host{setup};
    host.greetAndArm();

    host.get<MoveReply>(Move{612, 200, 0, 0});
    host.wait(1s);

    QVERIFY(isClose(host.pitch(), degrees(90.0) - 100 * 1.01 * kCountAngle, 1e-4));
    QCOMPARE(int(host.get<StatusReply>(GetStatus{}).pos), 612);
}

void EmulatedBoardTest::itMeasuresInWholeCounts()
{
    EmulatedBoardSetup setup = levelBoard();
    for (const auto& [pitch, counts] : {std::pair{90.0, 512}, {90.14, 512}, {90.15, 513}, {89.86, 512}, {89.85, 511}}) {
        setup.startPitch = degrees(pitch);  // a count is 0.293 degrees
        BoardHost host{setup};

        QCOMPARE(int(host.get<StatusReply>(GetStatus{}).pos), counts);
        QVERIFY(isClose(host.pitch(), degrees(pitch)));
    }
}

void EmulatedBoardTest::whenTheHostFallsSilentTheMotorStands200MillisecondsLater_data()
{
    QTest::addColumn<bool>("sweeps");
    QTest::newRow("on its way") << false;
    QTest::newRow("in a sweep") << true;
}

void EmulatedBoardTest::whenTheHostFallsSilentTheMotorStands200MillisecondsLater()
{
    QFETCH(bool, sweeps);
    BoardHost host{levelBoard()};
    host.greetAndArm();
    if (sweeps)
        host.get<SweepReply>(Sweep{512, 800, 10, 28, 1, 8, 400, 1});
    else
        host.get<MoveReply>(Move{800, 400, 1, 0});
    host.wait(sweeps ? 200ms : 100ms);
    host.get<HeartbeatReply>(Heartbeat{1});
    const auto last = host.now();
    QVERIFY(host.board().pitchAt(last) > degrees(90.0));

    host.wait(140ms, false);
    QVERIFY(host.pitch() > host.board().pitchAt(host.now() - 5ms));
    host.wait(5s, false);

    const double stands = host.board().pitchAt(last + 200ms);
    for (const auto later : {250ms, 500ms, 1000ms, 5000ms})
        QCOMPARE(host.board().pitchAt(last + later), stands);
    QVERIFY(stands < pitchOf(780));
    QCOMPARE(host.board().state(), State::Stopped);
    QCOMPARE(host.board().torque(), 1000);
}

void EmulatedBoardTest::aStopOfTheWatchdogIsToldWhenTheHostIsHeardAgain()
{
    BoardHost host{levelBoard()};
    host.greetAndArm();
    host.get<MoveReply>(Move{800, 100, 1, 0});
    host.wait(1s, false);
    QVERIFY(host.all<FaultEvent>().empty());

    const auto beat = host.get<HeartbeatReply>(Heartbeat{1});

    QCOMPARE(beat.state, State::Stopped);
    QCOMPARE(beat.fault, Fault::Watchdog);
    const auto faults = host.all<FaultEvent>();
    QCOMPARE(faults.size(), std::size_t(1));
    QCOMPARE(faults[0].code, Fault::Watchdog);
    QCOMPARE(int(faults[0].detail), 150);
    QVERIFY(faults[0].atUs < 200'000);
    host.wait(1s);
    QCOMPARE(host.all<FaultEvent>().size(), std::size_t(1));
    QCOMPARE(host.get<ArmReply>(Arm{1}).state, State::Armed);
}

void EmulatedBoardTest::anEmergencyStopTakesTheTorqueOnlyWhenItIsAnotherOne()
{
    BoardHost host{levelBoard()};
    host.greetAndArm();
    host.get<MoveReply>(Move{800, 400, 1, 0});
    host.wait(200ms);

    QVERIFY(host.askWith(100, Estop{}));
    const double stoppedAt = host.board().pitchAt(host.now() + 40ms);
    QCOMPARE(host.board().torque(), 300);
    QVERIFY(host.askWith(100, Estop{}));
    QCOMPARE(host.board().torque(), 300);
    host.wait(1s);
    QCOMPARE(host.pitch(), stoppedAt);

    QVERIFY(host.askWith(101, Estop{}));
    QCOMPARE(host.board().torque(), 0);
    host.get<ClearFaultReply>(ClearFault{});
    QCOMPARE(host.board().torque(), 0);
    host.get<ArmReply>(Arm{1});
    QCOMPARE(host.board().torque(), 1000);
}

void EmulatedBoardTest::aRequestThatComesTwiceIsDoneOnce()
{
    BoardHost host{levelBoard()};
    host.greetAndArm();

    const auto first = host.askWith(50, Move{600, 400, 1, 0});
    host.wait(500ms);
    const auto other = host.askWith(51, Move{700, 400, 1, 0});
    const auto again = host.askWith(50, Move{600, 400, 1, 0});
    host.wait(1s);

    QVERIFY(first && other);
    QCOMPARE(again, first);
    QVERIFY(isClose(host.pitch(), pitchOf(700), 1e-4));
    QCOMPARE(host.all<ArrivedEvent>().size(), std::size_t(2));
    // The same number with another content is another request.
    QVERIFY(host.askWith(51, Move{500, 400, 1, 0}) != other);
    host.wait(1s);
    QVERIFY(isClose(host.pitch(), pitchOf(500), 1e-4));
}

void EmulatedBoardTest::onlyTheLastTwoRepliesAreKept()
{
    BoardHost host{levelBoard()};
    host.greetAndArm();
    host.askWith(50, Estop{});
    host.askWith(51, Stop{});
    for (int seq = 52; seq < 60; ++seq) {
        host.askWith(seq, Heartbeat{1});
        host.askWith(seq, GetStatus{});
        host.askWith(seq, GetConfig{});
    }

    host.askWith(50, Estop{});
    QCOMPARE(host.board().torque(), 300);
    host.askWith(60, Stop{});
    host.askWith(50, Estop{});

    QCOMPARE(host.board().torque(), 0);
}

void EmulatedBoardTest::aNewSessionForgetsTheRepliesAndDisarms()
{
    BoardHost host{levelBoard()};
    host.greetAndArm();
    host.askWith(50, Move{800, 100, 1, 0});
    host.wait(200ms);

    host.get<HelloReply>(Hello{});
    QCOMPARE(host.board().state(), State::Unarmed);
    host.wait(300ms);
    const double restsAt = host.pitch();
    host.wait(300ms);
    QCOMPARE(host.pitch(), restsAt);
    const auto again = host.askWith(50, Move{800, 100, 1, 0});

    QVERIFY(again);
    QCOMPARE(int(again->type), int(Nak::kType));
}

void EmulatedBoardTest::positionsComeAsOftenAsTheyAreAskedFor()
{
    BoardHost host{levelBoard()};
    host.greet(200);
    host.events.clear();

    host.wait(1s, false);

    const auto positions = host.all<PositionEvent>();
    QCOMPARE(positions.size(), std::size_t(200));
    for (std::size_t i = 1; i < positions.size(); ++i)
        QCOMPARE(positions[i].atUs - positions[i - 1].atUs, std::uint64_t(5000));
    QCOMPARE(int(positions[0].pos), 512);
}

void EmulatedBoardTest::eventsAreCountedFrom8000OnWithEveryHello()
{
    BoardHost host{levelBoard()};
    host.greet(100);
    host.wait(100ms);
    QVERIFY(host.events.size() > 5);
    QCOMPARE(int(host.events[0].seq), 0x8000);
    QCOMPARE(int(host.events[1].seq), 0x8001);

    host.events.clear();
    host.get<HelloReply>(Hello{});
    host.wait(50ms);

    QVERIFY(std::any_of(host.events.begin(), host.events.end(), [](const Frame& f) { return f.seq == 0x8000; }));
    QVERIFY(host.events.back().seq < 0x8008);
    QCOMPARE(host.parser.counters().lostEvents, std::uint64_t(0));
}

void EmulatedBoardTest::aTriggeredSliceHasTheAngleOfTheEdge()
{
    BoardHost host{levelBoard()};
    host.greetAndArm();
    host.get<MoveReply>(Move{712, 160, 0, 0});
    host.wait(300ms);

    host.get<TriggerReply>(Trigger{17});
    host.wait(50ms);

    const auto slices = host.all<SliceEvent>();
    QCOMPARE(slices.size(), std::size_t(1));
    QCOMPARE(slices[0].slice, 17U);
    const std::chrono::microseconds edge{static_cast<std::int64_t>(slices[0].atUs)};
    QVERIFY((edge - 3ms) % 25ms == 0us);
    const double counts = 512 + (host.board().pitchAt(edge) - degrees(90.0)) / kCountAngle;
    QVERIFY(std::abs(slices[0].pos - counts) <= 0.5);
    QCOMPARE(int(slices[0].moved), 3);  // 160 counts a second for 18.75 ms
    QCOMPARE(slices[0].state, State::Moving);
}

void EmulatedBoardTest::withoutTheSyncWireThereIsAFault()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.nextEdge = nullptr;
    BoardHost host{setup};
    host.greetAndArm();

    host.get<TriggerReply>(Trigger{1});
    host.wait(1100ms);
    QCOMPARE(host.all<FaultEvent>().at(0).code, Fault::NoSync);
    QCOMPARE(host.board().state(), State::Armed);
    host.get<SweepReply>(Sweep{512, 700, 4, 40, 0, 8, 160, 1});
    host.wait(1500ms);

    QCOMPARE(host.all<FaultEvent>().size(), std::size_t(2));
    QCOMPARE(host.all<FaultEvent>()[1].state, State::Stopped);
    QVERIFY(host.all<SliceEvent>().empty());
}

void EmulatedBoardTest::aSweepStopsForEverySlice()
{
    BoardHost host{levelBoard()};
    host.greetAndArm();

    host.get<SweepReply>(Sweep{400, 480, 4, 21, 0, 8, 160, 100});
    host.wait(4s);

    const auto slices = host.all<SliceEvent>();
    QCOMPARE(slices.size(), std::size_t(21));
    for (int i = 0; i < 21; ++i) {
        const SliceEvent& slice = slices[static_cast<std::size_t>(i)];
        QCOMPARE(slice.slice, 100U + static_cast<unsigned>(i));
        QVERIFY(std::abs(slice.pos - (400 + 4 * i)) <= 2);
        QVERIFY(std::abs(slice.moved) <= 1);
        QVERIFY((std::chrono::microseconds{static_cast<std::int64_t>(slice.atUs)} - 3ms) % 25ms == 0us);
        QCOMPARE(int(slice.err), 0);
    }
    const double duration = static_cast<double>(slices.back().atUs - slices.front().atUs) * 1e-6;
    QVERIFY(duration <= 20 * 0.1);
    QCOMPARE(host.all<ArrivedEvent>().size(), std::size_t(1));
    QCOMPARE(host.board().state(), State::Armed);
}

void EmulatedBoardTest::aSweepDownwardsIsOneToo()
{
    BoardHost host{levelBoard()};
    host.greetAndArm();

    host.get<SweepReply>(Sweep{520, 500, 10, 3, 0, 8, 160, 1});
    host.wait(1s);

    const auto slices = host.all<SliceEvent>();
    QCOMPARE(slices.size(), std::size_t(3));
    QVERIFY(std::abs(slices[2].pos - 500) <= 2);
}

void EmulatedBoardTest::aContinuousSweepMovesOneStepATurn()
{
    BoardHost host{levelBoard()};
    host.greetAndArm();

    host.get<SweepReply>(Sweep{400, 640, 4, 50, 1, 8, 160, 1});
    host.wait(4s);

    const auto slices = host.all<SliceEvent>();
    QCOMPARE(slices.size(), std::size_t(50));
    QCOMPARE(int(slices[0].pos), 400);
    for (std::size_t i = 2; i < slices.size(); ++i) {
        QCOMPARE(slices[i].atUs - slices[i - 1].atUs, std::uint64_t(25'000));
        QVERIFY(std::abs(slices[i].pos - slices[i - 1].pos - 4) <= 1);
        QVERIFY(std::abs(slices[i].moved - 3) <= 1);
    }
    QVERIFY(std::abs(slices[49].pos - slices[9].pos - 160) <= 1);
    QCOMPARE(host.all<ArrivedEvent>().size(), std::size_t(1));
    QCOMPARE(host.board().state(), State::Armed);
}

void EmulatedBoardTest::whatHoldsTheMotorIsAFault()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.faults = {{"board-stall", 0}};
    BoardHost host{setup};
    host.greetAndArm();

    host.get<MoveReply>(Move{700, 100, 1, 0});
    host.wait(290ms);
    QVERIFY(host.all<FaultEvent>().empty());
    host.wait(20ms);

    QCOMPARE(host.all<FaultEvent>().size(), std::size_t(1));
    QCOMPARE(host.all<FaultEvent>()[0].code, Fault::Stall);
    QCOMPARE(int(host.all<FaultEvent>()[0].detail), 700);
    QCOMPARE(host.board().state(), State::Fault);
    QCOMPARE(host.get<ClearFaultReply>(ClearFault{}).state, State::Unarmed);
    // At two counts a second a count takes half a second: three of these are waited for.
    host.get<ArmReply>(Arm{1});
    host.get<MoveReply>(Move{700, 2, 1, 0});
    host.wait(1400ms);
    QCOMPARE(host.board().state(), State::Moving);
    host.wait(200ms);
    QCOMPARE(host.board().state(), State::Fault);
}

void EmulatedBoardTest::passingALimitStopsIt()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.dynamics.overshoot = 0.1;  // 20 counts
    BoardHost host{setup};
    host.greetAndArm();

    host.get<MoveReply>(Move{800, 400, 1, 0});
    host.wait(2s);

    const auto limits = host.all<LimitEvent>();
    QCOMPARE(limits.size(), std::size_t(1));
    QCOMPARE(int(limits[0].limit), 800);
    QCOMPARE(int(limits[0].side), 1);
    QVERIFY(limits[0].pos > 802);
    QCOMPARE(host.board().state(), State::Stopped);
    QVERIFY(host.all<ArrivedEvent>().empty());
    // From outside it may come back in.
    host.get<ArmReply>(Arm{1});
    host.get<MoveReply>(Move{700, 100, 0, 0});
    host.wait(3s);
    QCOMPARE(host.all<LimitEvent>().size(), std::size_t(1));
    QCOMPARE(host.all<ArrivedEvent>().size(), std::size_t(1));
}

void EmulatedBoardTest::itsClockDrifts()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.clockDrift = 0.001;
    setup.bootAt = 2s;
    BoardHost host{setup};
    host.wait(12s, false);

    const auto beat = host.get<HeartbeatReply>(Heartbeat{77});

    QCOMPARE(beat.hostUs, std::uint64_t(77));
    // Heard 0.2 ms after 12 s by a clock that began at 2 s and gains a millisecond a second.
    QCOMPARE(beat.receivedUs, std::uint64_t(10'010'200));
    QCOMPARE(beat.sentUs, std::uint64_t(10'010'260));
}

void EmulatedBoardTest::statusTellsWhatWasLost()
{
    BoardHost host{levelBoard()};
    std::vector<std::uint8_t> damaged = encodeFrame(toFrame(1, Hello{}));
    damaged[6] ^= 0x10;
    host.sendBytes(damaged);
    host.sendBytes(std::vector<std::uint8_t>(100, 0x55));
    host.sendBytes({0});

    const auto status = host.get<StatusReply>(GetStatus{});

    QCOMPARE(status.crcErrors, 1U);
    QCOMPARE(status.lostBytes, 108U);
    QCOMPARE(int(status.voltMv), 14'800);
    QCOMPARE(int(status.tempC), 38);
}

void EmulatedBoardTest::edgesComeEveryPeriod()
{
    const auto next = edgesEvery(25ms, 3ms);

    QVERIFY(next(0ms) == 3ms);
    QVERIFY(next(3ms) == 28ms);
    QVERIFY(next(28ms - 1ns) == 28ms);
    QVERIFY(next(-30ms) == -22ms);
    QVERIFY(next(-22ms) == 3ms);
}

void EmulatedBoardTest::faultsOfNoKindAreRefusedWithThoseThatThereAre()
{
    EmulatedBoardSetup setup;
    for (const BoardFaultKind& kind : boardFaultKinds()) {
        setup.faults = {{std::string{kind.kind}, 3}};
        QVERIFY(EmulatedBoard::make(setup));
        QVERIFY(!kind.sentence.empty());
    }
    setup.faults = {{"board-on-fire", 0}};
    const auto none = EmulatedBoard::make(setup);
    QCOMPARE(none.error().code, ErrorCode::Usage);
    for (const BoardFaultKind& kind : boardFaultKinds())
        QVERIFY(none.error().message.find(kind.kind) != std::string::npos);
    setup.faults = {{"board-crc", -1}};
    QCOMPARE(EmulatedBoard::make(setup).error().code, ErrorCode::Usage);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::EmulatedBoardTest)
#include "emulated_board_test.moc"
