// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/plane_lives.h"

#include <QtTest>

#include "core/params/presets.h"
#include "core/pipeline/plane_extractor.h"
#include "tests/core/pipeline/drawn_step.h"
#include "tests/core/pipeline/simulated_room.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

using Kind = LifeEventKind;

Decision fitted(PlaneId plane, ClusterId cluster)
{
    return {Phase::Fit, DecisionKind::Fit, {ClusterRef{cluster}}, {}, {PlaneRef{plane}}};
}

Decision merged(PlaneId a, PlaneId b, PlaneId kept)
{
    return {Phase::SplitMerge, DecisionKind::Merge, {PlaneRef{a}, PlaneRef{b}}, {}, {PlaneRef{kept}}};
}

Decision split(PlaneId plane, const std::vector<PlaneId>& parts)
{
    Decision decision{Phase::SplitMerge, DecisionKind::Split, {PlaneRef{plane}}, {}, {}};
    for (const PlaneId part : parts)
        decision.result.emplace_back(PlaneRef{part});
    return decision;
}

std::vector<Kind> kindsOf(const PlaneLife& life)
{
    std::vector<Kind> kinds;
    for (const LifeEvent& event : life.events)
        kinds.push_back(event.kind);
    return kinds;
}

/// Plane 0 is made of cluster 4, then 1 of cluster 6; 0 is split into 0 and 2; 1 goes into 2; the last pass deletes 0.
PlaneLives drawnLives()
{
    PlaneLives lives;
    lives.add(drawnStep(4, {fitted(0, 4)}, {{0, 5}}));
    lives.add(drawnStep(5, {}, {{0, 8}}));
    lives.add(drawnStep(6, {fitted(1, 6)}, {{0, 8}, {1, 3}}));
    lives.add(drawnStep(7, {split(0, {0, 2})}, {{0, 4}, {1, 3}, {2, 4}}));
    lives.add(drawnStep(14, {merged(1, 2, 2)}, {{0, 4}, {2, 7}}));
    lives.add(drawnStep(-1, {{Phase::Finish, DecisionKind::NoFit, {PlaneRef{0}}, {}, {}}}, {{2, 7}}));
    return lives;
}

}  // namespace

class PlaneLivesTest : public QObject {
    Q_OBJECT

private slots:
    void aPlaneIsBornGrowsIsSplitAndEnds();
    void aMergedPlaneEndsInTheOther();
    void familiesHoldAncestorsAndDescendants();
    void aPlaneIsFollowedOverSplitsAndMerges_data();
    void aPlaneIsFollowedOverSplitsAndMerges();
    void whatWasSplitBeforeTheMergeIsNotFollowed();
    void aPlaneOfSegmentsOfOneTakenApartComesFromIt();
    void aPlaneGivenUpAtOnceIsNoAncestor();
    void aPlaneThatEndsUnsaidIsDeleted();
    void withoutDecisionsPlanesSayThemselves();
    void simulatedLivesAreThoseOfTheSnapshots_data();
    void simulatedLivesAreThoseOfTheSnapshots();
};

void PlaneLivesTest::aPlaneIsBornGrowsIsSplitAndEnds()
{
    const PlaneLives lives = drawnLives();
    const PlaneLife& life = lives.lives().at(0);

    QCOMPARE(kindsOf(life), (std::vector{Kind::Fitted, Kind::SplitInto, Kind::Deleted}));
    QCOMPARE(life.bornStep(), 4);
    QCOMPARE(life.events[0].from, std::vector<ClusterId>{4});
    QCOMPARE(life.events[1].step, 7);
    QCOMPARE(life.events[1].others, std::vector<PlaneId>{2});
    QCOMPARE(life.events[2].step, -1);
    QVERIFY(life.isOver);
    // 5 segments at step 4, 8 from step 5 on, 4 from step 7 on.
    QCOMPARE(life.sizes.size(), std::size_t{3});
    QCOMPARE(life.sizes[1].step, 5);
    QCOMPARE(life.sizes[1].segments, 8);
    QCOMPARE(life.sizes[2].segments, 4);
}

void PlaneLivesTest::aMergedPlaneEndsInTheOther()
{
    const PlaneLives lives = drawnLives();

    QCOMPARE(kindsOf(lives.lives().at(1)), (std::vector{Kind::Fitted, Kind::MergedInto}));
    QCOMPARE(kindsOf(lives.lives().at(2)), (std::vector{Kind::SplitFrom, Kind::MergedFrom}));
    QCOMPARE(lives.lives().at(1).events[1].others, std::vector<PlaneId>{2});
    QCOMPARE(lives.lives().at(2).events[0].others, std::vector<PlaneId>{0});
    QVERIFY(!lives.lives().at(2).isOver);
    QVERIFY(lives.isThere(1, 7) && !lives.isThere(1, 14) && lives.isThere(0, 14) && !lives.isThere(0, -1));
}

