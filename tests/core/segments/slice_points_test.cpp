// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/slice_points.h"

#include <cmath>
#include <random>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <QtTest>

#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A total-least-squares line the long way: eigenvectors of the scatter about the mean.
struct BruteLine {
    int points = 0;
    Eigen::Vector2d centroid = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    double largest = 0.0;
    double smallest = 0.0;
};

BruteLine bruteLine(const SlicePoints& points, const PointRun& run)
{
    BruteLine line;
    for (int beam = run.first; beam <= run.last; ++beam) {
        if (!points.hasEcho(beam))
            continue;
        line.centroid += points[beam];
        ++line.points;
    }
    line.centroid /= line.points;
    for (int beam = run.first; beam <= run.last; ++beam) {
        if (!points.hasEcho(beam))
            continue;
        const Eigen::Vector2d offset = points[beam] - line.centroid;
        line.covariance += offset * offset.transpose() / line.points;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(line.covariance);
    line.smallest = solver.eigenvalues()[0];
    line.largest = solver.eigenvalues()[1];
    return line;
}

ScanSlice randomSlice(int beams, double missingShare, std::mt19937_64& random)
{
    ScanSlice slice = emptySlice(degrees(-45.0), degrees(0.25), beams);
    double range = 5.0;
    for (double& value : slice.ranges) {
        range = std::clamp(range + 0.2 * normal(random), 0.5, 20.0);
        value = uniform(random) < missingShare ? 0.0 : range;
    }
    return slice;
}

bool samePoints(const SlicePoints& a, const SlicePoints& b)
{
    if (a.beams() != b.beams() || a.echoes() != b.echoes())
        return false;
    for (int beam = 0; beam < a.beams(); ++beam) {
        if (a.hasEcho(beam) != b.hasEcho(beam) || a.range(beam) != b.range(beam) || a[beam] != b[beam] ||
            a.varianceAcross(beam, {0.6, 0.8}) != b.varianceAcross(beam, {0.6, 0.8}))
            return false;
    }
    const PointRun all{0, a.beams() - 1};
    return a.lineThrough(all).direction == b.lineThrough(all).direction;
}

}  // namespace

class SlicePointsTest : public QObject {
    Q_OBJECT

private slots:
    void hasNoBeamsBeforeTheFirstSlice();
    void pointsLieAtTheirRangeAndBearing();
    void echoesAreThoseWithinTheRangeLimits();
    void lineThroughTwoPointsIsTheirChord();
    void aLineHasItsNormalAndDistancesByHand();
    void lineThroughMatchesTheEigenvectorsOfTheScatter_data();
    void lineThroughMatchesTheEigenvectorsOfTheScatter();
    void lineThroughAnExactWallIsTheWall();
    void lineThroughAShortFarRunOfAFullSliceIsExactEnough();
    void varianceAcrossMatchesTheNumericPropagation();
    void aReusedObjectHoldsTheNewSliceOnly();
};

void SlicePointsTest::hasNoBeamsBeforeTheFirstSlice()
{
    const SlicePoints points;

    QCOMPARE(points.beams(), 0);
    QCOMPARE(points.echoes(), 0);
}

void SlicePointsTest::pointsLieAtTheirRangeAndBearing()
{
    ScanSlice slice = emptySlice(degrees(30.0), degrees(30.0), 3);
    slice.ranges = {2.0, 4.0, 6.0};

    const SlicePoints points = pointsOf(slice);

    QVERIFY((points[0] - Eigen::Vector2d(std::sqrt(3.0), 1.0)).norm() < 1e-14);
    QVERIFY((points[1] - Eigen::Vector2d(2.0, 2.0 * std::sqrt(3.0))).norm() < 1e-14);
    QVERIFY((points[2] - Eigen::Vector2d(0.0, 6.0)).norm() < 1e-14);
    QCOMPARE(points.range(1), 4.0);
}

