// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/decisions_model.h"

#include <algorithm>
#include <set>

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

#include "core/params/presets.h"
#include "core/params/registry.h"
#include "tests/core/pipeline/simulated_room.h"
#include "tests/test_program.h"
#include "ui/models/model_roles.h"

namespace planewright {

class DecisionsModelTest : public QObject {
    Q_OBJECT

private slots:
    void phasesThatAreNotDueSayWhenTheyAre();
    void nothingIsPromisedAfterTheLastStep();
    void theTreeHasPhasesDecisionsAndConditions();
    void thePhaseInTheViewIsMarked();
    void rowsAreCopiedWithTheirConditions();
    void clustersStandForTheirSegments();
    void everyConditionOfAScanHasWords_data();
    void everyConditionOfAScanHasWords();
    void whatIsShownIsWhatTheReportHas_data();
    void whatIsShownIsWhatTheReportHas();
};

namespace {

using Kind = DecisionKind;

/// Step 63 of files, 64 of the screen: no fit, no split; two segments asked, one of them to no plane.
InspectedStep step63()
{
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->report.step = 63;
    snapshot->report.counts.segments = 2;
    snapshot->report.counts.returns = 700;
    snapshot->report.times[static_cast<std::size_t>(Phase::Assign)] = std::chrono::microseconds{1100};
    snapshot->report.decisions = {
        {Phase::Assign,
         Kind::Assign,
         {SegmentId{63, 0}, PlaneRef{12}},
         {{"plane_distance", 0.012, Comparison::Less, 0.05}, {"orthogonality", 0.03, Comparison::Less, 0.1}},
         {PlaneRef{12}}},
        {Phase::Assign, Kind::Reject, {SegmentId{63, 1}}, {}, {}},
        {Phase::Cluster,
         Kind::Cluster,
         {SegmentId{63, 1}},
         {{"direction_similarity", 0.99, Comparison::Greater, 0.9848}},
         {ClusterRef{5}}}};
    auto cluster = std::make_shared<DirectionCluster>();
    cluster->id = 5;
    cluster->segments = {{60, 2}, {63, 1}};
    snapshot->clusters = {cluster};
    InspectedStep step;
    step.snapshot = std::move(snapshot);
    step.newest = 63;
    step.planned = 137;
    return step;
}

Parameters parametersOf(const QString& preset)
{
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset.toStdString()), parameters);
    return parameters;
}

void addPresets()
{
    QTest::addColumn<QString>("preset");
    QTest::newRow("paper") << "paper";
    QTest::newRow("precise") << "precise";
}

}  // namespace

void DecisionsModelTest::phasesThatAreNotDueSayWhenTheyAre()
{
    DecisionsModel model;
    model.setStep(step63());

    QStringList rows;
    for (int row = 0; row < model.rowCount(); ++row)
        rows << model.index(row, 0).data().toString();
    QCOMPARE(rows, (QStringList{"Extract segments  2 segments in 700 returns",
                                "Assign to planes  1 assigned, 1 fit none  1.1 ms", "Cluster  1 to clusters",
                                "Fit planes: next at step 65", "Split and merge: next at step 70",
                                "Fit remaining: next at step 65"}));
    QCOMPARE(model.index(3, 0).data(kLineRole).value<TextLine>().parts.front().tone, TextTone::Faint);
}

void DecisionsModelTest::nothingIsPromisedAfterTheLastStep()
{
    DecisionsModel model;
    InspectedStep step = step63();
    step.planned = 65;  // the last one is the screen's step 65
    step.parameters.schedule.splitAndMergeEvery = 10;

    model.setStep(step);

    QCOMPARE(model.index(3, 0).data().toString(), QStringLiteral("Fit planes: next at step 65"));
    QCOMPARE(model.index(4, 0).data().toString(), QStringLiteral("Split and merge: no more before the last pass"));
}

