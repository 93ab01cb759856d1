// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <utility>

#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QtTest>

#include "app/window/script_runner.h"
#include "app/window/waiting.h"
#include "tests/app/window/shown_window.h"
#include "tests/test_program.h"
#include "ui/panels/decision_tree.h"

namespace planewright {

/// Step inspector, why not and lineage in the window, with a scan of the corridor.
class InspectorWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void itIsInTheInspectLayoutAndFits();
    void withoutAScanItSaysWhatToDo();
    void itTellsOfTheStepAtThePlayhead();
    void aScriptGoesOnWhenTheStepIsTold();
    void nothingIsWorkedOutWhileItIsHidden();
    void aRowSelectsItsOperands();
    void aDiscardedPieceIsShown();
    void aParameterIsShownInSetup();
    void phasesArePlayedOneByOne();
    void whyNotTakesTheSelection();
    void whyNotOfASegmentAndAPlane();
    void whyNotIsAskedAgainAtAnotherStep();
    void theRunThatReplacesAnotherIsTold();
    void theSelectionFollowsAPlaneThroughTime();
    void theGraphLeadsToItsSteps();
    void itFollowsAScanThatRuns();

private:
    InspectorPanel& inspector() { return shown_->controllers->inspector.inspector(); }
    WhyNotPanel& whyNot() { return shown_->controllers->inspector.whyNotPanel(); }
    LineagePanel& lineage() { return shown_->controllers->lineage.panel(); }
    QTabWidget& tabs() { return shown_->controllers->inspector.tabs(); }

    void scanAndInspect();
    /// The same in a room where planes merge.
    void scanOffice();
    /// Goes to a place and waits until the window shows it; false if it does not.
    bool goTo(int place);
    bool settle();
    /// The first event of a kind, with its plane.
    std::pair<PlaneId, LifeEvent> firstOf(LifeEventKind kind);

    QTemporaryDir folder_;
    std::unique_ptr<ShownWindow> shown_;
    WindowParts* parts_ = nullptr;
};

void InspectorWindowTest::initTestCase()
{
    useFixedLook();
}

void InspectorWindowTest::init()
{
    auto shown = ShownWindow::open(folder_.filePath("settings.ini"));
    QVERIFY2(shown, shown ? "" : shown.error().message.c_str());
    shown_ = std::move(*shown);
    parts_ = &shown_->parts;
}

void InspectorWindowTest::cleanup()
{
    shown_.reset();
    QFile::remove(folder_.filePath("settings.ini"));
}

void InspectorWindowTest::scanAndInspect()
{
    shown_->action("actLayoutInspect")->trigger();
    QVERIFY(shown_->scanCorridor());
}

void InspectorWindowTest::scanOffice()
{
    shown_->action("actLayoutInspect")->trigger();
    shown_->controllers->scan.open(QStringLiteral("sim:office?seed=7&speed=0"), true);
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));
    QVERIFY(settle());
}

bool InspectorWindowTest::settle()
{
    return waitForRest(*parts_, kPatience).has_value();
}

bool InspectorWindowTest::goTo(int place)
{
    parts_->playhead.goTo(place);
    const auto snapshot = parts_->playhead.snapshot();
    return settle() && waitUntil([&] { return parts_->shown->snapshot == snapshot; }, kPatience);
}

std::pair<PlaneId, LifeEvent> InspectorWindowTest::firstOf(LifeEventKind kind)
{
    for (const auto& [plane, life] : parts_->session.planeLives().lives()) {
        for (const LifeEvent& event : life.events) {
            if (event.kind == kind && event.step > 0)
                return {plane, event};
        }
    }
    qFatal("there is no such event");
}

void InspectorWindowTest::itIsInTheInspectLayoutAndFits()
{
    const auto* dock = parts_->window->findChild<QDockWidget*>("dockInspector");
    shown_->action("actLayoutOperate")->trigger();
    QVERIFY(!dock->isVisible());

    shown_->action("actLayoutInspect")->trigger();
    parts_->window->resize(1024, 700);
    QTest::qWait(300);

    QVERIFY(dock->isVisible());
    QCOMPARE(parts_->window->size(), QSize(1024, 700));
    QVERIFY2(dock->height() >= 200, qPrintable(QString::number(dock->height())));
    QVERIFY(parts_->window->rect().contains(QRect(dock->mapTo(parts_->window.get(), QPoint()), dock->size())));
    QVERIFY2(parts_->window->view().width() >= 260, qPrintable(QString::number(parts_->window->view().width())));
    shown_->action("actLayoutOperate")->trigger();
    QVERIFY(!dock->isVisible());
}

