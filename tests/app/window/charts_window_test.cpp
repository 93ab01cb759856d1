// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QTableView>
#include <QToolButton>
#include <QtTest>

#include "app/window/waiting.h"
#include "tests/app/window/shown_window.h"
#include "tests/test_program.h"
#include "ui/charts/charts_panel.h"
#include "ui/panels/slice_panel.h"

namespace planewright {

/// Charts and slice in the window: they follow the one playhead and share the one selection.
class ChartsWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { useFixedLook(); }
    void init();
    void aClickOnAChartGoesToTheStep();
    void chartsAreMadeWhenTheyAreSeen();
    void theSliceIsThatOfThePlayhead();
    void aSegmentOfTheSliceIsSelectedEverywhere();
    void bothFollowAScanThatRuns();
    void bothFitIntoTheSmallestWindow();

private:
    ChartsPanel& charts() { return shown_->controllers->charts.panel(); }
    SlicePanel& slice() { return shown_->controllers->slice.panel(); }
    int sketchedStep() { return slice().model().sketch() ? slice().model().sketch()->slice->step : -1; }

    QTemporaryDir folder_;
    std::unique_ptr<ShownWindow> shown_;
};

void ChartsWindowTest::init()
{
    shown_.reset();
    auto opened = ShownWindow::open(folder_.filePath("settings.ini"));
    QVERIFY2(opened, opened ? "" : opened.error().message.c_str());
    shown_ = std::move(*opened);
}

void ChartsWindowTest::aClickOnAChartGoesToTheStep()
{
    QVERIFY(shown_->scanCorridor());
    shown_->action("actShowCharts")->trigger();
    ChartView& fitted = *charts().views()[0];
    QVERIFY(waitUntil([&] { return !fitted.chart().isEmpty() && !fitted.frame().isEmpty() && fitted.isVisible(); },
                      kPatience));
    fitted.grab();

    const PlotFrame& frame = fitted.frame();
    QTest::mouseClick(&fitted, Qt::LeftButton, {}, QPointF(frame.pixelX(20.0), frame.area.center().y()).toPoint());

    QCOMPARE(shown_->parts.playhead.place(), 19);
    QVERIFY(waitUntil([&] { return shown_->parts.shown->step == 19; }, kPatience));
    QCOMPARE(fitted.cursor(), std::optional<std::size_t>(19));
    QCOMPARE(fitted.chart().series[0].y[19],
             static_cast<double>(shown_->parts.playhead.snapshot()->report.counts.fitted));
}

void ChartsWindowTest::chartsAreMadeWhenTheyAreSeen()
{
    shown_->parts.window->showBottomPanel(QStringLiteral("logPanel"));
    QVERIFY(shown_->scanCorridor());
    QVERIFY(charts().views()[0]->chart().isEmpty());

    shown_->parts.window->showBottomPanel(QStringLiteral("chartsPanel"));

    QCOMPARE(charts().views()[0]->chart().places.size() + 1, shown_->parts.playhead.history().size());
}

void ChartsWindowTest::theSliceIsThatOfThePlayhead()
{
    shown_->action("actShowSlice")->trigger();
    QVERIFY(shown_->scanCorridor());

    for (const int place : {30, 31, 4, 100}) {
        shown_->parts.playhead.goTo(place);
        QVERIFY(waitUntil([&] { return sketchedStep() == place; }, kPatience));

        const SegmentLog& log = shown_->parts.playhead.snapshot()->segments;
        const Segments& segments = log.slice(log.find(place));
        std::size_t kept = 0;
        for (const TracedPiece& piece : slice().model().sketch()->trace.pieces) {
            if (piece.segment < 0)
                continue;
            QCOMPARE(piece.firstBeam, segments[kept].firstBeam);
            QCOMPARE(piece.lastBeam, segments[kept].lastBeam);
            ++kept;
        }
        QCOMPARE(kept, segments.size());
    }
}

void ChartsWindowTest::aSegmentOfTheSliceIsSelectedEverywhere()
{
    shown_->action("actShowSlice")->trigger();
    QVERIFY(shown_->scanCorridor());
    shown_->parts.playhead.goTo(40);
    QVERIFY(waitUntil([&] { return sketchedStep() == 40; }, kPatience));
    const auto row = slice().model().rowOf(SegmentId{40, 0});
    QVERIFY(row);

    slice().list()->selectRow(*row);
    QCOMPARE(shown_->parts.selection.segments(), (std::set<SegmentId>{{40, 0}}));

    shown_->parts.selection.select({}, {{40, 1}});
    QCOMPARE(slice().list()->selectionModel()->selectedRows().front().row(), *slice().model().rowOf(SegmentId{40, 1}));
}

void ChartsWindowTest::bothFollowAScanThatRuns()
{
    shown_->action("actShowSlice")->trigger();
    shown_->controllers->scan.open(QStringLiteral("sim:corridor?seed=7&speed=1"), true);

    QVERIFY(waitUntil([&] { return sketchedStep() >= 3; }, kPatience));
    shown_->action("actShowCharts")->trigger();
    QVERIFY(waitUntil([&] { return charts().views()[0]->chart().places.size() >= 10; }, kPatience));
    const std::size_t before = charts().views()[0]->chart().places.size();
    QVERIFY(waitUntil([&] { return charts().views()[0]->chart().places.size() > before; }, kPatience));
}

void ChartsWindowTest::bothFitIntoTheSmallestWindow()
{
    QVERIFY(shown_->scanCorridor());
    MainWindow& window = *shown_->parts.window;
    window.resize(1024, 700);
    for (const char* action : {"actShowCharts", "actShowSlice"}) {
        shown_->action(action)->trigger();
        QTest::qWait(300);

        QWidget& panel = qstrcmp(action, "actShowCharts") == 0 ? static_cast<QWidget&>(charts()) : slice();
        QCOMPARE(window.size(), QSize(1024, 700));
        for (const QWidget* button : panel.findChildren<QToolButton*>()) {
            if (button->isVisible())
                QVERIFY2(panel.rect().contains(QRect(button->mapTo(&panel, QPoint()), button->size())),
                         qPrintable(button->objectName()));
        }
    }
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ChartsWindowTest)
#include "charts_window_test.moc"
