// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/charts/charts_panel.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_history.h"
#include "ui/common/scan_charts.h"

namespace planewright {

class ChartsPanelTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void aClickGoesToTheStep();
    void arrowKeysGoFromStepToStep();
    void aClickOnAPointOfTheScatterGoesToItsStep();
    void theLastPassLeavesTheCursorAtTheLastStep();
    void asManyChartsAsThereIsRoomForStandBesideEachOther();
    void oneChartCanBeShownAlone();
    void oneChartAloneIsAsHighAsThereIsRoom();
    void copyGivesTabSeparatedNumbers();
    void theTableHasTheSameNumbers();
    void picturesAreWritten();
    void nothingIsDrawnWhileItIsHidden();
    void everyControlHasANameAndASize();

private:
    /// The middle of a step in a chart, in the view's pixels.
    static QPoint placeOf(const ChartView& view, double step)
    {
        return QPointF(view.frame().pixelX(step), view.frame().area.center().y()).toPoint();
    }
    ChartView& view(std::size_t number) { return *panel_->views()[number]; }

    std::unique_ptr<ChartsPanel> panel_;
};

void ChartsPanelTest::init()
{
    panel_ = std::make_unique<ChartsPanel>();
    panel_->setCharts(scanCharts(MadeHistory().scan(30).lastPass().get(), 4.0));
    panel_->resize(720, 190);
    panel_->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
    panel_->grab();
}

void ChartsPanelTest::aClickGoesToTheStep()
{
    QSignalSpy chosen(panel_.get(), &ChartsPanel::placeChosen);

    QTest::mouseClick(&view(0), Qt::LeftButton, {}, placeOf(view(0), 12.0));
    QTest::mouseClick(&view(0), Qt::LeftButton, {}, QPoint(2, 2));

    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen[0][0].toInt(), 11);
}

void ChartsPanelTest::arrowKeysGoFromStepToStep()
{
    QSignalSpy chosen(panel_.get(), &ChartsPanel::placeChosen);
    panel_->setPlace(4);

    QTest::keyClick(&view(1), Qt::Key_Right);
    QTest::keyClick(&view(1), Qt::Key_Left);
    QTest::keyClick(&view(1), Qt::Key_End);
    QTest::keyClick(&view(1), Qt::Key_Home);

    QCOMPARE(chosen.size(), 4);
    QCOMPARE(chosen[0][0].toInt(), 5);
    QCOMPARE(chosen[1][0].toInt(), 3);
    QCOMPARE(chosen[2][0].toInt(), 29);
    QCOMPARE(chosen[3][0].toInt(), 0);
}

void ChartsPanelTest::aClickOnAPointOfTheScatterGoesToItsStep()
{
    panel_->choose(6);
    QTest::qWait(20);
    panel_->grab();
    QSignalSpy chosen(panel_.get(), &ChartsPanel::placeChosen);
    const ChartSeries& points = view(6).chart().series[0];

    QTest::mouseClick(&view(6), Qt::LeftButton, {}, view(6).frame().pixel(points.x[20], points.y[20]).toPoint());

    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen[0][0].toInt(), 20);
}

void ChartsPanelTest::theLastPassLeavesTheCursorAtTheLastStep()
{
    panel_->setPlace(30);
    QCOMPARE(view(0).cursor(), std::optional<std::size_t>(29));

    panel_->setPlace(-1);
    QCOMPARE(view(0).cursor(), std::nullopt);

    panel_->setPlace(0);
    QCOMPARE(view(0).cursor(), std::optional<std::size_t>(0));
}

void ChartsPanelTest::asManyChartsAsThereIsRoomForStandBesideEachOther()
{
    QCOMPARE(view(0).y(), view(1).y());
    QVERIFY(view(2).y() > view(1).y());

    panel_->resize(310, 190);
    QTest::qWait(0);
    QCOMPARE(view(0).x(), view(1).x());

    panel_->resize(1400, 400);
    QTest::qWait(0);
    QCOMPARE(view(0).y(), view(3).y());
    QVERIFY(view(0).height() >= 150);
}

