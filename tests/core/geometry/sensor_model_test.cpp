// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/sensor_model.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Core>
#include <Eigen/LU>
#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

Eigen::Matrix3d numericJacobian(const Eigen::Vector3d& x, const SensorModel& sensor)
{
    constexpr double kStep = 1e-6;
    Eigen::Matrix3d jacobian;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
        const Eigen::Vector3d a = x + step;
        const Eigen::Vector3d b = x - step;
        jacobian.col(i) = (toCartesian(a[0], a[1], a[2], sensor) - toCartesian(b[0], b[1], b[2], sensor)) / (2 * kStep);
    }
    return jacobian;
}

double uniform(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// A standard normal draw (Box and Muller).
double normal(std::mt19937_64& random)
{
    return std::sqrt(-2.0 * std::log(1.0 - uniform(random))) * std::cos(2.0 * std::numbers::pi * uniform(random));
}

bool isPoint(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return (a - b).norm() < 1e-12;
}

}  // namespace

class SensorModelTest : public QObject {
    Q_OBJECT

private slots:
    void aLevelBeamAheadLiesAhead();
    void aBeamStraightDownLiesBelow();
    void aBeamToTheRightLiesOnTheRight();
    void eq6ByHandAtThirtyAndSixtyDegrees();
    void jacobianMatchesTheNumericDerivativeOfEq6();
    void jacobianHasTheDeterminantOfASphere();
    void covarianceMatchesMonteCarlo();
    void covarianceOfALevelBeamAheadByHand();
    void covarianceIsSingularOnThePitchAxis();
    void rangesOutsideTheLimitsAreNoEcho();
    void aDescriptionGivesItsModel();
    void anAttitudeTurnsPointsAndTheirCovariances();
};

void SensorModelTest::aLevelBeamAheadLiesAhead()
{
    // φ = 90° looks level; the laser then sits d_l above the axis.
    QVERIFY(isPoint(toCartesian(4.0, degrees(90.0), degrees(90.0), {0.05, 0.1, 30.0}), {0.0, 4.0, 0.05}));
}

void SensorModelTest::aBeamStraightDownLiesBelow()
{
    QVERIFY(isPoint(toCartesian(4.0, degrees(90.0), 0.0, {0.05, 0.1, 30.0}), {0.0, 0.05, -4.0}));
}

void SensorModelTest::aBeamToTheRightLiesOnTheRight()
{
    QVERIFY(isPoint(toCartesian(4.0, 0.0, degrees(90.0), {0.05, 0.1, 30.0}), {4.0, 0.0, 0.05}));
}

void SensorModelTest::eq6ByHandAtThirtyAndSixtyDegrees()
{
    // ρ = 2, θ = 30°, φ = 60°, d_l = 0.1: ρ cos θ = √3, ρ sin θ = 1; y = sin 60° + 0.1 cos 60°,
    // z = −cos 60° + 0.1 sin 60°.
    const double r3 = std::sqrt(3.0);

    QVERIFY(isPoint(toCartesian(2.0, degrees(30.0), degrees(60.0), {0.1, 0.1, 30.0}),
                    {r3, r3 / 2.0 + 0.05, -0.5 + 0.05 * r3}));
}

void SensorModelTest::jacobianMatchesTheNumericDerivativeOfEq6()
{
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 1000; ++trial) {
        const SensorModel sensor{0.3 * uniform(random), 0.1, 30.0};
        const Eigen::Vector3d x{0.1 + 30.0 * uniform(random), degrees(-45.0 + 270.0 * uniform(random)),
                                degrees(180.0 * uniform(random))};

        const Eigen::Matrix3d jacobian = cartesianJacobian(x[0], x[1], x[2], sensor);

        QVERIFY((jacobian - numericJacobian(x, sensor)).cwiseAbs().maxCoeff() < 1e-7);
    }
}

void SensorModelTest::jacobianHasTheDeterminantOfASphere()
{
    // det J = ρ² sin θ, whatever d_l: the printed sign of entry (3,1) would break it.
    const Eigen::Matrix3d jacobian = cartesianJacobian(3.0, degrees(50.0), degrees(70.0), {0.16, 0.1, 30.0});

    QVERIFY(std::abs(jacobian.determinant() - 9.0 * std::sin(degrees(50.0))) < 1e-12);
}

