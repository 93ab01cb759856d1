// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/charts/chart_ranges.h"

#include <algorithm>
#include <cmath>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class ChartRangesTest : public QObject {
    Q_OBJECT

private slots:
    void ticksAreRound();
    void aLimitIsInThePictureWhereItIsNear();
    void thinnedLinesKeepTheirPeaks();
    void thinnedStacksKeepWholeSteps();
    void whatHasRoomStaysAsItIs();
    void aLineIsTakenApartAtItsGaps();
};

namespace {

/// x = 1 … 1000; y = x % 7, with one peak and one dip.
ChartSeries manyPoints(ChartSeries::Style style)
{
    ChartSeries series;
    series.style = style;
    for (int i = 1; i <= 1000; ++i) {
        series.x.push_back(i);
        series.y.push_back(i == 505 ? 100.0 : i == 707 ? -5.0 : i % 7);
    }
    return series;
}

}  // namespace

void ChartRangesTest::ticksAreRound()
{
    QCOMPARE(tickStep(10.0, 5.0, 0.0), 2.0);
    QCOMPARE(tickStep(10.0, 3.0, 0.0), 5.0);
    QCOMPARE(tickStep(137.0, 6.0, 1.0), 50.0);
    QCOMPARE(tickStep(2.0, 10.0, 1.0), 1.0);
}

void ChartRangesTest::aLimitIsInThePictureWhereItIsNear()
{
    Chart chart;
    chart.series = {{"a", {1.0, 2.0}, {0.5, 3.0}, ChartSeries::Style::Line, 0},
                    {"10", {0.0}, {10.0}, ChartSeries::Style::Limit, 0},
                    {"25", {0.0}, {25.0}, ChartSeries::Style::Limit, 0}};
    const double seen = rangesOf(chart).highY;
    QVERIFY(seen > 10.0 && seen < 12.0);

    chart.series[0].y = {0.5, 2.0};
    QVERIFY(rangesOf(chart).highY < 3.0);

    chart.series[0].y = {0.5, 11.0};
    QVERIFY(rangesOf(chart).highY > 25.0);
}

void ChartRangesTest::thinnedLinesKeepTheirPeaks()
{
    Chart chart;
    chart.series.push_back(manyPoints(ChartSeries::Style::Line));

    const ChartSeries series = thinned(chart, 100.0).series[0];

    QVERIFY(series.x.size() <= 202);
    QVERIFY(std::is_sorted(series.x.begin(), series.x.end()));
    QVERIFY(std::find(series.x.begin(), series.x.end(), 505.0) != series.x.end());
    QVERIFY(std::find(series.x.begin(), series.x.end(), 707.0) != series.x.end());
}

void ChartRangesTest::thinnedStacksKeepWholeSteps()
{
    Chart chart;
    chart.series.push_back(manyPoints(ChartSeries::Style::Stacked));
    chart.series.push_back(manyPoints(ChartSeries::Style::Stacked));
    chart.series[1].y.assign(1000, 1.0);

    const Chart drawn = thinned(chart, 100.0);

    QVERIFY(drawn.series[0].x.size() <= 101);
    QCOMPARE(drawn.series[0].x, drawn.series[1].x);
    QVERIFY(std::find(drawn.series[0].y.begin(), drawn.series[0].y.end(), 100.0) != drawn.series[0].y.end());
}

void ChartRangesTest::whatHasRoomStaysAsItIs()
{
    Chart chart;
    chart.series.push_back(manyPoints(ChartSeries::Style::Line));

    QCOMPARE(thinned(chart, 1000.0).series[0].x, chart.series[0].x);
}

void ChartRangesTest::aLineIsTakenApartAtItsGaps()
{
    const double none = std::nan("");
    Chart chart;
    chart.series = {{"E", {1.0, 2.0, 3.0, 4.0, 5.0}, {none, 2.0, 3.0, none, 1.0}, ChartSeries::Style::Line, 3},
                    {"limit", {0.0}, {4.0}, ChartSeries::Style::Limit, 0}};

    const Chart pieces = inPieces(chart);

    QCOMPARE(rangesOf(chart).highY, 1.08 * 4.0);
    QCOMPARE(pieces.series.size(), std::size_t(3));
    QCOMPARE(pieces.series[0].x, (std::vector<double>{2.0, 3.0}));
    QCOMPARE(pieces.series[0].y, (std::vector<double>{2.0, 3.0}));
    QCOMPARE(pieces.series[1].x, std::vector<double>{5.0});
    QCOMPARE(pieces.series[1].colour, 3);
    QCOMPARE(pieces.series[2].y, std::vector<double>{4.0});
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ChartRangesTest)
#include "chart_ranges_test.moc"
