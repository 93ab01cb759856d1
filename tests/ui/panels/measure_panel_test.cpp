// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/measure_panel.h"

#include <QAction>
#include <QClipboard>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/panels/filtered_table.h"

namespace planewright {

class MeasurePanelTest : public QObject {
    Q_OBJECT

private slots:
    void itSaysHowToMeasure();
    void chosenMeasurementsAreRemovedWithTheKeyboard();
    void measurementsAreCopied();
};

void MeasurePanelTest::itSaysHowToMeasure()
{
    MeasurementsModel model;
    const MeasurePanel panel(model);

    QCOMPARE(panel.table()->shownInstead(), QStringLiteral("Press D and click two points."));
    QVERIFY(!panel.removeAction()->isEnabled());
    QVERIFY(!panel.table()->copyAction()->isEnabled());
}

void MeasurePanelTest::chosenMeasurementsAreRemovedWithTheKeyboard()
{
    MeasurementsModel model;
    MeasurePanel panel(model);
    for (const double length : {1.0, 2.0, 3.0})
        model.addPoints({0.0, 0.0, 0.0}, {length, 0.0, 0.0});
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    panel.table()->view()->setFocus();
    panel.table()->choose({0, 2});

    QTest::keyClick(panel.table()->view(), Qt::Key_Delete);

    QCOMPARE(model.rowCount(), 1);
    QCOMPARE(*model.at(0).distance, 2.0);
}

void MeasurePanelTest::measurementsAreCopied()
{
    MeasurementsModel model;
    MeasurePanel panel(model);
    model.addPoints({0.0, 0.0, 0.0}, {0.0, 3.0, 0.0});

    panel.table()->copyAction()->trigger();

    QCOMPARE(QGuiApplication::clipboard()->text(),
             QStringLiteral("Between\tDistance m\tAngle°\tRight m\tForward m\tUp m\tStep\n"
                            "Point – point\t3.00\t0.0\t0.00\t3.00\t0.00\t–\n"));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::MeasurePanelTest)
#include "measure_panel_test.moc"
