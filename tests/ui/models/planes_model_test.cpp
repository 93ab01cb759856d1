// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/planes_model.h"

#include <QAbstractItemModelTester>
#include <QColor>
#include <QSignalSpy>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_map.h"
#include "ui/models/model_roles.h"

namespace planewright {

class PlanesModelTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cellsSayWhatThePlaneIs_data();
    void cellsSayWhatThePlaneIs();
    void anErrorIsHeldAgainstALimitOnlyWhereThereIsOne();
    void aLevelPlaneHasNoHeading();
    void anOutlineToComeIsThreeDots();
    void lengthsAreShownInTheUnitThatWasChosen();
    void numbersHaveADecimalPointInEveryLocale();
    void whatIsTypedIsARequestAndChangesNothing();
    void typingTheSameNameIsNoRequest();
    void aMapTouchesOnlyTheRowsThatAreOthers();
    void planesOfAnotherScanAreOthersWhateverTheirRevision();
    void planesComeAndGoInOrderOfId();
    void aPersistentIndexFollowsItsPlane();
    void everyColumnHasATitleAndAMeaning();

private:
    QString cell(int row, PlaneColumn column) const
    {
        return model_->index(row, static_cast<int>(column)).data().toString();
    }

    std::unique_ptr<PlanesModel> model_;
    std::unique_ptr<QAbstractItemModelTester> tester_;
};

void PlanesModelTest::init()
{
    model_ = std::make_unique<PlanesModel>();
    tester_ = std::make_unique<QAbstractItemModelTester>(model_.get());
}

void PlanesModelTest::cellsSayWhatThePlaneIs_data()
{
    QTest::addColumn<int>("column");
    QTest::addColumn<QString>("text");
    const auto row = [](const char* name, PlaneColumn column, const char* text) {
        QTest::newRow(name) << static_cast<int>(column) << QString::fromUtf8(text);
    };
    row("id", PlaneColumn::Id, "P03");
    row("name", PlaneColumn::Name, "Right wall");
    row("class", PlaneColumn::Class, "wall");
    row("nx", PlaneColumn::Nx, "0.8000");
    row("ny", PlaneColumn::Ny, "-0.6000");
    row("nz", PlaneColumn::Nz, "0.0000");
    row("d", PlaneColumn::Distance, "2.56");
    row("heading is clockwise from ahead: atan2(0.8, -0.6)", PlaneColumn::Heading, "126.9");
    row("tilt of a wall", PlaneColumn::Tilt, "90.0");
    row("area", PlaneColumn::Area, "3.21");
    row("size", PlaneColumn::Size, "2.50 × 1.28");
    row("segments", PlaneColumn::SegmentCount, "2");
    row("end points, two a segment", PlaneColumn::EndPoints, "4");
    row("error", PlaneColumn::Error, "0.87");
    row("rms in millimetres", PlaneColumn::Rms, "4.5");
    row("born: step 4 is shown as 5", PlaneColumn::Born, "5");
    row("changed: step 62 is shown as 63", PlaneColumn::Changed, "63");
    row("lineage", PlaneColumn::MadeOf, "P03←P07+P11");
    row("state", PlaneColumn::State, "merged");
}

void PlanesModelTest::cellsSayWhatThePlaneIs()
{
    QFETCH(int, column);
    QFETCH(QString, text);
    MadeMap made;
    made.slice(2);
    Plane plane = made.wall(3, {{0, 0}, {0, 1}});
    plane.normal = {0.8, -0.6, -0.00001};  // never "-0.0000"
    plane.distance = 2.556;
    plane.fittingError = 0.871;
    plane.rms = 0.00449;
    plane.changedStep = 62;
    plane.lineage = {Lineage::Kind::Merged, {7, 11}};
    model_->setMap(made.plane(plane, "wall", "Right wall").outlined(3.2101, 2.5, 1.284).get());

    QCOMPARE(model_->index(0, column).data().toString(), text);
}