void InspectorWindowTest::withoutAScanItSaysWhatToDo()
{
    shown_->action("actLayoutInspect")->trigger();
    QTest::qWait(100);

    QCOMPARE(inspector().shownInstead(), QStringLiteral("Choose a step in the timeline."));
    shown_->action("actWhyNot")->trigger();
    QCOMPARE(whyNot().sentence(), QStringLiteral("Choose a step in the timeline."));
}

void InspectorWindowTest::itTellsOfTheStepAtThePlayhead()
{
    scanAndInspect();
    QVERIFY(goTo(69));
    QVERIFY(waitUntil([&] { return inspector().header().startsWith("Step 70 of"); }, kPatience));

    const DecisionsModel& model = inspector().model();
    const StepCounts& counts = parts_->playhead.snapshot()->report.counts;
    QVERIFY(waitUntil([&] { return model.step()->phased != nullptr; }, kPatience));
    QCOMPARE(model.rowCount(), 6);
    QCOMPARE(model.rowCount(model.index(1, 0)) - counts.clustered, counts.assigned);
    QVERIFY(inspector().header().contains(QStringLiteral("%1 segments: %2 assigned, %3 clustered")
                                              .arg(counts.segments)
                                              .arg(counts.assigned)
                                              .arg(counts.clustered)));
    // The forced last pass has its own passes.
    QVERIFY(goTo(static_cast<int>(parts_->playhead.history().size()) - 1));
    QVERIFY(waitUntil([&] { return inspector().header().startsWith("Last pass"); }, kPatience));
    QVERIFY(waitUntil([&] { return model.rowCount() > 3; }, kPatience));
}

void InspectorWindowTest::aScriptGoesOnWhenTheStepIsTold()
{
    scanAndInspect();
    QFile script(folder_.filePath("goto.ndjson"));
    QVERIFY(script.open(QIODevice::WriteOnly));
    script.write(R"({"do":"goto","step":69})");
    script.close();
    ScriptRunner runner(*parts_, shown_->controllers->scan);

    QVERIFY(runner.run(script.fileName()));

    QVERIFY2(inspector().header().startsWith("Step 70 of"), qPrintable(inspector().header()));
    QVERIFY(inspector().model().step()->phased != nullptr);
}

void InspectorWindowTest::nothingIsWorkedOutWhileItIsHidden()
{
    shown_->action("actLayoutOperate")->trigger();
    QVERIFY(shown_->scanCorridor());
    QVERIFY(goTo(20));
    QTest::qWait(500);
    QVERIFY(!inspector().model().step());

    shown_->action("actLayoutInspect")->trigger();

    QVERIFY(waitUntil([&] { return inspector().header().startsWith("Step 21 of"); }, kPatience));
}

void InspectorWindowTest::aRowSelectsItsOperands()
{
    scanOffice();
    const Playhead::History& history = parts_->playhead.history();
    const auto decides = [&](int place, DecisionKind kind) {
        const auto& decisions = history[static_cast<std::size_t>(place)]->report.decisions;
        return std::any_of(decisions.begin(), decisions.end(),
                           [kind](const Decision& decision) { return decision.kind == kind; });
    };
    int place = 20;
    while (!decides(place, DecisionKind::Cluster) || !decides(place, DecisionKind::Assign))
        ++place;
    QVERIFY(goTo(place));
    const DecisionsModel& model = inspector().model();
    QVERIFY(waitUntil(
        [&] { return model.step() && model.step()->snapshot == parts_->playhead.snapshot() && model.step()->phased; },
        kPatience));
    int assignments = 0;
    int clusters = 0;
    for (int phase = 0; phase < model.rowCount(); ++phase) {
        const QModelIndex above = model.index(phase, 0);
        for (int row = 0; row < model.rowCount(above); ++row) {
            const QModelIndex index = model.index(row, 0, above);
            const Decision decision = *model.decisionAt(index);
            inspector().tree()->setCurrentIndex(index);
            if (decision.kind == DecisionKind::Assign) {
                QVERIFY(parts_->selection.segments() ==
                        std::set<SegmentId>{std::get<SegmentId>(decision.operands.front())});
                QVERIFY(parts_->selection.planes() == std::set<PlaneId>{std::get<PlaneRef>(decision.result[0]).id});
                ++assignments;
            } else if (decision.kind == DecisionKind::Cluster) {
                const auto segments =
                    segmentsOfCluster(std::get<ClusterRef>(decision.result[0]).id,
                                      history[static_cast<std::size_t>(place) - 1].get(), *parts_->playhead.snapshot());
                QVERIFY(parts_->selection.segments() == std::set<SegmentId>(segments.begin(), segments.end()));
                QVERIFY(parts_->selection.segments().contains(std::get<SegmentId>(decision.operands[0])));
                ++clusters;
            }
        }
    }
    QVERIFY(assignments > 0);
    QVERIFY(clusters > 0);
}

