// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/lineage_chart.h"

#include <QAbstractItemModelTester>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/drawn_lives.h"
#include "ui/models/life_events_model.h"

namespace planewright {

class LineageChartTest : public QObject {
    Q_OBJECT

private slots:
    void livesAreBarsOverTheSteps();
    void jointsLeadFromBarToBar();
    void eventsAreToldOnceAndInOrder();
    void aScanThatGoesOnHasOpenBars();
    void theTableGrowsWithTheEvents();
};

namespace {

LineageChart familyOf(PlaneId plane)
{
    const PlaneLives lives = drawnLives();
    return lineageChart(lives, lives.familyOf(plane), 20, true);
}

}  // namespace

void LineageChartTest::livesAreBarsOverTheSteps()
{
    const LineageChart chart = familyOf(2);  // which came from 0 and took in 1

    QCOMPARE(chart.bars.size(), std::size_t(3));
    QCOMPARE(chart.bars[0].plane, 0);
    QCOMPARE(chart.bars[0].first, 4);
    QCOMPARE(chart.bars[0].last, 21);  // the forced last pass, after step 20
    QVERIFY(chart.bars[0].isOver);
    QCOMPARE(chart.bars[1].last, 14);
    QVERIFY(!chart.bars[2].isOver);
    QCOMPARE(chart.bars[2].first, 7);
    QCOMPARE(chart.bars[2].last, 21);
    QCOMPARE(chart.mostSegments, 8);
    QCOMPARE(chart.bars[0].sizes.size(), std::size_t(3));  // 5, 8, 4 segments
    QCOMPARE(chart.bars[0].sizes[2].step, 7);
    QCOMPARE(chart.stepOf(21), -1);
    QCOMPARE(chart.momentOf(-1), 21);
    QVERIFY(!chart.barOf(3));
}

void LineageChartTest::jointsLeadFromBarToBar()
{
    const LineageChart chart = familyOf(2);

    QCOMPARE(chart.joints.size(), std::size_t(2));
    QCOMPARE(chart.joints[0].from, 0);
    QCOMPARE(chart.joints[0].to, 2);
    QCOMPARE(chart.joints[0].moment, 7);
    QCOMPARE(chart.joints[1].from, 1);
    QCOMPARE(chart.joints[1].to, 2);
    QCOMPARE(chart.joints[1].moment, 14);
}

void LineageChartTest::eventsAreToldOnceAndInOrder()
{
    QStringList texts;
    for (const FamilyEvent& event : familyOf(2).events)
        texts << QStringLiteral("%1: %2 [%3]").arg(event.step).arg(eventText(event)).arg(event.segments);

    QCOMPARE(texts, (QStringList{"4: P00 fitted from C4 [5]", "6: P01 fitted from C6 [3]", "7: P00 splits off P02 [4]",
                                 "14: P01 merged into P02 [0]", "-1: P00 given up [0]"}));
}

void LineageChartTest::aScanThatGoesOnHasOpenBars()
{
    PlaneLives lives;
    lives.add(drawnStep(4, {}, {{0, 5}}));
    lives.add(drawnStep(9, {}, {{0, 6}}));

    const LineageChart chart = lineageChart(lives, {0}, 9, false);

    QCOMPARE(chart.bars[0].last, 9);
    QCOMPARE(chart.lastMoment(), 9);
    QVERIFY(lineageChart(lives, {}, 9, false).bars.empty());
}

void LineageChartTest::theTableGrowsWithTheEvents()
{
    LifeEventsModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    std::vector<FamilyEvent> events = familyOf(2).events;
    const std::vector<FamilyEvent> first(events.begin(), events.begin() + 2);
    model.setEvents(first);
    const QPersistentModelIndex kept = model.index(1, 1);

    model.setEvents(events);

    QCOMPARE(model.rowCount(), 5);
    QVERIFY(kept.isValid());
    QCOMPARE(model.rowsAsText({model.index(2, 0), model.index(4, 0)}),
             QStringLiteral("Step\tEvent\tSegments\n8\tP00 splits off P02\t4\nlast pass\tP00 given up\t–\n"));
    model.setEvents(first);
    QVERIFY(!kept.isValid());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::LineageChartTest)
#include "lineage_chart_test.moc"
