// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/segments_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_map.h"
#include "ui/models/filter_proxy_model.h"

namespace planewright {

class SegmentsModelTest : public QObject {
    Q_OBJECT

private slots:
    void rowsAreTheSegmentsSliceAfterSlice();
    void cellsSayWhoHoldsASegment();
    void unfittedSegmentsCanBeAskedFor();
    void aMapThatGoesOnAddsRowsAndKeepsTheRest();
    void segmentsThatChangeHandsAreToldInRuns();
    void anotherScanBeginsAnew();
};

namespace {

QString cell(const SegmentsModel& model, int row, SegmentColumn column)
{
    return model.index(row, static_cast<int>(column)).data().toString();
}

}  // namespace

void SegmentsModelTest::rowsAreTheSegmentsSliceAfterSlice()
{
    SegmentsModel model;
    const QAbstractItemModelTester tester(&model);

    model.setMap(MadeMap().slice(2).slice(0).slice(3).get());

    QCOMPARE(model.rowCount(), 5);
    QVERIFY(model.segmentAt(2) == (SegmentId{2, 0}));
    QCOMPARE(*model.rowOf({2, 1}), 3);
    QVERIFY(!model.rowOf({1, 0}));
    QVERIFY(!model.rowOf({7, 0}));
}

void SegmentsModelTest::cellsSayWhoHoldsASegment()
{
    MadeMap made;
    made.slice(2).slice(1);
    made.plane(made.wall(4, {{1, 0}})).cluster(8, {{0, 1}});
    SegmentsModel model;

    model.setMap(made.get());

    QCOMPARE(cell(model, 2, SegmentColumn::Id), QStringLiteral("2.0"));  // step 1 is shown as 2
    QCOMPARE(cell(model, 2, SegmentColumn::Plane), QStringLiteral("P04"));
    QCOMPARE(cell(model, 2, SegmentColumn::State), QStringLiteral("fitted"));
    QCOMPARE(cell(model, 2, SegmentColumn::Cluster), QStringLiteral("–"));
    QCOMPARE(cell(model, 1, SegmentColumn::Cluster), QStringLiteral("C8"));
    QCOMPARE(cell(model, 1, SegmentColumn::State), QStringLiteral("unfitted"));
    QCOMPARE(cell(model, 0, SegmentColumn::Length), QStringLiteral("1.00"));
    QCOMPARE(cell(model, 0, SegmentColumn::Rms), QStringLiteral("4.0"));
    QCOMPARE(cell(model, 2, SegmentColumn::End), QStringLiteral("1.00 2.00 0.10"));
    QCOMPARE(model.unfitted(), 2);
}

void SegmentsModelTest::unfittedSegmentsCanBeAskedFor()
{
    MadeMap made;
    made.slice(3);
    SegmentsModel model;
    model.setMap(made.plane(made.wall(0, {{0, 1}})).get());
    FilterProxyModel rows(segmentFilterKeys());
    rows.setSourceModel(&model);

    QVERIFY(!rows.setQuery("state:unfitted"));
    QCOMPARE(rows.rowCount(), 2);
    QVERIFY(!rows.setQuery("state:fitted"));
    QCOMPARE(rows.rowCount(), 1);
}

void SegmentsModelTest::aMapThatGoesOnAddsRowsAndKeepsTheRest()
{
    MadeMap made;
    SegmentsModel model;
    const QAbstractItemModelTester tester(&model);
    model.setMap(made.slice(2).get());
    QSignalSpy inserted(&model, &SegmentsModel::rowsInserted);
    QSignalSpy reset(&model, &SegmentsModel::modelReset);
    QSignalSpy changed(&model, &SegmentsModel::dataChanged);

    model.setMap(made.slice(3).get());

    QCOMPARE(reset.size(), 0);
    QCOMPARE(changed.size(), 0);
    QCOMPARE(inserted.size(), 1);
    QCOMPARE(inserted[0][1].toInt(), 2);
    QCOMPARE(inserted[0][2].toInt(), 4);
}

void SegmentsModelTest::segmentsThatChangeHandsAreToldInRuns()
{
    MadeMap made;
    SegmentsModel model;
    model.setMap(made.slice(3).slice(3).get());
    QSignalSpy changed(&model, &SegmentsModel::dataChanged);

    model.setMap(made.plane(made.wall(0, {{0, 1}, {0, 2}, {1, 0}, {1, 2}})).get());

    QCOMPARE(changed.size(), 2);
    QCOMPARE(changed[0][0].toModelIndex().row(), 1);
    QCOMPARE(changed[0][1].toModelIndex().row(), 3);
    QCOMPARE(changed[1][0].toModelIndex().row(), 5);
}

void SegmentsModelTest::anotherScanBeginsAnew()
{
    SegmentsModel model;
    model.setMap(MadeMap().slice(2).slice(2).get());
    QSignalSpy reset(&model, &SegmentsModel::modelReset);

    model.setMap(MadeMap().slice(1).get());

    QCOMPARE(reset.size(), 1);
    QCOMPARE(model.rowCount(), 1);
    model.setMap(nullptr);
    QCOMPARE(model.rowCount(), 0);
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::SegmentsModelTest)
#include "segments_model_test.moc"
