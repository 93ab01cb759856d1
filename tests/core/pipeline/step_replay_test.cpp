// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/step_replay.h"

#include <set>

#include <QtTest>

#include "core/params/presets.h"
#include "tests/core/pipeline/same_snapshot.h"
#include "tests/core/pipeline/simulated_room.h"
#include "tests/core/planes/recorded_decisions.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

constexpr std::array kPresets{"paper", "precise"};

Parameters parametersOf(std::string_view preset)
{
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset), parameters);
    return parameters;
}

/// A scan with its history: snapshots as they were given while it ran, the last pass at the end.
struct Scanned {
    SimulatedRoom room;
    Parameters parameters;
    std::vector<ParametersFrom> changes;
    std::vector<std::shared_ptr<const Snapshot>> history;

    Scanned(std::string_view scene, const Parameters& first, std::vector<ParametersFrom> later = {})
        : room(scanOf(scene, "default", 5, "table10-1")), parameters(first), changes(std::move(later))
    {
        PlaneExtractor extractor(sensor(), parameters);
        auto change = changes.begin();
        for (const ScanSlice& slice : room.scan.recording.slices) {
            for (; change != changes.end() && change->step <= slice.step; ++change)
                extractor.setParameters(change->parameters);
            history.push_back(extractor.step(slice));
        }
        for (; change != changes.end(); ++change)
            extractor.setParameters(change->parameters);
        history.push_back(extractor.finish());
    }

    SensorModel sensor() const { return sensorOf(room.scan.recording.description); }

    StepReplay replay() const
    {
        StepReplay replay(sensor(), parameters);
        for (const ScanSlice& slice : room.scan.recording.slices)
            replay.add(std::make_shared<const ScanSlice>(slice));
        for (const ParametersFrom& change : changes)
            replay.change(change);
        return replay;
    }

    int steps() const { return static_cast<int>(room.scan.recording.slices.size()); }
    /// What the scan gave at a step, or in its last pass.
    const Snapshot& at(int step) const
    {
        return *history[step == kLastPass ? history.size() - 1 : static_cast<std::size_t>(step)];
    }
};

std::vector<Phase> phasesOf(const PhasedStep& step)
{
    std::vector<Phase> phases;
    for (const PhaseState& state : step.phases)
        phases.push_back(state.phase);
    return phases;
}

bool sameOperand(const Operand& a, const Operand& b)
{
    const PieceRef p = pieceOf(a);
    const PieceRef q = pieceOf(b);
    return segmentOf(a) == segmentOf(b) && planeOf(a) == planeOf(b) && clusterOf(a) == clusterOf(b) &&
           p.step == q.step && p.firstBeam == q.firstBeam && p.lastBeam == q.lastBeam;
}

bool sameDecision(const Decision& a, const Decision& b)
{
    const auto sameTest = [](const Test& p, const Test& q) {
        return p.name == q.name && p.value == q.value && p.comparison == q.comparison && p.limit == q.limit;
    };
    return a.phase == b.phase && a.kind == b.kind &&
           std::equal(a.operands.begin(), a.operands.end(), b.operands.begin(), b.operands.end(), sameOperand) &&
           std::equal(a.tests.begin(), a.tests.end(), b.tests.begin(), b.tests.end(), sameTest) &&
           std::equal(a.result.begin(), a.result.end(), b.result.begin(), b.result.end(), sameOperand);
}

}  // namespace

