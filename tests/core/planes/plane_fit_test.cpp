// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_fit.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <QtTest>

#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

PlaneParameters exacting(PlaneCost cost = PlaneCost::MaximumLikelihood)
{
    PlaneParameters parameters;
    parameters.cost = cost;
    parameters.flatness = 0.005;
    parameters.refineTolerance = 1e-15;
    parameters.refineIterations = 100;
    return parameters;
}

/// A plane n·p = d, and end points on it or near it.
struct Patch {
    Eigen::Vector3d normal;
    double distance = 0.0;
    std::vector<EndPoint> points;

    PlaneFit truth() const
    {
        PlaneFit fit;
        fit.normal = normal;
        fit.distance = distance;
        fit.tangents = tangentsOf(normal);
        return fit;
    }
};

/// Points within ±2 m on a plane a few metres away, each with a covariance of its own, without noise.
Patch exactPatch(Random& random, int count = 40)
{
    Patch patch{anyNormal(random), random.uniform(1.0, 6.0), {}};
    const auto tangents = tangentsOf(patch.normal);
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector2d place{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)};
        patch.points.push_back({patch.distance * patch.normal + tangents * place, anyCovariance(random, 0.01)});
    }
    return patch;
}

/// The same with noise of just these covariances.
Patch noisyPatch(Random& random, int count = 40)
{
    Patch patch = exactPatch(random, count);
    for (EndPoint& point : patch.points)
        point.position += point.covariance.llt().matrixL() * anyVector(random);
    return patch;
}

PlaneFit turned(const PlaneFit& fit, const Eigen::Vector3d& x)
{
    PlaneFit moved = fit;
    moved.normal = (fit.normal + fit.tangents * x.head<2>()).normalized();
    moved.distance = fit.distance + x[2];
    return moved;
}

/// E of Eq. (16), or its maximum-likelihood twin, from the paper's own formula.
double errorAt(const PlaneFit& fit, const std::vector<EndPoint>& points, const PlaneParameters& parameters)
{
    double sum = 0.0;
    for (const EndPoint& point : points) {
        const Eigen::Matrix3d covariance =
            point.covariance + parameters.flatness * parameters.flatness * Eigen::Matrix3d::Identity();
        const double residual = fit.normal.dot(point.position) - fit.distance;
        const Eigen::Vector3d toFoot = residual * fit.normal;
        sum += parameters.cost == PlaneCost::Foot ? toFoot.dot(covariance.ldlt().solve(toFoot))
                                                  : residual * residual / fit.normal.dot(covariance * fit.normal);
    }
    return sum / static_cast<double>(points.size());
}

/// Newton's method on E with numeric first and second derivatives: slow, and knows nothing of Table VI.
PlaneFit slowMinimum(PlaneFit fit, const std::vector<EndPoint>& points, const PlaneParameters& parameters)
{
    constexpr double kStep = 1e-4;
    const auto at = [&](const Eigen::Vector3d& x) { return errorAt(turned(fit, x), points, parameters); };
    for (int round = 0; round < 30; ++round) {
        fit.tangents = tangentsOf(fit.normal);
        Eigen::Vector3d gradient;
        Eigen::Matrix3d hessian;
        for (Eigen::Index i = 0; i < 3; ++i) {
            const Eigen::Vector3d a = kStep * Eigen::Vector3d::Unit(i);
            // Two step widths take out the error of the third derivative.
            gradient[i] = (8.0 * (at(a) - at(-a)) - (at(2.0 * a) - at(-2.0 * a))) / (12.0 * kStep);
            for (Eigen::Index j = 0; j < 3; ++j) {
                const Eigen::Vector3d b = kStep * Eigen::Vector3d::Unit(j);
                hessian(i, j) = (at(a + b) - at(a - b) - at(b - a) + at(-a - b)) / (4.0 * kStep * kStep);
            }
        }
        fit = turned(fit, -hessian.ldlt().solve(gradient));
    }
    return fit;
}

