// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_clock.h"

#include <random>

#include <QtTest>

#include "devices/scip/scip_stamps.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;
using Time = std::chrono::nanoseconds;

class ScipClockTest : public QObject {
    Q_OBJECT

private slots:
    void stampsGoOnFromTheEndOfTheRangeToZero();
    void stampsGoOnThereWithScansLost();
    void stampsGoOnForDays();
    void aSmallStepBackOpensAnEpoch();
    void aClockSetToZeroLateInItsRangeIsNotTakenForOneThatPassedTheEnd();
    void aJumpForwardBeyondTheTimeThatPassedOpensAnEpoch();
    void aStampThatComesPromptlyHasGoneOnAsMuchAsTheTime();
    void theSameStampIsCounted();
    void nothingIsKnownOfWhatWasForgotten();
    void scansComeWhenTheyWereMeasuredByAnswersOfTimeMode();
    void withoutAnswersScansAreLateByTheWay();
    void withoutAnswersTheClocksAreKnownAfterSomeScans();
    void theWayIsKnownFromAnswersBefore();
    void aClockThatDriftsIsFollowed_data();
    void aClockThatDriftsIsFollowed();
    void aScanThatIsLateIsToldAndDoesNotMoveTheOthers();
    void theStampOfTheScanBeforeIsToldByItsArrival();
    void afterAResetTheWayIsStillKnown();
    void answersThatCannotBeTrueAreDropped();
    void clocksThatDoNotStandAsTheyDidAreComparedAnew_data();
    void clocksThatDoNotStandAsTheyDidAreComparedAnew();
    void slowAnswersTellNothing();
    void theQuickestAnswerCounts();
};

namespace {

constexpr std::uint32_t kLast = 0xFFFFFF;
constexpr Time kEnd = 18'750us;
constexpr Time kPeriod = 25ms;

/// A laser whose clock begins at some moment of the host's and may run wrongly.
struct TickingLaser {
    Time zero{0};
    double drift = 0.0;

    std::uint32_t stampAt(Time host) const
    {
        const double milliseconds = std::chrono::duration<double, std::milli>(host - zero).count() * (1.0 + drift);
        return static_cast<std::uint32_t>(static_cast<std::int64_t>(milliseconds) % kScipClockRange);
    }
};

/// Largest and least error of the times of scans.
struct Errors {
    double least = 1e9;
    double most = -1e9;

    void add(Time found, Time truth)
    {
        const double error = std::chrono::duration<double, std::milli>(found - truth).count();
        least = std::min(least, error);
        most = std::max(most, error);
    }
};

/// A second's worth of answers in time mode: 1 ms there, 1 ms back, and longer every other time.
void ask(ScipClock& clock, const TickingLaser& laser, Time from)
{
    for (int question = 0; question < 8; ++question) {
        const Time asked = from + question * 20ms;
        const Time slow = question % 2 == 0 ? 8ms : 0ms;
        clock.addAnswer(laser.stampAt(asked + 1ms + slow), asked, asked + 2ms + slow);
    }
}

}  // namespace

void ScipClockTest::stampsGoOnFromTheEndOfTheRangeToZero()
{
    ScipStamps stamps;

    QCOMPARE(stamps.take(kLast - 24, 0ms).milliseconds, std::int64_t(kLast - 24));
    QCOMPARE(stamps.take(0, 25ms).milliseconds, std::int64_t(kLast) + 1);
    const ScipTime next = stamps.take(25, 50ms);

    QCOMPARE(next.milliseconds, std::int64_t(kLast) + 26);
    QCOMPARE(next.epoch, 1);
    QVERIFY(!next.isNewEpoch);
}

void ScipClockTest::stampsGoOnThereWithScansLost()
{
    for (const int lost : {1, 40, 4000}) {
        ScipStamps stamps;
        const auto gap = 25 * (lost + 1);
        stamps.take(kLast, 0ms);

        const ScipTime next = stamps.take(static_cast<std::uint32_t>(gap - 1), std::chrono::milliseconds{gap});

        QCOMPARE(next.milliseconds, std::int64_t(kLast) + gap);
        QVERIFY(!next.isNewEpoch);
    }
}

