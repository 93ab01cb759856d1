// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/scan_charts.h"

#include <cmath>

#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_history.h"

namespace planewright {

class ScanChartsTest : public QObject {
    Q_OBJECT

private slots:
    void withoutStepsThereAreSevenEmptyCharts();
    void countsAreThoseOfTheReports();
    void theLastPassIsNoStep();
    void averagesAreOverTheStepsAtWhichAPhaseRan();
    void timeAgainstSegmentsAddsUpAndIsFitted();
    void theMeanErrorHasALineAtItsLimitOrAtWhatIsExpected();
    void theTableIsTabSeparated();
    void chartsOverStepsShareATable();
};

void ScanChartsTest::withoutStepsThereAreSevenEmptyCharts()
{
    const std::vector<Chart> charts = scanCharts({}, 4.0);

    QCOMPARE(charts.size(), std::size_t(7));
    for (const Chart& chart : charts)
        QVERIFY(chart.isEmpty());
    QCOMPARE(charts[3].series[1].y.front(), 4.0);
}

void ScanChartsTest::countsAreThoseOfTheReports()
{
    const auto history = MadeHistory().step(3, 1, 0, 0.0).step(8, 2, 1, 1.5).get();

    const std::vector<Chart> charts = scanCharts(history, 4.0);

    QCOMPARE(charts[0].series[0].x, (std::vector<double>{1.0, 2.0}));
    QCOMPARE(charts[0].series[0].y, (std::vector<double>{3.0, 8.0}));
    QCOMPARE(charts[1].series[0].y, (std::vector<double>{1.0, 2.0}));
    QCOMPARE(charts[2].series[0].y, (std::vector<double>{0.0, 1.0}));
    QVERIFY(std::isnan(charts[3].series[0].y[0]));  // no plane, no error
    QCOMPARE(charts[3].series[0].y[1], 1.5);
    QCOMPARE(charts[0].places, (std::vector<int>{0, 1}));
}

void ScanChartsTest::theLastPassIsNoStep()
{
    const auto history = MadeHistory().step(3, 1, 0, 0.0).lastPass().get();

    for (const Chart& chart : scanCharts(history, 4.0)) {
        if (chart.overSteps)
            QCOMPARE(chart.series[0].x, std::vector<double>{1.0});
    }
}

void ScanChartsTest::averagesAreOverTheStepsAtWhichAPhaseRan()
{
    using std::chrono::microseconds;
    const auto history = MadeHistory()
                             .step(1, 0, 0, 0.0)
                             .takes(Phase::Extract, microseconds(1000))
                             .step(2, 0, 0, 0.0)
                             .takes(Phase::Extract, microseconds(2000))
                             .takes(Phase::Fit, microseconds(6000))
                             .get();

    const std::vector<Chart> charts = scanCharts(history, 4.0);

    const ChartSeries& averages = charts[5].series[0];
    QCOMPARE(averages.y[0], 1.5);
    QCOMPARE(averages.y[3], 6.0);
    QCOMPARE(averages.y[1], 0.0);
    QCOMPARE(charts[4].series[0].y, (std::vector<double>{1.0, 2.0}));
    QCOMPARE(charts[4].series[3].y, (std::vector<double>{0.0, 6.0}));
}

void ScanChartsTest::timeAgainstSegmentsAddsUpAndIsFitted()
{
    using std::chrono::microseconds;
    const auto history = MadeHistory()
                             .step(4, 6, 0, 0.0)
                             .takes(Phase::Extract, microseconds(1500))
                             .step(10, 10, 1, 0.0)
                             .takes(Phase::Assign, microseconds(500))
                             .get();

    const Chart chart = scanCharts(history, 4.0)[6];

    QCOMPARE(chart.series[0].x, (std::vector<double>{10.0, 20.0}));
    QCOMPARE(chart.series[0].y, (std::vector<double>{1.5, 2.0}));
    // 0.5 ms for ten segments, and 1 ms before the first.
    QCOMPARE(QString::fromStdString(chart.note), QStringLiteral("1 ms +0.05 ms per segment, R² 1.00"));
}

void ScanChartsTest::theMeanErrorHasALineAtItsLimitOrAtWhatIsExpected()
{
    const Chart limited = scanCharts({}, 4.5)[3];
    const Chart unlimited = scanCharts({}, std::nullopt)[3];

    QCOMPARE(limited.series[1].name, std::string("limit"));
    QCOMPARE(limited.series[1].y.front(), 4.5);
    QCOMPARE(unlimited.series[1].name, std::string("expected"));
    QCOMPARE(unlimited.series[1].y.front(), 1.0);
    QVERIFY(limited.yTitle.empty());
}

void ScanChartsTest::theTableIsTabSeparated()
{
    const auto history = MadeHistory().step(3, 1, 0, 0.0).step(8, 2, 1, 1.5).get();

    const std::string text = tabSeparated(tableOf(scanCharts(history, 4.0)[3]));

    QCOMPARE(QString::fromStdString(text), QStringLiteral("step\tmean E\n1\t\n2\t1.5\n"));
}

void ScanChartsTest::chartsOverStepsShareATable()
{
    const auto history = MadeHistory().step(3, 1, 0, 0.0).step(8, 2, 1, 1.5).get();

    const ChartTable table = tableOf(scanCharts(history, 4.0));

    QCOMPARE(table.headings.size(), std::size_t(1 + 4 + 6));
    QCOMPARE(table.headings[1], std::string("fitted [segments]"));
    QCOMPARE(table.rows.size(), std::size_t(2));
    QCOMPARE(table.rows[1][0], std::string("2"));
    QCOMPARE(table.rows[1][1], std::string("8"));
    QCOMPARE(table.rows[1][4], std::string("1.5"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScanChartsTest)
#include "scan_charts_test.moc"