void PlanesModelTest::anErrorIsHeldAgainstALimitOnlyWhereThereIsOne()
{
    MadeMap made;
    made.slice(2);
    Plane plane = made.wall(0, {{0, 0}, {0, 1}});
    plane.fittingError = 9.0;
    model_->setMap(made.plane(plane).get());
    const QModelIndex error = model_->index(0, static_cast<int>(PlaneColumn::Error));
    const auto tip = [&] { return error.data(Qt::ToolTipRole).toString(); };

    model_->setErrorLimit(4.5);
    QCOMPARE(error.data(kLimitRole).toDouble(), 4.5);
    QVERIFY2(tip().contains("by 3.0 times") && tip().contains("above 4.5"), qPrintable(tip()));
    model_->setErrorLimit(std::nullopt);

    QVERIFY(!error.data(kLimitRole).isValid());
    QVERIFY2(tip().contains("by 3.0 times") && tip().contains("splits no plane"), qPrintable(tip()));
}

void PlanesModelTest::aLevelPlaneHasNoHeading()
{
    MadeMap made;
    Plane floor = made.wall(0, {});
    floor.normal = {0.0, 0.0, -1.0};
    model_->setMap(made.plane(floor).get());

    QCOMPARE(cell(0, PlaneColumn::Heading), QStringLiteral("–"));
    QCOMPARE(cell(0, PlaneColumn::Tilt), QStringLiteral("0.0"));
    QVERIFY(!model_->index(0, static_cast<int>(PlaneColumn::Heading)).data(kSortRole).isValid());
}

void PlanesModelTest::anOutlineToComeIsThreeDots()
{
    MadeMap made;
    model_->setMap(made.plane(made.wall(0, {})).get());

    QCOMPARE(cell(0, PlaneColumn::Area), QStringLiteral("…"));
    QCOMPARE(cell(0, PlaneColumn::Size), QStringLiteral("…"));
    QVERIFY(!model_->areaAt(0));
}

void PlanesModelTest::lengthsAreShownInTheUnitThatWasChosen()
{
    MadeMap made;
    model_->setMap(made.plane(made.wall(0, {})).outlined(1.0, 1.2345, 0.5).get());

    model_->setLengthStyle({.millimetres = true, .decimals = 4});

    QCOMPARE(cell(0, PlaneColumn::Distance), QStringLiteral("2000.0"));
    QCOMPARE(cell(0, PlaneColumn::Size), QStringLiteral("1234.5 × 500.0"));
    QCOMPARE(model_->headerData(static_cast<int>(PlaneColumn::Distance), Qt::Horizontal, Qt::DisplayRole).toString(),
             QStringLiteral("d mm"));
    QCOMPARE(model_->index(0, static_cast<int>(PlaneColumn::Distance)).data(kSortRole).toDouble(), 2.0);
}

void PlanesModelTest::numbersHaveADecimalPointInEveryLocale()
{
    QLocale::setDefault(QLocale(QLocale::German));
    MadeMap made;
    model_->setMap(made.plane(made.wall(0, {})).get());

    QCOMPARE(cell(0, PlaneColumn::Distance), QStringLiteral("2.00"));
    QLocale::setDefault(QLocale::c());
}

void PlanesModelTest::whatIsTypedIsARequestAndChangesNothing()
{
    MadeMap made;
    model_->setMap(made.plane(made.wall(7, {})).get());
    QSignalSpy renamed(model_.get(), &PlanesModel::renameRequested);
    QSignalSpy classed(model_.get(), &PlanesModel::classRequested);
    QSignalSpy hidden(model_.get(), &PlanesModel::hideRequested);
    QSignalSpy locked(model_.get(), &PlanesModel::lockRequested);
    const auto index = [this](PlaneColumn column) { return model_->index(0, static_cast<int>(column)); };

    model_->setData(index(PlaneColumn::Name), "Rear wall", Qt::EditRole);
    model_->setData(index(PlaneColumn::Class), "door?", Qt::EditRole);
    model_->setData(index(PlaneColumn::Colour), Qt::Unchecked, Qt::CheckStateRole);
    model_->setData(index(PlaneColumn::Lock), Qt::Checked, Qt::CheckStateRole);

    QCOMPARE(renamed.value(0), (QVariantList{7, "Rear wall"}));
    QCOMPARE(classed.value(0), (QVariantList{7, "door?"}));
    QCOMPARE(hidden.value(0), (QVariantList{7, true}));
    QCOMPARE(locked.value(0), (QVariantList{7, true}));
    QCOMPARE(cell(0, PlaneColumn::Name), QString());
    QCOMPARE(index(PlaneColumn::Colour).data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Checked));
}

