// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/axis_strength.h"

#include <cmath>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class AxisStrengthTest : public QObject {
    Q_OBJECT

private slots:
    void nothingIsKnownWithoutPlanes();
    void aBareCorridorHasNoStrengthAlongIt();
    void planesAcrossEachOtherAddUp();
    void aSlantedPlaneTellsOfBoth();
};

namespace {

std::shared_ptr<const Plane> planeKnownTo(const Eigen::Vector3d& normal, double sigma)
{
    auto plane = std::make_shared<Plane>();
    plane->normal = normal.normalized();
    plane->covariance(2, 2) = sigma * sigma;
    return plane;
}

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-9;
}

}  // namespace

void AxisStrengthTest::nothingIsKnownWithoutPlanes()
{
    QVERIFY(!axisStrength({}).weakestSigma);
    const std::vector<std::shared_ptr<const Plane>> unknown{planeKnownTo(Eigen::Vector3d::UnitX(), 0.0)};
    const AxisStrength strength = axisStrength(unknown);
    QVERIFY(strength.information.isZero(0.0));
    QVERIFY(!strength.sigma[0] && !strength.sigma[1] && !strength.sigma[2]);
}

void AxisStrengthTest::aBareCorridorHasNoStrengthAlongIt()
{
    const std::vector<std::shared_ptr<const Plane>> planes{planeKnownTo(Eigen::Vector3d::UnitX(), 0.002),
                                                           planeKnownTo(-Eigen::Vector3d::UnitX(), 0.002),
                                                           planeKnownTo(-Eigen::Vector3d::UnitZ(), 0.001)};

    const AxisStrength strength = axisStrength(planes);

    QVERIFY(isNear(strength.sigma[0].value(), 0.002 / std::sqrt(2.0)));
    QVERIFY(!strength.sigma[1]);
    QVERIFY(isNear(strength.sigma[2].value(), 0.001));
    QVERIFY(!strength.weakestSigma);
    QVERIFY(isNear(std::abs(strength.weakest.y()), 1.0));
}

void AxisStrengthTest::planesAcrossEachOtherAddUp()
{
    const std::vector<std::shared_ptr<const Plane>> planes{planeKnownTo(Eigen::Vector3d::UnitX(), 0.003),
                                                           planeKnownTo(Eigen::Vector3d::UnitY(), 0.02),
                                                           planeKnownTo(Eigen::Vector3d::UnitZ(), 0.001)};

    const AxisStrength strength = axisStrength(planes);

    QVERIFY(isNear(strength.sigma[1].value(), 0.02));
    QVERIFY(isNear(strength.weakestSigma.value(), 0.02));
    QVERIFY(isNear(strength.information(2, 2), 1e6));
}

/// Across x with 1 mm, and across x + y with 1 mm: y = √2 (x + y)/√2 − x has √(2 + 1) mm.
void AxisStrengthTest::aSlantedPlaneTellsOfBoth()
{
    const std::vector<std::shared_ptr<const Plane>> planes{planeKnownTo(Eigen::Vector3d::UnitX(), 0.001),
                                                           planeKnownTo({1.0, 1.0, 0.0}, 0.001),
                                                           planeKnownTo(Eigen::Vector3d::UnitZ(), 0.001)};

    const AxisStrength strength = axisStrength(planes);

    QVERIFY(isNear(strength.sigma[0].value(), 0.001));
    QVERIFY(isNear(strength.sigma[1].value(), 0.001 * std::sqrt(3.0)));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::AxisStrengthTest)
#include "axis_strength_test.moc"
