// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QtTest>

#include "app/window/waiting.h"
#include "core/params/registry.h"
#include "tests/app/window/shown_window.h"
#include "tests/test_program.h"
#include "tests/ui/view3d/reference_image.h"
#include "ui/panels/filtered_table.h"

namespace planewright {

/// A scan and its second extraction, side by side in the window.
class CompareWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void anExtractionWithItsOwnParametersIsTheSame();
    void theOtherMethodIsShownBesideIt();
    void theLayoutComparesWithAnotherMethod();
    void bothShowTheStepThatIsLookedAt();
    void bothShowThePhaseThatIsLookedAt();
    void bothHaveOneCamera();
    void bothShowTheSamePlaceUnasked();
    void theClipBoxIsOfBothAndItsFieldsComeIntoSight();
    void partnersAreChosenTogether();
    void closingTakesTheSecondViewAway();
    void anotherScanEndsTheComparison();
    void movingAveragesAreAnExample();

private:
    ComparePanel& panel() { return *parts_->window->findChild<ComparePanel*>(QStringLiteral("comparePanel")); }
    const ScanBranch* branch() { return shown_->controllers->compare.branch(); }
    const CompareModel& model() { return static_cast<const CompareModel&>(*panel().table()->rows()->sourceModel()); }
    /// Scans the corridor and compares it with a choice by its name.
    void compareWith(const QString& name);
    bool settle() { return waitForRest(*parts_, kPatience).has_value(); }

    QTemporaryDir folder_;
    std::unique_ptr<ShownWindow> shown_;
    WindowParts* parts_ = nullptr;
};

void CompareWindowTest::initTestCase()
{
    useFixedLook();
}

void CompareWindowTest::init()
{
    auto shown = ShownWindow::open(folder_.filePath(QStringLiteral("window.ini")));
    QVERIFY2(shown, shown ? "" : shown.error().message.c_str());
    shown_ = std::move(*shown);
    parts_ = &shown_->parts;
}

void CompareWindowTest::cleanup()
{
    shown_.reset();
}

void CompareWindowTest::compareWith(const QString& name)
{
    QVERIFY(shown_->scanCorridor());
    shown_->action("actCompare")->trigger();
    auto* choice = panel().findChild<QComboBox*>(QStringLiteral("compareWith"));
    QVERIFY(choice->findText(name) >= 0);
    choice->setCurrentText(name);
    QTest::mouseClick(panel().findChild<QPushButton*>(QStringLiteral("compareRun")), Qt::LeftButton);
    QVERIFY(settle());
    QVERIFY(branch() != nullptr);
    QVERIFY(branch()->isFinished());
}

void CompareWindowTest::anExtractionWithItsOwnParametersIsTheSame()
{
    compareWith(QStringLiteral("parameters as set"));

    QCOMPARE(model().rowCount(), static_cast<int>(parts_->shown->snapshot->planes.size()));
    for (const PairedPlanes& pair : model().comparison().pairs) {
        QCOMPARE(pair.a, pair.b);
        QCOMPARE(pair.overlap, 1.0);
        QCOMPARE(pair.difference.angle, 0.0);
        QCOMPARE(pair.difference.distance, 0.0);
    }
}

void CompareWindowTest::theOtherMethodIsShownBesideIt()
{
    compareWith(QStringLiteral("paper"));

    QVERIFY(parts_->window->showsSecondView());
    QVERIFY(std::abs(parts_->window->view().width() - parts_->window->secondView().width()) < 40);
    QCOMPARE(printParameter(branch()->parameters(), "method.estimator"), std::string("end-points"));
    const std::size_t planes = branch()->history().newest()->snapshot->planes.size();
    QCOMPARE(model().comparison().pairs.size() + model().comparison().onlyB.size(), planes);
    QVERIFY(model().comparison().pairs.size() >= 4);  // floor, ceiling and the long walls at least
    const QString totals = panel().findChild<QLabel*>(QStringLiteral("compareTotals"))->text();
    QVERIFY(totals.contains(QStringLiteral(">%1</td>").arg(planes)));
    const QImage picture = parts_->window->secondView().picture({400, 300}, 1.0);
    QVERIFY(coloursOf(picture, kFewestColours) >= kFewestColours);
}

void CompareWindowTest::theLayoutComparesWithAnotherMethod()
{
    QVERIFY(shown_->scanCorridor());

    shown_->action("actLayoutCompare")->trigger();
    QVERIFY(settle());

    QVERIFY(branch() != nullptr);
    QCOMPARE(panel().findChild<QComboBox*>(QStringLiteral("compareWith"))->currentText(), QStringLiteral("paper"));
    QVERIFY(branch()->parameters().method.estimator != parts_->session.parameters().method.estimator);
}

void CompareWindowTest::bothShowTheStepThatIsLookedAt()
{
    compareWith(QStringLiteral("paper"));

    parts_->playhead.goTo(40);
    QVERIFY(settle());

    QCOMPARE(parts_->shown->snapshot->report.step, 40);
    const auto expected = branch()->history().after(41)->snapshot;
    QCOMPARE(expected->report.step, 40);
    QCOMPARE(model().comparison().pairs.size() + model().comparison().onlyB.size(), expected->planes.size());
    parts_->playhead.follow();
    QVERIFY(settle());
    QCOMPARE(model().comparison().pairs.size() + model().comparison().onlyB.size(),
             branch()->history().newest()->snapshot->planes.size());
}

