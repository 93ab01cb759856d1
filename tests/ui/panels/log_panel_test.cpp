// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/log_panel.h"

#include <QClipboard>
#include <QPushButton>
#include <QScrollBar>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/panels/filter_box.h"
#include "ui/panels/filtered_table.h"

namespace planewright {

class LogPanelTest : public QObject {
    Q_OBJECT

private slots:
    void anEmptyLogIsQuiet();
    void theReportHasItsHeadAndTheLastLines();
    void withoutAHeadThereIsNoButton();
    void theNewestLineStaysInViewUnlessOneScrollsUp();
    void linesAreFiltered();
};

namespace {

void append(LogModel& model, int lines)
{
    for (int i = 0; i < lines; ++i)
        model.append({QDateTime::currentDateTime(), i % 2 == 0 ? LogSeverity::Info : LogSeverity::Warning,
                      QStringLiteral("scanner"), QStringLiteral("line %1").arg(i)});
}

}  // namespace

void LogPanelTest::anEmptyLogIsQuiet()
{
    LogModel model;
    const LogPanel panel(model);

    QCOMPARE(panel.table()->shownInstead(), QStringLiteral("All quiet."));
}

void LogPanelTest::theReportHasItsHeadAndTheLastLines()
{
    LogModel model;
    LogPanel panel(model);
    append(model, 250);
    panel.setReportHead([] { return QStringLiteral("Planewright 1.2.3"); });

    panel.findChild<QPushButton*>("copyBugReport")->click();

    const QStringList lines = QGuiApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 201);
    QCOMPARE(lines.front(), QStringLiteral("Planewright 1.2.3"));
    QVERIFY(lines.back().endsWith("line 249"));
}

void LogPanelTest::withoutAHeadThereIsNoButton()
{
    LogModel model;
    LogPanel panel(model);
    panel.show();

    QVERIFY(!panel.findChild<QPushButton*>("copyBugReport")->isVisible());
    panel.setReportHead([] { return QString(); });
    QVERIFY(panel.findChild<QPushButton*>("copyBugReport")->isVisible());
}

void LogPanelTest::theNewestLineStaysInViewUnlessOneScrollsUp()
{
    LogModel model;
    LogPanel panel(model);
    panel.resize(600, 220);
    panel.show();
    append(model, 50);
    QScrollBar* bar = panel.table()->view()->verticalScrollBar();

    QTRY_VERIFY(bar->maximum() > 0 && bar->value() == bar->maximum());
    bar->setValue(0);
    append(model, 10);
    QTest::qWait(20);

    QCOMPARE(bar->value(), 0);
}

void LogPanelTest::linesAreFiltered()
{
    LogModel model;
    LogPanel panel(model);
    append(model, 10);

    panel.table()->filter()->setQuery("level:warning");

    QCOMPARE(panel.table()->rows()->rowCount(), 5);
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::LogPanelTest)
#include "log_panel_test.moc"