void DecisionsModelTest::theTreeHasPhasesDecisionsAndConditions()
{
    DecisionsModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setStep(step63());
    const QModelIndex assign = model.index(1, 0);
    const QModelIndex joined = model.index(0, 0, assign);
    const QModelIndex distance = model.index(0, 0, joined);

    QCOMPARE(model.rowCount(assign), 2);
    QCOMPARE(model.rowCount(joined), 2);
    QCOMPARE(model.rowCount(model.index(1, 0, assign)), 0);
    QCOMPARE(model.rowCount(distance), 0);
    QCOMPARE(distance.parent(), joined);
    QCOMPARE(joined.parent(), assign);
    QCOMPARE(distance.data().toString(), QStringLiteral("D 0.012 < 0.050 m ✔  Plane distance"));
    QVERIFY(model.parameterAt(distance) == "assignment.plane-distance");
    QVERIFY(model.parameterAt(joined).empty());
    QCOMPARE(model.decisionAt(distance), model.decisionAt(joined));
    QVERIFY(distance.data(Qt::ToolTipRole).toString().contains(QStringLiteral("farther end")));
    model.setStep(std::nullopt);
    QCOMPARE(model.rowCount(), 0);
}

void DecisionsModelTest::thePhaseInTheViewIsMarked()
{
    DecisionsModel model;
    model.setStep(step63());
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);

    model.setShownPhase(2);

    QCOMPARE(changed.count(), 1);
    QCOMPARE(model.indexOfPhase(2), model.index(2, 0));
    QCOMPARE(model.index(2, 0).data().toString(), QStringLiteral("▶ Cluster  1 to clusters  shown in 3D"));
    QVERIFY(!model.indexOfPhase(3).isValid());
}

void DecisionsModelTest::rowsAreCopiedWithTheirConditions()
{
    DecisionsModel model;
    model.setStep(step63());
    const QModelIndex assign = model.index(1, 0);

    const QString text = model.rowsAsText({model.index(0, 0), model.index(0, 0, assign), model.index(1, 0, assign)});

    QCOMPARE(text.split('\n'), (QStringList{"Step\tPhase\tDecision\tCondition\tValue\tComparison\tLimit\tUnit\tHolds",
                                            "64\tExtract segments\t2 segments in 700 returns\t\t\t\t\t\t",
                                            "64\tAssign to planes\tseg 64.0 → P12\tD\t0.012\t<\t0.050\tm\tyes",
                                            "64\tAssign to planes\tseg 64.0 → P12\t|n·δ|\t0.03\t<\t0.10\t\tyes",
                                            "64\tAssign to planes\tseg 64.1 fits no plane\t\t\t\t\t\t", ""}));
}

void DecisionsModelTest::clustersStandForTheirSegments()
{
    const InspectedStep now = step63();
    Snapshot before;
    auto cluster = std::make_shared<DirectionCluster>();
    cluster->id = 5;
    cluster->segments = {{58, 0}, {60, 2}};
    before.clusters = {cluster};

    QVERIFY((segmentsOfCluster(5, &before, *now.snapshot) == std::vector<SegmentId>{{58, 0}, {60, 2}, {63, 1}}));
    QVERIFY((segmentsOfCluster(5, nullptr, *now.snapshot) == std::vector<SegmentId>{{60, 2}, {63, 1}}));
    QVERIFY(segmentsOfCluster(6, &before, *now.snapshot).empty());
}

void DecisionsModelTest::everyConditionOfAScanHasWords_data()
{
    addPresets();
}

