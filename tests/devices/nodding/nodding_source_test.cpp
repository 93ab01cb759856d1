// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/nodding_source.h"

#include <algorithm>

#include <QtTest>

#include "core/simulation/nodding_scanner.h"
#include "devices/board/frame_parser.h"
#include "devices/emulated/emulated_motor.h"
#include "tests/devices/nodding/emulated_scanner.h"
#include "tests/devices/nodding/watched_link.h"
#include "tests/test_program.h"

using namespace std::chrono_literals;

namespace planewright {

class NoddingSourceTest : public QObject {
    Q_OBJECT

private slots:
    void nothingMovesBeforeItBegins_data() { tiltUnits(); }
    void nothingMovesBeforeItBegins();
    void everySliceHasTheAngleThatTheHeadReallyHad_data() { modes(); }
    void everySliceHasTheAngleThatTheHeadReallyHad();
    void everySliceSeesWhatIsThere_data() { modes(); }
    void everySliceSeesWhatIsThere();
    void aSweepTakesATurnOfTheMirrorForEachSlice_data() { tiltUnits(); }
    void aSweepTakesATurnOfTheMirrorForEachSlice();
    void steppingTakesMoveRestAndTheNextTurn_data() { tiltUnits(); }
    void steppingTakesMoveRestAndTheNextTurn();
    void steppingWastesNoTime_data() { tiltUnits(); }
    void steppingWastesNoTime();
    void aPauseHoldsTheHeadAndLosesNoSlice_data() { modes(); }
    void aPauseHoldsTheHeadAndLosesNoSlice();
    void aStopOfMotionHoldsAtOnceAndNothingGoesOnByItself_data() { modes(); }
    void aStopOfMotionHoldsAtOnceAndNothingGoesOnByItself();
    void aStopOfMotionSilencesTheLaser();
    void aStopEndsTheWait();
    void aLostEventOfTheBoardLosesNoSlice();
    void aSlowSweepHasTheSpeedThatTheServoHas();
    void aSecondScanBeginsAnew();
    void aPlanThatCannotBeIsRefusedBeforeAnythingMoves();

private:
    static void tiltUnits();
    static void modes();
};

namespace {

using Tilt = EmulatedRigSetup::Tilt;
using Mode = ScanPlan::Mode;

EmulatedRigSetup corridorRig(Tilt tilt)
{
    EmulatedRigSetup setup;
    setup.scene = makeScene("corridor", 7).value();
    setup.tilt = tilt;
    return setup;
}

ScanPlan shortPlan(Mode mode)
{
    ScanPlan plan;
    plan.mode = mode;
    plan.firstPitch = degrees(60.0);
    plan.slices = 20;
    return plan;
}

/// A scanner that stands where its scan begins; null, with a warning, where that fails.
std::unique_ptr<NoddingSource> begun(EmulatedScanner& emulated, const ScanPlan& plan)
{
    auto scanner = emulated.open(plan);
    if (scanner) {
        if (const auto ready = (*scanner)->begin({}); ready)
            return std::move(*scanner);
        else
            scanner = tl::unexpected{ready.error()};
    }
    qWarning("%s", scanner.error().message.c_str());
    return nullptr;
}

std::vector<ScanSlice> takeAll(NoddingSource& scanner)
{
    std::vector<ScanSlice> slices;
    while (true) {
        const auto slice = scanner.next({});
        if (!slice)
            qWarning("%s", slice.error().message.c_str());
        if (!slice || !*slice)
            return slices;
        slices.push_back(**slice);
    }
}

/// A frame of the type 2F (resources/manual/board-protocol.md).
bool isEmergencyStop(std::span<const std::uint8_t> bytes)
{
    board::FrameParser parser;
    const auto frames = parser.push(bytes);
    return std::any_of(frames.begin(), frames.end(), [](const board::Frame& frame) { return frame.type == 0x2F; });
}

double turned(EmulatedScanner& emulated, double from)
{
    return std::abs(emulated.rig().pitchAt(emulated.clock().now()) - from);
}

}  // namespace

void NoddingSourceTest::tiltUnits()
{
    QTest::addColumn<Tilt>("tilt");
    QTest::newRow("servo") << Tilt::Servo;
    QTest::newRow("board") << Tilt::Board;
}

void NoddingSourceTest::modes()
{
    QTest::addColumn<Tilt>("tilt");
    QTest::addColumn<Mode>("mode");
    QTest::newRow("servo, sweeping") << Tilt::Servo << Mode::Continuous;
    QTest::newRow("servo, stepping") << Tilt::Servo << Mode::StepAndStare;
    QTest::newRow("board, sweeping") << Tilt::Board << Mode::Continuous;
    QTest::newRow("board, stepping") << Tilt::Board << Mode::StepAndStare;
}

void NoddingSourceTest::nothingMovesBeforeItBegins()
{
    QFETCH(Tilt, tilt);
    EmulatedScanner emulated(corridorRig(tilt));
    const double before = emulated.rig().pitchAt(0ns);

    const auto scanner = emulated.open(shortPlan(Mode::Continuous));

    QVERIFY2(scanner.has_value(), scanner ? "" : scanner.error().message.c_str());
    QCOMPARE(turned(emulated, before), 0.0);
    QCOMPARE((*scanner)->plannedSlices(), std::optional<int>(20));
    QCOMPARE((*scanner)->description().beams, 721);
    QVERIFY(QString::fromStdString((*scanner)->description().scanner).startsWith("UTM-30LX"));
    QVERIFY(std::abs((*scanner)->description().firstBearing) < 1e-9);
}

void NoddingSourceTest::everySliceHasTheAngleThatTheHeadReallyHad()
{
    QFETCH(Tilt, tilt);
    QFETCH(Mode, mode);
    EmulatedScanner emulated(corridorRig(tilt));
    const auto scanner = begun(emulated, shortPlan(mode));
    QVERIFY(scanner);
    const double count = degrees(300.0 / 1023.0);
    // 70 of the RX-64's units of 0.111 rpm are the nearest to 1.16 degrees in 25 ms; a board may have any whole counts.
    const double units = degrees(70 * 0.111 * 6.0 * 0.025);
    const double counts = 158 * count * 0.025;  // 46.4 degrees a second are 158.2 counts
    const double step = mode == Mode::StepAndStare ? degrees(1.16) : tilt == Tilt::Servo ? units : counts;
    QVERIFY(std::abs(scanner->fittedPlan().pitchStep - step) < 1e-9);

    const auto slices = takeAll(*scanner);

    QCOMPARE(slices.size(), std::size_t(20));
    for (std::size_t i = 0; i < slices.size(); ++i) {
        const ScanSlice& slice = slices[i];
        const double planned = degrees(60.0) + static_cast<double>(i) * step;
        QCOMPARE(slice.step, static_cast<int>(i));
        QVERIFY(!slice.angleSuspect && !slice.timeSuspect && !slice.retaken);
        QCOMPARE(slice.tiltEnd.has_value(), mode == Mode::Continuous);
        // Steps of the unit, and in a sweep up to half a turn of the mirror until the first slice.
        QVERIFY(std::abs(slice.tilt - planned) < (mode == Mode::Continuous ? degrees(1.5) : 1.5 * count));
        QVERIFY(std::abs(slice.tiltCommanded.value() - planned) < 1e-9);
        if (mode == Mode::Continuous) {
            const double half = degrees(1.16) * 0.5;  // 12.5 ms of 25
            QVERIFY(std::abs(*slice.tiltEnd - slice.tilt - half) < count);
        }
    }
}

/// The ranges are those of a simulated slice at the angle that was measured, but for the counts of the servo.
void NoddingSourceTest::everySliceSeesWhatIsThere()
{
    QFETCH(Tilt, tilt);
    QFETCH(Mode, mode);
    EmulatedScanner emulated(corridorRig(tilt));
    const auto scanner = begun(emulated, shortPlan(mode));
    QVERIFY(scanner);

    for (const ScanSlice& slice : takeAll(*scanner)) {
        AcquisitionSettings settings;
        settings.slices = 1;
        settings.firstTilt = slice.tilt;
        settings.continuous = slice.tiltEnd.has_value();
        settings.tiltStep = slice.tiltEnd.value_or(slice.tilt) - slice.tilt;
        const ScanSlice simulated = simulateSlice(makeScene("corridor", 7).value(), settings, {}, 1, 0).slice;
        int near = 0;
        for (std::size_t beam = 0; beam < slice.ranges.size(); ++beam)
            near += std::abs(slice.ranges[beam] - simulated.ranges[beam]) < 0.01 + 0.01 * simulated.ranges[beam];
        // Edges of doors, and grazing beams on floor and ceiling, move by more.
        QVERIFY2(near > 0.9 * 721, qPrintable(QString("slice %1: %2 of 721").arg(slice.step).arg(near)));
    }
}

void NoddingSourceTest::aSweepTakesATurnOfTheMirrorForEachSlice()
{
    QFETCH(Tilt, tilt);
    EmulatedScanner emulated(corridorRig(tilt));
    const auto scanner = begun(emulated, ScanPlan());  // Table VIII
    QVERIFY(scanner);

    const auto slices = takeAll(*scanner);

    QCOMPARE(slices.size(), std::size_t(137));
    const double least = 136 * 0.025;
    QVERIFY(std::chrono::duration<double>(slices.back().time).count() < 1.05 * least);
    // Bars of time are those of the whole scan: what comes after the last slice is not waited for.
    const double after = std::chrono::duration<double>(emulated.clock().now()).count();
    QVERIFY(after > least);
}

/// The mirror is not waited for by the head, nor the head by the mirror: the next turn that begins at rest counts.
void NoddingSourceTest::steppingTakesMoveRestAndTheNextTurn()
{
    QFETCH(Tilt, tilt);
    EmulatedScanner emulated(corridorRig(tilt));
    const ScanPlan plan = shortPlan(Mode::StepAndStare);
    const auto scanner = begun(emulated, plan);
    QVERIFY(scanner);

    const auto slices = takeAll(*scanner);

    QCOMPARE(slices.size(), std::size_t(20));
    const double each = std::chrono::duration<double>(slices.back().time).count() / 19.0;
    // The motor never comes to its full speed on so short a way: half of it it gains speed, half it brakes.
    const double move = 2.0 * std::sqrt(plan.pitchStep / MotorDynamics{}.acceleration);
    const double least = move + std::chrono::duration<double>(plan.settle).count() + 0.025;
    const double turns = std::ceil(least / 0.025) * 0.025;
    QVERIFY2(each < 1.05 * turns, qPrintable(QString("%1 s for each slice").arg(each)));
}

/// Where move, rest and a turn are just less than six turns, a slice takes six: 5 % more than its parts at most.
void NoddingSourceTest::steppingWastesNoTime()
{
    QFETCH(Tilt, tilt);
    EmulatedScanner emulated(corridorRig(tilt));
    ScanPlan plan = shortPlan(Mode::StepAndStare);
    const double move = 2.0 * std::sqrt(plan.pitchStep / MotorDynamics{}.acceleration);
    plan.settle = std::chrono::milliseconds{static_cast<int>(1000.0 * (0.144 - move - 0.025))};
    const auto scanner = begun(emulated, plan);
    QVERIFY(scanner);

    const auto slices = takeAll(*scanner);

    QCOMPARE(slices.size(), std::size_t(20));
    const double each = std::chrono::duration<double>(slices.back().time).count() / 19.0;
    const double least = move + std::chrono::duration<double>(plan.settle).count() + 0.025;
    QVERIFY2(each < 1.05 * least, qPrintable(QString("%1 s for each slice, of %2").arg(each).arg(least)));
}

void NoddingSourceTest::aPauseHoldsTheHeadAndLosesNoSlice()
{
    QFETCH(Tilt, tilt);
    QFETCH(Mode, mode);
    EmulatedScanner emulated(corridorRig(tilt));
    std::function<void()> onRead;
    int emergencies = 0;
    emulated.wrapTilt = [&](std::unique_ptr<Transport> link) -> std::unique_ptr<Transport> {
        return std::make_unique<WatchedLink>(
            std::move(link), [&] { return onRead ? onRead() : void(); },
            [&](std::span<const std::uint8_t> bytes) { emergencies += tilt == Tilt::Board && isEmergencyStop(bytes); });
    };
    const auto scanner = begun(emulated, shortPlan(mode));
    QVERIFY(scanner);
    for (int slice = 0; slice < 8; ++slice)
        QVERIFY(scanner->next({}).has_value());

    const std::chrono::nanoseconds paused = emulated.clock().now();
    QVERIFY(scanner->pause().has_value());
    std::optional<double> held;
    double moved = 0.0;
    bool resumed = false;
    onRead = [&] {
        const std::chrono::nanoseconds now = emulated.clock().now();
        if (resumed || now < paused + 200ms)
            return;
        held = held.value_or(emulated.rig().pitchAt(now));
        moved = std::max(moved, turned(emulated, *held));
        if (now < paused + 2s)
            return;
        resumed = true;
        QVERIFY(scanner->resume().has_value());
    };
    const auto slices = takeAll(*scanner);
    onRead = nullptr;  // what it looks at goes before the scanner does

    QVERIFY(held.has_value());
    QVERIFY(moved < degrees(0.5));
    QCOMPARE(emergencies, 0);
    QCOMPARE(slices.size(), std::size_t(12));
    QCOMPARE(slices.front().step, 8);
    QCOMPARE(slices.back().step, 19);
    QVERIFY(std::abs(slices.front().tilt - degrees(60.0 + 8 * 1.16)) < degrees(1.5));
}

void NoddingSourceTest::aStopOfMotionHoldsAtOnceAndNothingGoesOnByItself()
{
    QFETCH(Tilt, tilt);
    QFETCH(Mode, mode);
    EmulatedScanner emulated(corridorRig(tilt));
    const auto scanner = begun(emulated, shortPlan(mode));
    QVERIFY(scanner);
    for (int slice = 0; slice < 8; ++slice)
        QVERIFY(scanner->next({}).has_value());
    const std::chrono::nanoseconds before = emulated.clock().now();

    QVERIFY(scanner->stopMotion().has_value());

    const std::chrono::nanoseconds roundTrip = emulated.clock().now() - before;
    QVERIFY2(roundTrip < 20ms, qPrintable(QString::number(roundTrip.count())));
    emulated.clock().advance(60ms);
    const double held = emulated.rig().pitchAt(emulated.clock().now());
    emulated.clock().advance(2s);
    QVERIFY(turned(emulated, held) < degrees(0.05));
    QVERIFY(!scanner->resume().has_value());
    scanner->release();
    QVERIFY(scanner->resume().has_value());
    QCOMPARE(takeAll(*scanner).size(), std::size_t(12));
}

/// The laser is told QT as soon as the scanning thread comes to it, whatever the unit does.
void NoddingSourceTest::aStopOfMotionSilencesTheLaser()
{
    EmulatedScanner emulated(corridorRig(Tilt::Servo));
    std::optional<std::chrono::nanoseconds> silenced;
    emulated.wrapLaser = [&](std::unique_ptr<Transport> link) -> std::unique_ptr<Transport> {
        return std::make_unique<WatchedLink>(
            std::move(link), [] {},
            [&](std::span<const std::uint8_t> bytes) {
                if (std::string(bytes.begin(), bytes.end()).starts_with("QT"))
                    silenced = emulated.clock().now();
            });
    };
    std::stop_source stop;
    std::chrono::nanoseconds stopped{0};
    const NoddingSource* running = nullptr;
    emulated.wrapTilt = [&](std::unique_ptr<Transport> link) -> std::unique_ptr<Transport> {
        return std::make_unique<WatchedLink>(std::move(link), [&] {
            if (running != nullptr && emulated.clock().now() > stopped + 1s)
                stop.request_stop();
        });
    };
    const auto scanner = begun(emulated, shortPlan(Mode::Continuous));
    QVERIFY(scanner);
    QVERIFY(scanner->next({}).has_value());
    silenced.reset();

    QVERIFY(scanner->stopMotion().has_value());
    stopped = emulated.clock().now();
    running = scanner.get();
    const auto slice = scanner->next(stop.get_token());

    QVERIFY(slice.has_value() && !*slice);
    QVERIFY(silenced.has_value());
    QVERIFY(*silenced - stopped < 200ms);
}

void NoddingSourceTest::aStopEndsTheWait()
{
    EmulatedScanner emulated(corridorRig(Tilt::Servo));
    const auto scanner = begun(emulated, shortPlan(Mode::Continuous));
    QVERIFY(scanner);
    std::stop_source stop;
    stop.request_stop();

    const auto slice = scanner->next(stop.get_token());

    QVERIFY(slice.has_value() && !*slice);
}

/// Two hundred angles a second are near enough to each other that one may be missing.
void NoddingSourceTest::aLostEventOfTheBoardLosesNoSlice()
{
    EmulatedRigSetup setup = corridorRig(Tilt::Board);
    setup.faults = {{"board-lost-event", 0}};  // every tenth
    EmulatedScanner emulated(setup);
    const auto scanner = begun(emulated, shortPlan(Mode::Continuous));
    QVERIFY(scanner);

    const auto slices = takeAll(*scanner);

    QCOMPARE(slices.size(), std::size_t(20));
    QVERIFY(std::none_of(slices.begin(), slices.end(), [](const ScanSlice& slice) { return slice.retaken; }));
}

/// 0.293 degrees in 25 ms are 17.6 of the RX-64's units: rounded down they would be off by a slice in thirty.
void NoddingSourceTest::aSlowSweepHasTheSpeedThatTheServoHas()
{
    EmulatedScanner emulated(corridorRig(Tilt::Servo));
    ScanPlan plan;
    plan.firstPitch = degrees(20.0);
    plan.pitchStep = degrees(0.293);
    plan.slices = 400;
    plan.firstBearing = degrees(80.0);
    plan.lastBearing = degrees(100.0);
    const auto scanner = begun(emulated, plan);
    QVERIFY(scanner);

    const auto slices = takeAll(*scanner);

    const double step = degrees(18 * 0.111 * 6.0 * 0.025);  // 0.2997 degrees
    QVERIFY(std::abs(scanner->fittedPlan().pitchStep - step) < 1e-9);
    QCOMPARE(slices.size(), std::size_t(400));
    QVERIFY(std::none_of(slices.begin(), slices.end(), [](const ScanSlice& s) { return s.angleSuspect || s.retaken; }));
    QVERIFY(std::abs(slices.back().tilt - slices.front().tilt - 399 * step) < 2.0 * step);
}

void NoddingSourceTest::aSecondScanBeginsAnew()
{
    EmulatedScanner emulated(corridorRig(Tilt::Servo));
    const auto scanner = begun(emulated, shortPlan(Mode::Continuous));
    QVERIFY(scanner);
    QCOMPARE(takeAll(*scanner).size(), std::size_t(20));
    QVERIFY(scanner->end().has_value());

    QVERIFY(scanner->begin({}).has_value());
    const auto slices = takeAll(*scanner);

    QCOMPARE(slices.size(), std::size_t(20));
    QCOMPARE(slices.front().step, 0);
    QCOMPARE(slices.front().time, 0us);
    QCOMPARE(emulated.lasersOpened, 1);
    QCOMPARE(emulated.unitsOpened, 1);
}

void NoddingSourceTest::aPlanThatCannotBeIsRefusedBeforeAnythingMoves()
{
    EmulatedScanner emulated(corridorRig(Tilt::Servo));
    ScanPlan plan;
    plan.slices = 500;
    const double before = emulated.rig().pitchAt(0ns);

    const auto scanner = emulated.open(plan);

    QVERIFY(!scanner.has_value());
    QCOMPARE(scanner.error().code, ErrorCode::Usage);
    QCOMPARE(turned(emulated, before), 0.0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::NoddingSourceTest)
#include "nodding_source_test.moc"
