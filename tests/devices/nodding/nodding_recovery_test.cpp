// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QtTest>

#include "devices/nodding/nodding_source.h"
#include "tests/devices/nodding/scripted_devices.h"
#include "tests/test_program.h"

using namespace std::chrono_literals;

namespace planewright {

/// What a nodding source does, and in which order, where something is in its way.
class NoddingRecoveryTest : public QObject {
    Q_OBJECT

private slots:
    void whatStoppedTheUnitIsClearedAfterAReleaseAlone();
    void aReleaseIsForOneBeginAlone();
    void theLaserScansBeforeTheUnitIsArmed();
    void aStopWhileItBeginsIsNoError();
    void aStopOfMotionWhileItBeginsIsNoErrorAndIsKept();
    void aStopOfMotionStaysUntilItIsReleased();
    void aStopOfMotionSilencesTheLaser();
    void aPauseAndTheEndStopInOrder();
    void aDeviceThatIsLostInAPauseIsToldAtOnce();
    void aPauseThatCannotStopTheHeadIsAFault();
    void aUnitThatTellsNoAngleIsGivenUp();
    void aLaserThatTellsNothingIsGivenUpBeforeAnythingMoves();
    void theHeadStopsWhileTheLaserIsSilent();
    void aHeadThatRestsBesideItsGoalHasArrived();
    void aHeadThatWasHeldInASweepIsSentThereOnceMore();
    void aHeadThatStaysBlockedIsToldWithItsLoad();
    void aUnitThatFallsSilentInAScanIsLostAndNotBlocked_data();
    void aUnitThatFallsSilentInAScanIsLostAndNotBlocked();
    void whatGivesNoSliceIsToldByWhoKnowsWhy_data();
    void whatGivesNoSliceIsToldByWhoKnowsWhy();
    void slicesThatWereLostAreTakenAgain_data();
    void slicesThatWereLostAreTakenAgain();
    void slicesThatAreLostForGoodAreCounted();
    void theScanDoesNotGoOnWithAnotherDevice_data();
    void theScanDoesNotGoOnWithAnotherDevice();
};

namespace {

using Time = std::chrono::nanoseconds;
using Mode = ScanPlan::Mode;

ScanPlan recoveryPlan(Mode mode = Mode::Continuous)
{
    ScanPlan plan;
    plan.mode = mode;
    plan.firstPitch = degrees(80.0);
    plan.pitchStep = degrees(1.0);
    plan.slices = 20;
    return plan;
}

std::unique_ptr<NoddingSource> openOn(DeviceScript& script, const ScanPlan& plan)
{
    return NoddingSource::open(scriptedDevices(script), plan, script.clock, {}).value();
}

/// All slices until the end or an error.
std::vector<ScanSlice> takeAllOf(NoddingSource& source, const std::stop_token& stop = {})
{
    std::vector<ScanSlice> slices;
    for (auto slice = source.next(stop); slice && *slice; slice = source.next(stop))
        slices.push_back(**slice);
    return slices;
}

Result<void> alarm()
{
    return fail(ErrorCode::NeedsOperator, "servo: was turned off by an alarm; see to the cause");
}

Result<void> unplugged()
{
    return fail(ErrorCode::DeviceLost, "the cable is pulled out");
}

}  // namespace

void NoddingRecoveryTest::whatStoppedTheUnitIsClearedAfterAReleaseAlone()
{
    DeviceScript script;
    bool isAlarmed = true;
    script.onArm = [&] { return isAlarmed ? alarm() : Result<void>{}; };
    script.onRecover = [&]() -> Result<void> {
        isAlarmed = false;
        return {};
    };
    const auto source = openOn(script, recoveryPlan());

    const auto first = source->begin({});
    const auto second = source->begin({});

    QVERIFY(!first && !second);
    QCOMPARE(second.error().code, ErrorCode::NeedsOperator);
    QCOMPARE(script.count("recover"), 0);
    QCOMPARE(script.count("move"), 0);
    source->release();
    QVERIFY(source->begin({}));
    QCOMPARE(script.count("recover"), 1);
    QCOMPARE(takeAllOf(*source).size(), std::size_t(20));
}

void NoddingRecoveryTest::aReleaseIsForOneBeginAlone()
{
    DeviceScript script;
    bool isAlarmed = false;
    script.onArm = [&] { return isAlarmed ? alarm() : Result<void>{}; };
    const auto source = openOn(script, recoveryPlan());
    source->release();
    QVERIFY(source->begin({}));
    QVERIFY(source->end());

    isAlarmed = true;
    const auto again = source->begin({});

    QVERIFY(!again);
    QCOMPARE(again.error().code, ErrorCode::NeedsOperator);
    QCOMPARE(script.count("recover"), 0);
}

void NoddingRecoveryTest::theLaserScansBeforeTheUnitIsArmed()
{
    DeviceScript script;
    script.laserStart = 3s;
    const auto source = openOn(script, recoveryPlan());

    QVERIFY(source->begin({}));

    const Time started = script.firstFrom("laser start", 0ns);
    const Time armed = script.firstFrom("arm", 0ns);
    QVERIFY(armed >= started + 3s);
    // A board stops a motor of which it has not been reminded for 150 ms.
    QVERIFY(script.firstFrom("move", armed) - armed < 150ms);
}

void NoddingRecoveryTest::aStopWhileItBeginsIsNoError()
{
    DeviceScript script;
    std::stop_source stop;
    script.onArm = [&]() -> Result<void> {
        stop.request_stop();
        return fail(ErrorCode::Interrupted, "arming was stopped");
    };
    const auto source = openOn(script, recoveryPlan());

    const auto begun = source->begin(stop.get_token());
    const auto slice = source->next(stop.get_token());

    QVERIFY2(begun.has_value(), begun ? "" : begun.error().message.c_str());
    QVERIFY(slice.has_value() && !*slice);
    QCOMPARE(script.count("move"), 0);
}

void NoddingRecoveryTest::aStopOfMotionWhileItBeginsIsNoErrorAndIsKept()
{
    DeviceScript script;
    std::unique_ptr<NoddingSource> source = openOn(script, recoveryPlan());
    script.onArm = [&]() -> Result<void> {
        if (script.count("arm") > 1)
            return {};
        [[maybe_unused]] const auto stopped = source->stopMotion();
        return fail(ErrorCode::Interrupted, "arming was stopped");
    };

    const auto begun = source->begin({});

    QVERIFY2(begun.has_value(), begun ? "" : begun.error().message.c_str());
    QCOMPARE(script.count("move"), 0);
    QVERIFY(!source->begin({}));
    source->release();
    QVERIFY(source->resume());
    QCOMPARE(takeAllOf(*source).size(), std::size_t(20));
}

void NoddingRecoveryTest::aStopOfMotionStaysUntilItIsReleased()
{
    DeviceScript script;
    const auto source = openOn(script, recoveryPlan());
    QVERIFY(source->stopMotion());

    const auto begun = source->begin({});
    const auto resumed = source->resume();

    QVERIFY(!begun && !resumed);
    QCOMPARE(begun.error().code, ErrorCode::NeedsOperator);
    QVERIFY(QString::fromStdString(begun.error().message).contains("release"));
    QCOMPARE(resumed.error().code, ErrorCode::NeedsOperator);
    QCOMPARE(script.count("arm") + script.count("move"), 0);
    source->release();
    QCOMPARE(script.count("arm") + script.count("move"), 0);
    QVERIFY(source->begin({}));
    QCOMPARE(takeAllOf(*source).size(), std::size_t(20));
}

void NoddingRecoveryTest::aStopOfMotionSilencesTheLaser()
{
    DeviceScript script;
    const auto source = openOn(script, recoveryPlan());
    QVERIFY(source->begin({}));
    QVERIFY(source->next({}));
    std::stop_source stop;
    Time stoppedAt{0};
    script.onTime = [&](Time now) {
        if (stoppedAt == 0ns) {
            stoppedAt = now;
            [[maybe_unused]] const auto stopped = source->stopMotion();
        } else if (now > stoppedAt + 2s) {
            stop.request_stop();
        }
    };

    takeAllOf(*source, stop.get_token());

    QCOMPARE(script.firstFrom("hold", 0ns), stoppedAt);
    QVERIFY(script.firstFrom("laser stop", stoppedAt) <= stoppedAt + 200ms);
    QCOMPARE(script.firstFrom("move", stoppedAt), Time::max());
}

void NoddingRecoveryTest::aPauseAndTheEndStopInOrder()
{
    DeviceScript script;
    const auto source = openOn(script, recoveryPlan());
    QVERIFY(source->begin({}));
    QVERIFY(source->next({}));
    const Time paused = script.clock.now();
    script.onTime = [&](Time now) {
        if (now > paused + 1s && script.count("resumed") == 0) {
            script.note("resumed");
            [[maybe_unused]] const auto resumed = source->resume();
        }
    };

    QVERIFY(source->pause());
    const auto rest = takeAllOf(*source);
    QVERIFY(source->end());

    QCOMPARE(rest.size(), std::size_t(19));
    QCOMPARE(rest.front().step, 1);
    QVERIFY(script.firstFrom("stop", paused) <= paused + 10ms);
    QVERIFY(script.firstFrom("move", paused) >= paused + 1s);
    QCOMPARE(script.calls.back().what, std::string("stop"));
    QCOMPARE(script.count("hold"), 0);
}

void NoddingRecoveryTest::aDeviceThatIsLostInAPauseIsToldAtOnce()
{
    DeviceScript script;
    const auto source = openOn(script, recoveryPlan());
    QVERIFY(source->begin({}));
    QVERIFY(source->next({}));
    QVERIFY(source->pause());
    const Time lostAt = script.clock.now() + 500ms;
    script.onSample = [&] { return script.clock.now() >= lostAt ? unplugged() : Result<void>{}; };

    const auto slice = source->next({});

    QVERIFY(!slice);
    QCOMPARE(slice.error().code, ErrorCode::DeviceLost);
    QVERIFY(script.clock.now() <= lostAt + 200ms);
}

void NoddingRecoveryTest::aPauseThatCannotStopTheHeadIsAFault()
{
    DeviceScript script;
    const auto source = openOn(script, recoveryPlan());
    QVERIFY(source->begin({}));
    QVERIFY(source->next({}));
    script.onStop = unplugged;

    QVERIFY(source->pause());
    const auto slice = source->next({});

    QVERIFY(!slice);
    QCOMPARE(slice.error().code, ErrorCode::DeviceLost);
}

void NoddingRecoveryTest::aUnitThatTellsNoAngleIsGivenUp()
{
    DeviceScript script;
    script.hasSamples = false;
    const auto source = openOn(script, recoveryPlan());

    const auto begun = source->begin({});

    QVERIFY(!begun);
    QCOMPARE(begun.error().code, ErrorCode::DeviceLost);
    QVERIFY(QString::fromStdString(begun.error().message).contains("no angle"));
    QVERIFY(script.clock.now() < 5s);
    QVERIFY(script.count("stop") > 0);
}

void NoddingRecoveryTest::aLaserThatTellsNothingIsGivenUpBeforeAnythingMoves()
{
    DeviceScript script;
    script.silentFrom = 0ns;
    const auto source = openOn(script, recoveryPlan());

    const auto begun = source->begin({});

    QVERIFY(!begun);
    QCOMPARE(begun.error().code, ErrorCode::DeviceLost);
    QCOMPARE(script.count("move"), 0);
}

void NoddingRecoveryTest::theHeadStopsWhileTheLaserIsSilent()
{
    DeviceScript script;
    const auto source = openOn(script, recoveryPlan());
    QVERIFY(source->begin({}));
    QVERIFY(source->next({}));
    script.silentFrom = script.clock.now() + 100ms;
    script.silentTo = script.silentFrom + 2s;

    const auto slices = takeAllOf(*source);

    QCOMPARE(slices.size(), std::size_t(19));
    QCOMPARE(slices.back().step, 19);
    const Time stopped = script.firstFrom("stop", script.silentFrom);
    QVERIFY(stopped <= script.silentFrom + 350ms);  // ten turns of the mirror
    QVERIFY(script.firstFrom("move", stopped) >= script.silentTo);
}

void NoddingRecoveryTest::aHeadThatRestsBesideItsGoalHasArrived()
{
    DeviceScript script;
    script.tolerance = degrees(1.25);  // five steps of the unit
    script.sag = degrees(1.2);
    const auto source = openOn(script, recoveryPlan(Mode::StepAndStare));

    QVERIFY(source->begin({}));
    const auto slices = takeAllOf(*source);

    QCOMPARE(slices.size(), std::size_t(20));
    QVERIFY(std::abs(slices[3].tilt - degrees(83.0 - 1.2)) < 1e-9);
}

/// Something is in its way at 90.3°, until the head has gone back to where the slice after it begins.
void NoddingRecoveryTest::aHeadThatWasHeldInASweepIsSentThereOnceMore()
{
    DeviceScript script;
    script.blocks = [&](double pitch) { return script.count("move") < 4 ? std::min(pitch, degrees(90.3)) : pitch; };
    const auto source = openOn(script, recoveryPlan());
    QVERIFY(source->begin({}));

    const auto slices = takeAllOf(*source);

    QCOMPARE(slices.size(), std::size_t(20));
    QCOMPARE(script.count("move"), 4);  // to where the sweep begins, and through it: twice
    for (std::size_t i = 0; i < slices.size(); ++i)
        QCOMPARE(slices[i].step, static_cast<int>(i));
}

void NoddingRecoveryTest::aHeadThatStaysBlockedIsToldWithItsLoad()
{
    for (const Mode mode : {Mode::Continuous, Mode::StepAndStare}) {
        DeviceScript script;
        script.blocks = [](double pitch) { return std::min(pitch, degrees(90.3)); };
        const auto source = openOn(script, recoveryPlan(mode));
        QVERIFY(source->begin({}));

        Result<std::optional<ScanSlice>> slice = source->next({});
        while (slice && *slice)
            slice = source->next({});

        QVERIFY(!slice);
        QCOMPARE(slice.error().code, ErrorCode::NeedsOperator);
        const QString message = QString::fromStdString(slice.error().message);
        QVERIFY2(message.startsWith("RX-64, number 1, firmware 24: the head has not moved for 0.8 s (load 0 %)"),
                 qPrintable(message));
        QVERIFY(script.clock.now() < 10s);
    }
}

void NoddingRecoveryTest::aUnitThatFallsSilentInAScanIsLostAndNotBlocked_data()
{
    QTest::addColumn<Mode>("mode");
    QTest::newRow("sweeping") << Mode::Continuous;
    QTest::newRow("stepping") << Mode::StepAndStare;
}

void NoddingRecoveryTest::aUnitThatFallsSilentInAScanIsLostAndNotBlocked()
{
    QFETCH(Mode, mode);
    DeviceScript script;
    const auto source = openOn(script, recoveryPlan(mode));
    QVERIFY(source->begin({}));
    for (int i = 0; i < 5; ++i)
        QVERIFY(source->next({}).value());

    script.hasSamples = false;
    Result<std::optional<ScanSlice>> slice = source->next({});
    while (slice && *slice)
        slice = source->next({});

    QVERIFY(!slice);
    QCOMPARE(slice.error().code, ErrorCode::DeviceLost);
    const QString message = QString::fromStdString(slice.error().message);
    QVERIFY2(message.startsWith(
                 "RX-64, number 1, firmware 24: no angle that can be used has come for 0.5 s; look at its cable") ||
                 message.contains("for 0.6 s; look at its cable"),
             qPrintable(message));
    QVERIFY(script.count("stop") > 0);
}

void NoddingRecoveryTest::whatGivesNoSliceIsToldByWhoKnowsWhy_data()
{
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("laser");
    QTest::addColumn<QString>("says");
    QTest::newRow("the unit does") << "bus: servo 1 answers 60 ms late"
                                   << ""
                                   << "RX-64, number 1, firmware 24: no slice that can be used has come for "
                                      "1.@: bus: servo 1 answers 60 ms late";
    QTest::newRow("the laser does")
        << ""
        << "usb: its clock stands still"
        << "UTM-30LX: no slice that can be used has come for 1.@: usb: its clock stands still";
    QTest::newRow("nobody does") << ""
                                 << ""
                                 << "UTM-30LX: no slice that can be used has come for 1.@; look at the cables";
}

void NoddingRecoveryTest::whatGivesNoSliceIsToldByWhoKnowsWhy()
{
    QFETCH(QString, unit);
    QFETCH(QString, laser);
    QFETCH(QString, says);
    DeviceScript script;
    const auto source = openOn(script, recoveryPlan(Mode::StepAndStare));
    QVERIFY(source->begin({}));
    for (int i = 0; i < 5; ++i)
        QVERIFY(source->next({}).value());

    script.hasTimes = false;
    script.unitTrouble = unit.toStdString();
    script.laserTrouble = laser.toStdString();
    Result<std::optional<ScanSlice>> slice = source->next({});
    while (slice && *slice)
        slice = source->next({});

    QVERIFY(!slice);
    QCOMPARE(slice.error().code, ErrorCode::DeviceLost);
    const QString message = QString::fromStdString(slice.error().message);
    const QStringList parts = says.split('@');
    QVERIFY2(message.startsWith(parts[0]) && message.contains(parts[1]), qPrintable(message));
}

void NoddingRecoveryTest::slicesThatWereLostAreTakenAgain_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("lost");
    QTest::newRow("one") << 5 << 1;
    QTest::newRow("two") << 5 << 2;
    QTest::newRow("many") << 5 << 9;
    QTest::newRow("the last") << 19 << 1;
    QTest::newRow("the last three") << 17 << 3;
}