void DecisionsModelTest::everyConditionOfAScanHasWords()
{
    QFETCH(QString, preset);
    const Recording recording = scanOf("office", "default", 3, "table10-2").scan.recording;
    PlaneExtractor extractor(sensorOf(recording.description), parametersOf(preset), {{}, true});
    std::vector<StepReport> reports;
    for (const ScanSlice& slice : recording.slices)
        reports.push_back(extractor.advance(slice));
    const auto last = extractor.finish();
    reports.push_back(last->report);

    std::set<std::string_view> names;
    const auto look = [&](const Test& test, TestAbout about) {
        names.insert(test.name);
        QVERIFY2(wordsFor(test.name, about) != nullptr, std::string{test.name}.c_str());
    };
    for (const StepReport& report : reports) {
        for (const Decision& decision : report.decisions) {
            for (const Test& test : decision.tests)
                look(test, aboutOf(decision));
        }
    }
    QVERIFY(names.size() > 8);
    const PlaneRef first{last->planes[0]->id};
    const PlaneRef second{last->planes[1]->id};
    for (const Operand& operand : {Operand{second}, Operand{last->planes[1]->segments.front()}}) {
        const auto answer = extractor.whyNot(first, operand);
        QVERIFY(answer);
        for (const Conditions& way : answer->ways) {
            QVERIFY(wayTitle(way.name) != QString::fromStdString(std::string{way.name}));
            for (const Test& test : way.tests)
                look(test, aboutOf(way.name, way.tests));
        }
    }
    // Every parameter that is named exists.
    for (const TestWords& words : allTestWords()) {
        for (const std::string_view key : words.parameters)
            QVERIFY2(key.empty() || std::any_of(parameterRows().begin(), parameterRows().end(),
                                                [key](const ParameterRow& row) { return row.key == key; }),
                     std::string{key}.c_str());
    }
}

void DecisionsModelTest::whatIsShownIsWhatTheReportHas_data()
{
    addPresets();
}

/// Told by the report alone and phase by phase a step says the same, and its rows add up to the counts.
void DecisionsModelTest::whatIsShownIsWhatTheReportHas()
{
    QFETCH(QString, preset);
    const Recording recording = scanOf("corridor", "default", 7, "table10-2").scan.recording;
    const Parameters parameters = parametersOf(preset);
    PlaneExtractor extractor(sensorOf(recording.description), parameters);
    DecisionsModel brief;
    DecisionsModel phased;
    int all = 0;
    for (const ScanSlice& slice : recording.slices) {
        const auto step = std::make_shared<const PhasedStep>(extractor.stepByPhases(slice));
        brief.setStep(InspectedStep{step->snapshot, nullptr, parameters});
        phased.setStep(InspectedStep{step->snapshot, step, parameters});

        QCOMPARE(brief.rowCount(), phased.rowCount());
        std::size_t due = 0;
        std::array<int, kPhases> joined{};
        for (int row = 0; row < brief.rowCount(); ++row) {
            const InspectedPhase& told = phased.phases()[static_cast<std::size_t>(row)];
            QCOMPARE(brief.rowCount(brief.index(row, 0)), phased.rowCount(phased.index(row, 0)));
            if (!told.number)
                continue;
            QCOMPARE(*told.number, due);
            QCOMPARE(static_cast<int>(told.phase), static_cast<int>(step->phases[due].phase));
            QCOMPARE(told.decisions.size(), step->phases[due].snapshot->report.decisions.size());
            for (const Decision& decision : told.decisions)
                joined[static_cast<std::size_t>(told.phase)] +=
                    decision.kind == Kind::Assign || decision.kind == Kind::Cluster ? 1 : 0;
            ++due;
        }
        QCOMPARE(due, step->phases.size());
        const StepCounts& counts = step->snapshot->report.counts;
        all += counts.segments;
        QCOMPARE(joined[static_cast<std::size_t>(Phase::Assign)], counts.assigned);
        QCOMPARE(joined[static_cast<std::size_t>(Phase::Cluster)], counts.clustered);
        QCOMPARE(counts.assigned + counts.clustered, counts.segments);
        QCOMPARE(counts.fitted + counts.unfitted, all);
    }
    const auto last = std::make_shared<const PhasedStep>(extractor.finishByPhases());
    phased.setStep(InspectedStep{last->snapshot, last, parameters});
    QCOMPARE(static_cast<std::size_t>(phased.rowCount()), last->phases.size());
    std::size_t decisions = 0;
    for (const InspectedPhase& pass : phased.phases())
        decisions += pass.decisions.size();
    QCOMPARE(decisions, last->snapshot->report.decisions.size());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DecisionsModelTest)
#include "decisions_model_test.moc"