void InspectorWindowTest::aDiscardedPieceIsShown()
{
    scanOffice();
    const Playhead::History& history = parts_->playhead.history();
    const auto pieceIn = [](const Decision& decision) {
        return decision.operands.empty() ? nullptr : std::get_if<PieceRef>(&decision.operands.front());
    };
    int place = 20;
    while (place < static_cast<int>(history.size()) &&
           std::none_of(history[static_cast<std::size_t>(place)]->report.decisions.begin(),
                        history[static_cast<std::size_t>(place)]->report.decisions.end(), pieceIn))
        ++place;
    QVERIFY(goTo(place));
    const DecisionsModel& model = inspector().model();
    QVERIFY(waitUntil(
        [&] { return model.step() && model.step()->snapshot == parts_->playhead.snapshot() && model.step()->phased; },
        kPatience));
    const QModelIndex extract = model.index(0, 0);
    int row = 0;
    while (row < model.rowCount(extract) && pieceIn(*model.decisionAt(model.index(row, 0, extract))) == nullptr)
        ++row;
    QVERIFY(row < model.rowCount(extract));
    const PieceRef piece = *pieceIn(*model.decisionAt(model.index(row, 0, extract)));
    parts_->selection.select({0});

    inspector().tree()->setCurrentIndex(model.index(row, 0, extract));

    QVERIFY(parts_->selection.planes().empty());
    QVERIFY(parts_->selection.pieces() == (std::set<BeamRun>{{piece.step, piece.firstBeam, piece.lastBeam}}));
    QVERIFY(parts_->window->view().scene().selection().pieces == parts_->selection.pieces());
    const auto points = pointsOf(*parts_->selection.pieces().begin(), *parts_->shown);
    QVERIFY(!points.empty());
    QVERIFY(parts_->window->view().scene().selectedBounds().contains(points.front()));
    const QString said = parts_->window->findChild<QLabel*>("stMessage")->text();
    QVERIFY2(said.startsWith(QStringLiteral("Step %1: beam").arg(place + 1)), qPrintable(said));
    // Without the slice there is nothing to be shown.
    QVERIFY(goTo(place - 1));
    QVERIFY(parts_->selection.isEmpty());
}

void InspectorWindowTest::aParameterIsShownInSetup()
{
    scanAndInspect();

    emit inspector().parameterRequested(QStringLiteral("planes.error-limit"));

    QVERIFY(parts_->parametersPanel->isVisible());
}

void InspectorWindowTest::phasesArePlayedOneByOne()
{
    scanAndInspect();
    QVERIFY(goTo(68));
    QTest::qWait(200);

    inspector().findChild<QPushButton*>("playPhase")->click();
    QCOMPARE(parts_->playhead.place(), 69);
    QCOMPARE(parts_->playhead.phase(), std::optional<std::size_t>(0));
    inspector().findChild<QPushButton*>("playPhase")->click();
    QCOMPARE(parts_->playhead.phase(), std::optional<std::size_t>(1));

    QVERIFY(waitUntil([&] { return inspector().model().step()->snapshot->report.step == 69; }, kPatience));
    QVERIFY(inspector().model().index(1, 0).data().toString().startsWith(QStringLiteral("▶ Assign")));
    emit inspector().phaseRequested(3);
    QVERIFY(waitUntil([&] { return parts_->shownPhase && parts_->shown->snapshot == parts_->shownPhase; }, kPatience));
    QCOMPARE(parts_->playhead.phase(), std::optional<std::size_t>(3));
    QVERIFY(inspector().model().index(3, 0).data().toString().startsWith(QStringLiteral("▶ Fit")));
}