void PlaneLivesTest::familiesHoldAncestorsAndDescendants()
{
    PlaneLives lives = drawnLives();
    lives.add(drawnStep(-1, {fitted(9, 8)}, {{2, 7}, {9, 3}}));

    QCOMPARE(lives.familyOf(2), (std::vector<PlaneId>{0, 1, 2}));
    QCOMPARE(lives.familyOf(0), (std::vector<PlaneId>{0, 2}));
    QCOMPARE(lives.familyOf(1), (std::vector<PlaneId>{1, 2}));
    QCOMPARE(lives.familyOf(9), std::vector<PlaneId>{9});
    QVERIFY(lives.familyOf(5).empty());
}

void PlaneLivesTest::aPlaneIsFollowedOverSplitsAndMerges_data()
{
    QTest::addColumn<int>("plane");
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::addColumn<std::vector<int>>("found");
    QTest::newRow("the same step") << 0 << 5 << 5 << std::vector{0};
    QTest::newRow("it goes on") << 0 << 4 << 6 << std::vector{0};
    QTest::newRow("into its parts") << 0 << 4 << 7 << std::vector{0, 2};
    QTest::newRow("into another") << 1 << 7 << 14 << std::vector{2};
    QTest::newRow("past its end") << 0 << 14 << -1 << std::vector<int>{};
    QTest::newRow("over a split and past its end") << 0 << 4 << -1 << std::vector{2};
    QTest::newRow("back to what it was split from") << 2 << 7 << 5 << std::vector{0};
    QTest::newRow("back to all that went into it") << 2 << -1 << 7 << std::vector{1, 2};
    QTest::newRow("back over a merge and a split") << 2 << 14 << 6 << std::vector{0, 1};
    QTest::newRow("back before its birth") << 1 << 7 << 5 << std::vector<int>{};
    QTest::newRow("one that never was") << 5 << 7 << 14 << std::vector<int>{};
}

void PlaneLivesTest::aPlaneIsFollowedOverSplitsAndMerges()
{
    QFETCH(int, plane);
    QFETCH(int, from);
    QFETCH(int, to);
    QFETCH(std::vector<int>, found);

    QCOMPARE(drawnLives().follow(plane, from, to), found);
}

void PlaneLivesTest::whatWasSplitBeforeTheMergeIsNotFollowed()
{
    PlaneLives lives;
    lives.add(drawnStep(0, {fitted(0, 0), fitted(1, 1)}, {{0, 9}, {1, 3}}));
    // In one step, 2 is split off from 0, and then 1 goes into 0.
    lives.add(drawnStep(1, {split(0, {0, 2}), merged(0, 1, 0)}, {{0, 8}, {2, 4}}));

    QCOMPARE(lives.follow(1, 0, 1), std::vector<PlaneId>{0});
    QCOMPARE(lives.follow(0, 0, 1), (std::vector<PlaneId>{0, 2}));
    QCOMPARE(lives.follow(2, 1, 0), std::vector<PlaneId>{0});
    QCOMPARE(lives.follow(0, 1, 0), (std::vector<PlaneId>{0, 1}));
}

void PlaneLivesTest::aPlaneOfSegmentsOfOneTakenApartComesFromIt()
{
    PlaneLives lives;
    lives.add(drawnStep(0, {fitted(0, 0)}, {{0, 9}}));
    const Decision riser{
        Phase::Finish, DecisionKind::Fit, {SegmentId{0, 0}, SegmentId{1, 0}, SegmentId{2, 0}}, {}, {PlaneRef{1}}};
    lives.add(drawnStep(-1, {split(0, {}), riser}, {{1, 3}}));

    QCOMPARE(kindsOf(lives.lives().at(0)), (std::vector{Kind::Fitted, Kind::TakenApart}));
    QCOMPARE(lives.lives().at(0).events[1].others, std::vector<PlaneId>{1});
    QCOMPARE(kindsOf(lives.lives().at(1)), std::vector{Kind::SplitFrom});
    QCOMPARE(lives.follow(0, 0, -1), std::vector<PlaneId>{1});
}

void PlaneLivesTest::aPlaneGivenUpAtOnceIsNoAncestor()
{
    const std::vector<Operand> seeds{SegmentId{0, 0}, SegmentId{1, 0}, SegmentId{2, 0}};
    PlaneLives lives;
    lives.add(drawnStep(2,
                        {{Phase::Cluster, DecisionKind::Cluster, {SegmentId{0, 0}}, {}, {ClusterRef{3}}},
                         {Phase::Fit, DecisionKind::Fit, seeds, {}, {PlaneRef{0}}},
                         {Phase::Fit, DecisionKind::NoFit, {PlaneRef{0}}, {}, {}},
                         {Phase::Fit, DecisionKind::Fit, seeds, {}, {PlaneRef{1}}}},
                        {{1, 3}}));

    QVERIFY(!lives.lives().contains(0));
    QCOMPARE(kindsOf(lives.lives().at(1)), std::vector{Kind::Fitted});
    QCOMPARE(lives.lives().at(1).events[0].from, std::vector<ClusterId>{3});
}

