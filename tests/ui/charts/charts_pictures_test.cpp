// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QApplication>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_history.h"
#include "tests/ui/view3d/reference_image.h"
#include "ui/charts/charts_panel.h"
#include "ui/common/scan_charts.h"
#include "ui/theme/theme.h"

namespace planewright {

/// The charts as the dock shows them, beside pictures that somebody has looked at.
class ChartsPicturesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void chartsAreAsTheyWere_data();
    void chartsAreAsTheyWere();
};

void ChartsPicturesTest::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    QApplication::setFont(font);
}

void ChartsPicturesTest::chartsAreAsTheyWere_data()
{
    QTest::addColumn<bool>("dark");
    QTest::addColumn<int>("chart");
    QTest::addColumn<int>("steps");
    QTest::addColumn<QSize>("size");
    for (const bool dark : {false, true}) {
        const char* theme = dark ? "dark" : "light";
        QTest::addRow("charts-all-%s", theme) << dark << -1 << 137 << QSize(1240, 520);
        QTest::addRow("charts-dock-%s", theme) << dark << -1 << 137 << QSize(720, 190);
        QTest::addRow("charts-times-%s", theme) << dark << 4 << 137 << QSize(720, 190);
        QTest::addRow("charts-empty-%s", theme) << dark << 3 << 0 << QSize(720, 190);
    }
}

void ChartsPicturesTest::chartsAreAsTheyWere()
{
    QFETCH(bool, dark);
    QFETCH(int, chart);
    QFETCH(int, steps);
    QFETCH(QSize, size);
    applyTheme(dark ? Theme::Dark : Theme::Light);
    ChartsPanel panel;
    panel.resize(size);
    panel.setCharts(scanCharts(MadeHistory().scan(steps).get(), 4.0));
    panel.choose(chart);
    panel.setPlace(steps > 0 ? 62 : -1);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    panel.setFocus();
    QTest::qWait(20);

    const QString difference = differenceFromReference(panel.grab().toImage(), QTest::currentDataTag());

    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ChartsPicturesTest)
#include "charts_pictures_test.moc"
