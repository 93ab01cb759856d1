// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <numbers>

#include <Eigen/Geometry>
#include <QTest>

#include "simulated_room.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

/// The scene turned about the vertical axis by an angle [rad].
Scene turned(Scene scene, double angle)
{
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    for (RectangleSurface& surface : scene.rectangles) {
        surface.corner = rotation * surface.corner;
        surface.edgeU = rotation * surface.edgeU;
        surface.edgeV = rotation * surface.edgeV;
    }
    for (CylinderSurface& surface : scene.cylinders) {
        surface.base = rotation * surface.base;
        surface.axis = rotation * surface.axis;
        surface.radius = rotation * surface.radius;
    }
    for (TruePlane& plane : scene.planes)
        plane.normal = rotation * plane.normal;
    return scene;
}

/// A box of four walls, floor and ceiling around the sensor, 6 m × 8 m × 2.6 m.
Scene boxRoom()
{
    Scene scene;
    scene.name = "box";
    const Eigen::Vector3d low{-2.5, -3.0, -1.0};
    const Eigen::Vector3d high{3.5, 5.0, 1.6};
    const Eigen::Vector3d size = high - low;
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d edgeU = size[(axis + 1) % 3] * Eigen::Vector3d::Unit((axis + 1) % 3);
        const Eigen::Vector3d edgeV = size[(axis + 2) % 3] * Eigen::Vector3d::Unit((axis + 2) % 3);
        for (const bool far : {false, true}) {
            const int id = static_cast<int>(scene.planes.size());
            const double place = far ? high[axis] : low[axis];
            Eigen::Vector3d corner = low;
            corner[axis] = place;
            scene.rectangles.push_back({corner, edgeU, edgeV, id, 0.0});
            const double side = place < 0.0 ? -1.0 : 1.0;
            scene.planes.push_back({id, "side", side * Eigen::Vector3d::Unit(axis), side * place});
        }
    }
    return scene;
}

/// Parameters that fit a scanner without noise: points off a line by a micrometre are of another surface. With the
/// usual ones a wall seen by two or three points in a corner may lend an end point to its neighbour.
Parameters withoutNoise()
{
    Parameters parameters;
    parameters.noise = {0.0, 0.0, 0.0, 0.0};
    parameters.segments.splitDistance = 1e-6;
    return parameters;
}

}  // namespace

class ExactRoomsTest : public QObject {
    Q_OBJECT

private slots:
    void planesOfANoiseFreeRoomAreExact_data();
    void planesOfANoiseFreeRoomAreExact();
    void turningTheRoomTurnsItsPlanes_data();
    void turningTheRoomTurnsItsPlanes();
};

void ExactRoomsTest::planesOfANoiseFreeRoomAreExact_data()
{
    QTest::addColumn<QString>("settings");
    QTest::addColumn<QString>("cost");
    QTest::addColumn<bool>("usual");

    QTest::newRow("137 x 721, usual parameters") << "table8"
                                                 << "ml" << true;
    QTest::newRow("56 x 361, usual parameters") << "table10-1"
                                                << "ml" << true;
    QTest::newRow("137 x 721, printed Eq. (16), usual parameters") << "table8"
                                                                   << "foot" << true;
    QTest::newRow("137 x 721") << "table8"
                               << "ml" << false;
    QTest::newRow("137 x 881, behind the axis too") << "table10-4"
                                                    << "ml" << false;
    QTest::newRow("137 x 881, printed Eq. (16)") << "table10-4"
                                                 << "foot" << false;
}

void ExactRoomsTest::planesOfANoiseFreeRoomAreExact()
{
    QFETCH(const QString, settings);
    QFETCH(const QString, cost);
    QFETCH(const bool, usual);
    const SimulatedRoom room = scanOf(boxRoom(), "none", 1, settings.toStdString());
    Parameters parameters = usual ? Parameters{} : withoutNoise();
    parameters.planes.cost = cost == "foot" ? PlaneCost::Foot : PlaneCost::MaximumLikelihood;

    const auto found = extracted(room.scan.recording, parameters);

    const LabelComparison compared = comparedWithTruth(room, *found, 400);
    QVERIFY(compared.correct.size() >= 5);
    QCOMPARE(compared.correct.size(), compared.groups);
    QCOMPARE(compared.correct.size(), compared.regions);
    QVERIFY2(compared.errors.angle.max < 1e-6, qPrintable(QString::number(compared.errors.angle.max)));
    QVERIFY2(compared.errors.distance.max < 1e-6, qPrintable(QString::number(compared.errors.distance.max)));
}

void ExactRoomsTest::turningTheRoomTurnsItsPlanes_data()
{
    QTest::addColumn<double>("angle");

    for (const double angle : {-20.0, -7.3, 3.1, 11.0, 34.0})
        QTest::addRow("%g degrees", angle) << degrees(angle);
}

void ExactRoomsTest::turningTheRoomTurnsItsPlanes()
{
    QFETCH(const double, angle);
    const SimulatedRoom room = scanOf(turned(boxRoom(), angle), "none", 1);

    const auto found = extracted(room.scan.recording, withoutNoise());

    // The truth was turned with the room, so its planes are where turning puts them.
    const LabelComparison compared = comparedWithTruth(room, *found, 400);
    QCOMPARE(compared.correct.size(), compared.groups);
    QVERIFY2(compared.errors.angle.max < 1e-6, qPrintable(QString::number(compared.errors.angle.max)));
    QVERIFY2(compared.errors.distance.max < 1e-6, qPrintable(QString::number(compared.errors.distance.max)));
}

PLANEWRIGHT_TEST(ExactRoomsTest)
#include "exact_rooms_test.moc"
