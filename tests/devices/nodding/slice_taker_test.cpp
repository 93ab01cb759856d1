// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/slice_taker.h"

#include <QtTest>

#include "tests/devices/nodding/still_unit.h"
#include "tests/test_program.h"

using namespace std::chrono_literals;

namespace planewright {

class SliceTakerTest : public QObject {
    Q_OBJECT

private slots:
    void aSweepBeginsAndEndsOutsideOfItsSlices();
    void aSweepEndsAtTheLimits();
    void turnsOfASweepBecomeItsSlices();
    void theHeadGoesBackForLostTurns_data();
    void theHeadGoesBackForLostTurns();
    void theHeadGoesBackForTheLastSlice();
    void aSliceThatIsLostAgainAndAgainLeavesAGap();
    void everySecondTurnOfASlowSweepIsASlice();
    void aSweepDownwardsCountsDownwards();
    void aSweepGoesOnAtTheMissingSlice();
    void anAngleThatIsNotAsToldIsMarkedOnceAndThenAnError();
    void aHeadThatStopsInASweepIsSeen();
    void aSlowHeadHasTimeForItsCounts();
    void anglesThatDoNotComeAreNoStandstill();
    void aRestingSliceIsTakenAfterTheRestOnly();
    void aRestingSliceHasTheMeanOfItsAngles();
    void aHeadThatNeverGetsThereIsSeen();
};

namespace {

using Time = std::chrono::nanoseconds;

ScanPlan smallPlan(ScanPlan::Mode mode = ScanPlan::Mode::Continuous)
{
    ScanPlan plan;
    plan.mode = mode;
    plan.firstPitch = degrees(40.0);
    plan.pitchStep = degrees(1.0);
    plan.slices = 5;
    plan.settle = 10ms;
    return plan;
}

SliceTaker takerOf(const ScanPlan& plan)
{
    const StillUnit unit;
    return {plan,
            fitPlan(plan, utm30lx(), unit).value(),
            utm30lx(),
            {"unit", unit.lowest(), unit.highest(), unit.resolution(), unit.fastest(), unit.tolerance()}};
}

/// The turn of the mirror whose first beam is at a moment; 180° of it take 12.5 ms.
LaserScan turnAt(Time first)
{
    LaserScan scan;
    scan.first = first;
    scan.last = first + 12500us;
    scan.arrived = scan.last + 1ms;
    scan.ranges.assign(721, 2500);
    return scan;
}

/// A head that has passed a pitch at time 0 and goes on at a speed [rad/s], sampled every 4 ms.
TiltTrack movingTrack(double pitch, double speed, Time until)
{
    TiltTrack track;
    for (Time t = -40ms; t <= until; t += 4ms)
        track.add({t, pitch + speed * std::chrono::duration<double>(t).count(), true});
    return track;
}

std::vector<ScanSlice> takeTurns(SliceTaker& taker, const TiltTrack& track, std::initializer_list<Time> turns)
{
    std::vector<ScanSlice> slices;
    for (const Time turn : turns) {
        const auto slice = taker.take(turnAt(turn), track);
        if (slice && *slice)
            slices.push_back(**slice);
    }
    return slices;
}

bool isNear(double angle, double inDegrees)
{
    return std::abs(toDegrees(angle) - inDegrees) < 1e-9;
}

}  // namespace

void SliceTakerTest::aSweepBeginsAndEndsOutsideOfItsSlices()
{
    const SliceTaker taker = takerOf(smallPlan());  // 1 degree in 25 ms: 40 degrees a second

    QVERIFY(isNear(taker.start().pitch, 40.0 - 0.06 * 40.0));
    QVERIFY(isNear(taker.start().speed, 90.0));
    QVERIFY(isNear(taker.goal().pitch, 44.0 + 2.0 * 1.0 + 2.0 + 0.05 * 4.0));
    QVERIFY(isNear(taker.goal().speed, 40.0));
}

void SliceTakerTest::aSweepEndsAtTheLimits()
{
    ScanPlan plan = smallPlan();
    plan.firstPitch = 0.0;
    plan.pitchStep = degrees(2.0);
    plan.slices = 91;

    const SliceTaker taker = takerOf(plan);

    QVERIFY(isNear(taker.start().pitch, 0.0));
    QVERIFY(isNear(taker.goal().pitch, 180.0));
}

void SliceTakerTest::turnsOfASweepBecomeItsSlices()
{
    SliceTaker taker = takerOf(smallPlan());
    taker.aimed(-30ms);
    const TiltTrack track = movingTrack(degrees(39.8), degrees(40.0), 200ms);

    // The head is at 38.8, 39.8, 40.8 ... degrees: the first is too early by more than half a step.
    const auto slices = takeTurns(taker, track, {-25ms, 0ms, 25ms, 50ms, 75ms, 100ms, 125ms});

    QCOMPARE(slices.size(), std::size_t(5));
    for (int i = 0; i < 5; ++i) {
        const ScanSlice& slice = slices[static_cast<std::size_t>(i)];
        QCOMPARE(slice.step, i);
        QCOMPARE(slice.time, std::chrono::microseconds(25ms * i));
        QVERIFY(isNear(slice.tilt, 39.8 + i));
        QVERIFY(isNear(slice.tiltEnd.value(), 39.8 + i + 0.5));
        QVERIFY(isNear(slice.tiltCommanded.value(), 40.0 + i));
        QVERIFY(isNear(slice.firstBearing, 0.0));
        QCOMPARE(slice.ranges.size(), std::size_t(721));
        QCOMPARE(slice.ranges[7], 2.5);
        QVERIFY(!slice.angleSuspect && !slice.retaken);
    }
    QVERIFY(taker.isDone());
}

void SliceTakerTest::theHeadGoesBackForLostTurns_data()
{
    QTest::addColumn<int>("lost");
    QTest::newRow("one") << 1;
    QTest::newRow("three") << 3;
}

void SliceTakerTest::theHeadGoesBackForLostTurns()
{
    QFETCH(int, lost);
    ScanPlan plan = smallPlan();
    plan.slices = 20;
    SliceTaker taker = takerOf(plan);
    taker.aimed(-30ms);
    const TiltTrack track = movingTrack(degrees(40.0), degrees(40.0), 400ms);

    const auto slices = takeTurns(taker, track, {0ms, 25ms, 50ms + lost * 25ms});

    QCOMPARE(slices.size(), std::size_t(2));
    QVERIFY(taker.mustGoBack());
    QCOMPARE(taker.next(), 2);
    QCOMPARE(taker.lost(), 0);
    taker.resume();
    QVERIFY(!taker.mustGoBack());
    QVERIFY(isNear(taker.start().pitch, 42.0 - 2.4));
}

void SliceTakerTest::theHeadGoesBackForTheLastSlice()
{
    SliceTaker taker = takerOf(smallPlan());
    taker.aimed(-30ms);
    const TiltTrack track = movingTrack(degrees(40.0), degrees(40.0), 200ms);

    const auto slices = takeTurns(taker, track, {0ms, 25ms, 50ms, 75ms, 125ms});

    QCOMPARE(slices.size(), std::size_t(4));
    QVERIFY(!taker.isDone());
    QVERIFY(taker.mustGoBack());
    QCOMPARE(taker.next(), 4);
}

void SliceTakerTest::aSliceThatIsLostAgainAndAgainLeavesAGap()
{
    SliceTaker taker = takerOf(smallPlan());
    std::vector<ScanSlice> slices;
    for (int sweep = 0; sweep < 3; ++sweep) {  // the head goes back twice for a slice
        const Time begin = 10s * sweep;
        const double first = sweep == 0 ? 40.0 : 41.0;
        TiltTrack track;
        for (Time t = begin - 40ms; t <= begin + 200ms; t += 4ms)
            track.add({t, degrees(first + 40.0 * std::chrono::duration<double>(t - begin).count()), true});
        taker.aimed(begin - 30ms);
        std::vector<Time> turns{50ms, 75ms, 100ms};
        if (sweep == 0)
            turns.insert(turns.begin(), 0ms);
        for (const Time turn : turns) {
            if (taker.mustGoBack())
                break;
            // In the second and third sweep slice 1 would begin with the turn at 0 ms.
            const Time at = begin + turn - (sweep == 0 ? 0ms : 25ms);
            const auto slice = taker.take(turnAt(at), track);
            if (slice && *slice)
                slices.push_back(**slice);
        }
        taker.resume();
    }

    QCOMPARE(taker.lost(), 1);
    QCOMPARE(slices.size(), std::size_t(4));
    QCOMPARE(slices[1].step, 2);
    QVERIFY(isNear(slices[1].tilt, 42.0));
    QVERIFY(taker.isDone());
}

void SliceTakerTest::everySecondTurnOfASlowSweepIsASlice()
{
    ScanPlan plan = smallPlan();
    plan.pitchStep = degrees(4.0);  // 160 degrees a second in one turn; the unit may do 100
    plan.slices = 3;
    SliceTaker taker = takerOf(plan);
    taker.aimed(-30ms);
    const TiltTrack track = movingTrack(degrees(40.0), degrees(80.0), 200ms);

    const auto slices = takeTurns(taker, track, {0ms, 25ms, 50ms, 75ms, 100ms});

    QCOMPARE(slices.size(), std::size_t(3));
    QCOMPARE(slices[2].step, 2);
    QVERIFY(isNear(slices[1].tilt, 44.0));
}

void SliceTakerTest::aSweepDownwardsCountsDownwards()
{
    ScanPlan plan = smallPlan();
    plan.pitchStep = degrees(-1.0);
    SliceTaker taker = takerOf(plan);
    QVERIFY(isNear(taker.start().pitch, 42.4));
    taker.aimed(-30ms);
    const TiltTrack track = movingTrack(degrees(40.2), degrees(-40.0), 200ms);

    const auto slices = takeTurns(taker, track, {-25ms, 0ms, 25ms, 50ms, 75ms, 100ms});

    QCOMPARE(slices.size(), std::size_t(5));
    QVERIFY(isNear(slices[4].tilt, 36.2));
}

void SliceTakerTest::aSweepGoesOnAtTheMissingSlice()
{
    SliceTaker taker = takerOf(smallPlan());
    taker.aimed(-30ms);
    takeTurns(taker, movingTrack(degrees(40.0), degrees(40.0), 100ms), {0ms, 25ms});
    taker.resume();
    QVERIFY(isNear(taker.start().pitch, 42.0 - 2.4));
    taker.aimed(960ms);

    TiltTrack second;
    for (Time t = 950ms; t < 1200ms; t += 4ms)
        second.add({t, degrees(42.0) + degrees(40.0) * std::chrono::duration<double>(t - 1000ms).count(), true});
    const auto slices = takeTurns(taker, second, {955ms, 1000ms, 1025ms, 1050ms});

    QCOMPARE(slices.size(), std::size_t(3));
    QCOMPARE(slices[0].step, 2);
    QVERIFY(slices[0].retaken);
    QVERIFY(!slices[1].retaken);
    QCOMPARE(slices[0].time, std::chrono::microseconds(1s));
}

void SliceTakerTest::anAngleThatIsNotAsToldIsMarkedOnceAndThenAnError()
{
    ScanPlan plan = smallPlan();
    plan.slices = 20;
    SliceTaker taker = takerOf(plan);
    taker.aimed(-30ms);
    TiltTrack track;
    for (Time t = -40ms; t <= 400ms; t += 4ms) {  // it jumps by 5 degrees
        const double jump = t > 64ms ? degrees(5.0) : 0.0;
        track.add({t, degrees(40.0) + jump + degrees(40.0) * std::chrono::duration<double>(t).count(), true});
    }

    takeTurns(taker, track, {0ms, 25ms, 50ms});
    const auto suspect = taker.take(turnAt(75ms), track);
    const auto failed = taker.take(turnAt(100ms), track);

    QVERIFY(suspect && *suspect);
    QVERIFY((*suspect)->angleSuspect);
    QVERIFY(isNear((*suspect)->tilt, 48.0));  // measured, not as told
    QVERIFY(!failed);
    QCOMPARE(failed.error().code, ErrorCode::NeedsOperator);
    QCOMPARE(taker.next(), 4);  // it was not given, so it is to be taken again
}

void SliceTakerTest::aHeadThatStopsInASweepIsSeen()
{
    ScanPlan plan = smallPlan();
    plan.slices = 60;
    SliceTaker taker = takerOf(plan);
    taker.aimed(-30ms);
    TiltTrack track = movingTrack(degrees(40.0), degrees(40.0), 400ms);
    QVERIFY(taker.getsOn(track, 400ms));

    for (Time t = 404ms; t <= 900ms; t += 4ms)
        track.add({t, degrees(56.0), false});
    QVERIFY(taker.getsOn(track, 900ms));  // its driver may tell it once more first
    for (Time t = 904ms; t <= 1300ms; t += 4ms)
        track.add({t, degrees(56.0), false});

    QVERIFY(!taker.getsOn(track, 1300ms));
}

void SliceTakerTest::aSlowHeadHasTimeForItsCounts()
{
    // 0.6 degrees a second: a count of 0.29 degrees takes half a second.
    ScanPlan plan = smallPlan();
    plan.pitchStep = degrees(0.3);
    plan.slices = 60;
    FittedPlan fitted = fitPlan(plan, utm30lx(), StillUnit{}).value();
    fitted.sweepSpeed = degrees(0.6);
    constexpr double kCount = degrees(0.29);
    SliceTaker taker{plan, fitted, utm30lx(), {"unit", 0.0, degrees(180.0), kCount, degrees(90.0), kCount}};
    taker.aimed(-1ms);
    TiltTrack track;
    Time now{0};
    for (; now <= 6s; now += 5ms) {
        const double way = degrees(0.6) * std::chrono::duration<double>(now).count();
        track.add({now, degrees(40.0) + kCount * std::floor(way / kCount), true});
        QVERIFY(taker.getsOn(track, now));
    }

    const double there = track.last().pitch;
    for (; now <= 9s; now += 5ms)
        track.add({now, there, false});

    QVERIFY(!taker.getsOn(track, now));
}

void SliceTakerTest::anglesThatDoNotComeAreNoStandstill()
{
    for (const auto mode : {ScanPlan::Mode::Continuous, ScanPlan::Mode::StepAndStare}) {
        ScanPlan plan = smallPlan(mode);
        plan.slices = 60;
        SliceTaker taker = takerOf(plan);
        taker.aimed(-30ms);
        const TiltTrack track = movingTrack(degrees(38.0), degrees(2.0), 400ms);

        for (const Time now : {500ms, 700ms, 1200ms, 5000ms})
            QVERIFY(taker.getsOn(track, now));
    }
}

void SliceTakerTest::aRestingSliceIsTakenAfterTheRestOnly()
{
    SliceTaker taker = takerOf(smallPlan(ScanPlan::Mode::StepAndStare));
    QVERIFY(taker.aimsForEach());
    QVERIFY(isNear(taker.goal().pitch, 40.0));
    taker.aimed(0ms);
    TiltTrack track;
    for (Time t = 0ms; t <= 100ms; t += 5ms)
        track.add({t, degrees(t < 20ms ? 39.0 : 40.0), t < 30ms});

    // It rests from 20 ms on, and is to be left alone for 10 ms more.
    QVERIFY(takeTurns(taker, track, {-5ms, 5ms, 20ms, 29ms}).empty());
    const auto slices = takeTurns(taker, track, {30ms});

    QCOMPARE(slices.size(), std::size_t(1));
    QCOMPARE(slices[0].step, 0);
    QVERIFY(!slices[0].tiltEnd);
    QVERIFY(isNear(taker.goal().pitch, 41.0));
}

void SliceTakerTest::aRestingSliceHasTheMeanOfItsAngles()
{
    SliceTaker taker = takerOf(smallPlan(ScanPlan::Mode::StepAndStare));
    taker.aimed(0ms);
    TiltTrack track;
    for (Time t = 0ms; t <= 100ms; t += 4ms)
        track.add({t, degrees(t == 48ms ? 40.2 : 40.0), false});

    const auto slices = takeTurns(taker, track, {40ms});  // samples at 40, 44, 48 and 52 ms

    QCOMPARE(slices.size(), std::size_t(1));
    QVERIFY(isNear(slices[0].tilt, 40.05));
    QVERIFY(isNear(slices[0].tiltCommanded.value(), 40.0));
}

void SliceTakerTest::aHeadThatNeverGetsThereIsSeen()
{
    SliceTaker taker = takerOf(smallPlan(ScanPlan::Mode::StepAndStare));
    taker.aimed(0ms);
    TiltTrack track;
    for (Time t = 0ms; t <= 795ms; t += 5ms)
        track.add({t, degrees(39.0), false});
    QVERIFY(taker.getsOn(track, 795ms));

    track.add({800ms, degrees(39.0), false});

    QVERIFY(!taker.getsOn(track, 800ms));
    QVERIFY(takeTurns(taker, track, {100ms, 200ms}).empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SliceTakerTest)
#include "slice_taker_test.moc"
