// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/uncertain_plane.h"

#include <cmath>

#include <Eigen/LU>
#include <QtTest>

#include "core/types/angle.h"
#include "tests/core/mapping/known_planes.h"
#include "tests/core/mapping/simulated_floor.h"
#include "tests/test_program.h"

namespace planewright {

class UncertainPlaneTest : public QObject {
    Q_OBJECT

private slots:
    void aPlaneMovesAsItsPoints();
    void thePoseJacobianIsTheNumericDerivative();
    void theCovarianceMovesByTheNumericDerivative();
    void seenFromAPointAndBackIsTheSame();
    void chiSquareIsTheSameInEveryFrame();
    void chiSquareHasTheMeanOfThreeDegreesOfFreedom();
    void theFacesOfAWallAreNeverOnePlane();
    void fusedInformationAddsUp();
    void theLimitsAreThoseOfTheTables();
    void anUnevenWallIsKnownNoBetterThanItIsFlat();
};

namespace {

UncertainPlane slantedPlane()
{
    UncertainPlane plane = planeKnownTo({0.3, 0.9, 0.2}, 4.0, 1e-3, 2e-3);
    plane.covariance(0, 2) = plane.covariance(2, 0) = 1e-6;
    return plane;
}

const Pose& somePose()
{
    static const Pose pose = poseAt({3.0, -2.0, 1.2}, {0.02, -0.1, 1.1});
    return pose;
}

}  // namespace

void UncertainPlaneTest::aPlaneMovesAsItsPoints()
{
    const UncertainPlane plane = slantedPlane();
    const UncertainPlane moved = inMap(plane, somePose());

    for (const Eigen::Vector2d& at :
         {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(3.0, 1.0), Eigen::Vector2d(-2.0, 5.0)}) {
        const Eigen::Vector3d point = plane.distance * plane.normal + plane.tangents * at;
        QVERIFY(std::abs(moved.normal.dot(somePose() * point) - moved.distance) < 1e-12);
    }
}

void UncertainPlaneTest::thePoseJacobianIsTheNumericDerivative()
{
    const UncertainPlane plane = slantedPlane();
    const UncertainPlane moved = inMap(plane, somePose());
    const Matrix3x6d jacobian = poseJacobian(moved, somePose());
    constexpr double kStep = 1e-6;

    for (int i = 0; i < 6; ++i) {
        const Vector6d step = kStep * Vector6d::Unit(i);
        const Eigen::Vector3d change = difference(moved, inMap(plane, withError(somePose(), step))) -
                                       difference(moved, inMap(plane, withError(somePose(), -step)));
        QVERIFY((change / (2.0 * kStep) - jacobian.col(i)).norm() < 1e-8);
    }
}

void UncertainPlaneTest::theCovarianceMovesByTheNumericDerivative()
{
    const UncertainPlane plane = slantedPlane();
    const UncertainPlane moved = inMap(plane, somePose());
    constexpr double kStep = 1e-6;
    Eigen::Matrix3d jacobian;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
        jacobian.col(i) = (difference(moved, inMap(changedBy(plane, step), somePose())) -
                           difference(moved, inMap(changedBy(plane, -step), somePose()))) /
                          (2.0 * kStep);
    }

    QVERIFY(moved.covariance.isApprox(jacobian * plane.covariance * jacobian.transpose(), 1e-7));
}

void UncertainPlaneTest::seenFromAPointAndBackIsTheSame()
{
    const UncertainPlane plane = slantedPlane();
    const UncertainPlane back = seenFrom(seenFrom(plane, {100.0, -50.0, 3.0}), {-100.0, 50.0, -3.0});

    QVERIFY(numbersOf(back).isApprox(numbersOf(plane), 1e-12));
    QVERIFY((back.covariance - plane.covariance).norm() < 1e-12);
}

void UncertainPlaneTest::chiSquareIsTheSameInEveryFrame()
{
    const UncertainPlane plane = slantedPlane();
    UncertainPlane other = changedBy(plane, {2e-3, -1e-3, 3e-3});
    other.tangents = tangentsOf(other.normal);

    const double here = chiSquare(plane, other);
    const double there = chiSquare(inMap(plane, somePose()), inMap(other, somePose()));

    QVERIFY(here > 1.0);
    QVERIFY(std::abs(here - there) < 1e-3 * here);
    QVERIFY(std::abs(here - chiSquare(other, plane)) < 1e-2 * here);
}

