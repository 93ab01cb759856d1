// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/opponents.h"

#include <cmath>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/benchmarks/opponents/ball_accumulator.h"
#include "tests/benchmarks/opponents/connected_voxels.h"
#include "tests/benchmarks/opponents/labelled_points.h"
#include "tests/benchmarks/opponents/normal_clusters.h"
#include "tests/benchmarks/opponents/opponent_run.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A box of 6 m × 5 m × 2.6 m about the sensor without its back: five planes, nothing else.
Scene box()
{
    Scene scene;
    const auto face = [&](const Eigen::Vector3d& corner, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
                          const Eigen::Vector3d& normal) {
        const int id = static_cast<int>(scene.planes.size());
        scene.rectangles.push_back({corner, u, v, id, 0.0});
        scene.planes.push_back({id, "face", normal, normal.dot(corner)});
    };
    const Eigen::Vector3d low{-3.0, -1.0, -1.0};
    const Eigen::Vector3d high{3.0, 4.0, 1.6};
    const Eigen::Vector3d x{6.0, 0.0, 0.0};
    const Eigen::Vector3d y{0.0, 5.0, 0.0};
    const Eigen::Vector3d z{0.0, 0.0, 2.6};
    face(low, x, y, -Eigen::Vector3d::UnitZ());
    face(low, y, z, -Eigen::Vector3d::UnitX());
    face(high, -x, -y, Eigen::Vector3d::UnitZ());
    face(high, -x, -z, Eigen::Vector3d::UnitY());
    face(high, -y, -z, Eigen::Vector3d::UnitX());
    return scene;
}

}  // namespace

class OpponentsTest : public QObject {
    Q_OBJECT

private slots:
    void everyOpponentFindsTheFacesOfABox();
    void theSameScanGivesTheSamePlanes();
    void leastSquaresMergesTheHalvesOfAWall();
    void pointsBesideAPlaneGetItsLabel();
    void groupsEndWhereTheGapIsWider();
    void normalsClusterByDirection();
    void votesForOnePlaneMeetInOneCell();
    void theBallHasNoFavouredDirection();
};

void OpponentsTest::everyOpponentFindsTheFacesOfABox()
{
    const SimulationNoise noise = *simulationNoise("default");
    const Scene scene = box();
    const SimulatedScan scan = simulate(scene, *acquisitionSettings("table8"), noise, 1);
    const Judge judge(scene, scan, noise, 200);
    const PointScan points = pointScanOf(scan.recording, noise);

    for (const auto& opponent : makeOpponents()) {
        const OpponentRun run = runOpponent(*opponent, points, judge, 1);

        QVERIFY2(run.score.at80.recall() == 1.0, opponent->name().data());
        for (const FoundPlane& plane : run.score.found) {
            QVERIFY2(plane.angle < degrees(0.3), opponent->name().data());
            QVERIFY2(plane.distance < 0.01, opponent->name().data());
        }
    }
}

void OpponentsTest::theSameScanGivesTheSamePlanes()
{
    const SimulationNoise noise = *simulationNoise("default");
    const SimulatedScan scan = simulate(*makeScene("office", 7), *acquisitionSettings("table10-1"), noise, 7);
    const PointScan points = pointScanOf(scan.recording, noise);

    for (const auto& opponent : makeOpponents()) {
        const OpponentResult first = opponent->extract(points);
        const OpponentResult second = opponent->extract(points);

        QVERIFY2(first.labels == second.labels, opponent->name().data());
        QCOMPARE(first.planes.size(), second.planes.size());
        for (std::size_t i = 0; i < first.planes.size(); ++i) {
            QVERIFY2(first.planes[i].normal == second.planes[i].normal, opponent->name().data());
            QVERIFY2(first.planes[i].distance == second.planes[i].distance, opponent->name().data());
        }
    }
}

namespace {

/// A wall y = 2 seen by 10 slices of 20 beams, exact.
PointScan wall()
{
    PointScan scan;
    scan.slices = 10;
    scan.beams = 20;
    for (int slice = 0; slice < scan.slices; ++slice) {
        for (int beam = 0; beam < scan.beams; ++beam) {
            scan.grid.push_back(static_cast<int>(scan.points.size()));
            scan.points.emplace_back(0.1 * beam - 1.0, 2.0, 0.1 * slice - 0.5);
            scan.slice.push_back(slice);
            scan.beam.push_back(beam);
        }
    }
    scan.noise.rangeConstant = 0.01;
    scan.medianRange = 2.2;
    scan.minReturns = 10;
    return scan;
}

}  // namespace

