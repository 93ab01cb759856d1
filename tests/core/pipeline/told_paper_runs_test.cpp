// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/core/pipeline/leaning_runs_twin.h"
#include "tests/core/pipeline/plane_pair_twin.h"
#include "tests/core/pipeline/told_step.h"
#include "tests/test_program.h"

namespace planewright {

/// What `paper` says of runs that lean out of planes, and of gaps between them, worked out anew from segments.
class ToldPaperRunsTest : public QObject {
    Q_OBJECT

private slots:
    void planesAreContestedByTheRunsOnThem_data() { scenes(); }
    void planesAreContestedByTheRunsOnThem();
    void segmentsThatLeanOutAreOfSuchRuns_data() { scenes(); }
    void segmentsThatLeanOutAreOfSuchRuns();
    void pairsAreAsFarApartAsTold_data() { scenes(); }
    void pairsAreAsFarApartAsTold();

private:
    static void scenes()
    {
        QTest::addColumn<QString>("scene");
        for (const char* scene : {"corridor", "office", "stairs", "clutter", "hall", "curved"})
            QTest::newRow(scene) << scene;
    }
};

void ToldPaperRunsTest::planesAreContestedByTheRunsOnThem()
{
    QFETCH(QString, scene);
    const ToldScan scan("paper", scene.toStdString(), 3);
    const PlaneParameters& p = scan.parameters.planes;
    Recomputed recomputed;
    for (const ToldPhase& phase : scan.phases) {
        const RunTwin runs(phase.after->segments, p);
        for (const Decision& decision : phase.decisions()) {
            const Plane* plane = nullptr;
            if (decision.kind == DecisionKind::Fit)
                plane = planeIn(*phase.after, planeOf(decision.result[0]));
            if (decision.kind == DecisionKind::Split && decision.tests.front().name == "contested")
                plane = planeIn(*phase.before, planeOf(decision.operands[0]));
            if (plane == nullptr)
                continue;
            const Test& told = testOf(decision.tests, "contested");
            QVERIFY(recomputed.agree(phase, told, runs.share(plane->segments, plane->normal, plane->distance),
                                     p.maxContested));
        }
    }
    QVERIFY(recomputed.counts["contested"] > 4);
}

void ToldPaperRunsTest::segmentsThatLeanOutAreOfSuchRuns()
{
    QFETCH(QString, scene);
    const ToldScan scan("paper", scene.toStdString(), 3);
    Recomputed recomputed;
    for (const ToldPhase& phase : scan.phases) {
        if (phase.phase != Phase::Assign)
            continue;
        const RunTwin runs(phase.after->segments, scan.parameters.planes);
        for (const Decision& decision : phase.decisions()) {
            if (decision.kind != DecisionKind::Reject || decision.tests.empty() ||
                decision.tests.front().name != "contested")
                continue;
            const Plane& plane = *planeIn(*phase.before, planeOf(decision.operands[1]));
            const SegmentId segment = segmentOf(decision.operands[0]);
            const bool leans = plane.segments.size() < 100 && runs.contests(segment, plane.normal, plane.distance);
            QVERIFY(recomputed.agree(phase, decision.tests.front(), leans ? 1.0 : 0.0, 0.0));
        }
        // And one that joined a young plane is of none.
        for (const Decision& decision : phase.decisions()) {
            if (decision.kind != DecisionKind::Assign)
                continue;
            const Plane& plane = *planeIn(*phase.before, planeOf(decision.operands[1]));
            if (plane.segments.size() < 90 && plane.revision == planeIn(*phase.after, plane.id)->revision - 1) {
                QVERIFY2(!runs.contests(segmentOf(decision.operands[0]), plane.normal, plane.distance),
                         phase.text().c_str());
                ++recomputed.counts["joined"];
            }
        }
    }
    QVERIFY(recomputed.counts["joined"] > 20);
}

void ToldPaperRunsTest::pairsAreAsFarApartAsTold()
{
    QFETCH(QString, scene);
    const ToldScan scan("paper", scene.toStdString(), 3);
    const PlaneParameters& p = scan.parameters.planes;
    Recomputed recomputed;
    for (const ToldPhase& phase : scan.phases) {
        const SegmentLog& log = phase.after->segments;
        const RunTwin runs(log, p);
        std::set<PlaneId> changed;
        for (const Decision& decision : phase.decisions()) {
            const auto asBefore = [&](const Operand& operand) -> const Plane* {
                return changed.contains(planeOf(operand)) ? nullptr : planeIn(*phase.before, planeOf(operand));
            };
            const bool isPair = decision.kind == DecisionKind::Merge || decision.kind == DecisionKind::Near;
            if (isPair && asBefore(decision.operands[0]) != nullptr && asBefore(decision.operands[1]) != nullptr) {
                const Plane& a = *asBefore(decision.operands[0]);
                const Plane& b = *asBefore(decision.operands[1]);
                // The larger takes in the smaller one where that fits it, or both are held against the plane of both.
                const bool isTakenIn = decision.tests.front().name == "shared_segments";
                const Test& gap = testOf(decision.tests, "in_plane_gap");
                QVERIFY(recomputed.agree(phase, gap, gapOf(a.segments, b.segments, log, p.mergeGap), p.mergeGap, 1e-6));
                const TogetherTwin together(a, b, log, p);
                if (!isTakenIn) {
                    QVERIFY(recomputed.agree(phase, testOf(decision.tests, "fitting_error"), together.error,
                                             p.errorLimit, 0.002));
                }
                const auto told = std::find_if(decision.tests.begin(), decision.tests.end(),
                                               [](const Test& test) { return test.name == "contested"; });
                if (told != decision.tests.end()) {
                    const double share =
                        isTakenIn ? runs.share(b.segments, a.normal, a.distance)
                                  : std::max(runs.share(a.segments, together.plane.normal, together.plane.distance),
                                             runs.share(b.segments, together.plane.normal, together.plane.distance));
                    QVERIFY(recomputed.agree(phase, *told, share, p.maxContested));
                }
            }
            if (decision.kind == DecisionKind::Merge || decision.kind == DecisionKind::Split) {
                for (const Operand& operand : decision.operands)
                    changed.insert(planeOf(operand));
                for (const Operand& result : decision.result)
                    changed.insert(planeOf(result));
            }
        }
    }
    if (scene == "curved")
        QVERIFY(recomputed.counts["in_plane_gap"] > 20 && recomputed.counts["contested"] > 3);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldPaperRunsTest)
#include "told_paper_runs_test.moc"
