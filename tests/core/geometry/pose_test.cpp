// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/pose.h"

#include <array>
#include <cmath>
#include <numbers>

#include <QtTest>

#include "core/simulation/random.h"
#include "core/types/angle.h"
#include "tests/core/mapping/known_planes.h"
#include "tests/test_program.h"

namespace planewright {

class PoseTest : public QObject {
    Q_OBJECT

private slots:
    void aPoseAndItsInverseCancel();
    void aRotationVectorIsFoundAgain();
    void anErrorLeadsFromOnePoseToTheOther();
    void aTurnShiftsWhatStandsBeside();
    void odometryKnowsTwoPercentOfTheWayAndADegreeOnTenMetres();
    void aWayThatIsLevelRisesSeenFromWhereTheFirstStopIsTilted();
};

void PoseTest::aPoseAndItsInverseCancel()
{
    const Pose pose = poseAt({3.0, -2.0, 1.0}, {0.1, -0.4, 2.0});
    const Eigen::Vector3d point{0.3, 7.0, -1.0};

    QVERIFY((pose.inverse() * (pose * point)).isApprox(point, 1e-12));
    QVERIFY(((pose.inverse() * pose) * point).isApprox(point, 1e-12));
    // A quarter turn about z takes x to y.
    QVERIFY((poseAt({1.0, 0.0, 0.0}, {0.0, 0.0, degrees(90.0)}) * Eigen::Vector3d::UnitX())
                .isApprox(Eigen::Vector3d(1.0, 1.0, 0.0), 1e-12));
}

void PoseTest::aRotationVectorIsFoundAgain()
{
    for (const Eigen::Vector3d& vector : {Eigen::Vector3d(1e-12, 0.0, 0.0), Eigen::Vector3d(0.3, -0.2, 0.1),
                                          Eigen::Vector3d(0.0, 0.0, 3.14), Eigen::Vector3d(-2.0, 1.0, 1.5)})
        QVERIFY((rotationVector(rotationAbout(vector)) - vector).norm() < 1e-9);
}

void PoseTest::anErrorLeadsFromOnePoseToTheOther()
{
    const Pose from = poseAt({3.0, -2.0, 1.0}, {0.1, -0.4, 2.0});
    const Pose to = poseAt({3.1, -2.2, 1.05}, {0.12, -0.42, 2.1});

    const Pose reached = withError(from, errorBetween(from, to));

    QVERIFY(reached.translation.isApprox(to.translation, 1e-12));
    QVERIFY(reached.rotation.isApprox(to.rotation, 1e-12));
}

/// Turned by a little about z, what stands 2 m along x moves along y.
void PoseTest::aTurnShiftsWhatStandsBeside()
{
    Vector6d error;
    error << 0.0, 0.0, 1e-3, 0.5, 0.0, 0.0;

    const Vector6d carried = carriedBy({2.0, 0.0, 0.0}) * error;

    Vector6d expected;
    expected << 0.0, 0.0, 1e-3, 0.5, 2e-3, 0.0;
    QVERIFY(carried.isApprox(expected, 1e-12));
}

void PoseTest::odometryKnowsTwoPercentOfTheWayAndADegreeOnTenMetres()
{
    OdometryNoise noise;
    noise.tilt = 0.0;
    noise.least = 0.0;

    const Matrix6d covariance = odometryCovariance({Eigen::Quaterniond::Identity(), {6.0, 8.0, 0.0}}, noise);

    QVERIFY(std::abs(std::sqrt(covariance(3, 3)) - 0.2) < 1e-12);
    QVERIFY(std::abs(toDegrees(std::sqrt(covariance(2, 2))) - 1.0) < 1e-4);
}

/// Stops stand tilted by a and b, each a normal draw of τ / √2 about x and y; odometry tells a level way.
void PoseTest::aWayThatIsLevelRisesSeenFromWhereTheFirstStopIsTilted()
{
    OdometryNoise noise;
    noise.height = 1e-3;
    const Eigen::Vector3d way{2.0, 3.0, 0.0};
    const Matrix6d told = odometryCovariance({Eigen::Quaterniond::Identity(), way}, noise);
    Random random(3);
    Eigen::Matrix3d drawn = Eigen::Matrix3d::Zero();  // of the turns about x and y, and of the height
    constexpr int kDraws = 20000;
    for (int i = 0; i < kDraws; ++i) {
        const auto [ax, ay] = random.normalPair();
        const auto [bx, by] = random.normalPair();
        const double one = noise.tilt / std::numbers::sqrt2;
        const Pose first{rotationAbout({one * ax, one * ay, 0.0}), Eigen::Vector3d::Zero()};
        const Pose second{rotationAbout({one * bx, one * by, 0.0}), way};
        const Vector6d error = errorBetween({Eigen::Quaterniond::Identity(), way}, first.inverse() * second);
        const Eigen::Vector3d part{error[0], error[1], error[5] + noise.height * random.normalPair().first};
        drawn += part * part.transpose() / kDraws;
    }
    const std::array<Eigen::Index, 3> places{0, 1, 5};
    for (Eigen::Index r = 0; r < 3; ++r) {
        for (Eigen::Index c = 0; c < 3; ++c) {
            const double scale = std::sqrt(drawn(r, r) * drawn(c, c));
            QVERIFY(std::abs(told(places[static_cast<std::size_t>(r)], places[static_cast<std::size_t>(c)]) -
                             drawn(r, c)) < 0.05 * scale);
        }
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PoseTest)
#include "pose_test.moc"