void PlaneLivesTest::aPlaneThatEndsUnsaidIsDeleted()
{
    PlaneLives lives;
    lives.add(drawnStep(0, {fitted(0, 0)}, {{0, 4}}));
    lives.add(drawnStep(1, {}, {}));

    QCOMPARE(kindsOf(lives.lives().at(0)), (std::vector{Kind::Fitted, Kind::Deleted}));
    QCOMPARE(lives.lives().at(0).events[1].step, 1);
}

void PlaneLivesTest::withoutDecisionsPlanesSayThemselves()
{
    Snapshot merged = drawnStep(2, {}, {{0, 9}});
    Plane kept = *merged.planes[0];
    kept.lineage = {Lineage::Kind::Merged, {0, 1}};
    merged.planes[0] = std::make_shared<const Plane>(kept);
    PlaneLives lives;
    lives.add(drawnStep(0, {}, {{0, 5}}));
    lives.add(drawnStep(1, {}, {{0, 5}, {1, 4}}));
    lives.add(merged);

    QCOMPARE(kindsOf(lives.lives().at(0)), (std::vector{Kind::Fitted, Kind::MergedFrom}));
    QCOMPARE(kindsOf(lives.lives().at(1)), (std::vector{Kind::Fitted, Kind::MergedInto}));
    QCOMPARE(lives.follow(1, 1, 2), std::vector<PlaneId>{0});
}

void PlaneLivesTest::simulatedLivesAreThoseOfTheSnapshots_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<QString>("scene");
    for (const char* preset : {"paper", "precise"}) {
        for (const char* scene : {"office", "clutter", "curved"})
            QTest::addRow("%s, %s", preset, scene) << preset << scene;
    }
}

void PlaneLivesTest::simulatedLivesAreThoseOfTheSnapshots()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset.toStdString()), parameters);
    const SimulatedRoom room = scanOf(scene.toStdString(), "default", 3, "table10-2");
    PlaneExtractor extractor(sensorOf(room.scan.recording.description), parameters, {{}, true});
    std::vector<std::shared_ptr<const Snapshot>> history;
    PlaneLives lives;
    for (const ScanSlice& slice : room.scan.recording.slices)
        history.push_back(extractor.step(slice));
    history.push_back(extractor.finish());
    for (const auto& snapshot : history)
        lives.add(*snapshot);

    int merges = 0;
    int ends = 0;
    for (const auto& [id, life] : lives.lives()) {
        QCOMPARE(life.id, id);
        for (const LifeEvent& event : life.events) {
            merges += event.kind == Kind::MergedInto ? 1 : 0;
            for (const PlaneId other : event.others)
                QVERIFY(lives.lives().contains(other));
        }
        ends += life.isOver ? 1 : 0;
        // A birth first, and nothing after an end.
        const auto isBirth = [](const LifeEvent& event) {
            return event.kind == Kind::Fitted || event.kind == Kind::SplitFrom;
        };
        QVERIFY(isBirth(life.events.front()));
        QCOMPARE(std::count_if(life.events.begin(), life.events.end(), isBirth), std::ptrdiff_t{1});
    }
    int counted = 0;
    for (const auto& snapshot : history) {
        counted += snapshot->report.counts.merges;
        const int step = snapshot->report.step;
        int there = 0;
        for (const auto& [id, life] : lives.lives())
            there += lives.isThere(id, step) ? 1 : 0;
        QCOMPARE(there, static_cast<int>(snapshot->planes.size()));
        for (const auto& plane : snapshot->planes) {
            QVERIFY(lives.isThere(plane->id, step));
            const PlaneLife& life = lives.lives().at(plane->id);
            QCOMPARE(life.bornStep() < 0 ? room.scan.recording.slices.back().step : life.bornStep(), plane->bornStep);
            int size = 0;
            for (const PlaneLife::Size& at : life.sizes) {
                if (step < 0 || (at.step >= 0 && at.step <= step))
                    size = at.segments;
            }
            QCOMPARE(size, static_cast<int>(plane->segments.size()));
            for (const PlaneId parent : plane->lineage.parents)
                QVERIFY(parent == plane->id || lives.lives().contains(parent));
        }
    }
    QCOMPARE(merges, counted);
    if (scene == "curved")
        QVERIFY(merges > 0 && ends > merges / 2);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PlaneLivesTest)
#include "plane_lives_test.moc"
