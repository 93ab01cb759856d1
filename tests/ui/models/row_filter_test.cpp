// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/row_filter.h"

#include <QStandardItemModel>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_map.h"
#include "ui/models/filter_proxy_model.h"
#include "ui/models/planes_model.h"

namespace planewright {

class RowFilterTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void aQueryKeepsWhatFulfilsAllOfIt_data();
    void aQueryKeepsWhatFulfilsAllOfIt();
    void aBadQuerySaysWhereAndWhy_data();
    void aBadQuerySaysWhereAndWhy();
    void aBadQueryLeavesTheTableAsItWas();
    void whatIsUnknownComesLastInEitherOrder();

private:
    QList<int> shown() const;

    PlanesModel model_;
    std::unique_ptr<FilterProxyModel> rows_;
};

void RowFilterTest::init()
{
    MadeMap made;
    Plane floor = made.wall(0, {});
    floor.normal = {0.0, 0.0, -1.0};
    floor.distance = 0.9;
    floor.bornStep = 4;  // shown as 5
    made.plane(floor, "floor").outlined(12.0, 4.0, 3.0);
    Plane left = made.wall(3, {});
    left.fittingError = 1.5;
    left.bornStep = 59;
    made.plane(left, "wall", "Left wall").outlined(6.0, 3.0, 2.0);
    Plane merged = made.wall(11, {});
    merged.lineage = {Lineage::Kind::Merged, {7, 9}};
    made.plane(merged, "wall", "Door leaf");  // no outline yet
    model_.setMap(made.get());
    rows_ = std::make_unique<FilterProxyModel>(planeFilterKeys());
    rows_->setSourceModel(&model_);
}

QList<int> RowFilterTest::shown() const
{
    QList<int> ids;
    for (int row = 0; row < rows_->rowCount(); ++row)
        ids << model_.planeAt(rows_->mapToSource(rows_->index(row, 0)).row());
    return ids;
}

void RowFilterTest::aQueryKeepsWhatFulfilsAllOfIt_data()
{
    QTest::addColumn<QString>("query");
    QTest::addColumn<QList<int>>("ids");
    QTest::newRow("nothing") << "" << QList<int>{0, 3, 11};
    QTest::newRow("blanks") << "  " << QList<int>{0, 3, 11};
    QTest::newRow("text of a column") << "class:wall" << QList<int>{3, 11};
    QTest::newRow("beginning of a word") << "class:w" << QList<int>{3, 11};
    QTest::newRow("not the middle of a word") << "class:all" << QList<int>{};
    QTest::newRow("capitals") << "CLASS:Wall" << QList<int>{3, 11};
    QTest::newRow("number above") << "area>7" << QList<int>{0};
    QTest::newRow("an unknown area fulfils nothing") << "area<100" << QList<int>{0, 3};
    QTest::newRow("error below") << "E<1" << QList<int>{0, 11};
    QTest::newRow("steps as they are shown") << "born=5" << QList<int>{0, 11};
    QTest::newRow("at most") << "d<=0.9" << QList<int>{0};
    QTest::newRow("unequal") << "id!=3" << QList<int>{0, 11};
    QTest::newRow("height of the rectangle") << "height>=3" << QList<int>{0};
    QTest::newRow("all of it") << "class:wall E<1 born<50" << QList<int>{11};
    QTest::newRow("plain text in the name") << "leaf" << QList<int>{11};
    QTest::newRow("plain text in the label") << "P03" << QList<int>{3};
    QTest::newRow("lineage") << "lineage:P07" << QList<int>{11};
    QTest::newRow("quotes") << "name:\"left w\"" << QList<int>{3};
    QTest::newRow("quotes keep operators") << "\"a<b\"" << QList<int>{};
}

void RowFilterTest::aQueryKeepsWhatFulfilsAllOfIt()
{
    QFETCH(QString, query);
    QFETCH(QList<int>, ids);

    QVERIFY(!rows_->setQuery(query));

    QCOMPARE(shown(), ids);
}

void RowFilterTest::aBadQuerySaysWhereAndWhy_data()
{
    QTest::addColumn<QString>("query");
    QTest::addColumn<int>("position");
    QTest::addColumn<int>("length");
    QTest::addColumn<QString>("part");
    QTest::newRow("unknown column") << "E<1 size>2" << 4 << 6 << "no column “size”";
    QTest::newRow("no number") << "area>2m" << 0 << 7 << "“2m” is no number";
    QTest::newRow("decimal comma") << "area>2,5" << 0 << 8 << "“2,5” is no number";
    QTest::newRow("number missing") << "class:wall area>" << 11 << 5 << "A number is missing";
    QTest::newRow("infinite") << "d<inf" << 0 << 5 << "“inf” is no number";
    QTest::newRow("word missing") << "class:" << 0 << 6 << "A word is missing";
    QTest::newRow("texts have no size") << "class>2" << 0 << 7 << "is a text";
    QTest::newRow("no comparison") << "d!2" << 0 << 3 << "no comparison";
    QTest::newRow("open quote") << "name:\"left" << 5 << 5 << "closing \"";
}

void RowFilterTest::aBadQuerySaysWhereAndWhy()
{
    QFETCH(QString, query);
    QFETCH(int, position);
    QFETCH(int, length);
    QFETCH(QString, part);

    const auto problem = rows_->setQuery(query);

    QVERIFY(problem);
    QCOMPARE(problem->position, position);
    QCOMPARE(problem->length, length);
    QVERIFY2(problem->reason.contains(part), qPrintable(problem->reason));
}

void RowFilterTest::aBadQueryLeavesTheTableAsItWas()
{
    QVERIFY(!rows_->setQuery("class:floor"));

    QVERIFY(rows_->setQuery("class:floor area>x"));

    QCOMPARE(shown(), QList<int>{0});
}

void RowFilterTest::whatIsUnknownComesLastInEitherOrder()
{
    rows_->sort(static_cast<int>(PlaneColumn::Area), Qt::AscendingOrder);
    QCOMPARE(shown(), (QList<int>{3, 0, 11}));

    rows_->sort(static_cast<int>(PlaneColumn::Area), Qt::DescendingOrder);
    QCOMPARE(shown(), (QList<int>{0, 3, 11}));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::RowFilterTest)
#include "row_filter_test.moc"
