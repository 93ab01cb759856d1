// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/line_moments.h"

#include <random>
#include <vector>

#include <Eigen/Eigenvalues>
#include <QtTest>

#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

std::vector<Eigen::Vector2d> cloud(int count, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < count; ++i)
        points.emplace_back(4.0 + normal(random), 7.0 + 0.3 * normal(random));
    return points;
}

LineMoments direct(const std::vector<Eigen::Vector2d>& points)
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const auto& point : points)
        mean += point / static_cast<double>(points.size());
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const auto& point : points)
        scatter += (point - mean) * (point - mean).transpose();
    return {static_cast<double>(points.size()), mean.x(), mean.y(), scatter(0, 0), scatter(0, 1), scatter(1, 1)};
}

bool near(const LineMoments& a, const LineMoments& b)
{
    return a.count == b.count && std::abs(a.u - b.u) < 1e-12 && std::abs(a.v - b.v) < 1e-12 &&
           std::abs(a.uu - b.uu) < 1e-10 && std::abs(a.uv - b.uv) < 1e-10 && std::abs(a.vv - b.vv) < 1e-10;
}

}  // namespace

class LineMomentsTest : public QObject {
    Q_OBJECT

private slots:
    void pointsAddUp();
    void setsAddUp();
    void whatIsRemovedLeavesTheOthers();
    void theLineIsTheLargerEigenvector_data();
    void theLineIsTheLargerEigenvector();
    void pointsOnALineLeaveNothingAcross();
    void onePlaceHasNoDirection();
};

void LineMomentsTest::pointsAddUp()
{
    const auto points = cloud(40, 1);
    LineMoments moments;
    for (const auto& point : points)
        moments.add(point.x(), point.y());

    QVERIFY(near(moments, direct(points)));
}

void LineMomentsTest::setsAddUp()
{
    const auto points = cloud(40, 2);
    LineMoments moments = direct({points.begin(), points.begin() + 13});

    moments.add(direct({points.begin() + 13, points.end()}));

    QVERIFY(near(moments, direct(points)));
}

void LineMomentsTest::whatIsRemovedLeavesTheOthers()
{
    const auto points = cloud(10, 3);
    LineMoments moments = direct(points);

    moments.remove(points[9].x(), points[9].y());
    moments.remove(points[8].x(), points[8].y());

    QVERIFY(near(moments, direct({points.begin(), points.begin() + 8})));
}

void LineMomentsTest::theLineIsTheLargerEigenvector_data()
{
    QTest::addColumn<double>("turn");

    for (const double turn : {0.0, 20.0, 45.0, 90.0, 135.0, 170.0})
        QTest::newRow(qPrintable(QString::number(turn))) << turn;
}

void LineMomentsTest::theLineIsTheLargerEigenvector()
{
    QFETCH(const double, turn);
    const Eigen::Rotation2Dd rotation(degrees(turn));
    auto points = cloud(50, 4);
    for (auto& point : points)
        point = rotation * point;
    const LineMoments moments = direct(points);
    Eigen::Matrix2d scatter;
    scatter << moments.uu, moments.uv, moments.uv, moments.vv;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(scatter);

    const MomentLine line = lineOf(moments);

    const Eigen::Vector2d direction{line.directionU, line.directionV};
    QVERIFY(std::abs(direction.norm() - 1.0) < 1e-12);
    QVERIFY(std::abs(direction.dot(eigen.eigenvectors().col(1))) > 1.0 - 1e-12);
    QVERIFY(std::abs(line.along - eigen.eigenvalues()[1]) < 1e-10);
    QVERIFY(std::abs(line.across - eigen.eigenvalues()[0]) < 1e-10);
}

void LineMomentsTest::pointsOnALineLeaveNothingAcross()
{
    const LineMoments moments = direct({{1.0, 2.0}, {2.0, 4.0}, {4.0, 8.0}});

    const MomentLine line = lineOf(moments);

    QVERIFY(line.across < 1e-14);
    QVERIFY(std::abs(line.directionV / line.directionU - 2.0) < 1e-12);
}

void LineMomentsTest::onePlaceHasNoDirection()
{
    const MomentLine line = lineOf({3.0, 1.0, 2.0, 0.0, 0.0, 0.0});

    QCOMPARE(line.along, 0.0);
    QCOMPARE(line.across, 0.0);
    QVERIFY(std::abs(std::hypot(line.directionU, line.directionV) - 1.0) < 1e-12);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::LineMomentsTest)
#include "line_moments_test.moc"