void OpponentsTest::leastSquaresMergesTheHalvesOfAWall()
{
    const PointScan scan = wall();
    OpponentResult result;
    result.planes.resize(2);
    for (const int beam : scan.beam)
        result.labels.push_back(beam < 10 ? 0 : 1);

    finishPlanes(scan, {}, result);

    QCOMPARE(result.planes.size(), std::size_t(1));
    QVERIFY(std::abs(std::abs(result.planes.front().normal.y()) - 1.0) < 1e-12);
    QVERIFY(std::abs(std::abs(result.planes.front().distance) - 2.0) < 1e-12);
    QVERIFY(std::all_of(result.labels.begin(), result.labels.end(), [](int label) { return label == 0; }));
}

void OpponentsTest::pointsBesideAPlaneGetItsLabel()
{
    PointScan scan = wall();
    OpponentResult result;
    result.planes.push_back({Eigen::Vector3d::UnitY(), 2.0});
    result.labels.assign(scan.points.size(), 0);
    result.labels[45] = -1;
    result.labels[46] = -1;
    scan.points[46].y() = 2.1;  // ten standard deviations off

    completeLabels(scan, result);

    QCOMPARE(result.labels[45], 0);
    QCOMPARE(result.labels[46], -1);
}

void OpponentsTest::groupsEndWhereTheGapIsWider()
{
    std::vector<Eigen::Vector3d> points;
    for (const double x : {0.0, 0.1, 0.2, 0.3, 1.3, 1.4})
        points.emplace_back(x, 0.0, 0.0);

    const auto groups = connectedGroups(points, {0, 1, 2, 3, 4, 5}, 0.2);

    QCOMPARE(groups.size(), std::size_t(2));
    QCOMPARE(groups[0], (std::vector<int>{0, 1, 2, 3}));
    QCOMPARE(groups[1], (std::vector<int>{4, 5}));
}

void OpponentsTest::normalsClusterByDirection()
{
    std::vector<Eigen::Vector3d> normals(7, Eigen::Vector3d{0.0, 0.0, 1.0});
    normals[1] = Eigen::Vector3d{0.05, 0.0, 1.0}.normalized();
    normals[4] = {1.0, 0.0, 0.0};
    normals[5] = {0.0, 0.0, 0.0};  // none
    normals[6] = {0.0, 0.0, -1.0};

    const auto clusters = clustersOfNormals(normals, degrees(10.0), 1);

    QCOMPARE(clusters.size(), std::size_t(3));
    QCOMPARE(clusters[0], (std::vector<int>{0, 1, 2, 3}));
}

void OpponentsTest::votesForOnePlaneMeetInOneCell()
{
    BallAccumulator accumulator(degrees(5.0), 0.1, 10.0);
    const Eigen::Vector3d normal = Eigen::Vector3d{0.5, 0.6, 0.62}.normalized();

    accumulator.vote(normal, 3.03);
    const BallAccumulator::Cell* cell = accumulator.vote(normal, 3.05);

    QVERIFY(cell != nullptr);
    QCOMPARE(cell->votes, 2);
    QVERIFY(std::abs(cell->distances / cell->votes - 3.04) < 1e-12);
    QCOMPARE(accumulator.vote(normal, 4.0)->votes, 1);
    QVERIFY(accumulator.vote(normal, 11.0) == nullptr);
    accumulator.clear();
    QCOMPARE(accumulator.vote(normal, 3.04)->votes, 1);
}

void OpponentsTest::theBallHasNoFavouredDirection()
{
    // Evenly spread directions: in cells of like size the fullest has few times the mean, at the poles as elsewhere.
    constexpr int kDirections = 200000;
    BallAccumulator accumulator(degrees(10.0), 1.0, 1.0);
    int most = 0;
    for (int i = 0; i < kDirections; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / kDirections;  // Fibonacci sphere
        const double turn = 2.399963229728653 * i;
        const double r = std::sqrt(1.0 - z * z);
        most = std::max(most, accumulator.vote({r * std::cos(turn), r * std::sin(turn), z}, 0.5)->votes);
    }

    // The sphere has 4 π / (10°)² = 412 such cells.
    QVERIFY(most < 1.5 * kDirections / 412.0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::OpponentsTest)
#include "opponents_test.moc"
