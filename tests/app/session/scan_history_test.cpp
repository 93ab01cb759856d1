// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/scan_history.h"

#include <QtTest>

#include "app/session/loops/extraction_loop.h"
#include "core/params/presets.h"
#include "tests/app/session/loops/batch.h"
#include "tests/app/session/loops/fakes.h"
#include "tests/core/pipeline/same_snapshot.h"
#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

const Recording& scanned()
{
    static const Recording recording =
        asRecorded(simulate(*makeScene("corridor", 3), smallScan(), *simulationNoise("default"), 3).recording);
    return recording;
}

Parameters presetParameters(const QString& preset)
{
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset.toStdString()), parameters);
    return parameters;
}

/// A scan as a session extracts it: its steps come one after another.
struct HistoryRun {
    explicit HistoryRun(std::vector<ParametersFrom> parameters)
        : loop{{scanned().description, std::move(parameters), true},
               in,
               bridge,
               clock,
               [this](const Error&) { ++failures; }},
          history(loop.correctedDescription(), static_cast<int>(scanned().slices.size()))
    {
    }

    /// Works off the slices, with a change before one of them.
    void run(int changeAt, const Parameters& changed)
    {
        for (const ScanSlice& slice : scanned().slices) {
            if (slice.step == changeAt)
                in.push(ParametersFrom{changeAt, changed});
            in.push(std::make_shared<const ScanSlice>(slice));
        }
        in.close();
        loop.run();
    }

    FakeClock clock;
    Channel<ExtractionItem> in{clock};
    SnapshotBridge bridge{{}};
    int failures = 0;
    ExtractionLoop loop;
    ScanHistory history;
};

}  // namespace

class ScanHistoryTest : public QObject {
    Q_OBJECT

private slots:
    void everyStepIsExplainedAsItWas_data() { presets(); }
    void everyStepIsExplainedAsItWas();
    void aScanThatGoesOnIsExplainedUpToItsNewestStep_data() { presets(); }
    void aScanThatGoesOnIsExplainedUpToItsNewestStep();
    void correctedSlicesAreExplained();
    void whyNotAnswersForAStep();
    void livesAreThoseOfItsPlanes_data() { presets(); }
    void livesAreThoseOfItsPlanes();
    void aHistoryWithoutStepsExplainsNone();

private:
    static void presets()
    {
        QTest::addColumn<QString>("preset");
        QTest::newRow("paper") << "paper";
        QTest::newRow("precise") << "precise";
    }
};

void ScanHistoryTest::everyStepIsExplainedAsItWas()
{
    QFETCH(QString, preset);
    const Parameters first = presetParameters(preset);
    Parameters stored = first;
    stored.segments.minLength = 0.5;
    Parameters changed = first;
    changed.planes.minSegments = 8;
    changed.likelihood.joinGate = 5.0;
    // Stored for the beginning and for after the end; somebody changes them in between, which replaces the latter.
    HistoryRun run{{{0, first}, {8, stored}, {1000, stored}}};
    run.run(23, changed);
    run.history.add(run.bridge.take());

    for (const int step : {5, 7, 8, 22, 23, 30, 12}) {
        const auto went = run.history.explained(step);
        QVERIFY(went.has_value());
        QCOMPARE(differenceOf(*(*went)->snapshot, *run.history.at(step)->snapshot), "");
    }
    const auto last = run.history.explained(kLastPass);
    QCOMPARE(differenceOf(*(*last)->snapshot, *run.history.newest()->snapshot), "");
    QVERIFY(run.history.newest()->finished);
    QVERIFY(!(*last)->snapshot->report.decisions.empty());
    QCOMPARE(run.failures, 0);
}

void ScanHistoryTest::aScanThatGoesOnIsExplainedUpToItsNewestStep()
{
    QFETCH(QString, preset);
    Parameters changed = presetParameters(preset);
    changed.segments.minLength = 0.6;
    HistoryRun run{{{0, presetParameters(preset)}}};
    run.run(17, changed);

    for (ExtractedStep& step : run.bridge.take()) {
        const std::shared_ptr<const Snapshot> snapshot = step.snapshot;
        run.history.add({std::move(step)});
        const auto went = run.history.explained(snapshot->report.step);
        QVERIFY(went.has_value());
        QCOMPARE(differenceOf(*(*went)->snapshot, *snapshot), "");
    }
    QVERIFY(run.history.newest()->snapshot->planes.size() >= 3);
}

void ScanHistoryTest::correctedSlicesAreExplained()
{
    Parameters parameters = presetParameters("precise");
    parameters.sensor.pitchZero = 0.02;
    parameters.sensor.pitchDelay = 0.1;
    parameters.sensor.leverArmCorrection = 0.02;
    HistoryRun run{{{0, parameters}}};
    run.run(-1, parameters);
    run.history.add(run.bridge.take());

    for (const int step : {4, 34, 20, kLastPass}) {
        const auto snapshot = step == kLastPass ? run.history.newest()->snapshot : run.history.at(step)->snapshot;
        QCOMPARE(differenceOf(*(*run.history.explained(step))->snapshot, *snapshot), "");
    }
}

void ScanHistoryTest::whyNotAnswersForAStep()
{
    HistoryRun run{{{0, presetParameters("precise")}}};
    run.run(-1, {});
    run.history.add(run.bridge.take());
    const auto& planes = run.history.at(35)->snapshot->planes;
    QVERIFY(planes.size() >= 2);

    const auto answer = run.history.whyNot(35, PlaneRef{planes[0]->id}, PlaneRef{planes[1]->id});

    QVERIFY(answer.has_value());
    QVERIFY(!answer->ways.front().pass());
    QCOMPARE(run.history.whyNot(35, PlaneRef{planes[0]->id}, PlaneRef{999}).error().code, ErrorCode::Usage);
}

void ScanHistoryTest::livesAreThoseOfItsPlanes()
{
    QFETCH(QString, preset);
    HistoryRun run{{{0, presetParameters(preset)}}};
    run.run(-1, {});
    run.history.add(run.bridge.take());

    const PlaneLives& lives = run.history.lives();
    for (const ExtractedStep& step : run.history.steps()) {
        for (const auto& plane : step.snapshot->planes)
            QVERIFY(lives.isThere(plane->id, step.snapshot->report.step));
    }
    for (const auto& plane : run.history.newest()->snapshot->planes) {
        QVERIFY(!lives.lives().at(plane->id).isOver);
        QCOMPARE(lives.lives().at(plane->id).sizes.back().segments, static_cast<int>(plane->segments.size()));
    }
}

void ScanHistoryTest::aHistoryWithoutStepsExplainsNone()
{
    ScanHistory history;

    QCOMPARE(history.explained(0).error().message, "The scan has no steps yet. Ask again after its first slice.");
    QCOMPARE(history.whyNot(0, PlaneRef{0}, PlaneRef{1}).error().code, ErrorCode::Usage);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScanHistoryTest)
#include "scan_history_test.moc"
