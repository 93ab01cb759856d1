// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/end_point_cost.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <QtTest>

#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

constexpr double kFlatness = 0.005;

PlaneParameters withCost(PlaneCost cost)
{
    PlaneParameters parameters;
    parameters.cost = cost;
    parameters.flatness = kFlatness;
    return parameters;
}

Eigen::Matrix3d flattened(const Eigen::Matrix3d& covariance)
{
    return covariance + kFlatness * kFlatness * Eigen::Matrix3d::Identity();
}

/// A plane and an end point some centimetres off it, anywhere within some metres.
struct Case {
    explicit Case(Random& random)
        : normal(anyNormal(random)), distance(random.uniform(-5.0, 5.0)), tangents(tangentsOf(normal))
    {
        const Eigen::Vector3d beside = tangents * Eigen::Vector2d(random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0));
        point.position = beside + (distance + random.uniform(-0.05, 0.05)) * normal;
        point.covariance = anyCovariance(random, 0.02);
    }

    Eigen::Vector3d normal;
    double distance;
    Eigen::Matrix<double, 3, 2> tangents;
    EndPoint point;

    /// H of Eq. (17) at (2 tangent angles, d) from the plane; C^(-1/2) is the inverse of C's Cholesky factor.
    Eigen::Vector3d residual(const Eigen::Vector3d& x, PlaneCost cost) const
    {
        const Eigen::Vector3d n = (normal + tangents * x.head<2>()).normalized();
        const double r = n.dot(point.position) - (distance + x[2]);
        const Eigen::Matrix3d covariance = flattened(point.covariance);
        if (cost == PlaneCost::MaximumLikelihood)
            return {r / std::sqrt(n.dot(covariance * n)), 0.0, 0.0};
        return covariance.llt().matrixL().solve(r * n);
    }

    /// dH/dx by central differences.
    Eigen::Matrix3d jacobian(PlaneCost cost) const
    {
        constexpr double kStep = 1e-6;
        Eigen::Matrix3d columns;
        for (Eigen::Index i = 0; i < 3; ++i) {
            const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
            columns.col(i) = (residual(step, cost) - residual(-step, cost)) / (2.0 * kStep);
        }
        return columns;
    }

    EndPointEquations equations(PlaneCost cost) const
    {
        EndPointEquations sum;
        addEquations(normal, distance, tangents, point, withCost(cost), sum);
        return sum;
    }
};

}  // namespace

class EndPointCostTest : public QObject {
    Q_OBJECT

private slots:
    void tangentsAreOrthonormalWithEveryNormal();
    void maximumLikelihoodWeighsByTheVarianceAlongTheNormal();
    void footWeighsByTheInverseCovariance();
    void footIsNeverLessThanMaximumLikelihood();
    void footEqualsMaximumLikelihoodAlongAnAxisOfTheCovariance();
    void weightsAreFiniteWhereTheCovarianceIsSingular();
    void costIsTheWeightedSquaredDistance_data() { bothCosts(); }
    void costIsTheWeightedSquaredDistance();
    void gradientIsHalfTheDerivativeOfTheCost_data() { bothCosts(); }
    void gradientIsHalfTheDerivativeOfTheCost();
    void informationIsTheSquareOfTheJacobian_data() { bothCosts(); }
    void informationIsTheSquareOfTheJacobian();
    void informationIsRegularInThreeParameters_data() { bothCosts(); }
    void informationIsRegularInThreeParameters();

private:
    static void bothCosts()
    {
        QTest::addColumn<bool>("foot");
        QTest::newRow("ml") << false;
        QTest::newRow("foot") << true;
    }
    static PlaneCost costInForce()
    {
        QFETCH(bool, foot);
        return foot ? PlaneCost::Foot : PlaneCost::MaximumLikelihood;
    }
};

void EndPointCostTest::tangentsAreOrthonormalWithEveryNormal()
{
    Random random(1);
    std::vector<Eigen::Vector3d> normals;
    for (int axis = 0; axis < 3; ++axis) {
        normals.emplace_back(Eigen::Vector3d::Unit(axis));
        normals.emplace_back(-Eigen::Vector3d::Unit(axis));
        normals.emplace_back((Eigen::Vector3d::Ones() - Eigen::Vector3d::Unit(axis)).normalized());
    }
    normals.emplace_back(Eigen::Vector3d::Ones().normalized());
    for (int i = 0; i < 1000; ++i)
        normals.push_back(anyNormal(random));

    for (const Eigen::Vector3d& normal : normals) {
        Eigen::Matrix3d frame;
        frame << tangentsOf(normal), normal;
        QVERIFY((frame.transpose() * frame).isApprox(Eigen::Matrix3d::Identity(), 1e-14));
    }
}

void EndPointCostTest::maximumLikelihoodWeighsByTheVarianceAlongTheNormal()
{
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const Case c(random);

        const double weight = endPointWeight(c.normal, c.point, withCost(PlaneCost::MaximumLikelihood));

        const double variance = c.normal.dot(c.point.covariance * c.normal) + kFlatness * kFlatness;
        QVERIFY(std::abs(weight * variance - 1.0) < 1e-7);
    }
}

