// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/pacer.h"

#include <limits>
#include <thread>

#include <QtTest>

#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class PacerTest : public QObject {
    Q_OBJECT

private slots:
    void theFirstSliceIsDueAtOnce();
    void slicesAreDueAtTheTimesAtWhichTheyWereMeasured();
    void speedTwoTakesHalfTheTime();
    void speedZeroTakesNoTime();
    void whatIsLateIsMadeUpFor();
    void aPauseInTheRecordingIsShortened();
    void timesThatRunBackwardsAreNotWaitedFor();
    void aPausedScanWaitsAndTheTimeOfThePauseDoesNotCount();
    void singleStepsLetOneSliceThroughEach();
    void aStepOfARunningScanIsRefused();
    void aNewSpeedHoldsForWhatIsLeftOfAWait();
    void aStopEndsTheWait();
    void whatIsNoSpeedIsRefused();
    void theRealClockIsWaitedForAndWoken();
};

namespace {

/// Waits until a thread has come to wait at a clock that stands.
void waitForAWait(const FakeClock& clock, int before)
{
    QTRY_VERIFY(clock.waits() > before);
}

}  // namespace

void PacerTest::theFirstSliceIsDueAtOnce()
{
    FakeClock clock;
    Pacer pacer{clock, 1.0};

    QVERIFY(pacer.wait(90s, {}));

    QVERIFY(clock.now() == 0ns);
}

void PacerTest::slicesAreDueAtTheTimesAtWhichTheyWereMeasured()
{
    FakeClock clock;
    Pacer pacer{clock, 1.0};

    QVERIFY(pacer.wait(10s, {}));
    QVERIFY(pacer.wait(10s + 25ms, {}));
    QVERIFY(clock.now() == 25ms);
    QVERIFY(pacer.wait(10s + 75ms, {}));
    QVERIFY(clock.now() == 75ms);
}

void PacerTest::speedTwoTakesHalfTheTime()
{
    FakeClock clock;
    Pacer pacer{clock, 2.0};

    pacer.wait(0s, {});
    pacer.wait(1s, {});

    QVERIFY(clock.now() == 500ms);
}

void PacerTest::speedZeroTakesNoTime()
{
    FakeClock clock;
    Pacer pacer{clock, 0.0};

    pacer.wait(0s, {});
    pacer.wait(1s, {});

    QVERIFY(clock.now() == 0ns);
}

void PacerTest::whatIsLateIsMadeUpFor()
{
    FakeClock clock;
    Pacer pacer{clock, 1.0};

    pacer.wait(0s, {});
    clock.advance(60ms);
    pacer.wait(25ms, {});
    QVERIFY(clock.now() == 60ms);
    pacer.wait(50ms, {});
    QVERIFY(clock.now() == 60ms);
    pacer.wait(75ms, {});

    QVERIFY(clock.now() == 75ms);
}

void PacerTest::aPauseInTheRecordingIsShortened()
{
    FakeClock clock;
    Pacer pacer{clock, 1.0};

    pacer.wait(0s, {});
    pacer.wait(std::chrono::hours{1'000'000}, {});

    QVERIFY(clock.now() == kLongestGap);
}

void PacerTest::timesThatRunBackwardsAreNotWaitedFor()
{
    FakeClock clock;
    Pacer pacer{clock, 1.0};

    pacer.wait(10s, {});
    pacer.wait(0s, {});
    pacer.wait(1s, {});

    QVERIFY(clock.now() == 1s);
}

void PacerTest::aPausedScanWaitsAndTheTimeOfThePauseDoesNotCount()
{
    FakeClock clock{FakeClock::Kind::Stands};
    Pacer pacer{clock, 1.0};
    pacer.wait(0s, {});
    std::atomic<bool> passed{false};
    std::jthread waiting{[&] { passed = pacer.wait(100ms, {}); }};
    waitForAWait(clock, 0);

    clock.advance(40ms);
    pacer.pause();
    clock.advance(1h);
    waitForAWait(clock, clock.waits() + 1);
    QVERIFY(!passed);
    pacer.resume();
    clock.advance(59ms);
    waitForAWait(clock, clock.waits() + 1);
    QVERIFY(!passed);
    clock.advance(1ms);

    QTRY_VERIFY(passed);
}

void PacerTest::singleStepsLetOneSliceThroughEach()
{
    FakeClock clock;
    Pacer pacer{clock, 1.0};
    pacer.pause();
    std::atomic<int> passed{0};
    std::jthread waiting{[&](const std::stop_token& stop) {
        for (std::chrono::microseconds time{0}; pacer.wait(time, stop); time += 25ms)
            ++passed;
    }};

    QVERIFY(pacer.step());
    QVERIFY(pacer.step());
    QTRY_COMPARE(passed.load(), 2);
    waitForAWait(clock, clock.waits() + 1);

    QCOMPARE(passed.load(), 2);
}

void PacerTest::aStepOfARunningScanIsRefused()
{
    FakeClock clock;
    Pacer pacer{clock, 1.0};

    const Result<void> stepped = pacer.step();

    QVERIFY(!stepped);
    QCOMPARE(stepped.error().code, ErrorCode::Usage);
}

void PacerTest::aNewSpeedHoldsForWhatIsLeftOfAWait()
{
    FakeClock clock{FakeClock::Kind::Stands};
    Pacer pacer{clock, 1.0};
    pacer.wait(0s, {});
    std::atomic<bool> passed{false};
    std::jthread waiting{[&] { passed = pacer.wait(1s, {}); }};
    waitForAWait(clock, 0);

    clock.advance(500ms);
    QVERIFY(pacer.setSpeed(10.0));
    clock.advance(49ms);
    waitForAWait(clock, clock.waits() + 1);
    QVERIFY(!passed);
    clock.advance(1ms);

    QTRY_VERIFY(passed);
}

void PacerTest::aStopEndsTheWait()
{
    FakeClock clock;
    Pacer pacer{clock, 1.0};
    pacer.pause();
    std::atomic<bool> passed{true};
    std::jthread waiting{[&](const std::stop_token& stop) { passed = pacer.wait(0s, stop); }};

    waiting.request_stop();
    waiting.join();

    QVERIFY(!passed);
}

void PacerTest::whatIsNoSpeedIsRefused()
{
    FakeClock clock;
    Pacer pacer{clock, 1.0};

    for (const double speed :
         {-1.0, 0.001, 2000.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        QVERIFY(!isReplaySpeed(speed));
        QVERIFY(!pacer.setSpeed(speed));
    }
    for (const double speed : {0.0, 0.01, 1.0, 1000.0})
        QVERIFY(pacer.setSpeed(speed));
}

void PacerTest::theRealClockIsWaitedForAndWoken()
{
    Pacer pacer{steadyClock(), 1.0};
    const auto began = steadyClock().now();
    QVERIFY(pacer.wait(0s, {}));
    QVERIFY(pacer.wait(20ms, {}));
    QVERIFY(steadyClock().now() - began >= 20ms);
    pacer.pause();
    std::jthread waiting{[&] { pacer.wait(2s, {}); }};

    pacer.resume();
    QVERIFY(pacer.setSpeed(0.0));
    waiting.join();

    QVERIFY(steadyClock().now() - began < 60s);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PacerTest)
#include "pacer_test.moc"