void InspectorWindowTest::whyNotTakesTheSelection()
{
    QVERIFY(shown_->scanCorridor());
    QVERIFY(goTo(80));
    const auto& planes = parts_->playhead.snapshot()->planes;
    const PlaneId first = planes[0]->id;
    const PlaneId second = planes[1]->id;
    parts_->selection.select({first, second});

    shown_->action("actWhyNot")->trigger();

    QVERIFY(whyNot().isVisible());
    QCOMPARE(tabs().currentWidget(), &whyNot());
    const auto expected = parts_->session.whyNot(80, PlaneRef{first}, PlaneRef{second});
    const auto& answer = whyNot().model().answer();
    QVERIFY(expected && answer);
    QCOMPARE(answer->ways.size(), expected->ways.size());
    bool failed = false;
    for (std::size_t way = 0; way < expected->ways.size(); ++way) {
        QCOMPARE(answer->ways[way].tests.size(), expected->ways[way].tests.size());
        for (std::size_t i = 0; i < expected->ways[way].tests.size(); ++i)
            QCOMPARE(answer->ways[way].tests[i].value, expected->ways[way].tests[i].value);
        failed = failed || !expected->ways[way].pass();
    }
    QVERIFY(failed);
    QVERIFY(whyNot().sentence().startsWith(QStringLiteral("Step 81: ")));
}

void InspectorWindowTest::whyNotOfASegmentAndAPlane()
{
    QVERIFY(shown_->scanCorridor());
    QVERIFY(goTo(80));
    const auto& planes = parts_->playhead.snapshot()->planes;
    const SegmentId segment = planes[0]->segments.front();
    parts_->selection.select({planes[0]->id}, {segment});
    shown_->action("actWhyNot")->trigger();
    QVERIFY(whyNot().model().answer());
    QVERIFY(whyNot().model().answer()->together);
    QVERIFY2(whyNot().sentence().contains(QStringLiteral(" is in ")), qPrintable(whyNot().sentence()));

    parts_->selection.select({planes[1]->id}, {segment});
    shown_->action("actWhyNot")->trigger();

    QVERIFY(whyNot().model().answer());
    QVERIFY(!whyNot().model().answer()->together);
    const auto& ways = whyNot().model().answer()->ways;
    QVERIFY(std::any_of(ways.begin(), ways.end(), [](const Conditions& way) { return !way.pass(); }));
    // Not a pair: two segments, or one plane twice.
    whyNot().setOperands(segment, segment);
    emit whyNot().asked();
    QVERIFY(whyNot().sentence().contains(QStringLiteral("Choose two planes")));
    QVERIFY(!whyNot().model().answer());
}

void InspectorWindowTest::whyNotIsAskedAgainAtAnotherStep()
{
    QVERIFY(shown_->scanCorridor());
    QVERIFY(goTo(80));
    const auto& planes = parts_->playhead.snapshot()->planes;
    parts_->selection.select({planes[0]->id, planes[1]->id});
    shown_->action("actWhyNot")->trigger();
    QVERIFY(whyNot().model().answer());

    QVERIFY(goTo(70));
    QVERIFY(waitUntil([&] { return whyNot().sentence().startsWith("Step 71: "); }, kPatience));
    QVERIFY(goTo(0));

    QVERIFY(waitUntil([&] { return whyNot().sentence().startsWith("There is no P"); }, kPatience));
    QVERIFY(whyNot().sentence().contains(QStringLiteral("at step 1.")));
}

void InspectorWindowTest::theRunThatReplacesAnotherIsTold()
{
    scanAndInspect();
    QVERIFY(waitUntil([&] { return inspector().header().startsWith("Last pass"); }, kPatience));
    const auto& planes = parts_->playhead.snapshot()->planes;
    const PlaneRef first{planes[0]->id};
    const PlaneRef second{planes[1]->id};
    parts_->selection.select({first.id, second.id});
    shown_->action("actWhyNot")->trigger();
    const double before = whyNot().model().answer()->ways[0].tests[0].value;
    const int fittedBefore = parts_->playhead.snapshot()->report.counts.fitted;
    const std::size_t steps = parts_->playhead.history().size();
    Parameters parameters = parts_->session.parameters();
    const double gate = std::exchange(parameters.likelihood.joinGate, 6.0);

    QVERIFY(parts_->session.setParameters(parameters));
    shown_->action("actRerun")->trigger();
    QVERIFY(waitUntil([&] { return parts_->playhead.snapshot()->report.counts.fitted != fittedBefore; }, kPatience));
    QVERIFY(settle());

    QCOMPARE(parts_->playhead.history().size(), steps);
    const auto snapshot = parts_->playhead.snapshot();
    QVERIFY(waitUntil([&] { return whyNot().model().answer()->ways[0].tests[0].value != before; }, kPatience));
    const auto expected = parts_->session.whyNot(-1, first, second);
    QVERIFY(expected);
    QCOMPARE(whyNot().model().answer()->ways[0].tests[0].value, expected->ways[0].tests[0].value);
    tabs().setCurrentWidget(&inspector());
    const StepCounts& counts = snapshot->report.counts;
    const QString numbers = QStringLiteral("So far %1 segments: %2 fitted, %3 unfitted; %4 planes")
                                .arg(counts.fitted + counts.unfitted)
                                .arg(counts.fitted)
                                .arg(counts.unfitted)
                                .arg(counts.planes);
    QVERIFY2(inspector().header().contains(numbers), qPrintable(inspector().header()));
    // The same while the inspector is in front.
    parameters.likelihood.joinGate = gate;
    QVERIFY(parts_->session.setParameters(parameters));
    shown_->action("actRerun")->trigger();
    QVERIFY(waitUntil([&] { return parts_->playhead.snapshot() != snapshot; }, kPatience));
    QVERIFY(waitUntil([&] { return inspector().model().step()->snapshot == parts_->playhead.snapshot(); }, kPatience));
    QCOMPARE(parts_->playhead.snapshot()->report.counts.fitted, fittedBefore);
    QVERIFY(inspector().header().contains(QStringLiteral("%1 fitted").arg(fittedBefore)));
}