WeightedSums sumsOf(const std::vector<EndPoint>& points, const std::vector<double>& weights)
{
    WeightedSums sums;
    for (std::size_t i = 0; i < points.size(); ++i)
        sums.add(points[i].position, weights[i]);
    return sums;
}

std::vector<double> anyWeights(Random& random, std::size_t count)
{
    std::vector<double> weights;
    for (std::size_t i = 0; i < count; ++i)
        weights.push_back(random.uniform(100.0, 10000.0));
    return weights;
}

}  // namespace

class PlaneFitTest : public QObject {
    Q_OBJECT

private slots:
    void leastSquaresIsTheThinnestDirectionOfTheCentredPoints();
    void leastSquaresIsExactOnAnExactPlane();
    void leastSquaresFindsAPlaneFarFromTheOriginAsWellAsNearIt();
    void normalKeepsItsSide();
    void informationIsTheSecondDerivativeOfTheSquares();
    void sumsOfPartsAddUp();
    void meanErrorIsTheWeightedMeanSquare();
    void meanErrorOfNothingIsZero();
    void covarianceIsTheInverseOfTheInformation();
    void covarianceOfASingularInformationIsZero();
    void largestNormalVarianceIsTheLargestEigenvalue();
    void refinementFindsTheMinimum_data() { bothCosts(); }
    void refinementFindsTheMinimum();
    void refinementIsExactWithoutNoise_data() { bothCosts(); }
    void refinementIsExactWithoutNoise();
    void refinementNeverEndsWorseThanItBegan_data() { bothCosts(); }
    void refinementNeverEndsWorseThanItBegan();
    void refinementStopsAtTheMostIterations();
    void refinementStopsEarlierWhereItMaySettleForLess();
    void refinementTellsTheTrueError_data() { bothCosts(); }
    void refinementTellsTheTrueError();
    void refinementOfNothingChangesNothing();
    void errorOfAPerfectPlaneIsOneWithMaximumLikelihood();
    void covarianceIsHonest();

private:
    static void bothCosts()
    {
        QTest::addColumn<bool>("foot");
        QTest::newRow("ml") << false;
        QTest::newRow("foot") << true;
    }
    static PlaneParameters parametersInForce()
    {
        QFETCH(bool, foot);
        return exacting(foot ? PlaneCost::Foot : PlaneCost::MaximumLikelihood);
    }
};

void PlaneFitTest::leastSquaresIsTheThinnestDirectionOfTheCentredPoints()
{
    Random random(21);
    for (int trial = 0; trial < 50; ++trial) {
        const Patch patch = noisyPatch(random, 12);
        const std::vector<double> weights = anyWeights(random, patch.points.size());

        const PlaneFit fit = fitPlane(sumsOf(patch.points, weights), patch.normal);

        double total = 0.0;
        Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < weights.size(); ++i) {
            total += weights[i];
            centroid += weights[i] * patch.points[i].position;
        }
        centroid /= total;
        Eigen::MatrixX3d rows(weights.size(), 3);
        for (std::size_t i = 0; i < weights.size(); ++i)
            rows.row(static_cast<Eigen::Index>(i)) = std::sqrt(weights[i]) * (patch.points[i].position - centroid);
        const Eigen::Vector3d thinnest =
            Eigen::JacobiSVD<Eigen::MatrixX3d, Eigen::ColPivHouseholderQRPreconditioner>(rows, Eigen::ComputeFullV)
                .matrixV()
                .col(2);
        QVERIFY(fit.normal.cross(thinnest).norm() < 1e-10);
        QVERIFY(std::abs(fit.distance - fit.normal.dot(centroid)) < 1e-10);
        QVERIFY(std::abs(fit.normal.norm() - 1.0) < 1e-14);
    }
}