void SensorModelTest::covarianceMatchesMonteCarlo()
{
    std::mt19937_64 random(2);
    const SensorModel sensor{0.05, 0.1, 30.0};
    const NoiseParameters noise{0.008, 0.001, degrees(0.05), degrees(0.084)};
    const Eigen::Vector3d x{6.0, degrees(40.0), degrees(75.0)};
    const double rangeSigma = std::sqrt(0.008 * 0.008 + 0.006 * 0.006);
    const Eigen::Vector3d mean = toCartesian(x[0], x[1], x[2], sensor);
    constexpr int kDraws = 200000;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (int i = 0; i < kDraws; ++i) {
        const double range = x[0] + rangeSigma * normal(random);
        const double bearing = x[1] + noise.bearing * normal(random);
        const double tilt = x[2] + noise.pitch * normal(random);
        const Eigen::Vector3d offset = toCartesian(range, bearing, tilt, sensor) - mean;
        sum += offset * offset.transpose();
    }

    const Eigen::Matrix3d covariance = cartesianCovariance(x[0], x[1], x[2], sensor, noise);

    // A variance of 200,000 draws scatters by √(2/200,000) = 0.3 %.
    const Eigen::Matrix3d difference = sum / kDraws - covariance;
    QVERIFY2(difference.norm() < 0.02 * covariance.norm(),
             qPrintable(QString::number(difference.norm() / covariance.norm())));
}

void SensorModelTest::covarianceOfALevelBeamAheadByHand()
{
    // θ = φ = 90°: range errs along y, bearing along x by ρ σ_θ, tilt along z by ρ σ_φ and along y by −d_l σ_φ.
    const NoiseParameters noise{0.01, 0.0, 0.002, 0.003};

    const Eigen::Matrix3d covariance = cartesianCovariance(5.0, degrees(90.0), degrees(90.0), {0.1, 0.1, 30.0}, noise);

    Eigen::Matrix3d expected;
    expected << 1e-4, 0.0, 0.0,               //
        0.0, 1e-4 + 9e-8, -0.1 * 5.0 * 9e-6,  //
        0.0, -0.1 * 5.0 * 9e-6, 25.0 * 9e-6;
    QVERIFY((covariance - expected).cwiseAbs().maxCoeff() < 1e-15);
}

void SensorModelTest::covarianceIsSingularOnThePitchAxis()
{
    // θ = 0 and d_l = 0: tilting does not move the point.
    const Eigen::Matrix3d covariance = cartesianCovariance(5.0, 0.0, degrees(90.0), {0.0, 0.1, 30.0}, {});

    QVERIFY(std::abs(covariance.determinant()) < 1e-25);
    QVERIFY(covariance(0, 0) > 0.0);
}

void SensorModelTest::rangesOutsideTheLimitsAreNoEcho()
{
    const SensorModel sensor{0.05, 0.1, 30.0};
    const SensorModel fromZero{0.05, 0.0, 30.0};

    QVERIFY(sensor.hasEcho(0.1));
    QVERIFY(sensor.hasEcho(30.0));
    QVERIFY(!sensor.hasEcho(0.0));
    QVERIFY(!sensor.hasEcho(0.099));
    QVERIFY(!sensor.hasEcho(30.001));
    QVERIFY(!sensor.hasEcho(-1.0));
    QVERIFY(!sensor.hasEcho(std::nan("")));
    QVERIFY(!fromZero.hasEcho(0.0));
}

void SensorModelTest::aDescriptionGivesItsModel()
{
    ScanDescription description;
    description.pitchAxisOffset = 0.16;
    description.rangeMin = 0.02;
    description.rangeMax = 80.0;

    const SensorModel sensor = sensorOf(description);

    QCOMPARE(sensor.pitchAxisOffset, 0.16);
    QCOMPARE(sensor.rangeMin, 0.02);
    QCOMPARE(sensor.rangeMax, 80.0);
}

void SensorModelTest::anAttitudeTurnsPointsAndTheirCovariances()
{
    // x right becomes z up: a scanner that turns about the vertical.
    ScanDescription description;
    description.pitchAxisOffset = 0.05;
    description.rangeMax = 30.0;
    const SensorModel level = sensorOf(description);
    description.attitude = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ());
    const Eigen::Matrix3d turn = description.attitude.toRotationMatrix();

    const SensorModel sensor = sensorOf(description);

    QVERIFY(isPoint(toCartesian(4.0, 0.0, degrees(90.0), {0.0, 0.1, 30.0}), {4.0, 0.0, 0.0}));
    QVERIFY(isPoint(toCartesian(4.0, 0.7, 1.1, sensor), turn * toCartesian(4.0, 0.7, 1.1, level)));
    QVERIFY(cartesianJacobian(4.2, 0.7, 1.1, sensor).isApprox(numericJacobian({4.2, 0.7, 1.1}, sensor), 1e-8));
    const NoiseParameters noise;
    QVERIFY(cartesianCovariance(4.2, 0.7, 1.1, sensor, noise)
                .isApprox(turn * cartesianCovariance(4.2, 0.7, 1.1, level, noise) * turn.transpose(), 1e-12));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SensorModelTest)
#include "sensor_model_test.moc"