/// A step that is gone back to is the step that was.
class StepReplayTest : public QObject {
    Q_OBJECT

private slots:
    void everyStepIsAsItWas_data() { presets(); }
    void everyStepIsAsItWas();
    void stepsInAnyOrderAreAsTheyWere_data() { presets(); }
    void stepsInAnyOrderAreAsTheyWere();
    void aScanWithChangedParametersIsAsItWas_data() { presets(); }
    void aScanWithChangedParametersIsAsItWas();
    void theLastPhaseIsTheStep_data() { presets(); }
    void theLastPhaseIsTheStep();
    void phasesAreThoseOfTableI();
    void thePhasesOfAStepTellAllItsDecisionsOnce_data() { presets(); }
    void thePhasesOfAStepTellAllItsDecisionsOnce();
    void decisionsAreThoseOfAnExplainedScan_data() { presets(); }
    void decisionsAreThoseOfAnExplainedScan();
    void aPhaseChangesWhatItIsFor_data() { presets(); }
    void aPhaseChangesWhatItIsFor();
    void everySegmentIsInAPlaneOrInAClusterAtAllTimes_data() { presets(); }
    void everySegmentIsInAPlaneOrInAClusterAtAllTimes();
    void aScanThatGoesOnIsFollowed_data() { presets(); }
    void aScanThatGoesOnIsFollowed();
    void aVisitTellsEveryStep_data() { presets(); }
    void aVisitTellsEveryStep();
    void aStepThatIsNotThereIsRefused();

private:
    static void presets()
    {
        QTest::addColumn<QString>("preset");
        for (const char* preset : kPresets)
            QTest::newRow(preset) << preset;
    }
};

void StepReplayTest::everyStepIsAsItWas()
{
    QFETCH(QString, preset);
    const Scanned scan("corridor", parametersOf(preset.toStdString()));
    StepReplay replay = scan.replay();

    for (int step = 0; step < scan.steps(); ++step)
        QCOMPARE(differenceOf(*(*replay.at(step))->snapshot, scan.at(step)), "");
    QCOMPARE(differenceOf(*(*replay.at(kLastPass))->snapshot, scan.at(kLastPass)), "");
    QVERIFY(scan.at(kLastPass).planes.size() > 3);
}

void StepReplayTest::stepsInAnyOrderAreAsTheyWere()
{
    QFETCH(QString, preset);
    const Scanned scan("office", parametersOf(preset.toStdString()));
    StepReplay replay = scan.replay();

    for (const int step : {40, 12, 41, kLastPass, 42, 42, 0, kLastPass, kLastPass, 55})
        QCOMPARE(differenceOf(*(*replay.at(step))->snapshot, scan.at(step)), "");
}

void StepReplayTest::aScanWithChangedParametersIsAsItWas()
{
    QFETCH(QString, preset);
    const Parameters first = parametersOf(preset.toStdString());
    Parameters second = first;
    second.planes.minSegments = 9;
    second.segments.minLength = 0.6;
    second.likelihood.joinGate = 4.0;
    Parameters third = second;
    third.assignment.planeDistance = 0.06;
    third.likelihood.mergeGate = 40.0;
    // One between two steps, two at the same moment, and one after the last slice.
    const Scanned scan("office", first, {{21, second}, {22, first}, {22, third}, {1000, second}});
    const Scanned unchanged("office", first);
    StepReplay replay = scan.replay();

    for (const int step : {20, 21, 22, 23, 50, 30, kLastPass})
        QCOMPARE(differenceOf(*(*replay.at(step))->snapshot, scan.at(step)), "");
    QVERIFY(differenceOf(unchanged.at(kLastPass), scan.at(kLastPass)) != "");
}

void StepReplayTest::theLastPhaseIsTheStep()
{
    QFETCH(QString, preset);
    const Scanned scan("corridor", parametersOf(preset.toStdString()));
    StepReplay replay = scan.replay();

    for (const int step : {4, 6, 34, 35, kLastPass}) {
        const auto went = *replay.at(step);
        const Snapshot& last = *went->phases.back().snapshot;
        QCOMPARE(differenceOf(last, *went->snapshot), "");
        QCOMPARE(last.report.counts.splits, went->snapshot->report.counts.splits);
        QCOMPARE(last.report.counts.merges, went->snapshot->report.counts.merges);
    }
}

