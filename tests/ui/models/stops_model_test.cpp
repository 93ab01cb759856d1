// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/stops_model.h"

#include <QAbstractItemModelTester>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_building.h"
#include "ui/models/model_roles.h"

namespace planewright {

class StopsModelTest : public QObject {
    Q_OBJECT

private slots:
    void everyStopHasARowAndThoseTakenOutComeLast();
    void aStopTellsWhereItIsAndWhatThatRestsOn();
    void whatIsTakenOutHasNoPlace();
    void numbersSortAsNumbers();
};

namespace {

QString cell(const StopsModel& model, int row, StopsColumn column)
{
    return model.index(row, static_cast<int>(column)).data().toString();
}

}  // namespace

void StopsModelTest::everyStopHasARowAndThoseTakenOutComeLast()
{
    StopsModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 0);

    model.setBuilding(madeBuilding()->building);

    QCOMPARE(model.rowCount(), 4);
    QCOMPARE(model.rowOfScan(4), 2);
    QCOMPARE(model.rowOfScan(3), 3);
    QCOMPARE(model.rowOfScan(9), -1);
    model.setBuilding(nullptr);
    QCOMPARE(model.rowCount(), 0);
    QCOMPARE(model.rowOfScan(4), -1);
}

void StopsModelTest::aStopTellsWhereItIsAndWhatThatRestsOn()
{
    StopsModel model;
    model.setBuilding(madeBuilding()->building);

    QCOMPARE(cell(model, 1, StopsColumn::Stop), QStringLiteral("1"));
    QCOMPARE(cell(model, 1, StopsColumn::Scan), QStringLiteral("2"));
    QCOMPARE(cell(model, 1, StopsColumn::Y), QStringLiteral("1.500"));
    QCOMPARE(cell(model, 1, StopsColumn::Sigma), QStringLiteral("2.0"));
    QCOMPARE(cell(model, 1, StopsColumn::Matched), QStringLiteral("1"));
    QCOMPARE(cell(model, 1, StopsColumn::Open), QStringLiteral("1"));
    QCOMPARE(cell(model, 1, StopsColumn::RestsOn), QStringLiteral("⚠ odometry decides"));
    QVERIFY(model.index(1, 0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("odometry alone tells which")));
    QCOMPARE(cell(model, 2, StopsColumn::RestsOn), QStringLiteral("first"));
}

void StopsModelTest::whatIsTakenOutHasNoPlace()
{
    StopsModel model;
    model.setBuilding(madeBuilding()->building);

    QCOMPARE(cell(model, 3, StopsColumn::Stop), QStringLiteral("–"));
    QCOMPARE(cell(model, 3, StopsColumn::X), QStringLiteral("–"));
    QCOMPARE(cell(model, 3, StopsColumn::RestsOn), QStringLiteral("taken out"));
}

void StopsModelTest::numbersSortAsNumbers()
{
    StopsModel model;
    model.setBuilding(madeBuilding()->building);

    QCOMPARE(model.index(1, static_cast<int>(StopsColumn::Y)).data(kSortRole).toDouble(), 1.5);
    QVERIFY(!model.index(3, static_cast<int>(StopsColumn::Y)).data(kSortRole).isValid());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::StopsModelTest)
#include "stops_model_test.moc"