/// Turns are lost once, from the moment on at which the head passes a slice.
void NoddingRecoveryTest::slicesThatWereLostAreTakenAgain()
{
    QFETCH(int, from);
    QFETCH(int, lost);
    DeviceScript script;
    const auto source = openOn(script, recoveryPlan());
    QVERIFY(source->begin({}));
    std::vector<ScanSlice> slices;
    for (int i = 0; i < from; ++i)
        slices.push_back(source->next({}).value().value());
    int left = lost;
    script.losesTurn = [&](Time turn) { return turn > script.clock.now() - 25ms && left-- > 0; };

    for (const ScanSlice& slice : takeAllOf(*source))
        slices.push_back(slice);

    QCOMPARE(slices.size(), std::size_t(20));
    for (int i = 0; i < 20; ++i)
        QCOMPARE(slices[static_cast<std::size_t>(i)].step, i);
    QCOMPARE(source->deviceHealth().slicesLost, 0);
}

void NoddingRecoveryTest::slicesThatAreLostForGoodAreCounted()
{
    DeviceScript script;
    const auto source = openOn(script, recoveryPlan());
    QVERIFY(source->begin({}));
    // Whenever the head is there nothing is heard of the laser.
    script.losesTurn = [&](Time turn) { return std::abs(script.pitchAt(turn) - degrees(85.0)) < degrees(0.5); };

    const auto slices = takeAllOf(*source);

    QCOMPARE(slices.size(), std::size_t(19));
    QCOMPARE(slices.back().step, 19);
    QCOMPARE(source->deviceHealth().slicesLost, 1);
    QCOMPARE(script.count("move"), 6);  // to the start and through the slices, and twice again
}

