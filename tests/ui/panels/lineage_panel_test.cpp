// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/lineage_panel.h"

#include <QClipboard>
#include <QSignalSpy>
#include <QTableView>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/drawn_lives.h"
#include "ui/theme/theme.h"

namespace planewright {

class LineagePanelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(Theme::Light); }
    void withoutAPlaneItSaysWhatToDo();
    void aClickOnABarTellsPlaneAndStep();
    void aClickOnAJointTellsItsEvent();
    void arrowKeysGoFromEventToEvent();
    void tableAndGraphFollowEachOther();
    void eventsAreCopied();
    void barsOfManyPlanesAreScrolled();

private:
    static void show(LineagePanel& panel);
};

namespace {

LineageChart drawnChart()
{
    const PlaneLives lives = drawnLives();
    return lineageChart(lives, lives.familyOf(2), 20, true);
}

}  // namespace

void LineagePanelTest::show(LineagePanel& panel)
{
    panel.resize(420, 400);
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    panel.view()->setFocus();
}

void LineagePanelTest::withoutAPlaneItSaysWhatToDo()
{
    LineagePanel panel;
    QVERIFY(panel.shownInstead().startsWith(QStringLiteral("Select a plane")));

    panel.setChart(drawnChart());

    QVERIFY(panel.shownInstead().isEmpty());
    panel.setChart({});
    QVERIFY(!panel.shownInstead().isEmpty());
}

void LineagePanelTest::aClickOnABarTellsPlaneAndStep()
{
    LineagePanel panel;
    panel.setChart(drawnChart());
    show(panel);
    QSignalSpy chosen(&panel, &LineagePanel::planeChosen);

    QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, panel.view()->placeOf(2, 11));
    QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, panel.view()->placeOf(2, 21));

    QCOMPARE(chosen.count(), 2);
    QCOMPARE(chosen[0][0].value<PlaneId>(), 2);
    QCOMPARE(chosen[0][1].toInt(), 11);
    QCOMPARE(chosen[1][1].toInt(), -1);
}

void LineagePanelTest::aClickOnAJointTellsItsEvent()
{
    LineagePanel panel;
    panel.setChart(drawnChart());
    show(panel);
    QSignalSpy chosen(&panel, &LineagePanel::planeChosen);

    // Between the bars of 1 and 2, where 1 goes into 2.
    const QPoint joint = (panel.view()->placeOf(1, 14) + panel.view()->placeOf(2, 14)) / 2;
    QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, joint);

    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen[0][0].value<PlaneId>(), 1);
    QCOMPARE(chosen[0][1].toInt(), 14);
    QCOMPARE(panel.view()->currentEvent(), std::optional<std::size_t>(3));
}

void LineagePanelTest::arrowKeysGoFromEventToEvent()
{
    LineagePanel panel;
    panel.setChart(drawnChart());
    show(panel);
    QSignalSpy chosen(&panel, &LineagePanel::planeChosen);
    const auto press = [&](Qt::Key key) {
        QTest::keyClick(panel.view(), key);
        return std::pair(chosen.back()[0].value<PlaneId>(), chosen.back()[1].toInt());
    };

    QCOMPARE(press(Qt::Key_Right), std::pair(0, 4));
    QCOMPARE(press(Qt::Key_Right), std::pair(1, 6));
    QCOMPARE(press(Qt::Key_Right), std::pair(0, 7));
    QCOMPARE(press(Qt::Key_Down), std::pair(1, 6));  // the nearest of the next plane
    QCOMPARE(press(Qt::Key_End), std::pair(0, -1));
    QCOMPARE(press(Qt::Key_Right), std::pair(0, -1));
    QCOMPARE(press(Qt::Key_Left), std::pair(1, 14));
    QCOMPARE(press(Qt::Key_Up), std::pair(0, 7));
    QCOMPARE(press(Qt::Key_Home), std::pair(0, 4));
}

void LineagePanelTest::tableAndGraphFollowEachOther()
{
    LineagePanel panel;
    panel.setChart(drawnChart());
    show(panel);
    QSignalSpy chosen(&panel, &LineagePanel::planeChosen);

    QTest::keyClick(panel.view(), Qt::Key_End);
    QCOMPARE(panel.table()->currentIndex().row(), 4);
    QCOMPARE(chosen.count(), 1);
    panel.table()->setFocus();
    QTest::keyClick(panel.table(), Qt::Key_Up);

    QCOMPARE(panel.view()->currentEvent(), std::optional<std::size_t>(3));
    QCOMPARE(chosen.count(), 2);
    QCOMPARE(chosen[1][1].toInt(), 14);
    // The same chart once more, as while a scan goes on, changes nothing of that.
    panel.setChart(drawnChart());
    QCOMPARE(panel.view()->currentEvent(), std::optional<std::size_t>(3));
    QCOMPARE(chosen.count(), 2);
}

void LineagePanelTest::eventsAreCopied()
{
    LineagePanel panel;
    panel.setChart(drawnChart());
    show(panel);
    panel.table()->setFocus();
    panel.table()->selectRow(2);

    QTest::keyClick(panel.table(), Qt::Key_C, Qt::ControlModifier);

    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("Step\tEvent\tSegments\n8\tP00 splits off P02\t4\n"));
}

void LineagePanelTest::barsOfManyPlanesAreScrolled()
{
    PlaneLives lives;
    std::vector<std::pair<PlaneId, int>> planes;
    std::vector<PlaneId> ids;
    for (PlaneId id = 0; id < 40; ++id) {
        planes.emplace_back(id, 5);
        ids.push_back(id);
        lives.add(drawnStep(id, {}, planes));
    }
    LineagePanel panel;
    panel.setChart(lineageChart(lives, ids, 39, false));
    show(panel);

    QTest::keyClick(panel.view(), Qt::Key_End);

    const int y = panel.view()->placeOf(*panel.view()->currentEvent()).y();
    QVERIFY2(y > 0 && y < panel.view()->viewport()->height(), qPrintable(QString::number(y)));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::LineagePanelTest)
#include "lineage_panel_test.moc"
