// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/matches_model.h"

#include <QAbstractItemModelTester>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_building.h"
#include "ui/models/model_roles.h"

namespace planewright {

class MatchesModelTest : public QObject {
    Q_OBJECT

private slots:
    void everyPlaneOfEveryStopHasARow();
    void aMatchTellsItsPlaneAndHowFarItWas();
    void anOpenOneTellsWhatItMayBe();
};

namespace {

QString cell(const MatchesModel& model, int row, MatchesColumn column)
{
    return model.index(row, static_cast<int>(column)).data().toString();
}

}  // namespace

void MatchesModelTest::everyPlaneOfEveryStopHasARow()
{
    MatchesModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);

    model.setBuilding(madeBuilding()->building);

    QCOMPARE(model.rowCount(), 6);
    QCOMPARE(model.rowOf({2, 7}), 4);
    QCOMPARE(model.rowOf({2, 9}), -1);
}

void MatchesModelTest::aMatchTellsItsPlaneAndHowFarItWas()
{
    MatchesModel model;
    model.setBuilding(madeBuilding()->building);

    QCOMPARE(cell(model, 2, MatchesColumn::Plane), QStringLiteral("P00"));
    QCOMPARE(cell(model, 2, MatchesColumn::State), QStringLiteral("matched by hand"));
    QCOMPARE(cell(model, 2, MatchesColumn::MapPlane), QStringLiteral("P00"));
    QCOMPARE(cell(model, 2, MatchesColumn::ChiSquare), QStringLiteral("2.25"));
    QCOMPARE(cell(model, 2, MatchesColumn::Area), QStringLiteral("12.50"));
    // What is new was held against nothing.
    QCOMPARE(cell(model, 3, MatchesColumn::State), QStringLiteral("new"));
    QCOMPARE(cell(model, 3, MatchesColumn::ChiSquare), QStringLiteral("–"));
    QVERIFY(!model.index(3, static_cast<int>(MatchesColumn::ChiSquare)).data(kSortRole).isValid());
}

void MatchesModelTest::anOpenOneTellsWhatItMayBe()
{
    MatchesModel model;
    model.setBuilding(madeBuilding()->building);

    QCOMPARE(cell(model, 4, MatchesColumn::State), QStringLiteral("open"));
    QCOMPARE(cell(model, 4, MatchesColumn::MapPlane), QStringLiteral("–"));
    QCOMPARE(cell(model, 4, MatchesColumn::Rivals), QStringLiteral("P01, P02"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MatchesModelTest)
#include "matches_model_test.moc"