void NoddingRecoveryTest::theScanDoesNotGoOnWithAnotherDevice_data()
{
    using Change = std::function<void(DeviceScript&)>;
    QTest::addColumn<Change>("change");
    QTest::addColumn<QString>("now");
    QTest::addColumn<QString>("before");
    const auto row = [](const char* name, const char* now, const char* before, Change change) {
        QTest::newRow(name) << change << QString(now) << QString(before);
    };
    row("another laser", "number 00000002", "number 00000001", [](DeviceScript& s) { s.laser.serial = "00000002"; });
    row("another model", "UST-20LX", "UTM-30LX", [](DeviceScript& s) { s.laser.model = "UST-20LX"; });
    row("fewer steps", "steps 0 to 1000 of 1440", "steps 0 to 1080 of 1440",
        [](DeviceScript& s) { s.limits.lastStep = 1000; });
    row("another unit", "AX-12", "RX-64", [](DeviceScript& s) { s.unit = "AX-12, number 1, firmware 24"; });
    row("other limits", "other limits", "", [](DeviceScript& s) { s.unitHighest = degrees(170.0); });
}

void NoddingRecoveryTest::theScanDoesNotGoOnWithAnotherDevice()
{
    QFETCH(std::function<void(DeviceScript&)>, change);
    QFETCH(QString, now);
    QFETCH(QString, before);
    DeviceScript script;
    const auto source = openOn(script, recoveryPlan());
    QVERIFY(source->begin({}));
    QVERIFY(source->next({}));
    script.onSample = unplugged;
    QVERIFY(!source->next({}));  // both are closed
    script.onSample = nullptr;
    const DeviceScript::Time lostAt = script.clock.now();
    const auto [laser, limits, unit, unitHighest] =
        std::tuple{script.laser, script.limits, script.unit, script.unitHighest};
    change(script);

    const auto refused = source->next({});

    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::NeedsOperator);
    const QString said = QString::fromStdString(refused.error().message);
    QVERIFY2(said.contains(now) && said.contains(before), qPrintable(said));
    QCOMPARE(script.firstFrom("move", lostAt + 1ns), Time::max());
    script.laser = laser;
    script.limits = limits;
    script.unit = unit;
    script.unitHighest = unitHighest;
    QCOMPARE(takeAllOf(*source).size(), std::size_t(19));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::NoddingRecoveryTest)
#include "nodding_recovery_test.moc"