void StepReplayTest::phasesAreThoseOfTableI()
{
    const Scanned scan("corridor", parametersOf("paper"));
    StepReplay replay = scan.replay();
    const std::vector<Phase> always{Phase::Extract, Phase::Assign, Phase::Cluster};

    // Planes are fitted and leftovers tried every 5 steps, planes split and merged every 7: after the 5th, 7th and
    // 35th.
    QCOMPARE(phasesOf(**replay.at(0)), always);
    QCOMPARE(phasesOf(**replay.at(4)),
             (std::vector<Phase>{Phase::Extract, Phase::Assign, Phase::Cluster, Phase::Fit, Phase::Remaining}));
    QCOMPARE(phasesOf(**replay.at(6)),
             (std::vector<Phase>{Phase::Extract, Phase::Assign, Phase::Cluster, Phase::SplitMerge}));
    QCOMPARE(phasesOf(**replay.at(34)), (std::vector<Phase>{Phase::Extract, Phase::Assign, Phase::Cluster, Phase::Fit,
                                                            Phase::SplitMerge, Phase::Remaining}));
    const auto last = *replay.at(kLastPass);
    QCOMPARE(phasesOf(*last), std::vector<Phase>(6, Phase::Finish));
    QCOMPARE(last->phases.front().pass, std::string_view{"fit"});
    QCOMPARE(last->phases.back().pass, std::string_view{"refine"});
}

void StepReplayTest::thePhasesOfAStepTellAllItsDecisionsOnce()
{
    QFETCH(QString, preset);
    const Scanned scan("office", parametersOf(preset.toStdString()));
    StepReplay replay = scan.replay();

    for (const int step : {4, 6, 34, kLastPass}) {
        const auto went = *replay.at(step);
        std::size_t told = 0;
        for (const PhaseState& state : went->phases) {
            for (const Decision& decision : state.snapshot->report.decisions)
                QCOMPARE(decision.phase, state.phase);
            told += state.snapshot->report.decisions.size();
        }
        QVERIFY(told > 0);
        QCOMPARE(told, went->snapshot->report.decisions.size());
    }
}

void StepReplayTest::decisionsAreThoseOfAnExplainedScan()
{
    QFETCH(QString, preset);
    const Scanned scan("office", parametersOf(preset.toStdString()));
    StepReplay replay = scan.replay();
    PlaneExtractor explained(scan.sensor(), scan.parameters, {{}, true});
    std::vector<StepReport> reports;
    for (const ScanSlice& slice : scan.room.scan.recording.slices)
        reports.push_back(explained.advance(slice));
    reports.push_back(explained.conclude());

    for (const int place : {50, 34, 4, scan.steps()}) {
        const StepReport& told = reports[static_cast<std::size_t>(place)];
        const auto went = *replay.at(told.step);
        QVERIFY(!told.decisions.empty());
        QVERIFY(std::equal(told.decisions.begin(), told.decisions.end(), went->snapshot->report.decisions.begin(),
                           went->snapshot->report.decisions.end(), sameDecision));
    }
}

void StepReplayTest::aPhaseChangesWhatItIsFor()
{
    QFETCH(QString, preset);
    const Scanned scan("corridor", parametersOf(preset.toStdString()));
    StepReplay replay = scan.replay();

    for (int step = 1; step < scan.steps(); ++step) {
        const auto went = *replay.at(step);
        const Snapshot& before = scan.at(step - 1);
        const Snapshot& extracted = *went->phases[0].snapshot;
        const Snapshot& assigned = *went->phases[1].snapshot;
        const Snapshot& clustered = *went->phases[2].snapshot;
        const int fresh = went->snapshot->report.counts.segments;

        // Nobody owns the new segments yet; then they join planes, and the rest joins clusters.
        QCOMPARE(static_cast<int>(extracted.segments.segmentCount() - before.segments.segmentCount()), fresh);
        QCOMPARE(extracted.report.counts.fitted, before.report.counts.fitted);
        QCOMPARE(extracted.report.counts.unfitted, before.report.counts.unfitted + fresh);
        QCOMPARE(extracted.report.counts.assigned, 0);
        QCOMPARE(assigned.report.counts.fitted, before.report.counts.fitted + assigned.report.counts.assigned);
        QCOMPARE(assigned.report.counts.clustered, 0);
        QCOMPARE(clustered.report.counts.assigned + clustered.report.counts.clustered, fresh);
        QCOMPARE(clustered.report.counts.fitted, assigned.report.counts.fitted);
    }
}