void SlicePointsTest::echoesAreThoseWithinTheRangeLimits()
{
    ScanSlice slice = emptySlice(0.0, degrees(1.0), 7);
    slice.ranges = {0.0, 0.099, 0.1, 5.0, std::nan(""), 30.0, 30.001};

    const SlicePoints points = pointsOf(slice);

    QCOMPARE(points.beams(), 7);
    QCOMPARE(points.echoes(), 3);
    QVERIFY(!points.hasEcho(0) && !points.hasEcho(1) && points.hasEcho(2) && points.hasEcho(3));
    QVERIFY(!points.hasEcho(4) && points.hasEcho(5) && !points.hasEcho(6));
    QCOMPARE(points.echoesIn({0, 6}), 3);
    QCOMPARE(points.echoesIn({0, 1}), 0);
    QCOMPARE(points.echoesIn({2, 3}), 2);
    QCOMPARE(points.echoesIn({6, 6}), 0);
}

void SlicePointsTest::lineThroughTwoPointsIsTheirChord()
{
    ScanSlice slice = emptySlice(0.0, degrees(90.0), 2);
    slice.ranges = {3.0, 4.0};  // (3, 0) and (0, 4)

    const SliceLine line = pointsOf(slice).lineThrough({0, 1});

    QCOMPARE(line.points, 2);
    QVERIFY((line.centroid - Eigen::Vector2d(1.5, 2.0)).norm() < 1e-14);
    QVERIFY(std::abs(crossed(line.direction, Eigen::Vector2d(-0.6, 0.8))) < 1e-14);
    QVERIFY(line.variance < 1e-14);
}

void SlicePointsTest::aLineHasItsNormalAndDistancesByHand()
{
    const SliceLine line{2, {1.0, 1.0}, {0.6, 0.8}, 0.0};

    QCOMPARE(line.normal(), Eigen::Vector2d(-0.8, 0.6));
    QCOMPARE(line.distanceTo({1.0, 1.0}), 0.0);
    QCOMPARE(line.distanceTo({1.0, 6.0}), 3.0);
    QCOMPARE(line.distanceTo({6.0, 1.0}), 4.0);
}

void SlicePointsTest::lineThroughMatchesTheEigenvectorsOfTheScatter_data()
{
    QTest::addColumn<double>("missingShare");
    QTest::newRow("every beam returns") << 0.0;
    QTest::newRow("every third beam is missing") << 0.33;
    QTest::newRow("most beams are missing") << 0.8;
}

void SlicePointsTest::lineThroughMatchesTheEigenvectorsOfTheScatter()
{
    QFETCH(double, missingShare);
    std::mt19937_64 random(11);
    int compared = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const SlicePoints points = pointsOf(randomSlice(300, missingShare, random));
        const int first = static_cast<int>(random() % 299);
        const PointRun run{first, first + 1 + static_cast<int>(random() % static_cast<unsigned>(299 - first))};
        if (points.echoesIn(run) < 2)
            continue;

        const SliceLine line = points.lineThrough(run);

        const BruteLine brute = bruteLine(points, run);
        QCOMPARE(line.points, brute.points);
        QVERIFY((line.centroid - brute.centroid).norm() < 1e-10);
        QVERIFY(std::abs(line.direction.norm() - 1.0) < 1e-14);
        QVERIFY(std::abs(line.direction.dot(brute.covariance * line.direction) - brute.largest) < 1e-9);
        QVERIFY(std::abs(line.variance - brute.smallest) < 1e-9);
        ++compared;
    }
    QVERIFY(compared > 400);
}

void SlicePointsTest::lineThroughAnExactWallIsTheWall()
{
    for (const double angle : {0.0, 40.0, 89.0, 90.0, 91.0, 135.0, 179.0}) {
        const Eigen::Vector2d along{std::cos(degrees(angle)), std::sin(degrees(angle))};
        const Eigen::Vector2d middle = 5.0 * Eigen::Vector2d(-along.y(), along.x());
        const DrawnWall wall{middle - 2.0 * along, middle + 2.0 * along};
        const double facing = std::atan2(middle.y(), middle.x());
        const ScanSlice slice = drawn(emptySlice(facing - degrees(15.0), degrees(0.25), 121), {wall});

        const SliceLine line = pointsOf(slice).lineThrough({0, 120});

        QVERIFY(std::abs(crossed(line.direction, along)) < 1e-12);
        QVERIFY(line.distanceTo(middle) < 1e-12);
        QVERIFY(line.variance < 1e-12);
    }
}

