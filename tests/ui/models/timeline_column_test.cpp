// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/timeline_column.h"

#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

class TimelineColumnTest : public QObject {
    Q_OBJECT

private slots:
    void numbersComeFromTheReport();
    void fitsAreDueByTheSchedule_data();
    void fitsAreDueByTheSchedule();
    void planesSplitOffAreNoFits();
    void theLastPassFitsSplitsAndMerges();
    void eventsAreFoundBothWays();
    void eachKindOfEventIsFound();
    void tipsCountStepsFromOne();
};

namespace {

Snapshot snapshotAt(int step, int planes)
{
    Snapshot snapshot;
    snapshot.report.step = step;
    snapshot.report.counts.planes = planes;
    return snapshot;
}

Decision decided(DecisionKind kind, Phase phase)
{
    Decision decision;
    decision.kind = kind;
    decision.phase = phase;
    return decision;
}

/// Fits at 2 and 6, a merge at 4, a fault at 5, an edit at 7; fitted in vain at 3.
std::vector<TimelineColumn> someColumns()
{
    std::vector<TimelineColumn> columns(9);
    columns[2].fitted = 1;
    columns[3].fits = true;
    columns[4].merges = 2;
    columns[5].faults = QStringList{QStringLiteral("lost")};
    columns[6].fitted = 3;
    columns[7].edits = QStringList{QStringLiteral("named")};
    return columns;
}

}  // namespace

void TimelineColumnTest::numbersComeFromTheReport()
{
    Snapshot now = snapshotAt(62, 9);
    now.report.tilt = degrees(81.9);
    now.report.counts.returns = 331;
    now.report.counts.segments = 12;
    now.report.counts.splits = 1;
    now.report.counts.merges = 2;
    const Snapshot before = snapshotAt(61, 8);

    const TimelineColumn column = timelineColumn(now, &before, {});

    QCOMPARE(column.step, 62);
    QCOMPARE(column.tilt, degrees(81.9));
    QCOMPARE(column.points, 331);
    QCOMPARE(column.segments, 12);
    QCOMPARE(column.planes, 9);
    QCOMPARE(column.planesBefore, 8);
    QCOMPARE(column.operations(), 3);
    QCOMPARE(timelineColumn(now, nullptr, {}).planesBefore, 0);
}

void TimelineColumnTest::fitsAreDueByTheSchedule_data()
{
    QTest::addColumn<int>("step");
    QTest::addColumn<bool>("fits");
    QTest::addColumn<bool>("splits");
    // Steps count from 0 here: the fifth is 4, the seventh 6, and 35 is the first that both divide.
    QTest::newRow("first") << 0 << false << false;
    QTest::newRow("fifth") << 4 << true << false;
    QTest::newRow("seventh") << 6 << false << true;
    QTest::newRow("thirty-fifth") << 34 << true << true;
}

void TimelineColumnTest::fitsAreDueByTheSchedule()
{
    QFETCH(int, step);
    QFETCH(bool, fits);
    QFETCH(bool, splits);

    const TimelineColumn column = timelineColumn(snapshotAt(step, 0), nullptr, {});

    QCOMPARE(column.fits, fits);
    QCOMPARE(column.splitsAndMerges, splits);
}

void TimelineColumnTest::planesSplitOffAreNoFits()
{
    Snapshot now = snapshotAt(34, 3);
    now.report.decisions = {decided(DecisionKind::Fit, Phase::Fit), decided(DecisionKind::NoFit, Phase::Fit),
                            decided(DecisionKind::Fit, Phase::SplitMerge), decided(DecisionKind::Fit, Phase::Fit)};

    QCOMPARE(timelineColumn(now, nullptr, {}).fitted, 2);
}

void TimelineColumnTest::theLastPassFitsSplitsAndMerges()
{
    const TimelineColumn column = timelineColumn(snapshotAt(-1, 3), nullptr, {});

    QVERIFY(column.fits);
    QVERIFY(column.splitsAndMerges);
    QVERIFY(timelineTip(column, false, 10).startsWith("Last pass"));
}

void TimelineColumnTest::eventsAreFoundBothWays()
{
    const auto columns = someColumns();
    std::vector<int> forward;
    for (auto place = nextEvent(columns, {8}, -1, true, TimelineEvent::Any); place;
         place = nextEvent(columns, {8}, *place, true, TimelineEvent::Any))
        forward.push_back(*place);
    std::vector<int> back;
    for (auto place = nextEvent(columns, {8}, 9, false, TimelineEvent::Any); place;
         place = nextEvent(columns, {8}, *place, false, TimelineEvent::Any))
        back.insert(back.begin(), *place);

    QCOMPARE(forward, (std::vector<int>{2, 4, 5, 6, 7, 8}));
    QCOMPARE(back, forward);
}

void TimelineColumnTest::eachKindOfEventIsFound()
{
    const auto columns = someColumns();
    const auto next = [&](int from, TimelineEvent kind) { return nextEvent(columns, {1}, from, true, kind); };

    QCOMPARE(next(0, TimelineEvent::Fits), std::optional(2));
    QCOMPARE(next(2, TimelineEvent::Fits), std::optional(6));
    QCOMPARE(next(6, TimelineEvent::Fits), std::optional<int>());
    QCOMPARE(next(0, TimelineEvent::SplitsAndMerges), std::optional(4));
    QCOMPARE(next(0, TimelineEvent::Faults), std::optional(5));
    QCOMPARE(next(0, TimelineEvent::Edits), std::optional(7));
    QCOMPARE(next(0, TimelineEvent::Bookmarks), std::optional(1));
    QCOMPARE(next(1, TimelineEvent::Bookmarks), std::optional<int>());
}

void TimelineColumnTest::tipsCountStepsFromOne()
{
    TimelineColumn column;
    column.step = 62;
    column.tilt = degrees(81.9);
    column.points = 331;
    column.segments = 1;
    column.planes = 9;
    column.planesBefore = 8;
    column.fits = true;
    column.fitted = 1;
    column.splits = 2;
    column.faults = QStringList{QStringLiteral("step 62 was lost")};

    QCOMPARE(timelineTip(column, true, 137),
             QStringLiteral("Step 63 of 137, φ 81.9°\n331 returns, 1 segment\n9 planes (+1)\n1 plane fitted\n2 splits\n"
                            "▲ step 62 was lost\nBookmark"));
    column.planes = 6;
    QVERIFY(timelineTip(column, false, 0).startsWith("Step 63, φ"));
    QVERIFY(timelineTip(column, false, 0).contains("6 planes (−2)"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::TimelineColumnTest)
#include "timeline_column_test.moc"
