// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/register_planes.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <QtTest>

#include "core/types/angle.h"
#include "tests/core/mapping/known_planes.h"
#include "tests/core/mapping/simulated_floor.h"
#include "tests/test_program.h"

namespace planewright {

class RegisterPlanesTest : public QObject {
    Q_OBJECT

private slots:
    void exactPlanesGiveTheExactPose();
    void aBareCorridorKeepsTheOdometryAlongIt();
    void withoutPriorABareCorridorHasNoPose();
    void theStrengthIsThatOfItsPlanes();
    void theCovarianceIsHonest();
    void withoutAnyPlaneThePriorStays();
};

namespace {

const Pose& truePose()
{
    static const Pose pose = poseAt({2.0, 1.0, 0.3}, {0.02, -0.01, 2.5});
    return pose;
}

/// A plane of the map, and what a stop at a pose sees of it.
MatchedPlanes pairOf(const Eigen::Vector3d& normal, double distance, double angle, double offset)
{
    MatchedPlanes pair;
    pair.known = planeKnownTo(normal, distance, angle, offset);
    pair.seen = inMap(pair.known, truePose().inverse());
    pair.seen.covariance = pair.known.covariance;
    return pair;
}

std::vector<MatchedPlanes> corridor()
{
    return {pairOf({1.0, 0.0, 0.0}, 4.0, 1e-3, 2e-3), pairOf({-1.0, 0.0, 0.0}, 1.0, 1e-3, 2e-3),
            pairOf({0.0, 0.0, -1.0}, 1.0, 1e-3, 2e-3)};
}

std::vector<MatchedPlanes> room()
{
    std::vector<MatchedPlanes> pairs = corridor();
    pairs.push_back(pairOf({0.1, 1.0, 0.0}, 6.0, 1e-3, 2e-3));
    return pairs;
}

Matrix6d odometryOf(double turn, double shift)
{
    Vector6d variances;
    variances << Eigen::Vector3d::Constant(square(turn)), Eigen::Vector3d::Constant(square(shift));
    return variances.asDiagonal();
}

}  // namespace

void RegisterPlanesTest::exactPlanesGiveTheExactPose()
{
    const auto found = registerPlanes(room(), std::nullopt);

    QVERIFY(found);
    QVERIFY(errorBetween(found->pose, truePose()).norm() < 1e-9);
    QVERIFY(found->chiSquare < 1e-9);
    QVERIFY(found->strength.fixesAll());
}

void RegisterPlanesTest::aBareCorridorKeepsTheOdometryAlongIt()
{
    Vector6d error;
    error << 0.0, 0.0, degrees(1.0), 0.05, 0.2, -0.02;
    const PosePrior odometry{withError(truePose(), error), odometryOf(degrees(1.0), 0.1)};

    const auto found = registerPlanes(corridor(), odometry);

    QVERIFY(found);
    const Vector6d left = errorBetween(truePose(), found->pose);
    QVERIFY(std::abs(left[4] - 0.2) < 1e-3);
    QVERIFY(std::abs(left[3]) < 1e-4 && std::abs(left[5]) < 1e-4 && left.head<3>().norm() < 1e-4);
    QVERIFY(std::abs(std::sqrt(found->covariance(4, 4)) - 0.1) < 1e-3);
    QVERIFY(std::sqrt(found->covariance(3, 3)) < 3e-3);
    // Which direction: along y.
    QVERIFY(!found->strength.shift.sigma[1]);
    QVERIFY(found->strength.shift.sigma[0] && found->strength.shift.sigma[2]);
    QVERIFY(std::abs(found->strength.shift.weakest.y()) > 0.999);
    QVERIFY(found->strength.turn.weakestSigma);
}

void RegisterPlanesTest::withoutPriorABareCorridorHasNoPose()
{
    QVERIFY(!registerPlanes(corridor(), std::nullopt));
}

/// Both sides of a pair are known to 2 mm, so each wall tells the shift along it to √8 mm; two walls to 2 mm.
void RegisterPlanesTest::theStrengthIsThatOfItsPlanes()
{
    const auto found = registerPlanes(corridor(), PosePrior{truePose(), odometryOf(degrees(1.0), 0.1)});

    // About the stop d and angle of the map's planes are not independent: the wall 4 m from the origin is 2 m away.
    const double leverage = 1e-3 * truePose().translation.norm();
    QVERIFY(*found->strength.shift.sigma[0] > 1.9e-3);
    QVERIFY(*found->strength.shift.sigma[0] < std::sqrt(4e-6 + leverage * leverage));
}

/// 400 draws of everything that takes part: e'C⁻¹e has mean 6 ± √(12/400).
void RegisterPlanesTest::theCovarianceIsHonest()
{
    Random random(7);
    const Matrix6d odometry = odometryOf(degrees(0.5), 0.05);
    double sum = 0.0;
    constexpr int kDraws = 400;
    for (int i = 0; i < kDraws; ++i) {
        std::vector<MatchedPlanes> pairs = room();
        for (MatchedPlanes& pair : pairs) {
            pair.seen = changedBy(pair.seen, drawn(pair.seen.covariance, random));
            pair.known = changedBy(pair.known, drawn(pair.known.covariance, random));
        }
        const auto found = registerPlanes(pairs, PosePrior{withError(truePose(), drawn(odometry, random)), odometry});
        const Vector6d error = errorBetween(truePose(), found->pose);
        sum += error.dot(found->covariance.llt().solve(error));
    }
    QVERIFY(std::abs(sum / kDraws - 6.0) < 4.0 * std::sqrt(12.0 / kDraws));
}

void RegisterPlanesTest::withoutAnyPlaneThePriorStays()
{
    const PosePrior odometry{truePose(), odometryOf(degrees(1.0), 0.1)};

    const auto found = registerPlanes({}, odometry);

    QVERIFY(found);
    QVERIFY(errorBetween(found->pose, truePose()).norm() < 1e-12);
    QVERIFY(found->covariance.isApprox(odometry.covariance, 1e-9));
    QVERIFY(!found->strength.shift.weakestSigma && !found->strength.turn.weakestSigma);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::RegisterPlanesTest)
#include "register_planes_test.moc"
