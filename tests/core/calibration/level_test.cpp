// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/calibration/level.h"

#include <cmath>

#include <Eigen/Geometry>
#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

namespace {

/// Planes of these normals as a scanner sees them whose pitch reads too little, and whose axis falls to the right.
struct Room {
    SeenPlanes seen;
    PlanesEstimate planes;

    Room(const std::vector<Eigen::Vector3d>& normals, double pitch, double roll)
    {
        const Eigen::Matrix3d turn =
            (Eigen::AngleAxisd(-pitch, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitY()))
                .toRotationMatrix();
        for (const Eigen::Vector3d& normal : normals) {
            const Eigen::Vector3d n = turn * normal.normalized();
            seen.planes.push_back({n, 1.0, 1000});
            planes.normals.push_back(n);
            Eigen::Matrix<double, 3, 2> tangents;
            tangents.col(0) = n.unitOrthogonal();
            tangents.col(1) = n.cross(tangents.col(0));
            planes.tangents.push_back(tangents);
        }
        const auto count = static_cast<Eigen::Index>(3 * normals.size());
        planes.covariance = std::pow(degrees(0.01), 2) * Eigen::MatrixXd::Identity(count, count);
    }
};

const Eigen::Vector3d kFloor{0.0, 0.0, -1.0};
const Eigen::Vector3d kAhead{0.0, 1.0, 0.0};
const Eigen::Vector3d kSide{1.0, 0.0, 0.0};

}  // namespace

class LevelTest : public QObject {
    Q_OBJECT

private slots:
    void findsPitchAndRoll_data();
    void findsPitchAndRoll();
    void slantingPlanesHaveNoSay();
    void planesThatDisagreeMakeItLessSure();
    void sideWallsAloneTellNoPitch();
    void withoutPlanesThereIsNone();
};

void LevelTest::findsPitchAndRoll_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("pitch");
    QTest::addColumn<double>("roll");
    QTest::newRow("floor alone") << 0 << 2.2 << 0.5;
    QTest::newRow("floor and walls") << 1 << -2.2 << 0.8;
    QTest::newRow("two walls") << 2 << 3.0 << -0.7;
    QTest::newRow("front wall alone, axis level") << 3 << 1.5 << 0.0;
}

void LevelTest::findsPitchAndRoll()
{
    QFETCH(int, kind);
    QFETCH(double, pitch);
    QFETCH(double, roll);
    const std::vector<std::vector<Eigen::Vector3d>> rooms{
        {kFloor}, {kFloor, kAhead, kSide, -kAhead}, {kAhead, kSide}, {kAhead}};
    const Room room(rooms[static_cast<std::size_t>(kind)], degrees(pitch), degrees(roll));

    const auto level = findLevel(room.seen, room.planes, degrees(0.1));

    QVERIFY(level);
    QVERIFY2(std::abs(level->pitch - degrees(pitch)) < degrees(0.01),
             qPrintable(QString::number(toDegrees(level->pitch))));
    QVERIFY2(std::abs(level->roll - degrees(roll)) < degrees(0.01),
             qPrintable(QString::number(toDegrees(level->roll))));
    QVERIFY(std::sqrt(level->covariance(0, 0)) < degrees(0.15));
}

void LevelTest::slantingPlanesHaveNoSay()
{
    const Room room({kFloor, kAhead, kSide, {0.0, 0.4, 0.9}, {0.3, 0.5, 0.2}, {0.1, 0.0, 1.0}}, degrees(1.0), 0.0);

    const auto level = findLevel(room.seen, room.planes, degrees(0.1));

    QVERIFY(level);
    QCOMPARE(level->levelPlanes, 1);
    QCOMPARE(level->plumbPlanes, 2);
    QVERIFY(std::abs(level->pitch - degrees(1.0)) < degrees(0.01));
}

void LevelTest::planesThatDisagreeMakeItLessSure()
{
    const double off = std::tan(degrees(0.5));
    const Room straight({kFloor, kAhead, kFloor, kAhead}, 0.0, 0.0);
    const Room crooked({{0.0, off, -1.0}, {0.0, 1.0, off}, {0.0, -off, -1.0}, {0.0, 1.0, -off}}, 0.0, 0.0);

    const auto agreed = findLevel(straight.seen, straight.planes, degrees(0.1));
    const auto disagreed = findLevel(crooked.seen, crooked.planes, degrees(0.1));

    QVERIFY(agreed && disagreed);
    QVERIFY(disagreed->covariance(0, 0) > 4.0 * agreed->covariance(0, 0));
}

void LevelTest::sideWallsAloneTellNoPitch()
{
    const Room room({kSide, -kSide}, degrees(2.0), 0.0);

    QVERIFY(!findLevel(room.seen, room.planes, degrees(0.1)));
}

void LevelTest::withoutPlanesThereIsNone()
{
    QVERIFY(!findLevel({}, {}, degrees(0.1)));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::LevelTest)
#include "level_test.moc"
