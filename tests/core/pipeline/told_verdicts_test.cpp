// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/core/pipeline/told_step.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Where planes are at the end of a phase that merged and dissolved some: by what the decisions say.
struct Fates {
    std::map<PlaneId, PlaneId> wentInto;
    std::set<PlaneId> dissolved;
    std::set<PlaneId> split;

    explicit Fates(const std::vector<Decision>& decisions)
    {
        for (const Decision& decision : decisions) {
            const PlaneId first = planeOf(decision.operands.front());
            if (decision.kind == DecisionKind::Merge) {
                const PlaneId kept = planeOf(decision.result.front());
                const PlaneId second = planeOf(decision.operands[1]);
                wentInto[first == kept ? second : first] = kept;
            } else if (decision.kind == DecisionKind::NoFit && first != kNoPlane)
                dissolved.insert(first);
            else if (decision.kind == DecisionKind::Split) {
                split.insert(first);
                if (decision.result.empty())
                    dissolved.insert(first);
            }
        }
    }

    /// The plane that a plane is part of by now; kNoPlane for one that was dissolved.
    PlaneId now(PlaneId plane) const
    {
        for (auto next = wentInto.find(plane); next != wentInto.end(); next = wentInto.find(plane))
            plane = next->second;
        return dissolved.contains(plane) ? kNoPlane : plane;
    }
};

PlaneId ownerIn(const Snapshot& snapshot, const SegmentId& segment)
{
    const Plane* owner = ownerOf(segment, snapshot);
    return owner == nullptr ? kNoPlane : owner->id;
}

}  // namespace

/// What decisions say has happened is what the snapshots show.
class ToldVerdictsTest : public QObject {
    Q_OBJECT

private slots:
    void segmentsAreWhereTheirLastDecisionPutThem_data() { scans(); }
    void segmentsAreWhereTheirLastDecisionPutThem();
    void planesAreThereOrGoneAsDecided_data() { scans(); }
    void planesAreThereOrGoneAsDecided();
    void everyEchoIsInASegmentOrDiscarded_data() { scans(); }
    void everyEchoIsInASegmentOrDiscarded();
    void nothingHappensToPlanesUntold_data() { scans(); }
    void nothingHappensToPlanesUntold();

private:
    static void scans()
    {
        QTest::addColumn<QString>("preset");
        QTest::addColumn<QString>("scene");
        for (const char* preset : {"paper", "precise"}) {
            for (const char* scene : {"corridor", "office", "stairs", "clutter", "hall", "curved"})
                QTest::addRow("%s, %s", preset, scene) << preset << scene;
        }
    }
};

void ToldVerdictsTest::segmentsAreWhereTheirLastDecisionPutThem()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    const ToldScan scan(preset.toStdString(), scene.toStdString(), 3);
    int assigned = 0;
    int rejected = 0;
    int clustered = 0;
    for (const ToldPhase& phase : scan.phases) {
        const Fates fates(phase.decisions());
        std::map<SegmentId, const Decision*> last;
        for (const Decision& decision : phase.decisions()) {
            const bool isOfSegment = decision.phase != Phase::Extract &&
                                     (decision.kind == DecisionKind::Assign || decision.kind == DecisionKind::Reject ||
                                      decision.kind == DecisionKind::Cluster);
            if (isOfSegment)
                last[segmentOf(decision.operands.front())] = &decision;
        }
        for (const auto& [segment, decision] : last) {
            const PlaneId owner = ownerIn(*phase.after, segment);
            if (decision->kind == DecisionKind::Assign) {
                const PlaneId joined = fates.now(planeOf(decision->result.front()));
                // Small planes of the last pass end unsaid: their segments are clustered, which is told.
                QVERIFY2(owner == joined, phase.text().c_str());
                ++assigned;
            } else if (decision->kind == DecisionKind::Reject) {
                QVERIFY2(owner == kNoPlane, phase.text().c_str());
                ++rejected;
            } else {
                const DirectionCluster* cluster = clusterIn(*phase.after, clusterOf(decision->result.front()));
                QVERIFY2(cluster != nullptr && holds(cluster->segments, segment), phase.text().c_str());
                QVERIFY2(owner == kNoPlane, phase.text().c_str());
                ++clustered;
            }
        }
    }
    QVERIFY(assigned > 100 && rejected > 20 && clustered > 20);
}