void EndPointCostTest::footWeighsByTheInverseCovariance()
{
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const Case c(random);

        const double weight = endPointWeight(c.normal, c.point, withCost(PlaneCost::Foot));

        const double expected = c.normal.dot(flattened(c.point.covariance).ldlt().solve(c.normal));
        QVERIFY(std::abs(weight / expected - 1.0) < 1e-6);
    }
}

void EndPointCostTest::footIsNeverLessThanMaximumLikelihood()
{
    Random random(4);
    double largestRatio = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const Case c(random);

        const double ml = endPointWeight(c.normal, c.point, withCost(PlaneCost::MaximumLikelihood));
        const double foot = endPointWeight(c.normal, c.point, withCost(PlaneCost::Foot));

        QVERIFY(foot >= ml * (1.0 - 1e-12));
        largestRatio = std::max(largestRatio, foot / ml);
    }
    QVERIFY(largestRatio > 2.0);
}

void EndPointCostTest::footEqualsMaximumLikelihoodAlongAnAxisOfTheCovariance()
{
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        Case c(random);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(c.point.covariance);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            c.normal = axes.eigenvectors().col(axis);

            const double ml = endPointWeight(c.normal, c.point, withCost(PlaneCost::MaximumLikelihood));
            const double foot = endPointWeight(c.normal, c.point, withCost(PlaneCost::Foot));

            QVERIFY(std::abs(foot / ml - 1.0) < 1e-9);
        }
    }
}

void EndPointCostTest::weightsAreFiniteWhereTheCovarianceIsSingular()
{
    const EndPoint onThePitchAxis{{1.0, 0.0, 0.0}, Eigen::Vector3d(1e-4, 0.0, 0.0).asDiagonal()};
    for (const PlaneCost cost : {PlaneCost::MaximumLikelihood, PlaneCost::Foot}) {
        PlaneParameters parameters = withCost(cost);
        parameters.flatness = 0.0;

        const double weight = endPointWeight(Eigen::Vector3d::UnitZ(), onThePitchAxis, parameters);

        QVERIFY(std::isfinite(weight));
        QVERIFY(weight > 0.0);
    }
}

void EndPointCostTest::costIsTheWeightedSquaredDistance()
{
    const PlaneCost cost = costInForce();
    Random random(6);
    EndPointEquations sum;
    double expected = 0.0;
    for (int i = 0; i < 50; ++i) {
        const Case c(random);
        const double residual = c.normal.dot(c.point.position) - c.distance;

        addEquations(c.normal, c.distance, c.tangents, c.point, withCost(cost), sum);

        expected += residual * residual * endPointWeight(c.normal, c.point, withCost(cost));
        QVERIFY(std::abs(sum.cost / expected - 1.0) < 1e-12);
    }
}

void EndPointCostTest::gradientIsHalfTheDerivativeOfTheCost()
{
    const PlaneCost cost = costInForce();
    constexpr double kStep = 1e-6;
    Random random(7);
    for (int i = 0; i < 200; ++i) {
        const Case c(random);

        const Eigen::Vector3d gradient = c.equations(cost).gradient;

        Eigen::Vector3d halfDerivative;
        for (Eigen::Index j = 0; j < 3; ++j) {
            const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(j);
            halfDerivative[j] =
                0.5 * (c.residual(step, cost).squaredNorm() - c.residual(-step, cost).squaredNorm()) / (2.0 * kStep);
        }
        const double size = std::sqrt(c.equations(cost).information.trace());
        QVERIFY((gradient - halfDerivative).norm() < 1e-5 * (gradient.norm() + size));
    }
}

void EndPointCostTest::informationIsTheSquareOfTheJacobian()
{
    const PlaneCost cost = costInForce();
    Random random(8);
    for (int i = 0; i < 200; ++i) {
        const Case c(random);

        const EndPointEquations equations = c.equations(cost);

        const Eigen::Matrix3d jacobian = c.jacobian(cost);
        QVERIFY(equations.information.isApprox(jacobian.transpose() * jacobian, 1e-6));
        const Eigen::Vector3d gradient = jacobian.transpose() * c.residual(Eigen::Vector3d::Zero(), cost);
        QVERIFY((equations.gradient - gradient).norm() < 1e-6 * (jacobian.norm() + gradient.norm()));
    }
}

void EndPointCostTest::informationIsRegularInThreeParameters()
{
    const PlaneCost cost = costInForce();
    Random random(9);
    const Case c(random);
    EndPointEquations sum;
    for (const Eigen::Vector2d& place :
         {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(0.0, 1.0)})
        addEquations(c.normal, c.distance, c.tangents, {c.distance * c.normal + c.tangents * place, c.point.covariance},
                     withCost(cost), sum);

    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(sum.information);

    QVERIFY(eigen.eigenvalues()[0] > 1e-3 * eigen.eigenvalues()[2]);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::EndPointCostTest)
#include "end_point_cost_test.moc"
