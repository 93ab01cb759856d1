// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/measurements_model.h"

#include <numbers>

#include <QAbstractItemModelTester>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_map.h"

namespace planewright {

class MeasurementsModelTest : public QObject {
    Q_OBJECT

private slots:
    void pointsAreMeasuredAlongTheAxes();
    void aPointIsMeasuredToItsFoot();
    void facingWallsHaveADistance();
    void wallsAtACornerHaveAnAngleAndNoDistance();
    void threePointsHaveAnAngle();
    void planesThatAreNotThereAreNotMeasured();
    void measurementsAreRemovedOneByOne();
};

namespace {

QString cell(const MeasurementsModel& model, MeasurementColumn column)
{
    return model.index(model.rowCount() - 1, static_cast<int>(column)).data().toString();
}

/// A wall 2 m ahead (P00), one 1.5 m behind (P01), and one to the right (P02).
std::shared_ptr<const ShownMap> room()
{
    MadeMap made;
    made.slice(1);
    const auto add = [&](PlaneId id, const Eigen::Vector3d& normal, double distance) {
        Plane plane = made.wall(id, {{0, 0}});
        plane.normal = normal;
        plane.distance = distance;
        made.plane(plane);
    };
    add(0, {0.0, 1.0, 0.0}, 2.0);
    add(1, {0.0, -1.0, 0.0}, 1.5);
    add(2, {1.0, 0.0, 0.0}, 1.0);
    return made.get();
}

}  // namespace

void MeasurementsModelTest::pointsAreMeasuredAlongTheAxes()
{
    MeasurementsModel model;
    const QAbstractItemModelTester tester(&model);

    model.addPoints({1.0, 1.0, 0.0}, {4.0, 5.0, 5.0});  // 3, 4, 5: level distance 5, slope 45°

    QCOMPARE(cell(model, MeasurementColumn::Distance), QStringLiteral("7.07"));
    QCOMPARE(cell(model, MeasurementColumn::Angle), QStringLiteral("45.0"));
    QCOMPARE(cell(model, MeasurementColumn::Right), QStringLiteral("3.00"));
    QCOMPARE(cell(model, MeasurementColumn::Forward), QStringLiteral("4.00"));
    QCOMPARE(cell(model, MeasurementColumn::Up), QStringLiteral("5.00"));
    QCOMPARE(cell(model, MeasurementColumn::Step), QStringLiteral("–"));
}

void MeasurementsModelTest::aPointIsMeasuredToItsFoot()
{
    MeasurementsModel model;
    model.setMap(room());

    QVERIFY(model.addPointAndPlane({5.0, 0.5, 1.0}, 0));

    QCOMPARE(cell(model, MeasurementColumn::What), QStringLiteral("Point – P00"));
    QCOMPARE(cell(model, MeasurementColumn::Distance), QStringLiteral("1.50"));
    QCOMPARE(cell(model, MeasurementColumn::Forward), QStringLiteral("1.50"));
    QVERIFY(model.at(0).to.isApprox(Eigen::Vector3d(5.0, 2.0, 1.0)));
    QCOMPARE(cell(model, MeasurementColumn::Step), QStringLiteral("1"));
}

void MeasurementsModelTest::facingWallsHaveADistance()
{
    MeasurementsModel model;
    model.setMap(room());

    QVERIFY(model.addPlanes(0, 1));

    QCOMPARE(cell(model, MeasurementColumn::What), QStringLiteral("P00 – P01"));
    QCOMPARE(cell(model, MeasurementColumn::Distance), QStringLiteral("3.50"));
    QCOMPARE(cell(model, MeasurementColumn::Angle), QStringLiteral("0.0"));
}

void MeasurementsModelTest::wallsAtACornerHaveAnAngleAndNoDistance()
{
    MeasurementsModel model;
    model.setMap(room());

    QVERIFY(model.addPlanes(0, 2));

    QCOMPARE(cell(model, MeasurementColumn::Distance), QStringLiteral("–"));
    QCOMPARE(cell(model, MeasurementColumn::Angle), QStringLiteral("90.0"));
}

void MeasurementsModelTest::threePointsHaveAnAngle()
{
    MeasurementsModel model;

    QVERIFY(model.addAngle({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {-1.0, std::sqrt(3.0), 0.0}));
    QVERIFY(std::abs(*model.at(0).angle - 2.0 * std::numbers::pi / 3.0) < 1e-12);
    QVERIFY(!model.addAngle({1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}));
    QCOMPARE(model.rowCount(), 1);
}

void MeasurementsModelTest::planesThatAreNotThereAreNotMeasured()
{
    MeasurementsModel model;
    QVERIFY(!model.addPlanes(0, 1));
    model.setMap(room());

    QVERIFY(!model.addPlanes(0, 7));
    QVERIFY(!model.addPointAndPlane({0.0, 0.0, 0.0}, 7));
    QCOMPARE(model.rowCount(), 0);
}

void MeasurementsModelTest::measurementsAreRemovedOneByOne()
{
    MeasurementsModel model;
    const QAbstractItemModelTester tester(&model);
    model.addPoints({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    model.addPoints({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0});

    model.remove(0);

    QCOMPARE(model.rowCount(), 1);
    QCOMPARE(*model.at(0).distance, 2.0);
    model.clear();
    QCOMPARE(model.rowCount(), 0);
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::MeasurementsModelTest)
#include "measurements_model_test.moc"
