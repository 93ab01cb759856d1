// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QtTest>

#include "tests/devices/board/board_rig.h"
#include "tests/devices/holds.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;
using board::State;

/// A board that has stopped for a reason waits until a person has seen to it.
class BoardTiltRecoveryTest : public QObject {
    Q_OBJECT

private slots:
    void whatHasStoppedStaysSoUntilItIsRecovered_data();
    void whatHasStoppedStaysSoUntilItIsRecovered();
    void aButtonThatIsPressedIsNotOverruled();
    void anotherProgramsStopIsNoSecondOne();
    void aHoldOfItsOwnNeedsNobody();
    void aHoldWorksAgainAfterTheBoardHasStartedAnew();
    void aBoardTellsWhenItHasStarted();
    void aBoardThatHasStartedAnewTellsALaterMoment();
    void withoutATroubleRecoveryDoesNothing();
    void whoIsNotConnectedCannotBeRecovered();
    void aBoardThatSendsNoAnglesIsLost();
    void samplesTellHowFarTheirMomentMayBeOff();
    void everyFaultIsLogged();
};

namespace {

/// Board faults begin at a turn of 25 ms; the motor is on its way then.
struct Moving : BoardRig {
    explicit Moving(const std::string& fault) : BoardRig(with(fault)) {}

    static EmulatedBoardSetup with(const std::string& fault)
    {
        EmulatedBoardSetup setup = levelBoard();
        if (!fault.empty())
            setup.faults = {{fault, 40}};
        return setup;
    }
    bool isUnderWay()
    {
        return tilt.connect({}) && tilt.arm({}) && tilt.moveTo(degrees(160.0), degrees(20.0)) && watch(100ms);
    }
};

}  // namespace

void BoardTiltRecoveryTest::whatHasStoppedStaysSoUntilItIsRecovered_data()
{
    QTest::addColumn<QString>("fault");
    QTest::addColumn<QString>("says");
    QTest::addColumn<int>("state");
    QTest::newRow("overload") << "board-overload"
                              << "overloaded" << static_cast<int>(State::Fault);
    QTest::newRow("heat") << "board-overheat"
                          << "too hot" << static_cast<int>(State::Fault);
    QTest::newRow("voltage") << "board-voltage"
                             << "voltage" << static_cast<int>(State::Fault);
    QTest::newRow("button") << "board-button"
                            << "emergency" << static_cast<int>(State::Estopped);
}

void BoardTiltRecoveryTest::whatHasStoppedStaysSoUntilItIsRecovered()
{
    QFETCH(QString, fault);
    QFETCH(QString, says);
    QFETCH(int, state);
    Moving rig{fault.toStdString()};
    QVERIFY(rig.isUnderWay());

    const auto samples = rig.watch(3s);

    QVERIFY(!samples);
    QCOMPARE(samples.error().code, ErrorCode::NeedsOperator);
    QVERIFY2(holds(samples.error().message, says.toStdString()), samples.error().message.c_str());
    QVERIFY2(holds(samples.error().message, "recover it"), samples.error().message.c_str());
    QCOMPARE(static_cast<int>(rig.state()), state);
    // Long after the cause is gone nothing releases it by itself: not arm(), not connect().
    QVERIFY(rig.watch(10s));
    const double rest = rig.pitch();
    QCOMPARE(rig.tilt.arm({}).error().code, ErrorCode::NeedsOperator);
    QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(20.0)).error().code, ErrorCode::NeedsOperator);
    QVERIFY(rig.tilt.connect({}));
    QCOMPARE(rig.tilt.arm({}).error().code, ErrorCode::NeedsOperator);
    QCOMPARE(static_cast<int>(rig.state()), state);
    QCOMPARE(rig.pitch(), rest);

    QVERIFY(rig.tilt.recover({}));

    QCOMPARE(rig.state(), State::Unarmed);
    QCOMPARE(rig.tilt.health().trouble, std::string());
    QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(20.0)).error().code, ErrorCode::Usage);  // not armed
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(100.0), degrees(20.0)));
    QVERIFY(rig.arrive());
}

void BoardTiltRecoveryTest::aButtonThatIsPressedIsNotOverruled()
{
    for (const char* const fault : {"board-button", "board-overheat"}) {
        Moving rig{fault};
        QVERIFY(rig.isUnderWay());
        QVERIFY(!rig.watch(3s));

        const auto recovered = rig.tilt.recover({});  // at once: the cause is still there

        QVERIFY(!recovered);
        QCOMPARE(recovered.error().code, ErrorCode::NeedsOperator);
        QVERIFY2(holds(recovered.error().message, "recover it again"), recovered.error().message.c_str());
        QCOMPARE(rig.tilt.arm({}).error().code, ErrorCode::NeedsOperator);
        QVERIFY(rig.watch(4s));
        QVERIFY(rig.tilt.recover({}));
        QVERIFY(rig.tilt.arm({}));
    }
}

void BoardTiltRecoveryTest::anotherProgramsStopIsNoSecondOne()
{
    Moving rig{""};
    QVERIFY(rig.isUnderWay());
    rig.board->receive(encodeFrame(board::toFrame(0x7000, board::Estop{})), rig.clock.now());
    QCOMPARE(rig.watch(1s).error().code, ErrorCode::NeedsOperator);
    QCOMPARE(rig.board->torque(), 300);

    QVERIFY(rig.tilt.hold());

    QCOMPARE(rig.board->torque(), 300);  // a second ESTOP would drop the laser
    QCOMPARE(rig.tilt.arm({}).error().code, ErrorCode::NeedsOperator);
}

