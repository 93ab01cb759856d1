// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/unit_motion.h"

#include <QtTest>

#include "app/sources/unit_tasks.h"
#include "tests/app/sources/fake_devices.h"
#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

/// A head that is moved outside of a scan: whatever happens, it is held in the end.
class UnitMotionTest : public QObject {
    Q_OBJECT

private slots:
    void itGoesToLevelAndIsHeldThere();
    void aStopHoldsAtOnceInTheThreadThatAsks();
    void aStopWhileItIsArmedHoldsAllTheSame();
    void nothingMovesAfterAStop();
    void aRefusedMoveIsHeld();
    void aBlockedHeadIsToldWithWhereItStands();
    void aSilentUnitIsToldAsOne();
    void theEndOfItComesToRest();
    void aUnitIsReleasedAndMovesNothing();
    void aUnitThatIsBroughtHomeSaysWhereItIsHeld();
};

namespace {

struct Rig {
    FakeClock clock;
    std::shared_ptr<FakeHead> head = std::make_shared<FakeHead>();
    std::stop_source stop;
    std::optional<UnitMotion> motion;

    Rig() { motion.emplace(std::make_unique<FakeUnit>(head, clock), clock, stop.get_token()); }
};

bool contains(const Error& error, const char* text)
{
    return error.message.find(text) != std::string::npos;
}

}  // namespace

void UnitMotionTest::itGoesToLevelAndIsHeldThere()
{
    Rig rig;
    rig.head->pitch = rig.head->goal = degrees(30.0);

    const auto there = rig.motion->goHome();

    QVERIFY2(there, there ? "" : there.error().message.c_str());
    QVERIFY(std::abs(*there - degrees(90.0)) < degrees(0.7));
    QVERIFY(rig.head->isHeld);
    QCOMPARE(rig.head->speed, degrees(20.0));
    // 60° at 20° a second take 3 s.
    QVERIFY(rig.clock.now() >= 2900ms && rig.clock.now() < 3500ms);
}

void UnitMotionTest::aStopHoldsAtOnceInTheThreadThatAsks()
{
    Rig rig;
    rig.head->pitch = rig.head->goal = degrees(30.0);
    double stoppedAt = 0.0;
    int holdsAtOnce = 0;
    rig.head->onSample = [&] {
        if (rig.head->pitch < degrees(50.0) || stoppedAt > 0.0)
            return;
        stoppedAt = rig.head->pitch;
        rig.stop.request_stop();
        holdsAtOnce = rig.head->holds;
    };

    const auto there = rig.motion->goHome();

    QVERIFY(!there);
    QCOMPARE(there.error().code, ErrorCode::Interrupted);
    QVERIFY(contains(there.error(), "stopped"));
    QCOMPARE(holdsAtOnce, 1);
    QVERIFY(std::abs(rig.head->pitch - stoppedAt) < degrees(0.5));
    QVERIFY(rig.head->isHeld);
}

void UnitMotionTest::aStopWhileItIsArmedHoldsAllTheSame()
{
    Rig rig;
    rig.head->whileArmed = [&] { rig.stop.request_stop(); };

    const auto armed = rig.motion->arm();

    QVERIFY(!armed);
    QCOMPARE(armed.error().code, ErrorCode::Interrupted);
    QVERIFY(rig.head->isHeld);  // arming has taken back the first hold
    QCOMPARE(rig.head->holds.load(), 2);
}

void UnitMotionTest::nothingMovesAfterAStop()
{
    Rig rig;
    rig.stop.request_stop();

    const auto there = rig.motion->goHome();

    QVERIFY(!there);
    QVERIFY(!rig.head->isArmed);
    QCOMPARE(rig.head->moves, 0);
}

void UnitMotionTest::aRefusedMoveIsHeld()
{
    Rig rig;
    QVERIFY(rig.motion->arm());
    rig.head->refusal = Error{ErrorCode::DeviceLost, "no answer"};

    const auto moved = rig.motion->moveTo(degrees(95.0), degrees(20.0));

    QVERIFY(!moved);
    QCOMPARE(moved.error().message, std::string("no answer"));
    QVERIFY(rig.head->isHeld);
}

void UnitMotionTest::aBlockedHeadIsToldWithWhereItStands()
{
    Rig rig;
    QVERIFY(rig.motion->arm());
    rig.head->isBlocked = true;

    const auto moved = rig.motion->moveTo(degrees(95.0), degrees(20.0));

    QVERIFY(!moved);
    QCOMPARE(moved.error().code, ErrorCode::DeviceLost);
    QVERIFY2(contains(moved.error(), "does not get to 95° but stands at 90°"), moved.error().message.c_str());
    QVERIFY(rig.head->isHeld);
    // Three times the 0.25 s that 5° at 20° a second take, and a second.
    QVERIFY(rig.clock.now() >= 1750ms && rig.clock.now() < 2s);
}

void UnitMotionTest::aSilentUnitIsToldAsOne()
{
    Rig rig;
    QVERIFY(rig.motion->arm());
    rig.head->isSilent = true;

    const auto moved = rig.motion->moveTo(degrees(95.0), degrees(20.0));

    QVERIFY(!moved);
    QVERIFY2(contains(moved.error(), "has not told its angle for a second"), moved.error().message.c_str());
    QVERIFY(rig.head->isHeld);
    QCOMPARE(rig.head->moves, 0);  // nobody moves what he does not see
}

void UnitMotionTest::aUnitIsReleasedAndMovesNothing()
{
    FakeClock clock;
    const auto head = std::make_shared<FakeHead>();
    FakeAccess devices(head, clock);

    const auto released = releaseUnit(devices, {}, {});

    QCOMPARE(released.value(), std::string("fake unit is released"));
    QCOMPARE(head->recoveries, 1);
    QVERIFY(!head->isArmed);
    QCOMPARE(head->moves, 0);
}

void UnitMotionTest::aUnitThatIsBroughtHomeSaysWhereItIsHeld()
{
    FakeClock clock;
    const auto head = std::make_shared<FakeHead>();
    FakeAccess devices(head, clock);
    head->pitch = head->goal = degrees(80.0);

    const auto home = bringUnitHome(devices, {}, clock, {});

    QCOMPARE(home.value_or(""), std::string("fake unit is held at 90°"));
    QVERIFY(head->isHeld);
}

void UnitMotionTest::theEndOfItComesToRest()
{
    Rig rig;
    QVERIFY(rig.motion->arm());

    rig.motion.reset();

    QVERIFY(rig.head->isHeld);
    QCOMPARE(rig.head->rests, 1);
    QCOMPARE(rig.head->holds.load(), 0);  // which is for emergencies
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::UnitMotionTest)
#include "unit_motion_test.moc"
