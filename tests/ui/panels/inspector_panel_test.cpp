// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/inspector_panel.h"

#include <QClipboard>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/panels/decision_tree.h"
#include "ui/theme/theme.h"

namespace planewright {

class InspectorPanelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(Theme::Light); }
    void withoutAStepItSaysWhatToDo();
    void theHeaderTellsTheNumbersOfTheStep();
    void aStepThatTakesTooLongIsMarked();
    void theLastPassHasItsPasses();
    void choosingARowTellsItsOperands();
    void openPhasesStayOpenFromStepToStep();
    void rowsAreActivatedWithTheKeyboard();
    void aClickOnAParameterAsksForIt();
    void rowsAreCopiedWithTheKeyboard();
    void thePhaseInTheViewIsInSight();
    void thousandsOfRowsAreShownAtOnce();
    void buttonsAskForWhatTheySay();

private:
    /// Shown, active, and with the keyboard in the tree.
    static void show(InspectorPanel& panel);
};

namespace {

using Kind = DecisionKind;

/// Step 69 of files: the fit and the split of the screen's step 70 are due, and its last phase.
InspectedStep step69(int assigned = 2)
{
    auto snapshot = std::make_shared<Snapshot>();
    StepReport& report = snapshot->report;
    report.step = 69;
    report.tilt = 1.4312;  // 82.0°
    report.counts = {689, 12, 9, 3, 812, 62, 11, 9, 1, 0, 0.934};
    report.times[static_cast<std::size_t>(Phase::Extract)] = std::chrono::microseconds{700};
    report.times[static_cast<std::size_t>(Phase::Fit)] = std::chrono::microseconds{2500};
    for (int i = 0; i < assigned; ++i)
        report.decisions.push_back(
            {Phase::Assign,
             Kind::Assign,
             {SegmentId{69, i}, PlaneRef{12}},
             {{"plane_distance", 0.012, Comparison::Less, 0.05}, {"orthogonality", 0.03, Comparison::Less, 0.1}},
             {PlaneRef{12}}});
    report.decisions.push_back(
        {Phase::Fit, Kind::NoFit, {ClusterRef{4}}, {{"cluster_segments", 4.0, Comparison::GreaterEqual, 5.0}}, {}});
    report.decisions.push_back({Phase::SplitMerge,
                                Kind::Split,
                                {PlaneRef{7}},
                                {{"fitting_error", 4.31, Comparison::Greater, 4.0}},
                                {PlaneRef{7}, PlaneRef{16}}});
    InspectedStep step;
    step.snapshot = std::move(snapshot);
    step.time = std::chrono::milliseconds{1725};
    step.newest = 100;
    step.planned = 137;
    return step;
}

QModelIndex rowOf(const InspectorPanel& panel, Phase phase, int decision = -1, int test = -1)
{
    const DecisionsModel& model = panel.model();
    for (int row = 0; row < model.rowCount(); ++row) {
        if (model.phases()[static_cast<std::size_t>(row)].phase != phase)
            continue;
        QModelIndex index = model.index(row, 0);
        if (decision >= 0)
            index = model.index(decision, 0, index);
        return test < 0 ? index : model.index(test, 0, index);
    }
    return {};
}

}  // namespace

void InspectorPanelTest::show(InspectorPanel& panel)
{
    panel.resize(420, 600);
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    panel.tree()->setFocus();
}

void InspectorPanelTest::withoutAStepItSaysWhatToDo()
{
    InspectorPanel panel;

    QCOMPARE(panel.shownInstead(), QStringLiteral("Choose a step in the timeline."));
    QVERIFY(!panel.findChild<QPushButton*>("playPhase")->isEnabled());
    panel.setStep(step69());
    QVERIFY(panel.shownInstead().isEmpty());
    QVERIFY(panel.findChild<QPushButton*>("playPhase")->isEnabled());
    panel.setStep(std::nullopt);
    QVERIFY(!panel.shownInstead().isEmpty());
}

void InspectorPanelTest::theHeaderTellsTheNumbersOfTheStep()
{
    InspectorPanel panel;
    panel.setStep(step69());

    QCOMPARE(panel.header().split('\n'),
             (QStringList{"Step 70 of 137   φ 82.0°   1.73 s   3.2 of 25 ms",
                          "689 returns, 12 segments: 9 assigned, 3 clustered",
                          "So far 874 segments: 812 fitted, 62 unfitted; 9 planes, mean E 0.93"}));
}