void PlaneFitTest::leastSquaresIsExactOnAnExactPlane()
{
    Random random(22);
    for (int trial = 0; trial < 50; ++trial) {
        const Patch patch = exactPatch(random, 6);

        const PlaneFit fit = fitPlane(sumsOf(patch.points, std::vector<double>(6, 1.0)), patch.normal);

        QVERIFY(angleBetween(fit.normal, patch.normal) < 1e-12);
        QVERIFY(std::abs(fit.distance - patch.distance) < 1e-12);
        QVERIFY(fit.error < 1e-12);
    }
}

void PlaneFitTest::leastSquaresFindsAPlaneFarFromTheOriginAsWellAsNearIt()
{
    // Symmetric about the wall y = d: least squares leaves it there, while the least Σ r²/(1 + d²) would not.
    for (const double distance : {0.0, 1.0, 30.0}) {
        WeightedSums sums;
        for (const double x : {-1.0, 1.0}) {
            for (const double z : {-1.0, 1.0})
                sums.add({x, distance + 0.1 * x * z, z}, 1.0);
        }

        const PlaneFit fit = fitPlane(sums, Eigen::Vector3d::UnitY());

        QVERIFY(angleBetween(fit.normal, Eigen::Vector3d::UnitY()) < 1e-12);
        QVERIFY(std::abs(fit.distance - distance) < 1e-12);
        QVERIFY(std::abs(fit.error - 0.01) < 1e-12);
    }
}

void PlaneFitTest::normalKeepsItsSide()
{
    Random random(23);
    const Patch patch = noisyPatch(random);
    const WeightedSums sums = sumsOf(patch.points, anyWeights(random, patch.points.size()));

    const PlaneFit there = fitPlane(sums, patch.normal);
    const PlaneFit back = fitPlane(sums, -patch.normal);

    QVERIFY(there.normal.dot(patch.normal) > 0.99);
    QVERIFY(there.distance > 0.0);
    QVERIFY(back.normal.dot(patch.normal) < -0.99);
    QVERIFY(back.distance < 0.0);
}

void PlaneFitTest::informationIsTheSecondDerivativeOfTheSquares()
{
    constexpr double kStep = 1e-4;
    Random random(24);
    const Patch patch = exactPatch(random);
    const std::vector<double> weights = anyWeights(random, patch.points.size());

    const PlaneFit fit = fitPlane(sumsOf(patch.points, weights), patch.normal);

    const auto halfSquares = [&](const Eigen::Vector3d& x) {
        const PlaneFit moved = turned(fit, x);
        double sum = 0.0;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const double residual = moved.normal.dot(patch.points[i].position) - moved.distance;
            sum += 0.5 * weights[i] * residual * residual;
        }
        return sum;
    };
    Eigen::Matrix3d second;
    for (Eigen::Index i = 0; i < 3; ++i) {
        for (Eigen::Index j = 0; j < 3; ++j) {
            const Eigen::Vector3d a = kStep * Eigen::Vector3d::Unit(i);
            const Eigen::Vector3d b = kStep * Eigen::Vector3d::Unit(j);
            second(i, j) = (halfSquares(a + b) - halfSquares(a - b) - halfSquares(b - a) + halfSquares(-a - b)) /
                           (4.0 * kStep * kStep);
        }
    }
    QVERIFY(fit.information.isApprox(second, 1e-6));
}

void PlaneFitTest::sumsOfPartsAddUp()
{
    Random random(25);
    const Patch patch = noisyPatch(random);
    const std::vector<double> weights = anyWeights(random, patch.points.size());
    WeightedSums first;
    WeightedSums second;
    for (std::size_t i = 0; i < weights.size(); ++i)
        (i % 3 == 0 ? first : second).add(patch.points[i].position, weights[i]);

    first += second;

    const WeightedSums all = sumsOf(patch.points, weights);
    QCOMPARE(first.points, static_cast<int>(weights.size()));
    QVERIFY(std::abs(first.weight / all.weight - 1.0) < 1e-14);
    QVERIFY(first.first.isApprox(all.first, 1e-13));
    QVERIFY(first.second.isApprox(all.second, 1e-13));
}