void PlanesModelTest::typingTheSameNameIsNoRequest()
{
    MadeMap made;
    model_->setMap(made.plane(made.wall(7, {}), "wall", "Rear wall").get());
    QSignalSpy renamed(model_.get(), &PlanesModel::renameRequested);

    model_->setData(model_->index(0, static_cast<int>(PlaneColumn::Name)), "Rear wall", Qt::EditRole);

    QCOMPARE(renamed.size(), 0);
}

void PlanesModelTest::aMapTouchesOnlyTheRowsThatAreOthers()
{
    MadeMap made;
    made.slice(1).plane(made.wall(1, {})).plane(made.wall(2, {})).plane(made.wall(3, {}));
    model_->setMap(made.get());
    QSignalSpy changed(model_.get(), &PlanesModel::dataChanged);
    QSignalSpy reset(model_.get(), &PlanesModel::modelReset);

    made.withoutPlanes();
    made.plane(made.wall(1, {}));                 // another object of the same revision
    made.plane(made.wall(2, {}, 2));              // refitted
    made.plane(made.wall(3, {}), "wall", "New");  // named
    model_->setMap(made.get());

    QCOMPARE(reset.size(), 0);
    QCOMPARE(changed.size(), 2);
    QCOMPARE(changed[0][0].toModelIndex().row(), 1);
    QCOMPARE(changed[1][0].toModelIndex().row(), 2);
}

void PlanesModelTest::planesOfAnotherScanAreOthersWhateverTheirRevision()
{
    MadeMap made;
    model_->setMap(made.slice(1).plane(made.wall(1, {})).get());
    MadeMap other;
    Plane plane = other.wall(1, {});
    plane.distance = 7.0;

    model_->setMap(other.slice(1).plane(plane).get());

    QCOMPARE(cell(0, PlaneColumn::Distance), QStringLiteral("7.00"));
}

void PlanesModelTest::planesComeAndGoInOrderOfId()
{
    MadeMap made;
    made.plane(made.wall(1, {})).plane(made.wall(4, {})).plane(made.wall(5, {})).plane(made.wall(9, {}));
    model_->setMap(made.get());

    MadeMap next;
    next.plane(next.wall(0, {})).plane(next.wall(5, {})).plane(next.wall(7, {}));
    model_->setMap(next.get());

    QCOMPARE(model_->rowCount(), 3);
    QCOMPARE(model_->planeAt(0), 0);
    QCOMPARE(model_->planeAt(1), 5);
    QCOMPARE(model_->planeAt(2), 7);
    QCOMPARE(*model_->rowOf(7), 2);
    QVERIFY(!model_->rowOf(9));
    model_->setMap(nullptr);
    QCOMPARE(model_->rowCount(), 0);
}

void PlanesModelTest::aPersistentIndexFollowsItsPlane()
{
    MadeMap made;
    model_->setMap(made.plane(made.wall(2, {})).plane(made.wall(5, {})).get());
    const QPersistentModelIndex fifth(model_->index(1, 0));

    MadeMap next;
    model_->setMap(next.plane(next.wall(1, {})).plane(next.wall(2, {})).plane(next.wall(5, {}, 8)).get());

    QVERIFY(fifth.isValid());
    QCOMPARE(model_->planeAt(fifth.row()), 5);
}

void PlanesModelTest::everyColumnHasATitleAndAMeaning()
{
    for (int column = 0; column < kPlaneColumns; ++column) {
        if (column != static_cast<int>(PlaneColumn::Colour))
            QVERIFY(!model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().isEmpty());
        QVERIFY(!model_->headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
    }
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::PlanesModelTest)
#include "planes_model_test.moc"