void InspectorPanelTest::aStepThatTakesTooLongIsMarked()
{
    InspectorPanel panel;
    InspectedStep step = step69();
    auto slow = std::make_shared<Snapshot>(*step.snapshot);
    slow->report.times[static_cast<std::size_t>(Phase::SplitMerge)] = std::chrono::milliseconds{30};
    step.snapshot = std::move(slow);

    panel.setStep(step);

    QVERIFY2(panel.header().contains(QStringLiteral("▲ 33.2 of 25 ms")), qPrintable(panel.header()));
}

void InspectorPanelTest::theLastPassHasItsPasses()
{
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->report.step = -1;
    auto phased = std::make_shared<PhasedStep>();
    phased->phases = {{Phase::Finish, "merge", snapshot}, {Phase::Finish, "refine", snapshot}};
    InspectorPanel panel;
    InspectedStep step;
    step.snapshot = snapshot;
    step.newest = 136;

    panel.setStep(step);
    QCOMPARE(panel.model().rowCount(), 1);
    step.phased = phased;
    panel.setStep(step);

    QVERIFY(panel.header().startsWith(QStringLiteral("Last pass after step 137")));
    QCOMPARE(panel.model().rowCount(), 2);
    QCOMPARE(panel.model().index(1, 0).data().toString(), QStringLiteral("Last fit of all planes  nothing"));
}

void InspectorPanelTest::choosingARowTellsItsOperands()
{
    InspectorPanel panel;
    panel.setStep(step69());
    show(panel);
    std::vector<Operand> told;
    connect(&panel, &InspectorPanel::operandsChosen, this, [&](const auto& operands) { told = operands; });

    panel.tree()->setCurrentIndex(rowOf(panel, Phase::SplitMerge, 0));

    QCOMPARE(told.size(), std::size_t(3));
    QCOMPARE(std::get<PlaneRef>(told[0]).id, 7);
    QCOMPARE(std::get<PlaneRef>(told[2]).id, 16);
    // From there the keyboard goes on, to the condition below too.
    panel.tree()->setCurrentIndex(rowOf(panel, Phase::Fit, 0));
    QCOMPARE(std::get<ClusterRef>(told[0]).id, 4);
    QTest::keyClick(panel.tree(), Qt::Key_Right);
    QTest::keyClick(panel.tree(), Qt::Key_Down);
    QCOMPARE(panel.tree()->currentIndex(), rowOf(panel, Phase::Fit, 0, 0));
}

void InspectorPanelTest::openPhasesStayOpenFromStepToStep()
{
    InspectorPanel panel;
    panel.setStep(step69());
    QVERIFY(panel.tree()->isExpanded(rowOf(panel, Phase::SplitMerge)));
    QVERIFY(!panel.tree()->isExpanded(rowOf(panel, Phase::Assign)));

    panel.tree()->expand(rowOf(panel, Phase::Assign));
    panel.tree()->collapse(rowOf(panel, Phase::SplitMerge));
    panel.setStep(step69(5));

    QVERIFY(!panel.tree()->isExpanded(rowOf(panel, Phase::SplitMerge)));
    QVERIFY(panel.tree()->isExpanded(rowOf(panel, Phase::Assign)));
}

void InspectorPanelTest::rowsAreActivatedWithTheKeyboard()
{
    InspectorPanel panel;
    panel.setStep(step69());
    show(panel);
    QSignalSpy phases(&panel, &InspectorPanel::phaseRequested);
    QSignalSpy parameters(&panel, &InspectorPanel::parameterRequested);

    panel.tree()->setCurrentIndex(rowOf(panel, Phase::Fit));
    QTest::keyClick(panel.tree(), Qt::Key_Return);
    QCOMPARE(phases.count(), 1);
    QCOMPARE(phases[0][0].value<std::size_t>(), std::size_t(3));
    panel.tree()->setCurrentIndex(rowOf(panel, Phase::SplitMerge, 0));
    QTest::keyClick(panel.tree(), Qt::Key_Return);
    QVERIFY(panel.tree()->isExpanded(rowOf(panel, Phase::SplitMerge, 0)));
    panel.tree()->setCurrentIndex(rowOf(panel, Phase::SplitMerge, 0, 0));
    QTest::keyClick(panel.tree(), Qt::Key_Return);

    QCOMPARE(parameters.count(), 1);
    QCOMPARE(parameters[0][0].toString(), QStringLiteral("planes.error-limit"));
}