/// 2000 draws: the mean of χ² with 3 degrees of freedom is 3 ± √(6/2000).
void UncertainPlaneTest::chiSquareHasTheMeanOfThreeDegreesOfFreedom()
{
    Random random(5);
    const UncertainPlane truth = inMap(slantedPlane(), somePose());
    Matrix6d poseCovariance = Matrix6d::Identity() * 1e-6;
    poseCovariance(2, 4) = poseCovariance(4, 2) = 5e-7;
    double sum = 0.0;
    constexpr int kDraws = 2000;
    for (int i = 0; i < kDraws; ++i) {
        const UncertainPlane seen = changedBy(slantedPlane(), drawn(slantedPlane().covariance, random));
        const Pose pose = withError(somePose(), drawn(poseCovariance, random));
        const UncertainPlane known = changedBy(truth, drawn(truth.covariance, random));
        sum += chiSquare(inMap(seen, pose, poseCovariance), known);
    }
    QVERIFY(std::abs(sum / kDraws - 3.0) < 4.0 * std::sqrt(6.0 / kDraws));
}

void UncertainPlaneTest::theFacesOfAWallAreNeverOnePlane()
{
    // Known so badly that the thickness of the wall means nothing.
    const UncertainPlane front = planeKnownTo({0.0, 1.0, 0.0}, 3.0, 0.1, 1.0);
    const UncertainPlane back = planeKnownTo({0.0, -1.0, 0.0}, -3.1, 0.1, 1.0);

    QVERIFY(std::isinf(chiSquare(front, back)));
}

void UncertainPlaneTest::fusedInformationAddsUp()
{
    const UncertainPlane a = planeKnownTo({0.0, 1.0, 0.0}, 3.0, 1e-3, 2e-3);
    UncertainPlane b = changedBy(a, {1e-3, 0.0, 4e-3});
    b.covariance = 3.0 * a.covariance;

    const UncertainPlane both = fused(a, b);

    // A quarter of the way to the plane that is known three times worse.
    QVERIFY(std::abs(both.distance - 3.001) < 1e-9);
    QVERIFY(std::abs(difference(a, both).x() - 0.25e-3) < 1e-9);
    QVERIFY(std::abs(both.covariance(2, 2) - 0.75 * a.covariance(2, 2)) < 1e-12);
    QVERIFY(std::abs(both.covariance(0, 0) - 0.75 * a.covariance(0, 0)) < 1e-12);
}

void UncertainPlaneTest::theLimitsAreThoseOfTheTables()
{
    const std::pair<int, double> table[] = {{3, 16.266}, {6, 22.458}, {9, 27.877}, {30, 59.703}, {60, 99.607}};
    for (const auto& [degreesOfFreedom, limit] : table)
        QVERIFY(std::abs(chiSquareLimit(degreesOfFreedom) / limit - 1.0) < 0.02);
}

/// A square metre of wall 5 m to the side, uneven by 2 mm.
void UncertainPlaneTest::anUnevenWallIsKnownNoBetterThanItIsFlat()
{
    ObservedPlane wall;
    wall.parameters = planeKnownTo({0.0, 1.0, 0.0}, 2.0, 0.0, 0.0);
    wall.parts.push_back({{{4.5, 2.0, -0.5}, {4.5, 2.0, 0.5}, {5.5, 2.0, 0.5}, {5.5, 2.0, -0.5}}, {}});

    addFlatness(wall, 2e-3);

    const Eigen::Matrix3d& covariance = wall.parameters.covariance;
    const double slope = 12.0 * 4e-6;  // over a square metre [rad²]
    QVERIFY(std::abs(covariance(0, 0) - slope) < 1e-12);
    QVERIFY(std::abs(covariance(2, 2) - (4e-6 + 25.0 * slope)) < 1e-9);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::UncertainPlaneTest)
#include "uncertain_plane_test.moc"