void PlaneFitTest::meanErrorIsTheWeightedMeanSquare()
{
    // 1 m above z = 2 with weight 2 and 3 m below it with weight 1: (2·1 + 1·9)/2.
    WeightedSums sums;
    sums.add({5.0, 1.0, 3.0}, 2.0);
    sums.add({-4.0, 2.0, -1.0}, 1.0);

    const double error = sums.meanError(Eigen::Vector3d::UnitZ(), 2.0);

    QVERIFY(std::abs(error - 5.5) < 1e-14);
}

void PlaneFitTest::meanErrorOfNothingIsZero()
{
    QCOMPARE(WeightedSums{}.meanError(Eigen::Vector3d::UnitX(), 1.0), 0.0);
}

void PlaneFitTest::covarianceIsTheInverseOfTheInformation()
{
    Random random(26);
    PlaneFit fit;
    fit.information = anyCovariance(random, 100.0);

    const Eigen::Matrix3d covariance = covarianceOf(fit);

    QVERIFY((covariance * fit.information).isApprox(Eigen::Matrix3d::Identity(), 1e-9));
}

void PlaneFitTest::covarianceOfASingularInformationIsZero()
{
    PlaneFit fit;
    fit.information = Eigen::Vector3d(4.0, 0.0, 1.0).asDiagonal();

    QVERIFY(covarianceOf(fit).isZero(0.0));
}

void PlaneFitTest::largestNormalVarianceIsTheLargestEigenvalue()
{
    // Principal variances 9 and 4, at 30°; the third row and column have no say.
    const double c = std::cos(degrees(30.0));
    const double s = std::sin(degrees(30.0));
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Constant(0.7);
    covariance.topLeftCorner<2, 2>() << 9.0 * c * c + 4.0 * s * s, 5.0 * c * s, 5.0 * c * s, 9.0 * s * s + 4.0 * c * c;

    QVERIFY(std::abs(largestNormalVariance(covariance) - 9.0) < 1e-13);
}

void PlaneFitTest::refinementFindsTheMinimum()
{
    const PlaneParameters parameters = parametersInForce();
    Random random(27);
    for (int trial = 0; trial < 20; ++trial) {
        const Patch patch = noisyPatch(random);
        const PlaneFit start = turned(patch.truth(), {0.05, -0.03, 0.02});

        const PlaneFit fit = refinePlane(start, patch.points, parameters);

        const PlaneFit minimum = slowMinimum(patch.truth(), patch.points, parameters);
        QVERIFY(angleBetween(fit.normal, minimum.normal) < 1e-8);
        QVERIFY(std::abs(fit.distance - minimum.distance) < 1e-8);
        QVERIFY(std::abs(fit.error / errorAt(minimum, patch.points, parameters) - 1.0) < 1e-6);
    }
}

void PlaneFitTest::refinementIsExactWithoutNoise()
{
    const PlaneParameters parameters = parametersInForce();
    Random random(28);
    for (int trial = 0; trial < 20; ++trial) {
        const Patch patch = exactPatch(random);
        const PlaneFit start = turned(patch.truth(), {degrees(5.0), degrees(-3.0), 0.1});

        const PlaneFit fit = refinePlane(start, patch.points, parameters);

        QVERIFY(angleBetween(fit.normal, patch.normal) < 1e-10);
        QVERIFY(std::abs(fit.distance - patch.distance) < 1e-10);
        QVERIFY(fit.error < 1e-12);
    }
}

void PlaneFitTest::refinementNeverEndsWorseThanItBegan()
{
    const PlaneParameters parameters = parametersInForce();
    Random random(29);
    for (int trial = 0; trial < 200; ++trial) {
        const Patch patch = noisyPatch(random, 8);
        const PlaneFit start =
            turned(patch.truth(), {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)});

        const PlaneFit fit = refinePlane(start, patch.points, parameters);

        QVERIFY(fit.error <= errorAt(start, patch.points, parameters) * (1.0 + 1e-9));
        QVERIFY(std::abs(fit.normal.norm() - 1.0) < 1e-14);
        QVERIFY(fit.tangents == tangentsOf(fit.normal));
    }
}

