// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/extraction_loop.h"

#include <QtTest>

#include "core/params/presets.h"
#include "tests/app/session/loops/batch.h"
#include "tests/app/session/loops/fakes.h"
#include "tests/core/params/preset_parameters.h"
#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {

class ExtractionLoopTest : public QObject {
    Q_OBJECT

private slots:
    void itsPlanesAreThoseOfABatch_data();
    void itsPlanesAreThoseOfABatch();
    void parametersChangedMidScanGiveThePlanesOfABatchWithTheSame();
    void whatIsSetNowReplacesWhatWasStored();
    void correctionsKeepSliceAndMeasurementTogether();
    void everySliceComesAcrossTheBridge();
    void slicesOfSuspectAngleAreLeftOut();
    void abandoningEndsItWithoutTheLastPass();
};

namespace {

const Recording& corridor()
{
    static const Recording recording =
        asRecorded(simulate(*makeScene("corridor", 3), smallScan(), *simulationNoise("default"), 3).recording);
    return recording;
}

/// A loop with its two ends.
struct ExtractionRun {
    explicit ExtractionRun(std::vector<ParametersFrom> parameters)
        : loop{
              {corridor().description, std::move(parameters), true}, in, bridge, clock, [this](const Error& /*error*/) {
                  ++failures;
              }}
    {
    }

    void push(const ScanSlice& slice) { in.push(std::make_shared<const ScanSlice>(slice)); }
    void pushAll()
    {
        for (const ScanSlice& slice : corridor().slices)
            push(slice);
    }
    std::vector<ExtractedStep> steps()
    {
        in.close();
        loop.run();
        return bridge.take();
    }

    FakeClock clock;
    Channel<ExtractionItem> in{clock};
    int news = 0;
    int failures = 0;
    SnapshotBridge bridge{[this] { ++news; }};
    ExtractionLoop loop;
};

}  // namespace

void ExtractionLoopTest::itsPlanesAreThoseOfABatch_data()
{
    QTest::addColumn<double>("pitchZero");
    QTest::addColumn<double>("pitchDelay");
    QTest::addColumn<double>("rangeOffset");
    QTest::addColumn<bool>("isPaper");
    QTest::newRow("precise") << 0.0 << 0.0 << 0.0 << false;
    QTest::newRow("paper") << 0.0 << 0.0 << 0.0 << true;
    QTest::newRow("corrected at once") << 0.01 << 0.0 << 0.02 << false;
    QTest::newRow("corrected by neighbours") << 0.0 << 0.2 << 0.0 << false;
}

void ExtractionLoopTest::itsPlanesAreThoseOfABatch()
{
    QFETCH(double, pitchZero);
    QFETCH(double, pitchDelay);
    QFETCH(double, rangeOffset);
    QFETCH(bool, isPaper);
    Parameters parameters = isPaper ? Parameters{} : precise();
    parameters.sensor.pitchZero = pitchZero;
    parameters.sensor.pitchDelay = pitchDelay;
    parameters.sensor.rangeOffset = rangeOffset;
    ExtractionRun run{{{0, parameters}}};
    run.pushAll();

    const auto steps = run.steps();

    QVERIFY(steps.back().snapshot->planes.size() >= 3);
    QCOMPARE(planesText(*steps.back().snapshot), batchPlanes(corridor(), {{0, parameters}}));
    QCOMPARE(run.failures, 0);
}

void ExtractionLoopTest::parametersChangedMidScanGiveThePlanesOfABatchWithTheSame()
{
    Parameters changed = precise();
    changed.planes.minPoints = 200;
    changed.likelihood.enoughPoints = 400;
    ExtractionRun run{{{0, precise()}}};
    for (const ScanSlice& slice : corridor().slices) {
        if (slice.step == 17)
            run.in.push(ParametersFrom{17, changed});
        run.push(slice);
    }

    const auto steps = run.steps();

    QCOMPARE(planesText(*steps.back().snapshot), batchPlanes(corridor(), {{0, precise()}, {17, changed}}));
    QVERIFY(planesText(*steps.back().snapshot) != batchPlanes(corridor(), {{0, precise()}}));
}

void ExtractionLoopTest::whatIsSetNowReplacesWhatWasStored()
{
    Parameters stored = precise();
    stored.planes.minPoints = 100'000;
    stored.likelihood.enoughPoints = 100'000;
    ExtractionRun run{{{0, precise()}, {20, stored}}};
    run.in.push(ParametersFrom{0, precise()});
    run.pushAll();

    const auto steps = run.steps();

    QCOMPARE(planesText(*steps.back().snapshot), batchPlanes(corridor(), {{0, precise()}}));
}

void ExtractionLoopTest::correctionsKeepSliceAndMeasurementTogether()
{
    Parameters parameters = precise();
    parameters.sensor.sweepTurn = 0.1;
    ExtractionRun run{{{0, parameters}}};
    run.pushAll();

    const auto steps = run.steps();

    QCOMPARE(steps.size(), corridor().slices.size() + 1);
    for (std::size_t i = 0; i < corridor().slices.size(); ++i) {
        QCOMPARE(steps[i].measured->step, static_cast<int>(i));
        QCOMPARE(steps[i].slice->step, static_cast<int>(i));
        QVERIFY(!steps[i].measured->tiltEnd);
        QVERIFY(steps[i].slice->tiltEnd);
    }
}

void ExtractionLoopTest::everySliceComesAcrossTheBridge()
{
    ExtractionRun run{{{0, precise()}}};
    run.pushAll();

    const auto steps = run.steps();

    QCOMPARE(steps.size(), corridor().slices.size() + 1);
    QVERIFY(!steps.back().slice);
    QCOMPARE(steps.back().snapshot->report.step, -1);
    QVERIFY(!steps[10].snapshot->report.decisions.empty());
    QCOMPARE(run.news, 1);  // nobody took anything in between
    QVERIFY(run.bridge.take().empty());
}

void ExtractionLoopTest::slicesOfSuspectAngleAreLeftOut()
{
    ExtractionRun run{{{0, precise()}}};
    for (ScanSlice slice : corridor().slices) {
        slice.angleSuspect = slice.step == 5;
        run.push(slice);
    }

    const auto steps = run.steps();

    Recording without = corridor();
    without.slices.erase(without.slices.begin() + 5);
    QCOMPARE(planesText(*steps.back().snapshot), batchPlanes(without, {{0, precise()}}));
}

void ExtractionLoopTest::abandoningEndsItWithoutTheLastPass()
{
    ExtractionRun run{{{0, precise()}}};
    run.pushAll();

    run.loop.abandon();

    QVERIFY(run.steps().empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ExtractionLoopTest)
#include "extraction_loop_test.moc"