void ToldVerdictsTest::planesAreThereOrGoneAsDecided()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    const ToldScan scan(preset.toStdString(), scene.toStdString(), 3);
    std::map<DecisionKind, int> seen;
    for (const ToldPhase& phase : scan.phases) {
        const Fates fates(phase.decisions());
        for (const Decision& decision : phase.decisions()) {
            ++seen[decision.kind];
            for (const Operand& result : decision.result) {
                const PlaneId plane = planeOf(result);
                if (plane == kNoPlane)
                    continue;
                const PlaneId now = fates.now(plane);
                QVERIFY2((planeIn(*phase.after, plane) != nullptr) == (now == plane), phase.text().c_str());
            }
            if (decision.kind == DecisionKind::Fit) {
                const PlaneId plane = planeOf(decision.result.front());
                QVERIFY(planeIn(*phase.before, plane) == nullptr);
                for (const Operand& seed : decision.operands) {
                    const bool staysSeed =
                        clusterOf(seed) == kNoCluster && fates.now(plane) != kNoPlane && phase.pass.empty();
                    if (staysSeed)
                        QCOMPARE(ownerIn(*phase.after, segmentOf(seed)), fates.now(plane));
                }
            }
            const bool isOfPair = decision.kind == DecisionKind::Near || decision.kind == DecisionKind::Merge;
            if (!isOfPair)
                continue;
            for (const Operand& operand : decision.operands) {
                const PlaneId plane = planeOf(operand);
                QVERIFY2((planeIn(*phase.after, plane) != nullptr) == (fates.now(plane) == plane),
                         phase.text().c_str());
                // All that was in a plane before it was merged as a whole is where it went.
                const Plane* before = planeIn(*phase.before, plane);
                const bool isWhole = decision.kind == DecisionKind::Merge && before != nullptr && fates.split.empty() &&
                                     testOf(decision.tests, "normal_alignment").pass();
                if (!isWhole)
                    continue;
                const Plane* after = planeIn(*phase.after, fates.now(plane));
                QVERIFY2(after != nullptr, phase.text().c_str());
                QVERIFY2(std::includes(after->segments.begin(), after->segments.end(), before->segments.begin(),
                                       before->segments.end()),
                         phase.text().c_str());
            }
        }
    }
    QVERIFY(seen[DecisionKind::Fit] > 3);
    // A curved wall is many planes that nearly are one.
    if (scene == "curved")
        QVERIFY(seen[DecisionKind::Merge] > 0 && seen[DecisionKind::Near] > 2 && seen[DecisionKind::Split] > 1);
    if (scene == "clutter")
        QVERIFY(seen[DecisionKind::Merge] + seen[DecisionKind::Near] > 3 && seen[DecisionKind::NoFit] > 3);
}

void ToldVerdictsTest::everyEchoIsInASegmentOrDiscarded()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    const ToldScan scan(preset.toStdString(), scene.toStdString(), 3);
    const SensorModel sensor = sensorOf(scan.recording.description);
    int discarded = 0;
    for (const ToldPhase& phase : scan.phases) {
        if (phase.phase != Phase::Extract)
            continue;
        const ScanSlice& slice = scan.sliceOf(phase.step);
        std::vector<std::pair<int, int>> parts;
        const std::size_t place = phase.after->segments.find(phase.step);
        for (const LineSegment& segment : phase.after->segments.slice(place))
            parts.emplace_back(segment.firstBeam, segment.lastBeam);
        QCOMPARE(static_cast<int>(parts.size()), phase.after->report.counts.segments);
        for (const Decision& decision : phase.decisions()) {
            QCOMPARE(decision.kind, DecisionKind::Reject);
            QVERIFY(decision.result.empty());
            QVERIFY2(std::any_of(decision.tests.begin(), decision.tests.end(),
                                 [](const Test& test) { return !test.pass(); }),
                     phase.text().c_str());
            const PieceRef piece = pieceOf(decision.operands.at(0));
            QCOMPARE(piece.step, phase.step);
            parts.emplace_back(piece.firstBeam, piece.lastBeam);
            ++discarded;
        }
        std::sort(parts.begin(), parts.end());
        int echoes = 0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            QVERIFY2(i == 0 || parts[i].first > parts[i - 1].second, phase.text().c_str());
            echoes += echoesIn(slice, sensor, parts[i].first, parts[i].second);
        }
        QCOMPARE(echoes, phase.after->report.counts.returns);
    }
    QVERIFY(discarded > 10);
}

void ToldVerdictsTest::nothingHappensToPlanesUntold()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    const ToldScan scan(preset.toStdString(), scene.toStdString(), 3);
    for (const ToldPhase& phase : scan.phases) {
        const Fates fates(phase.decisions());
        std::set<PlaneId> told;
        for (const Decision& decision : phase.decisions()) {
            for (const Operand& result : decision.result)
                told.insert(planeOf(result));
        }
        for (const auto& plane : phase.after->planes)
            QVERIFY2(planeIn(*phase.before, plane->id) != nullptr || told.contains(plane->id), phase.text().c_str());
        for (const auto& plane : phase.before->planes) {
            if (planeIn(*phase.after, plane->id) != nullptr)
                continue;
            // It went into another, was dissolved, or lost all its segments one by one.
            const bool isTold = fates.now(plane->id) != plane->id;
            const bool lostAll = std::none_of(plane->segments.begin(), plane->segments.end(), [&](const SegmentId& s) {
                return ownerIn(*phase.after, s) == plane->id;
            });
            QVERIFY2(isTold || (lostAll && (phase.pass == "split" || phase.pass == "reassign")), phase.text().c_str());
        }
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldVerdictsTest)
#include "told_verdicts_test.moc"