void StepReplayTest::everySegmentIsInAPlaneOrInAClusterAtAllTimes()
{
    QFETCH(QString, preset);
    const Scanned scan("office", parametersOf(preset.toStdString()));
    StepReplay replay = scan.replay();

    for (int step = 0; step <= scan.steps(); ++step) {
        const auto went = *replay.at(step < scan.steps() ? step : kLastPass);
        for (const PhaseState& state : went->phases) {
            const Snapshot& snapshot = *state.snapshot;
            std::set<SegmentId> fitted;
            std::size_t members = 0;
            for (const auto& plane : snapshot.planes) {
                members += plane->segments.size();
                fitted.insert(plane->segments.begin(), plane->segments.end());
            }
            std::set<SegmentId> clustered;
            std::size_t inClusters = 0;
            for (const auto& cluster : snapshot.clusters) {
                inClusters += cluster->segments.size();
                clustered.insert(cluster->segments.begin(), cluster->segments.end());
            }
            QCOMPARE(fitted.size(), members);
            QCOMPARE(clustered.size(), inClusters);
            QCOMPARE(members, static_cast<std::size_t>(snapshot.report.counts.fitted));
            QCOMPARE(members + static_cast<std::size_t>(snapshot.report.counts.unfitted),
                     snapshot.segments.segmentCount());
            // Segments of this slice are in neither before they are assigned or clustered.
            const bool isSettled = state.phase != Phase::Extract && state.phase != Phase::Assign;
            if (isSettled) {
                std::set<SegmentId> all = fitted;
                all.insert(clustered.begin(), clustered.end());
                QCOMPARE(all.size(), members + inClusters);
                QCOMPARE(all.size(), snapshot.segments.segmentCount());
            }
        }
    }
}

void StepReplayTest::aScanThatGoesOnIsFollowed()
{
    QFETCH(QString, preset);
    const Parameters first = parametersOf(preset.toStdString());
    Parameters second = first;
    second.segments.minLength = 0.5;
    const Scanned scan("office", first, {{31, second}});
    StepReplay replay(scan.sensor(), first);

    for (const ScanSlice& slice : scan.room.scan.recording.slices) {
        if (slice.step == 31)
            replay.change({31, second});
        replay.add(std::make_shared<const ScanSlice>(slice));
        QCOMPARE(differenceOf(*(*replay.at(slice.step))->snapshot, scan.at(slice.step)), "");
        // The last pass of a scan that is not over yet ends nothing.
        if (slice.step == 20)
            QVERIFY(replay.at(kLastPass).has_value());
    }
    QCOMPARE(differenceOf(*(*replay.at(kLastPass))->snapshot, scan.at(kLastPass)), "");
    // A change that comes late holds for the steps from its own on.
    replay.change({10, second});
    QCOMPARE(differenceOf(*(*replay.at(9))->snapshot, scan.at(9)), "");
    QVERIFY(differenceOf(*(*replay.at(30))->snapshot, scan.at(30)) != "");
}

void StepReplayTest::aVisitTellsEveryStep()
{
    QFETCH(QString, preset);
    Parameters second = parametersOf(preset.toStdString());
    second.segments.minLength = 0.5;
    const Scanned scan("corridor", parametersOf(preset.toStdString()), {{25, second}});
    const StepReplay replay = scan.replay();

    std::vector<int> steps;
    std::size_t decisions = 0;
    replay.visit(true, [&](const Snapshot& snapshot) {
        steps.push_back(snapshot.report.step);
        decisions += snapshot.report.decisions.size();
        QCOMPARE(differenceOf(snapshot, scan.at(snapshot.report.step)), "");
    });

    QCOMPARE(steps.size(), scan.history.size());
    QCOMPARE(steps.back(), kLastPass);
    QVERIFY(decisions > steps.size());
}

void StepReplayTest::aStepThatIsNotThereIsRefused()
{
    const Scanned scan("corridor", parametersOf("paper"));
    StepReplay replay = scan.replay();
    StepReplay empty(scan.sensor(), scan.parameters);

    QCOMPARE(replay.at(scan.steps()).error().code, ErrorCode::Usage);
    QCOMPARE(replay.at(-5).error().message, "The scan has no step -5. Choose one of its 56 steps from 0 to 55.");
    QCOMPARE(empty.at(0).error().message, "The scan has no steps yet. Ask again after its first slice.");
    QVERIFY((*empty.at(kLastPass))->snapshot->planes.empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::StepReplayTest)
#include "step_replay_test.moc"
