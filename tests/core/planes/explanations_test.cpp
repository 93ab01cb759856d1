// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <map>

#include <QtTest>

#include "core/pipeline/plane_extractor.h"
#include "core/simulation/nodding_scanner.h"
#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

constexpr std::size_t kKinds = kDecisionKindNames.size();

/// The reports of all steps of a simulated scan, and how often each kind of decision was taken.
struct Explained {
    std::vector<StepReport> reports;
    std::array<int, kKinds> taken{};

    Explained(std::string_view scene, std::uint64_t seed)
    {
        AcquisitionSettings settings;
        settings.beams = 361;
        settings.bearingStep = degrees(0.5);
        const SimulatedScan scan =
            simulate(makeScene(scene, seed).value(), settings, simulationNoise("default").value(), seed);
        ExtractionOptions options;
        options.explain = true;
        Parameters parameters;
        parameters.segments.minPoints = 5;
        PlaneExtractor extractor(sensorOf(scan.recording.description), parameters, options);
        for (const ScanSlice& slice : scan.recording.slices)
            reports.push_back(extractor.step(slice)->report);
        reports.push_back(extractor.finish()->report);
        for (const StepReport& report : reports) {
            for (const Decision& decision : report.decisions)
                ++taken[static_cast<std::size_t>(decision.kind)];
        }
    }

    int count(DecisionKind kind) const { return taken[static_cast<std::size_t>(kind)]; }
};

const Explained& explained(int scan)
{
    static const std::array<Explained, 3> scans{Explained("corridor", 71), Explained("office", 72),
                                                Explained("stairs", 73)};
    return scans[static_cast<std::size_t>(scan)];
}

}  // namespace

/// Simulated scans of three rooms: what was decided and the numbers told for it agree.
class ExplanationsTest : public QObject {
    Q_OBJECT

private slots:
    void everyDecisionAgreesWithItsTests_data() { rooms(); }
    void everyDecisionAgreesWithItsTests();
    void everyDecisionNamesWhatItIsAbout_data() { rooms(); }
    void everyDecisionNamesWhatItIsAbout();
    void splitsAndMergesAreCounted_data() { rooms(); }
    void splitsAndMergesAreCounted();
    void decisionsOfEveryKindWereTaken();
    void limitsAreFinite_data() { rooms(); }
    void limitsAreFinite();

private:
    static void rooms()
    {
        QTest::addColumn<int>("scan");
        QTest::newRow("corridor") << 0;
        QTest::newRow("office") << 1;
        QTest::newRow("stairs") << 2;
    }
};

void ExplanationsTest::everyDecisionAgreesWithItsTests()
{
    QFETCH(int, scan);
    for (const StepReport& report : explained(scan).reports) {
        for (const Decision& decision : report.decisions) {
            switch (decision.kind) {
                case DecisionKind::Assign:
                case DecisionKind::Fit:
                case DecisionKind::Split:
                case DecisionKind::Merge:
                    QVERIFY(!decision.tests.empty());
                    QVERIFY(allPass(decision.tests));
                    break;
                case DecisionKind::Reject:
                    // Without any plane there is nothing to compare a segment with.
                    QVERIFY(decision.tests.empty() ? decision.operands.size() == 1 : !allPass(decision.tests));
                    break;
                case DecisionKind::NoFit:
                case DecisionKind::Near:
                    QVERIFY(!allPass(decision.tests));
                    break;
                case DecisionKind::Cluster:
                    QVERIFY(!decision.tests.empty());
                    break;
            }
        }
    }
}

void ExplanationsTest::everyDecisionNamesWhatItIsAbout()
{
    QFETCH(int, scan);
    for (const StepReport& report : explained(scan).reports) {
        for (const Decision& decision : report.decisions) {
            QVERIFY(!decision.operands.empty());
            const bool negative = decision.kind == DecisionKind::Reject || decision.kind == DecisionKind::NoFit ||
                                  decision.kind == DecisionKind::Near;
            if (negative)
                QVERIFY(decision.result.empty());
            else if (decision.kind != DecisionKind::Split)
                QCOMPARE(decision.result.size(), std::size_t{1});
            if (decision.kind == DecisionKind::Cluster)
                QVERIFY(clusterOf(decision.result[0]) != kNoCluster);
            if (decision.kind == DecisionKind::Assign || decision.kind == DecisionKind::Fit ||
                decision.kind == DecisionKind::Merge)
                QVERIFY(planeOf(decision.result[0]) != kNoPlane);
        }
    }
}

void ExplanationsTest::splitsAndMergesAreCounted()
{
    QFETCH(int, scan);
    int splits = 0;
    int merges = 0;
    for (const StepReport& report : explained(scan).reports) {
        splits += report.counts.splits;
        merges += report.counts.merges;
    }

    QCOMPARE(splits, explained(scan).count(DecisionKind::Split));
    QCOMPARE(merges, explained(scan).count(DecisionKind::Merge));
}

void ExplanationsTest::decisionsOfEveryKindWereTaken()
{
    for (const DecisionKind kind : {DecisionKind::Assign, DecisionKind::Reject, DecisionKind::Cluster,
                                    DecisionKind::Fit, DecisionKind::NoFit, DecisionKind::Merge, DecisionKind::Near}) {
        int taken = 0;
        for (const int scan : {0, 1, 2})
            taken += explained(scan).count(kind);
        QVERIFY2(taken > 0, std::string(name(kind)).c_str());
    }
}

void ExplanationsTest::limitsAreFinite()
{
    QFETCH(int, scan);
    for (const StepReport& report : explained(scan).reports) {
        for (const Decision& decision : report.decisions) {
            for (const Test& test : decision.tests) {
                QVERIFY(std::isfinite(test.value));
                QVERIFY(std::isfinite(test.limit));
            }
        }
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ExplanationsTest)
#include "explanations_test.moc"
