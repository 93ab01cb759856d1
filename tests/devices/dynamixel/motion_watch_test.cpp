// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/motion_watch.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class MotionWatchTest : public QObject {
    Q_OBJECT

private slots:
    void arrivedAreThreeAnswersAtTheGoal();
    void aStandingServoThatHasNotBegunIsNotThere();
    void aServoThatStillMovesIsNotThere();
    void whatComesNoNearerFor300MillisecondsIsStuck();
    void aSlowMotionIsGivenTheTimeOfItsCounts();
    void whatIsNotThereInTimeIsStuck();
    void whatIsPushedAwayIsOnItsWayAgain();
};

namespace {

using Verdict = MotionWatch::Verdict;

/// From 500 to 600 at 200 counts/s: half a second; within two counts.
MotionWatch watch()
{
    return {500.0, 600.0, 200.0, 2.0, 1s};
}

}  // namespace

void MotionWatchTest::arrivedAreThreeAnswersAtTheGoal()
{
    MotionWatch motion = watch();

    QVERIFY(motion.look(550.0, true, 1s + 250ms) == Verdict::OnItsWay);
    QVERIFY(motion.look(598.0, false, 1s + 490ms) == Verdict::OnItsWay);
    QVERIFY(motion.look(600.0, false, 1s + 500ms) == Verdict::OnItsWay);
    QVERIFY(motion.look(601.0, false, 1s + 510ms) == Verdict::Arrived);
    QVERIFY(motion.look(600.0, false, 2h) == Verdict::Arrived);
}

void MotionWatchTest::aStandingServoThatHasNotBegunIsNotThere()
{
    MotionWatch motion = watch();

    for (int i = 0; i < 10; ++i)
        QVERIFY(motion.look(500.0, false, 1s + i * 10ms) == Verdict::OnItsWay);
}

void MotionWatchTest::aServoThatStillMovesIsNotThere()
{
    MotionWatch motion = watch();

    for (int i = 0; i < 5; ++i)
        QVERIFY(motion.look(599.0, true, 1s + 490ms + i * 5ms) == Verdict::OnItsWay);
    QVERIFY(motion.look(600.0, false, 1s + 520ms) == Verdict::OnItsWay);
}

void MotionWatchTest::whatComesNoNearerFor300MillisecondsIsStuck()
{
    MotionWatch motion = watch();

    QVERIFY(motion.look(520.0, true, 1s + 100ms) == Verdict::OnItsWay);
    QVERIFY(motion.look(520.0, true, 1s + 400ms) == Verdict::OnItsWay);
    QVERIFY(motion.look(519.0, false, 1s + 401ms) == Verdict::Stuck);
}

void MotionWatchTest::aSlowMotionIsGivenTheTimeOfItsCounts()
{
    // 2 counts/s: three counts take 1.5 s.
    MotionWatch motion{500.0, 510.0, 2.0, 2.0, 0s};

    QVERIFY(motion.look(500.0, true, 1s + 400ms) == Verdict::OnItsWay);
    QVERIFY(motion.look(500.0, true, 1s + 600ms) == Verdict::Stuck);
}

void MotionWatchTest::whatIsNotThereInTimeIsStuck()
{
    // Three times half a second and 500 ms; always a little nearer.
    MotionWatch motion = watch();

    for (int i = 0; i <= 20; ++i)
        QVERIFY(motion.look(500.0 + i, true, 1s + i * 100ms) == Verdict::OnItsWay);
    QVERIFY(motion.look(521.0, true, 3s + 1ms) == Verdict::Stuck);
}

void MotionWatchTest::whatIsPushedAwayIsOnItsWayAgain()
{
    MotionWatch motion = watch();
    for (int i = 0; i < 3; ++i)
        motion.look(600.0, false, 1s + 500ms);

    QVERIFY(motion.look(580.0, false, 1min) == Verdict::OnItsWay);
    QVERIFY(motion.look(580.0, false, 1min + 299ms) == Verdict::OnItsWay);
    QVERIFY(motion.look(580.0, false, 1min + 301ms) == Verdict::Stuck);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MotionWatchTest)
#include "motion_watch_test.moc"