void ChartsPanelTest::oneChartCanBeShownAlone()
{
    QTest::mouseDClick(&view(2), Qt::LeftButton, {}, view(2).rect().center());

    QCOMPARE(panel_->chosen(), 2);
    QVERIFY(view(2).isVisible());
    QVERIFY(!view(0).isVisible());
    QTest::qWait(0);
    QVERIFY(view(2).width() > 600);

    QTest::keyClick(&view(2), Qt::Key_Return);
    QCOMPARE(panel_->chosen(), -1);
    QVERIFY(view(0).isVisible());
}

void ChartsPanelTest::copyGivesTabSeparatedNumbers()
{
    panel_->setCharts(scanCharts(MadeHistory().step(3, 1, 0, 0.0).step(8, 2, 1, 1.5).get(), 4.0));
    panel_->choose(2);

    QTest::keyClick(&view(2), Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("step\tplanes [planes]\n1\t0\n2\t1\n"));

    panel_->choose(-1);
    QTest::mouseClick(panel_->findChild<QToolButton*>("copyChart"), Qt::LeftButton);
    const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
    QCOMPARE(lines[2].split('\t').mid(0, 5), (QStringList{"2", "8", "2", "1", "1.5"}));
}

void ChartsPanelTest::theTableHasTheSameNumbers()
{
    panel_->choose(0);
    QTest::mouseClick(panel_->findChild<QToolButton*>("chartTable"), Qt::LeftButton);

    QVERIFY(panel_->table()->isVisible());
    const QAbstractItemModel& model = *panel_->table()->model();
    QCOMPARE(model.rowCount(), 30);
    QCOMPARE(model.index(29, 0).data().toString(), QStringLiteral("30"));
    QCOMPARE(model.index(29, 1).data().toDouble(), view(0).chart().series[0].y[29]);

    QTest::keyClick(panel_->table(), Qt::Key_C, Qt::ControlModifier);
    QVERIFY(QGuiApplication::clipboard()->text().startsWith("step\tfitted [segments]\n1\t"));
}

void ChartsPanelTest::picturesAreWritten()
{
    QTemporaryDir folder;

    QVERIFY(panel_->savePicture(folder.filePath("charts.png")));
    QVERIFY(panel_->savePicture(folder.filePath("charts.svg")));
    QVERIFY(!panel_->savePicture(folder.filePath("none/charts.png")));

    QVERIFY(QImage(folder.filePath("charts.png")).width() >= 700);
    QFile svg(folder.filePath("charts.svg"));
    QVERIFY(svg.open(QIODevice::ReadOnly));
    QXmlStreamReader reader(&svg);
    QStringList texts;
    while (!reader.atEnd()) {
        if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == QLatin1String("text"))
            texts << reader.readElementText();
    }
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
    QVERIFY(texts.contains("Fitted segments"));
    QVERIFY(texts.contains(QStringLiteral("↑ 25 ms")));
}

void ChartsPanelTest::nothingIsDrawnWhileItIsHidden()
{
    panel_->hide();
    const double before = view(0).drawingTime();

    panel_->setCharts(scanCharts(MadeHistory().scan(40).get(), 4.0));
    QTest::qWait(20);

    QCOMPARE(view(0).drawingTime(), before);
}

void ChartsPanelTest::everyControlHasANameAndASize()
{
    for (const char* name : {"chartChooser", "chartTable", "copyChart", "saveChart", "chartNumbers"}) {
        auto* control = panel_->findChild<QWidget*>(name);
        QVERIFY2(control != nullptr, name);
        QVERIFY2(!control->accessibleName().isEmpty(), name);
    }
    for (const ChartView* chart : panel_->views()) {
        QVERIFY(!chart->accessibleName().isEmpty());
        QVERIFY(chart->focusPolicy() == Qt::StrongFocus);
    }
    panel_->setPlace(9);
    QVERIFY(view(0).accessibleDescription().startsWith("Step 10: fitted "));
    QVERIFY(panel_->minimumSizeHint().width() <= 480);
}

void ChartsPanelTest::oneChartAloneIsAsHighAsThereIsRoom()
{
    panel_->choose(2);
    const auto* seen = panel_->findChild<QScrollArea*>(QStringLiteral("chartScroll"))->viewport();

    for (const int height : {110, 130, 260, 130}) {
        panel_->resize(720, height);
        QTest::qWait(0);

        QCOMPARE(view(2).height(), seen->height());
    }
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ChartsPanelTest)
#include "charts_panel_test.moc"