void PlaneFitTest::refinementStopsAtTheMostIterations()
{
    Random random(30);
    const Patch patch = noisyPatch(random);
    const PlaneFit start = turned(patch.truth(), {0.2, -0.2, 0.3});
    double before = errorAt(start, patch.points, exacting());
    for (int most = 1; most <= 4; ++most) {
        PlaneParameters parameters = exacting();
        parameters.refineIterations = most;

        const PlaneFit fit = refinePlane(start, patch.points, parameters);

        QVERIFY(fit.iterations <= most);
        QVERIFY(fit.error <= before);
        before = fit.error;
    }
}

void PlaneFitTest::refinementStopsEarlierWhereItMaySettleForLess()
{
    Random random(31);
    const Patch patch = noisyPatch(random);
    const PlaneFit start = turned(patch.truth(), {0.2, -0.2, 0.3});
    PlaneParameters coarse = exacting();
    coarse.refineTolerance = 0.1;

    const PlaneFit quick = refinePlane(start, patch.points, coarse);
    const PlaneFit thorough = refinePlane(start, patch.points, exacting());

    QVERIFY(quick.iterations < thorough.iterations);
    QVERIFY(thorough.iterations < exacting().refineIterations);
    QVERIFY(thorough.error <= quick.error);
}

void PlaneFitTest::refinementTellsTheTrueError()
{
    PlaneParameters parameters = parametersInForce();
    Random random(32);
    const Patch patch = noisyPatch(random);
    const PlaneFit start = turned(patch.truth(), {0.1, 0.1, 0.2});
    for (const int most : {1, 2, 100}) {
        parameters.refineIterations = most;

        const PlaneFit fit = refinePlane(start, patch.points, parameters);

        QVERIFY(std::abs(fit.error / errorAt(fit, patch.points, parameters) - 1.0) < 1e-6);
    }
}

void PlaneFitTest::refinementOfNothingChangesNothing()
{
    PlaneFit start;
    start.normal = Eigen::Vector3d::UnitX();
    start.distance = 2.0;

    const PlaneFit fit = refinePlane(start, {}, exacting());

    QVERIFY(fit.normal == start.normal);
    QCOMPARE(fit.distance, 2.0);
    QCOMPARE(fit.error, 0.0);
}

void PlaneFitTest::errorOfAPerfectPlaneIsOneWithMaximumLikelihood()
{
    // Expected (N − 3)/N; the mean over 100 planes of 200 points strays by sqrt(2/20000) = 0.01.
    PlaneParameters parameters = exacting();
    parameters.flatness = 0.0;
    Random random(33);
    double sum = 0.0;
    for (int trial = 0; trial < 100; ++trial) {
        const Patch patch = noisyPatch(random, 200);
        sum += refinePlane(patch.truth(), patch.points, parameters).error;
    }

    QVERIFY(std::abs(sum / 100.0 - 197.0 / 200.0) < 0.04);
}

void PlaneFitTest::covarianceIsHonest()
{
    // The squared error in units of the reported covariance has three degrees of freedom: mean 3, and over 600 planes
    // a standard deviation of the mean of sqrt(6/600) = 0.1.
    PlaneParameters parameters = exacting();
    parameters.flatness = 0.0;
    constexpr int kTrials = 600;
    Random random(34);
    double sum = 0.0;
    for (int trial = 0; trial < kTrials; ++trial) {
        const Patch patch = noisyPatch(random);

        const PlaneFit fit = refinePlane(patch.truth(), patch.points, parameters);

        Eigen::Vector3d off;
        off << fit.tangents.transpose() * patch.normal, patch.distance - fit.distance;
        sum += off.dot(covarianceOf(fit).ldlt().solve(off));
    }

    QVERIFY(std::abs(sum / kTrials - 3.0) < 0.4);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PlaneFitTest)
#include "plane_fit_test.moc"