void InspectorPanelTest::aClickOnAParameterAsksForIt()
{
    InspectorPanel panel;
    panel.setStep(step69());
    show(panel);
    panel.tree()->expand(rowOf(panel, Phase::SplitMerge, 0));
    const QModelIndex test = rowOf(panel, Phase::SplitMerge, 0, 0);
    panel.tree()->scrollTo(test);
    QSignalSpy parameters(&panel, &InspectorPanel::parameterRequested);
    const QRect row = panel.tree()->visualRect(test);
    const QFontMetrics metrics(panel.tree()->font());

    // On the numbers nothing is asked, on the parameter's name behind them it is.
    QTest::mouseClick(panel.tree()->viewport(), Qt::LeftButton, {}, {row.left() + 8, row.center().y()});
    QVERIFY(parameters.isEmpty());
    const int link = row.left() + metrics.horizontalAdvance(QStringLiteral("E 4.31 > 4.00 ✔  Error")) + 4;
    QTest::mouseClick(panel.tree()->viewport(), Qt::LeftButton, {}, {link, row.center().y()});

    QCOMPARE(parameters.count(), 1);
    QCOMPARE(parameters[0][0].toString(), QStringLiteral("planes.error-limit"));
}

void InspectorPanelTest::rowsAreCopiedWithTheKeyboard()
{
    InspectorPanel panel;
    panel.setStep(step69());
    show(panel);
    panel.tree()->setCurrentIndex(rowOf(panel, Phase::SplitMerge, 0));

    QTest::keyClick(panel.tree(), Qt::Key_C, Qt::ControlModifier);

    QCOMPARE(QGuiApplication::clipboard()->text(),
             QStringLiteral("Step\tPhase\tDecision\tCondition\tValue\tComparison\tLimit\tUnit\tHolds\n"
                            "70\tSplit and merge\tSplit P07 → P07, P16\tE\t4.31\t>\t4.00\t\tyes\n"));
}

void InspectorPanelTest::thePhaseInTheViewIsInSight()
{
    InspectorPanel panel;
    panel.setStep(step69(300));
    show(panel);

    panel.setShownPhase(1);

    const QModelIndex assign = rowOf(panel, Phase::Assign);
    QVERIFY(panel.tree()->isExpanded(assign));
    QVERIFY(assign.data().toString().startsWith(QStringLiteral("▶ ")));
    QVERIFY(panel.tree()->viewport()->rect().contains(panel.tree()->visualRect(assign).center()));
    panel.setShownPhase(std::nullopt);
    QVERIFY(!assign.data().toString().startsWith(QStringLiteral("▶ ")));
}

void InspectorPanelTest::thousandsOfRowsAreShownAtOnce()
{
    constexpr int kRows = 5000;
    InspectorPanel panel;
    panel.setStep(step69());
    show(panel);
    panel.tree()->expand(rowOf(panel, Phase::Assign));
    QElapsedTimer timer;
    timer.start();

    panel.setStep(step69(kRows));
    panel.tree()->grab();

    // Words are made for the rows in view alone: all of them would take seconds.
    QVERIFY2(timer.elapsed() < 500, qPrintable(QString::number(timer.elapsed())));
    QCOMPARE(panel.model().rowCount(rowOf(panel, Phase::Assign)), kRows);
}

void InspectorPanelTest::buttonsAskForWhatTheySay()
{
    InspectorPanel panel;
    panel.setStep(step69());
    show(panel);
    QSignalSpy plays(&panel, &InspectorPanel::playPhaseRequested);
    QSignalSpy asks(&panel, &InspectorPanel::whyNotRequested);

    QTest::keyClick(panel.findChild<QPushButton*>("playPhase"), Qt::Key_Space);
    QTest::keyClick(panel.findChild<QPushButton*>("whyNotButton"), Qt::Key_Space);

    QCOMPARE(plays.count(), 1);
    QCOMPARE(asks.count(), 1);
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::InspectorPanelTest)
#include "inspector_panel_test.moc"