void SlicePointsTest::lineThroughAShortFarRunOfAFullSliceIsExactEnough()
{
    // The running sums are at their largest behind 65,536 beams of 30 m; a run of seven points spans 20 mm there.
    ScanSlice slice = emptySlice(0.0, degrees(0.005), 65536);
    slice.ranges.assign(65536, 30.0);
    const SlicePoints points = pointsOf(slice);
    const PointRun run{65529, 65535};

    const SliceLine line = points.lineThrough(run);

    const Eigen::Vector2d chord = (points[run.last] - points[run.first]).normalized();
    QVERIFY(std::abs(crossed(line.direction, chord)) < 1e-3);
    QVERIFY(std::sqrt(line.variance) < 1e-3);
}

void SlicePointsTest::varianceAcrossMatchesTheNumericPropagation()
{
    std::mt19937_64 random(12);
    const NoiseParameters noise{0.008, 0.002, degrees(0.05), 0.0};
    for (int trial = 0; trial < 200; ++trial) {
        const double range = 0.2 + 29.0 * uniform(random);
        const double bearing = degrees(-45.0 + 270.0 * uniform(random));
        const double turn = degrees(360.0 * uniform(random));
        const Eigen::Vector2d normal{std::cos(turn), std::sin(turn)};
        ScanSlice slice = emptySlice(bearing, degrees(1.0), 1);
        slice.ranges = {range};

        const double variance = pointsOf(slice, noise).varianceAcross(0, normal);

        const auto across = [&](double r, double b) {
            return normal.dot(r * Eigen::Vector2d(std::cos(b), std::sin(b)));
        };
        constexpr double kStep = 1e-6;
        const double byRange = (across(range + kStep, bearing) - across(range - kStep, bearing)) / (2.0 * kStep);
        const double byBearing = (across(range, bearing + kStep) - across(range, bearing - kStep)) / (2.0 * kStep);
        const double rangeVariance = 0.008 * 0.008 + 0.002 * 0.002 * range * range;
        const double expected =
            byRange * byRange * rangeVariance + byBearing * byBearing * noise.bearing * noise.bearing;
        QVERIFY(std::abs(variance - expected) < 1e-7 * (rangeVariance + range * range * noise.bearing * noise.bearing));
    }
}

void SlicePointsTest::aReusedObjectHoldsTheNewSliceOnly()
{
    // More beams, fewer, an interlaced start half a step on, another step: each time as if the object were new.
    std::mt19937_64 random(13);
    SlicePoints reused;
    for (const auto& [firstBearing, bearingStep, beams] : {std::tuple{-45.0, 0.25, 200},
                                                           {-45.0, 0.25, 300},
                                                           {-45.0, 0.25, 50},
                                                           {-44.875, 0.25, 50},
                                                           {-45.0, 0.25, 50},
                                                           {-45.0, 0.5, 50},
                                                           {-45.0, 0.5, 2}}) {
        ScanSlice slice = randomSlice(beams, beams > 2 ? 0.2 : 0.0, random);
        slice.firstBearing = degrees(firstBearing);
        slice.bearingStep = degrees(bearingStep);

        reused.take(slice, SensorModel{0.05, 0.1, 30.0}, kFineNoise);

        QVERIFY(samePoints(reused, pointsOf(slice, kFineNoise)));
    }

    reused.take(emptySlice(0.0, degrees(1.0), 0), SensorModel{0.05, 0.1, 30.0}, kFineNoise);

    QCOMPARE(reused.beams(), 0);
    QCOMPARE(reused.echoes(), 0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SlicePointsTest)
#include "slice_points_test.moc"
