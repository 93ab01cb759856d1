// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/stop_tree.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <QtTest>

#include "tests/core/mapping/known_planes.h"
#include "tests/core/mapping/simulated_floor.h"
#include "tests/test_program.h"

namespace planewright {

class StopTreeTest : public QObject {
    Q_OBJECT

private slots:
    void theCommonAncestorIsThatOfAPlainSearch();
    void variancesAddUpAlongTheWay();
    void aTurnWeighsMoreFarAway();
    void aClosedLoopIsAWay();
    void aDriftIsSharedOutByWhatEachPieceMayBeOff();
};

namespace {

Matrix6d covarianceOf(double turn, double shift)
{
    Vector6d variances;
    variances << Eigen::Vector3d::Constant(square(turn)), Eigen::Vector3d::Constant(square(shift));
    return variances.asDiagonal();
}

const Eigen::Vector3d kOrigin = Eigen::Vector3d::Zero();

/// A chain of stops, a metre each, without turns.
StopTree chainOf(int stops, double shift)
{
    StopTree tree;
    tree.addRoot();
    for (int i = 1; i < stops; ++i)
        tree.add(static_cast<std::size_t>(i - 1), {static_cast<double>(i), 0.0, 0.0}, covarianceOf(1e-9, shift));
    return tree;
}

}  // namespace

void StopTreeTest::theCommonAncestorIsThatOfAPlainSearch()
{
    Random random(3);
    StopTree tree;
    tree.addRoot();
    for (int i = 1; i < 200; ++i)
        tree.add(static_cast<std::size_t>(random.integer(std::max(0, i - 8), i - 1)), kOrigin,
                 covarianceOf(1e-3, 1e-3));

    for (std::size_t a = 0; a < tree.size(); a += 7) {
        for (std::size_t b = 0; b < tree.size(); b += 5) {
            std::size_t x = a;
            std::size_t y = b;
            while (x != y)  // a parent's number is the smaller one
                (x > y ? x : y) = tree.parentOf(std::max(x, y));
            QCOMPARE(tree.commonAncestor(a, b), x);
        }
    }
}

void StopTreeTest::variancesAddUpAlongTheWay()
{
    const StopTree tree = chainOf(10, 0.01);

    QVERIFY(std::abs(tree.between(2, 6, kOrigin)(3, 3) - 4.0e-4) < 1e-12);
    QVERIFY(tree.between(4, 4, kOrigin).norm() < 1e-12);
}

/// A turn of the stop at (5, 0) moves what stands at (8, 0) along y.
void StopTreeTest::aTurnWeighsMoreFarAway()
{
    StopTree tree;
    tree.addRoot();
    tree.add(0, {5.0, 0.0, 0.0}, covarianceOf(1e-3, 1e-2));

    QVERIFY(std::abs(tree.between(0, 1, {5.0, 0.0, 0.0})(4, 4) - 1e-4) < 1e-12);
    QVERIFY(std::abs(tree.between(0, 1, {8.0, 0.0, 0.0})(4, 4) - (1e-4 + 9.0e-6)) < 1e-12);
}

void StopTreeTest::aClosedLoopIsAWay()
{
    StopTree tree = chainOf(10, 0.01);
    QVERIFY(!tree.isLinked(1, 9, kOrigin));

    tree.link(9, 0, kOrigin, covarianceOf(1e-9, 0.001));

    QVERIFY(tree.isLinked(1, 9, kOrigin));
    QVERIFY(std::abs(tree.between(1, 9, kOrigin)(3, 3) - (1e-4 + 1e-6)) < 1e-12);
    QVERIFY(!tree.isLinked(1, 2, kOrigin));
}

/// Four pieces of the way, the third known ten times worse; a stop that hangs on the way moves with it.
void StopTreeTest::aDriftIsSharedOutByWhatEachPieceMayBeOff()
{
    StopTree tree;
    tree.addRoot();
    for (std::size_t i = 1; i <= 4; ++i)
        tree.add(i - 1, kOrigin, covarianceOf(1e-3, i == 3 ? 0.1 : 0.01));
    tree.add(3, kOrigin, covarianceOf(1e-3, 0.01));
    Vector6d drift = Vector6d::Zero();
    drift[3] = 0.103;  // the variances are 1, 1, 100, 1

    const std::vector<Vector6d> corrections = tree.corrections(4, 0, drift);

    QVERIFY(corrections[0].isZero(0.0));
    QVERIFY(std::abs(corrections[1][3] - 0.001) < 1e-9);
    QVERIFY(std::abs(corrections[2][3] - 0.002) < 1e-9);
    QVERIFY(std::abs(corrections[3][3] - 0.102) < 1e-9);
    QVERIFY(std::abs(corrections[4][3] - 0.103) < 1e-9);
    QVERIFY(std::abs(corrections[5][3] - 0.102) < 1e-9);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::StopTreeTest)
#include "stop_tree_test.moc"