void InspectorWindowTest::theSelectionFollowsAPlaneThroughTime()
{
    scanOffice();
    const auto [gone, merger] = firstOf(LifeEventKind::MergedInto);
    const int place = parts_->playhead.placeOf(merger.step);
    QVERIFY(goTo(place - 1));
    parts_->selection.select({gone});

    QVERIFY(goTo(place));
    QVERIFY(parts_->selection.planes() == std::set<PlaneId>{merger.others.front()});
    QVERIFY(goTo(place - 1));
    QVERIFY(parts_->selection.planes() == std::set<PlaneId>{gone});
    // As far as it goes, and back: nothing of what was chosen is lost on the way.
    QVERIFY(goTo(0));
    QVERIFY(goTo(static_cast<int>(parts_->playhead.history().size()) - 1));
    const auto kept = parts_->session.planeLives().follow(gone, merger.step - 1, -1);
    QVERIFY(parts_->selection.planes() == std::set<PlaneId>(kept.begin(), kept.end()));
    QVERIFY(goTo(place - 1));
    QVERIFY(parts_->selection.planes() == std::set<PlaneId>{gone});
    shown_->action("actSelectNone")->trigger();
    QVERIFY(goTo(place));
    QVERIFY(parts_->selection.isEmpty());
}

void InspectorWindowTest::theGraphLeadsToItsSteps()
{
    scanOffice();
    tabs().setCurrentWidget(&lineage());
    QVERIFY(!lineage().shownInstead().isEmpty());
    const auto [gone, merger] = firstOf(LifeEventKind::MergedInto);
    const PlaneId kept = merger.others.front();
    QVERIFY(goTo(parts_->playhead.placeOf(merger.step)));
    parts_->selection.select({kept});
    QVERIFY(lineage().shownInstead().isEmpty());
    const LineageChart& chart = lineage().view()->chart();
    const std::vector<PlaneId> family = parts_->session.planeLives().familyOf(kept);
    QCOMPARE(chart.bars.size(), family.size());
    QVERIFY(std::find(family.begin(), family.end(), gone) != family.end());

    lineage().view()->setFocus();
    QTest::keyClick(lineage().view(), Qt::Key_Home);
    QVERIFY(settle());

    const FamilyEvent birth = chart.events.front();
    QVERIFY(waitUntil([&] { return parts_->shown->step == birth.step; }, kPatience));
    QCOMPARE(parts_->playhead.place(), parts_->playhead.placeOf(birth.step));
    QVERIFY(parts_->selection.planes() == std::set<PlaneId>{birth.plane});
    // Where a plane ends, what became of it is selected.
    emit lineage().planeChosen(gone, merger.step);
    QVERIFY(waitUntil([this, step = merger.step] { return parts_->shown->step == step; }, kPatience));
    QVERIFY(parts_->selection.planes() == std::set<PlaneId>{kept});
}

void InspectorWindowTest::itFollowsAScanThatRuns()
{
    shown_->action("actLayoutInspect")->trigger();
    shown_->controllers->scan.open(QStringLiteral("sim:corridor?seed=7&speed=1"), true);

    std::set<int> seen;
    QVERIFY(waitUntil(
        [&] {
            const auto& step = inspector().model().step();
            if (step && parts_->session.state() == SessionState::Scanning)
                seen.insert(step->snapshot->report.step);
            return seen.size() >= 3;
        },
        kPatience));
    QVERIFY(parts_->playhead.followsNewest());
    QVERIFY(parts_->session.finish());
    QVERIFY(settle());
    QVERIFY(waitUntil([&] { return inspector().header().startsWith("Last pass"); }, kPatience));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::InspectorWindowTest)
#include "inspector_window_test.moc"