void CompareWindowTest::bothShowThePhaseThatIsLookedAt()
{
    compareWith(QStringLiteral("paper"));
    const auto planesOfB = [this] { return model().comparison().pairs.size() + model().comparison().onlyB.size(); };
    const auto facts = [this] { return parts_->window->secondView().overlay().facts.join(QStringLiteral("; ")); };
    // Step 35 from 1 is one at which both fit, split and merge.
    parts_->playhead.goTo(34);
    QVERIFY(settle());
    const auto expected = const_cast<ScanBranch*>(branch())->history().explained(34);
    QVERIFY(expected);
    QCOMPARE((*expected)->phases.size(), std::size_t(6));

    for (std::size_t phase = 0; phase < 6; ++phase) {
        parts_->playhead.showPhase(phase);
        QVERIFY(settle());

        QCOMPARE(parts_->shown->snapshot, parts_->shownPhase);
        QCOMPARE(planesOfB(), (*expected)->phases[phase].snapshot->planes.size());
        QVERIFY2(facts().contains(QStringLiteral("after ")), qPrintable(facts()));
    }

    // The passes of the other method are others.
    parts_->playhead.follow();
    QVERIFY(settle());
    const auto last = parts_->session.explained(-1);
    QVERIFY(last);
    parts_->playhead.showPhase(1);
    QCOMPARE((*last)->phases[1].pass, std::string_view("split"));
    QVERIFY(settle());
    QCOMPARE(planesOfB(), branch()->history().newest()->snapshot->planes.size());
    QVERIFY2(facts().contains(QStringLiteral("at its end")), qPrintable(facts()));
}

void CompareWindowTest::bothHaveOneCamera()
{
    compareWith(QStringLiteral("paper"));
    View3d& first = parts_->window->view();
    View3d& second = parts_->window->secondView();

    first.showNamed(NamedView::Top);
    QCOMPARE(second.camera(), first.camera());
    const ViewCamera before = first.camera();
    QTest::mousePress(&second, Qt::LeftButton, {}, QPoint(100, 100));
    QTest::mouseMove(&second, QPoint(160, 130));
    QTest::mouseRelease(&second, Qt::LeftButton, {}, QPoint(160, 130));

    QVERIFY(first.camera() != before);
    QCOMPARE(second.camera(), first.camera());
}

void CompareWindowTest::partnersAreChosenTogether()
{
    compareWith(QStringLiteral("paper"));
    const PairedPlanes pair = model().comparison().pairs.front();

    parts_->selection.select({pair.a});
    QCOMPARE(parts_->window->secondView().scene().selection().planes, std::set<PlaneId>{pair.b});

    parts_->selection.clear();
    panel().table()->choose({model().rowOfB(pair.b)});
    QCOMPARE(parts_->selection.planes(), std::set<PlaneId>{pair.a});
    QCOMPARE(parts_->window->secondView().scene().selection().planes, std::set<PlaneId>{pair.b});
}

void CompareWindowTest::closingTakesTheSecondViewAway()
{
    compareWith(QStringLiteral("paper"));

    QTest::mouseClick(panel().findChild<QPushButton*>(QStringLiteral("compareClose")), Qt::LeftButton);

    QVERIFY(!parts_->window->showsSecondView());
    QVERIFY(branch() == nullptr);
    QCOMPARE(model().rowCount(), 0);
}

void CompareWindowTest::anotherScanEndsTheComparison()
{
    compareWith(QStringLiteral("paper"));

    QVERIFY(shown_->scanCorridor());

    QVERIFY(branch() == nullptr);
    QVERIFY(!parts_->window->showsSecondView());
}

void CompareWindowTest::movingAveragesAreAnExample()
{
    shown_->action("actMovingAverages")->trigger();
    QVERIFY(waitUntil([this] { return branch() != nullptr && branch()->isFinished(); }, kPatience));
    QVERIFY(settle());

    QCOMPARE(printParameter(*parts_->session.history().back().parameters, "clusters.average"), std::string("sma"));
    QCOMPARE(printParameter(*parts_->session.history().back().parameters, "method.estimator"),
             std::string("end-points"));
    QCOMPARE(printParameter(branch()->parameters(), "clusters.average"), std::string("ewma"));
    QVERIFY(model().rowCount() > 0);
    const QString totals = panel().findChild<QLabel*>(QStringLiteral("compareTotals"))->text();
    QVERIFY2(totals.contains(QStringLiteral("A: paper, SMA")), qPrintable(totals));
    QVERIFY2(totals.contains(QStringLiteral("B: paper, EWMA")), qPrintable(totals));
}

void CompareWindowTest::bothShowTheSamePlaceUnasked()
{
    compareWith(QStringLiteral("paper"));
    View3d& first = parts_->window->view();
    View3d& second = parts_->window->secondView();

    // Nobody has moved a camera: the first view has fitted the scan into half its width.
    QCOMPARE(second.camera(), first.camera());
    const ViewCamera before = first.camera();
    parts_->window->resize(1100, 720);
    QVERIFY(waitUntil([&] { return first.camera() != before; }, kPatience));

    QCOMPARE(second.camera(), first.camera());
}

void CompareWindowTest::theClipBoxIsOfBothAndItsFieldsComeIntoSight()
{
    compareWith(QStringLiteral("paper"));
    QVERIFY(parts_->clipBoxPanel->visibleRegion().isEmpty());

    shown_->action("actClipBox")->setChecked(true);

    const auto box = parts_->window->view().scene().clipBox();
    QVERIFY(box);
    QVERIFY(parts_->window->secondView().scene().clipBox());
    QVERIFY(parts_->window->secondView().scene().clipBox()->isApprox(*box));
    QVERIFY(waitUntil([this] { return !parts_->clipBoxPanel->visibleRegion().isEmpty(); }, kPatience));
    shown_->action("actClipBox")->setChecked(false);
    QVERIFY(!parts_->window->secondView().scene().clipBox());
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::CompareWindowTest)
#include "compare_window_test.moc"