void BoardTiltRecoveryTest::aHoldOfItsOwnNeedsNobody()
{
    Moving rig{""};
    QVERIFY(rig.isUnderWay());
    QVERIFY(rig.tilt.hold());
    QCOMPARE(rig.state(), State::Estopped);

    QVERIFY(rig.tilt.arm({}));

    QCOMPARE(rig.state(), State::Armed);
    QVERIFY(rig.tilt.hold());
    QVERIFY(rig.tilt.recover({}));
    QCOMPARE(rig.state(), State::Unarmed);
    QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(20.0)).error().code, ErrorCode::Interrupted);  // still held
    QVERIFY(rig.tilt.arm({}));
}

void BoardTiltRecoveryTest::aHoldWorksAgainAfterTheBoardHasStartedAnew()
{
    Moving rig{"board-reset"};
    QVERIFY(rig.isUnderWay());
    QVERIFY(rig.tilt.hold());
    QVERIFY(!rig.watch(3s) || rig.state() == State::Unarmed);
    QCOMPARE(rig.state(), State::Unarmed);
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.moveTo(degrees(160.0), degrees(20.0)));
    QVERIFY(rig.watch(100ms));

    QVERIFY(rig.tilt.hold());

    QCOMPARE(rig.state(), State::Estopped);
}

void BoardTiltRecoveryTest::aBoardTellsWhenItHasStarted()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.bootAt = -90s;
    BoardRig rig{setup};

    QVERIFY(!rig.tilt.startedAt());
    QVERIFY(rig.tilt.connect({}));

    QVERIFY(rig.tilt.startedAt());
    QVERIFY(std::chrono::abs(*rig.tilt.startedAt() + 90s) < 50ms);  // an answer comes in time
}

void BoardTiltRecoveryTest::aBoardThatHasStartedAnewTellsALaterMoment()
{
    Moving rig{"board-reset"};
    QVERIFY(rig.isUnderWay());
    const auto before = rig.tilt.startedAt();
    QVERIFY(!rig.watch(3s));

    QVERIFY(rig.tilt.connect({}));

    QVERIFY(before);
    QVERIFY(*rig.tilt.startedAt() > *before + 100ms);
    QVERIFY(*rig.tilt.startedAt() <= rig.clock.now());
}

void BoardTiltRecoveryTest::withoutATroubleRecoveryDoesNothing()
{
    Moving rig{""};
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));

    QVERIFY(rig.tilt.recover({}));

    QCOMPARE(rig.state(), State::Armed);
    QVERIFY(rig.tilt.moveTo(degrees(100.0), degrees(20.0)));
}

void BoardTiltRecoveryTest::whoIsNotConnectedCannotBeRecovered()
{
    BoardRig rig;

    QCOMPARE(rig.tilt.recover({}).error().code, ErrorCode::NoDevice);
}

void BoardTiltRecoveryTest::aBoardThatSendsNoAnglesIsLost()
{
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.watch(100ms));
    // Another program has switched the positions off.
    board::SetConfig quiet;
    quiet.low = 200;
    quiet.high = 800;
    quiet.topSpeed = 400;
    quiet.park = 512;
    quiet.parkSpeed = 100;
    quiet.positionHz = 0;
    rig.board->receive(encodeFrame(board::toFrame(0x7000, quiet)), rig.clock.now());
    QVERIFY(rig.watch(50ms));
    const auto from = rig.clock.now();

    const auto samples = rig.watch(10s);

    QVERIFY(!samples);
    QCOMPARE(samples.error().code, ErrorCode::DeviceLost);
    QVERIFY2(holds(samples.error().message, "sends no angles"), samples.error().message.c_str());
    QVERIFY(rig.clock.now() - from <= 1100ms);
    QCOMPARE(rig.tilt.health().faults.at("board-no-angles"), std::uint64_t(1));
}

void BoardTiltRecoveryTest::samplesTellHowFarTheirMomentMayBeOff()
{
    BoardRig rig;
    QVERIFY(rig.tilt.connect({}));

    const auto samples = rig.watch(500ms);

    QVERIFY(samples && samples->size() > 40);
    for (const TiltSample& sample : *samples)  // 0.2 ms each way
        QVERIFY(sample.uncertainty > 190us && sample.uncertainty < 210us);
}

void BoardTiltRecoveryTest::everyFaultIsLogged()
{
    Moving rig{"board-crc"};
    QVERIFY(rig.isUnderWay());
    QVERIFY(rig.watch(1s));
    std::vector<FaultRecord> log = rig.tilt.takeLog();
    QVERIFY(!log.empty());
    const auto crc =
        std::find_if(log.begin(), log.end(), [](const auto& record) { return record.code != "board-lost-events"; });
    QVERIFY(crc != log.end());
    QVERIFY(!crc->bytes.empty());
    const FaultCounts faults = rig.tilt.health().faults;
    std::uint64_t damaged = 0;
    for (const char* const code : {"board-crc", "board-cobs", "board-length", "board-version"})
        damaged += faults.contains(code) ? faults.find(code)->second : 0;
    QCOMPARE(damaged, rig.tilt.health().corrupt);

    Moving stopped{"board-overload"};
    QVERIFY(stopped.isUnderWay());
    QVERIFY(!stopped.watch(3s));
    log = stopped.tilt.takeLog();
    QCOMPARE(log.size(), std::size_t(1));
    QCOMPARE(log[0].code, std::string{"board-overload"});
    QVERIFY(holds(log[0].text, "overloaded"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::BoardTiltRecoveryTest)
#include "board_tilt_recovery_test.moc"