void ScipClockTest::stampsGoOnForDays()
{
    ScipStamps stamps;
    for (std::int64_t t = 0; t < 4 * kScipClockRange; t += 60'000) {
        const ScipTime time =
            stamps.take(static_cast<std::uint32_t>(t % kScipClockRange), std::chrono::milliseconds{t});
        QCOMPARE(time.milliseconds, t);
        QCOMPARE(time.epoch, 1);
    }
}

void ScipClockTest::aSmallStepBackOpensAnEpoch()
{
    ScipStamps stamps;
    stamps.take(500'000, 0ms);

    const ScipTime reset = stamps.take(3, 25ms);
    const ScipTime next = stamps.take(28, 50ms);

    QVERIFY(reset.isNewEpoch);
    QCOMPARE(reset.epoch, 2);
    QCOMPARE(reset.milliseconds, std::int64_t(3));
    QVERIFY(!next.isNewEpoch);
    QCOMPARE(next.epoch, 2);
    QCOMPARE(next.milliseconds, std::int64_t(28));
}

void ScipClockTest::aClockSetToZeroLateInItsRangeIsNotTakenForOneThatPassedTheEnd()
{
    ScipStamps stamps;
    stamps.take(16'000'000, 0ms);  // 777 s before its end

    QVERIFY(stamps.take(3, 25ms).isNewEpoch);
}

void ScipClockTest::aJumpForwardBeyondTheTimeThatPassedOpensAnEpoch()
{
    ScipStamps stamps;
    stamps.take(1000, 0ms);

    QVERIFY(!stamps.take(2000, 25ms).isNewEpoch);  // the way may have been long before
    QVERIFY(stamps.take(9000, 50ms).isNewEpoch);
}

void ScipClockTest::aStampThatComesPromptlyHasGoneOnAsMuchAsTheTime()
{
    // Its clock has been set to zero meanwhile, and has gone on beyond what it showed.
    for (const bool isPrompt : {false, true}) {
        ScipStamps stamps;
        stamps.take(1000, 0ms);
        QCOMPARE(stamps.take(1100, 4s, isPrompt).isNewEpoch, isPrompt);
        QVERIFY(!stamps.take(2100, 5s, isPrompt).isNewEpoch);
        QVERIFY(!stamps.take(2600, 5s + 300ms, isPrompt).isNewEpoch);
    }
}

void ScipClockTest::theSameStampIsCounted()
{
    ScipStamps stamps;

    QCOMPARE(stamps.take(1000, 0ms).repeats, 0);
    QCOMPARE(stamps.take(1000, 25ms).repeats, 1);
    QCOMPARE(stamps.take(1000, 50ms).repeats, 2);
    QCOMPARE(stamps.take(1075, 75ms).repeats, 0);
}

void ScipClockTest::nothingIsKnownOfWhatWasForgotten()
{
    ScipStamps stamps;
    stamps.take(1000, 0ms);

    stamps.forget();
    const ScipTime next = stamps.take(17, std::chrono::hours{10});

    QVERIFY(!next.isNewEpoch);
    QCOMPARE(next.epoch, 2);
    QCOMPARE(next.repeats, 0);
}

void ScipClockTest::scansComeWhenTheyWereMeasuredByAnswersOfTimeMode()
{
    std::mt19937 random(1);
    const TickingLaser laser{-5000s - 400us};
    ScipClock clock;
    ask(clock, laser, 1s);
    Errors errors;
    for (Time start = 2s; start < 30s; start += kPeriod) {
        const Time delay = 3ms + std::chrono::microseconds{random() % 2000};
        errors.add(clock.addScan(laser.stampAt(start), start + kEnd + delay, kEnd, kPeriod).start, start);
    }

    // Whole milliseconds on both sides: half of one by the answer, half of one by the stamp.
    QVERIFY2(errors.least >= -1.0 && errors.most <= 1.0, qPrintable(QString::number(errors.most)));
}

void ScipClockTest::withoutAnswersScansAreLateByTheWay()
{
    std::mt19937 random(2);
    const TickingLaser laser{-5000s};
    ScipClock clock;
    Errors errors;
    for (Time start = 2s; start < 30s; start += kPeriod) {
        const Time delay = 3ms + std::chrono::microseconds{random() % 2000};
        const Time found = clock.addScan(laser.stampAt(start), start + kEnd + delay, kEnd, kPeriod).start;
        if (start > 4s)
            errors.add(found, start);
    }

    QVERIFY2(errors.least >= 2.5 && errors.most <= 3.6, qPrintable(QString::number(errors.most)));
}

void ScipClockTest::withoutAnswersTheClocksAreKnownAfterSomeScans()
{
    const TickingLaser laser{-5000s};
    ScipClock asked;
    ask(asked, laser, 1s);
    ScipClock unasked;
    for (int scan = 1; scan <= 50; ++scan) {
        const Time start = 2s + scan * kPeriod;
        QVERIFY(asked.addScan(laser.stampAt(start), start + kEnd + 3ms, kEnd, kPeriod).isKnown);
        const bool isKnown = unasked.addScan(laser.stampAt(start), start + kEnd + 3ms, kEnd, kPeriod).isKnown;
        QCOMPARE(isKnown, scan >= 16);
    }
}

void ScipClockTest::theWayIsKnownFromAnswersBefore()
{
    const TickingLaser laser{-5000s};
    ScipClock clock;
    ask(clock, laser, 1s);
    for (Time start = 2s; start < 4s; start += kPeriod)
        clock.addScan(laser.stampAt(start), start + kEnd + 3ms, kEnd, kPeriod);

    clock.restart();
    const Time found = clock.addScan(laser.stampAt(5s), 5s + kEnd + 3ms, kEnd, kPeriod).start;

    QVERIFY(std::chrono::abs(found - 5s) <= 1ms);
}

void ScipClockTest::aClockThatDriftsIsFollowed_data()
{
    QTest::addColumn<double>("drift");
    QTest::newRow("fast") << 100e-6;
    QTest::newRow("slow") << -100e-6;
}

void ScipClockTest::aClockThatDriftsIsFollowed()
{
    QFETCH(double, drift);
    std::mt19937 random(3);
    const TickingLaser laser{-100s, drift};
    ScipClock clock;
    ask(clock, laser, 1s);
    Errors errors;
    for (Time start = 2s; start < 3600s; start += kPeriod) {
        const Time delay = 3ms + std::chrono::microseconds{random() % 2000};
        errors.add(clock.addScan(laser.stampAt(start), start + kEnd + delay, kEnd, kPeriod).start, start);
    }

    // After an hour the clocks are 360 ms apart. In the window of 10 s they come apart by 1 ms, beside 1 ms of
    // rounding.
    QVERIFY2(errors.least >= -2.2, qPrintable(QString::number(errors.least)));
    QVERIFY2(errors.most <= 2.2, qPrintable(QString::number(errors.most)));
}

void ScipClockTest::aScanThatIsLateIsToldAndDoesNotMoveTheOthers()
{
    const TickingLaser laser{-100s};
    ScipClock clock;
    for (Time start = 2s; start < 4s; start += kPeriod)
        QVERIFY(!clock.addScan(laser.stampAt(start), start + kEnd + 3ms, kEnd, kPeriod).isLate);

    const ScipClock::Scan late = clock.addScan(laser.stampAt(4s), 4s + kEnd + 30ms, kEnd, kPeriod);
    const ScipClock::Scan next = clock.addScan(laser.stampAt(4s + 25ms), 4s + 25ms + kEnd + 3ms, kEnd, kPeriod);

    QVERIFY(late.isLate);
    QVERIFY(!next.isLate);
    QVERIFY(next.start - late.start == 25ms);
}

void ScipClockTest::theStampOfTheScanBeforeIsToldByItsArrival()
{
    const TickingLaser laser{-100s};
    ScipClock clock;
    for (Time start = 2s; start < 4s; start += kPeriod)
        clock.addScan(laser.stampAt(start), start + kEnd + 3ms, kEnd, kPeriod);

    // The scan of 4 s did not come; the next one bears its stamp.
    const ScipClock::Scan stale = clock.addScan(laser.stampAt(4s), 4s + 25ms + kEnd + 3ms, kEnd, kPeriod);
    const ScipClock::Scan slow = clock.addScan(laser.stampAt(4s + 50ms), 4s + 50ms + kEnd + 21ms, kEnd, kPeriod);

    QVERIFY(stale.isBehind);
    QVERIFY(!slow.isBehind);
}

void ScipClockTest::afterAResetTheWayIsStillKnown()
{
    ScipClock clock;
    const TickingLaser before{-100s};
    ask(clock, before, 1s);
    for (Time start = 2s; start < 4s; start += kPeriod)
        clock.addScan(before.stampAt(start), start + kEnd + 3ms, kEnd, kPeriod);
    const TickingLaser after{4s - 200us};

    const ScipClock::Scan first = clock.addScan(after.stampAt(4s), 4s + kEnd + 3ms, kEnd, kPeriod);

    QVERIFY(first.isNewEpoch);
    QVERIFY(!first.isLate);
    QVERIFY(std::chrono::abs(first.start - 4s) <= 1ms);
}

void ScipClockTest::answersThatCannotBeTrueAreDropped()
{
    // It answers 50 ms too little: by that its scans would arrive before they are measured.
    const TickingLaser laser{-100s};
    const TickingLaser lie{-100s + 50ms};
    ScipClock clock;
    ask(clock, lie, 1s);

    const Time found = clock.addScan(laser.stampAt(2s), 2s + kEnd + 3ms, kEnd, kPeriod).start;

    QVERIFY(std::chrono::abs(found - 2s - 3ms) <= 1ms);
}

void ScipClockTest::clocksThatDoNotStandAsTheyDidAreComparedAnew_data()
{
    QTest::addColumn<int>("jump");  // of the laser's clock [ms]
    QTest::newRow("ahead") << 300;
    QTest::newRow("back") << -300;
}

void ScipClockTest::clocksThatDoNotStandAsTheyDidAreComparedAnew()
{
    QFETCH(int, jump);
    const TickingLaser before{-100s};
    const TickingLaser after{-100s - std::chrono::milliseconds{jump}};
    ScipClock clock;
    ask(clock, before, 1s);
    Time start = 2s;
    for (; start < 5s; start += kPeriod)
        QVERIFY(clock.addScan(before.stampAt(start), start + kEnd + 3ms, kEnd, kPeriod).isKnown);

    int doubtful = 0;
    int scans = 0;
    for (start += 1s; start < 20s; start += kPeriod, ++scans) {
        const ScipClock::Scan scan = clock.addScan(after.stampAt(start), start + kEnd + 3ms, kEnd, kPeriod);
        if (!scan.isKnown || scan.isBehind)
            ++doubtful;
        else
            QVERIFY(std::chrono::abs(scan.start - start) <= 1ms);
    }

    // Scans that are late may as well be held back by the link: only an answer of the laser tells.
    const bool isLate = jump < 0;
    QVERIFY(isLate ? doubtful == scans : doubtful > 0 && doubtful <= 2 * ScipClock::kKnown);
    clock.restart();
    ask(clock, after, start);
    start += 1s;
    QVERIFY(clock.addScan(after.stampAt(start), start + kEnd + 3ms, kEnd, kPeriod).isKnown);
}

void ScipClockTest::slowAnswersTellNothing()
{
    const TickingLaser laser{-100s};
    ScipClock clock;
    clock.addAnswer(laser.stampAt(1s + 80ms), 1s, 1s + 100ms);

    QVERIFY(!clock.addScan(laser.stampAt(2s), 2s + kEnd + 3ms, kEnd, kPeriod).isKnown);
}

void ScipClockTest::theQuickestAnswerCounts()
{
    const TickingLaser laser{-100s};
    ScipClock clock;
    clock.addAnswer(laser.stampAt(1s + 40ms), 1s, 1s + 42ms);
    clock.addAnswer(laser.stampAt(2s + 1ms), 2s, 2s + 2ms);
    clock.addAnswer(laser.stampAt(3s + 1ms), 3s, 3s + 90ms);

    const Time found = clock.addScan(laser.stampAt(4s), 4s + kEnd + 3ms, kEnd, kPeriod).start;

    QVERIFY(std::chrono::abs(found - 4s) <= 1ms);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScipClockTest)
#include "scip_clock_test.moc"
