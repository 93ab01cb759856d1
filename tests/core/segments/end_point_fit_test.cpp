// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/end_point_fit.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Core>
#include <QtTest>

#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

using Pieces = std::vector<PointRun>;

/// How far the settling of a border may move it, at most, in beams.
constexpr int kSettled = 8;

SegmentParameters splitAt(double distance, double sigmas)
{
    SegmentParameters parameters;
    parameters.splitDistance = distance;
    parameters.splitSigmas = sigmas;
    return parameters;
}

Pieces piecesOf(const SlicePoints& points, const PointRun& run, const SegmentParameters& parameters)
{
    Pieces pieces;
    splitByEndPointFit(points, run, parameters, pieces);
    return pieces;
}

/// h_o and the farthest point by the formulas of the text: distance to the line through both ends.
int bruteFarthest(const SlicePoints& points, const PointRun& run, const SegmentParameters& parameters,
                  const NoiseParameters& noise)
{
    const Eigen::Vector2d chord = (points[run.last] - points[run.first]).normalized();
    int farthest = -1;
    double best = 0.0;
    for (int beam = run.first + 1; beam < run.last; ++beam) {
        const double distance = std::abs(crossed(chord, points[beam] - points[run.first]));
        const double cosine = std::abs(crossed(chord, points[beam].normalized()));  // of the ray with the normal
        const double variance = cosine * cosine * noise.rangeVariance(points.range(beam)) +
                                (1.0 - cosine * cosine) * std::pow(points.range(beam) * noise.bearing, 2);
        const double limit = std::max(parameters.splitDistance, parameters.splitSigmas * std::sqrt(variance));
        if (distance > limit && distance > best) {
            best = distance;
            farthest = beam;
        }
    }
    return farthest;
}

/// The textbook's recursion; gives the points of division in bearing order.
void bruteDivisions(const SlicePoints& points, const PointRun& run, const SegmentParameters& parameters,
                    const NoiseParameters& noise, std::vector<int>& divisions)
{
    const int division = bruteFarthest(points, run, parameters, noise);
    if (division < 0)
        return;
    bruteDivisions(points, {run.first, division}, parameters, noise, divisions);
    divisions.push_back(division);
    bruteDivisions(points, {division, run.last}, parameters, noise, divisions);
}

/// Walls round the scanner, their ranges blurred by noise of a standard deviation [m].
ScanSlice blurred(const std::vector<DrawnWall>& walls, double sigma, std::mt19937_64& random)
{
    const Eigen::Vector2d& end = walls.back().to;
    double span = std::atan2(end.y(), end.x());
    if (span < 0.0)
        span += degrees(360.0);
    ScanSlice slice = drawn(emptySlice(0.0, degrees(0.25), static_cast<int>(span / degrees(0.25)) + 1), walls);
    for (double& range : slice.ranges)
        range += sigma * normal(random);
    return slice;
}

}  // namespace

class EndPointFitTest : public QObject {
    Q_OBJECT

private slots:
    void splitDistanceIsTheLargerOfTheFixedAndTheSigmas();
    void farthestFromChordMatchesBruteForce();
    void farthestFromChordFindsNothingWithinTheSplitDistance();
    void aStraightRunIsOnePiece();
    void runsOfTwoPointsStayWhole();
    void splitsACornerExactlyAtTheCorner_data();
    void splitsACornerExactlyAtTheCorner();
    void everyPieceOfRandomWallsLiesOnOneWall();
    void piecesAreThoseOfTheTextbookRecursionUpToTheirBorders();
    void piecesAreAppendedInBearingOrder();
    void onlyTheBeamsOfTheRunAreSplit();
    void aMixedPixelBetweenTwoDepthsEndsNoPiece();
    void aRunThatEndsWhereItBeganIsSplitAtItsCorners();
    void aZigzagOf65536PointsIsSplitAtEveryTooth();
};

void EndPointFitTest::splitDistanceIsTheLargerOfTheFixedAndTheSigmas()
{
    // A point 10 m ahead: σ_ρ = √(0.03² + 0.04²) = 0.05 m along the ray, ρ σ_θ = 0.02 m across it.
    ScanSlice slice = emptySlice(degrees(90.0), degrees(1.0), 1);
    slice.ranges = {10.0};
    const SlicePoints points = pointsOf(slice, {0.03, 0.004, 0.002, 0.0});
    const auto isNear = [](double a, double b) { return std::abs(a - b) < 1e-12; };

    QVERIFY(isNear(splitDistance(points, 0, {0.0, 1.0}, splitAt(0.1, 3.0)), 0.15));
    QVERIFY(isNear(splitDistance(points, 0, {0.0, -1.0}, splitAt(0.2, 3.0)), 0.2));
    QVERIFY(isNear(splitDistance(points, 0, {1.0, 0.0}, splitAt(0.01, 3.0)), 0.06));
    QVERIFY(isNear(splitDistance(points, 0, {0.6, 0.8}, splitAt(0.0, 1.0)), std::hypot(0.6 * 0.02, 0.8 * 0.05)));
    QVERIFY(isNear(splitDistance(points, 0, {0.0, 1.0}, splitAt(0.1, 0.0)), 0.1));
}

void EndPointFitTest::farthestFromChordMatchesBruteForce()
{
    std::mt19937_64 random(21);
    const NoiseParameters noise{0.01, 0.002, degrees(0.2), 0.0};
    int divided = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const std::vector<DrawnWall> walls = randomWalls(6, random);
        const SlicePoints points = pointsOf(blurred(walls, 0.01, random), noise);
        const int first = static_cast<int>(random() % static_cast<unsigned>(points.beams() - 2));
        const int last = first + 2 + static_cast<int>(random() % static_cast<unsigned>(points.beams() - 2 - first));
        const SegmentParameters parameters = splitAt(0.05 * uniform(random), 10.0 * uniform(random));

        const int farthest = farthestFromChord(points, {first, last}, parameters);

        QCOMPARE(farthest, bruteFarthest(points, {first, last}, parameters, noise));
        divided += farthest >= 0 ? 1 : 0;
    }
    QVERIFY(divided > 100 && divided < 300);
}

void EndPointFitTest::farthestFromChordFindsNothingWithinTheSplitDistance()
{
    // A dent of 2 cm in a wall 4 m ahead.
    ScanSlice slice = drawn(emptySlice(degrees(80.0), degrees(0.25), 81), {{{-2.0, 4.0}, {2.0, 4.0}}});
    slice.ranges[40] += 0.02;

    QCOMPARE(farthestFromChord(pointsOf(slice, kFineNoise), {0, 80}, splitAt(0.021, 0.0)), -1);
    QCOMPARE(farthestFromChord(pointsOf(slice, kFineNoise), {0, 80}, splitAt(0.019, 0.0)), 40);
    QCOMPARE(farthestFromChord(pointsOf(slice, kFineNoise), {0, 80}, splitAt(0.0, 21.0)), -1);
    QCOMPARE(farthestFromChord(pointsOf(slice, kFineNoise), {0, 80}, splitAt(0.019, 19.0)), 40);
}

void EndPointFitTest::aStraightRunIsOnePiece()
{
    const ScanSlice slice = drawn(emptySlice(degrees(40.0), degrees(0.25), 400), {{{-9.0, 1.0}, {9.0, 5.0}}});

    QCOMPARE(piecesOf(pointsOf(slice, kFineNoise), {0, 399}, splitAt(0.005, 5.0)), (Pieces{{0, 399}}));
}

void EndPointFitTest::runsOfTwoPointsStayWhole()
{
    ScanSlice slice = emptySlice(0.0, degrees(1.0), 2);
    slice.ranges = {2.0, 9.0};

    QCOMPARE(piecesOf(pointsOf(slice), {0, 1}, splitAt(0.0, 0.0)), (Pieces{{0, 1}}));
}

void EndPointFitTest::splitsACornerExactlyAtTheCorner_data()
{
    QTest::addColumn<std::vector<DrawnWall>>("walls");
    using Walls = std::vector<DrawnWall>;
    QTest::newRow("inner corner of a room") << Walls{{{3.0, 0.0}, {3.0, 4.0}}, {{3.0, 4.0}, {0.0, 4.0}}};
    QTest::newRow("outer corner of a pier") << Walls{{{4.0, 0.0}, {1.5, 1.5}}, {{1.5, 1.5}, {0.0, 4.0}}};
    QTest::newRow("end of a corridor") << Walls{
        {{1.0, 0.0}, {1.0, 3.0}}, {{1.0, 3.0}, {-1.0, 3.0}}, {{-1.0, 3.0}, {-1.0, 0.0}}};
    QTest::newRow("obtuse bend of 25 degrees")
        << Walls{{{4.0, 0.0}, {4.0, 2.0}},
                 {{4.0, 2.0}, {4.0 - 2.0 * std::sin(degrees(25.0)), 2.0 + 2.0 * std::cos(degrees(25.0))}}};
    // 45° is beam 180 of 0.25°: the corner is a scan point itself.
    QTest::newRow("corner on a beam") << Walls{{{3.0, 0.0}, {3.0, 3.0}}, {{3.0, 3.0}, {0.0, 3.0}}};
}

void EndPointFitTest::splitsACornerExactlyAtTheCorner()
{
    QFETCH(std::vector<DrawnWall>, walls);
    std::mt19937_64 random(22);
    const SlicePoints points = pointsOf(blurred(walls, 0.0, random), kFineNoise);

    const Pieces pieces = piecesOf(points, {0, points.beams() - 1}, splitAt(0.03, 5.0));

    QCOMPARE(pieces.size(), walls.size());
    QCOMPARE(pieces.front().first, 0);
    QCOMPARE(pieces.back().last, points.beams() - 1);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        QVERIFY(liesOnOne({walls[i]}, points, pieces[i], 1e-12));
        QVERIFY(i == 0 || pieces[i].first == pieces[i - 1].last + 1);
    }
}

void EndPointFitTest::everyPieceOfRandomWallsLiesOnOneWall()
{
    std::mt19937_64 random(23);
    for (int trial = 0; trial < 60; ++trial) {
        const std::vector<DrawnWall> walls = randomWalls(12, random);
        const SlicePoints points = pointsOf(blurred(walls, 0.0, random), kFineNoise);

        const Pieces pieces = piecesOf(points, {0, points.beams() - 1}, splitAt(0.01, 0.0));

        QVERIFY(pieces.size() >= walls.size());
        int covered = 0;
        for (const PointRun& piece : pieces) {
            QVERIFY(liesOnOne(walls, points, piece, 0.01));
            covered += piece.points();
        }
        QVERIFY(covered > points.beams() - static_cast<int>(walls.size()));
    }
}

void EndPointFitTest::piecesAreThoseOfTheTextbookRecursionUpToTheirBorders()
{
    std::mt19937_64 random(24);
    const NoiseParameters noise{0.008, 0.001, degrees(0.02), 0.0};
    const SegmentParameters parameters = splitAt(0.03, 4.0);
    int cores = 0;
    for (int trial = 0; trial < 50; ++trial) {
        const SlicePoints points = pointsOf(blurred(randomWalls(8, random), 0.008, random), noise);
        const PointRun run{0, points.beams() - 1};
        std::vector<int> borders{0};
        bruteDivisions(points, run, parameters, noise, borders);
        borders.push_back(run.last);

        const Pieces pieces = piecesOf(points, run, parameters);

        // The inside of every piece of the recursion is in one piece, and no two of them are in the same.
        std::vector<PointRun> owners;
        for (std::size_t i = 1; i < borders.size(); ++i) {
            const PointRun core{borders[i - 1] + kSettled, borders[i] - kSettled};
            if (core.points() < 1)
                continue;
            const auto owner = std::ranges::find_if(
                pieces, [&](const PointRun& p) { return p.first <= core.first && core.last <= p.last; });
            QVERIFY(owner != pieces.end());
            QVERIFY(std::ranges::find(owners, *owner) == owners.end());
            owners.push_back(*owner);
        }
        cores += static_cast<int>(owners.size());
        QVERIFY(pieces.size() < borders.size());
    }
    QVERIFY(cores > 50 * 4);
}

void EndPointFitTest::piecesAreAppendedInBearingOrder()
{
    std::mt19937_64 random(25);
    const SlicePoints points = pointsOf(blurred(randomWalls(10, random), 0.01, random), kFineNoise);
    Pieces pieces{{0, 4}};

    splitByEndPointFit(points, {5, points.beams() - 1}, splitAt(0.02, 0.0), pieces);

    QVERIFY(pieces.size() > 10);
    QCOMPARE(pieces.front(), (PointRun{0, 4}));
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        QVERIFY(pieces[i].first > pieces[i - 1].last);
        QVERIFY(pieces[i].points() >= 2);
    }
}

void EndPointFitTest::onlyTheBeamsOfTheRunAreSplit()
{
    // Of the two walls of a corner at 53.13°, the run sees the second alone; the first must not leak in.
    const std::vector<DrawnWall> walls{{{3.0, 0.0}, {3.0, 4.0}}, {{3.0, 4.0}, {0.0, 4.0}}};
    const SlicePoints points = pointsOf(drawn(emptySlice(0.0, degrees(0.25), 360), walls), kFineNoise);

    QCOMPARE(piecesOf(points, {213, 340}, splitAt(0.01, 0.0)), (Pieces{{213, 340}}));
}

void EndPointFitTest::aMixedPixelBetweenTwoDepthsEndsNoPiece()
{
    // A wall steps back by 20 cm straight ahead; one beam hits the edge and measures in between.
    ScanSlice slice =
        drawn(emptySlice(degrees(70.0), degrees(0.25), 161), {{{-2.0, 4.2}, {0.0, 4.2}}, {{0.0001, 4.0}, {2.0, 4.0}}});
    slice.ranges[80] = 4.1;
    const SlicePoints points = pointsOf(slice, kFineNoise);

    const Pieces pieces = piecesOf(points, {0, 160}, splitAt(0.03, 0.0));

    QCOMPARE(pieces, (Pieces{{0, 79}, {81, 160}}));
}

void EndPointFitTest::aRunThatEndsWhereItBeganIsSplitAtItsCorners()
{
    // A full turn in a room: the last beam measures the first one's point once more, a millimetre off.
    const std::vector<DrawnWall> room{
        {{3.0, -2.0}, {3.0, 2.0}}, {{3.0, 2.0}, {-3.0, 2.0}}, {{-3.0, 2.0}, {-3.0, -2.0}}, {{-3.0, -2.0}, {3.0, -2.0}}};
    ScanSlice slice = drawn(emptySlice(degrees(50.0), degrees(1.0), 361), room);
    slice.ranges.back() += 0.001;
    const SlicePoints points = pointsOf(slice, kFineNoise);

    const Pieces pieces = piecesOf(points, {0, 360}, splitAt(0.03, 0.0));

    QVERIFY(pieces.size() >= 4);
    for (const PointRun& piece : pieces)
        QVERIFY(liesOnOne(room, points, piece, 0.0011));
}

void EndPointFitTest::aZigzagOf65536PointsIsSplitAtEveryTooth()
{
    // On a circle of 5 m: sixteen beams up by 4 mm, sixteen down.
    constexpr int kBeams = 65536;
    constexpr int kFlank = 16;
    ScanSlice slice = emptySlice(0.0, degrees(300.0) / kBeams, kBeams);
    for (int beam = 0; beam < kBeams; ++beam)
        slice.ranges[static_cast<std::size_t>(beam)] = 5.0 + 0.00025 * std::abs(beam % (2 * kFlank) - kFlank);
    const SlicePoints points = pointsOf(slice, kFineNoise);

    const Pieces pieces = piecesOf(points, {0, kBeams - 1}, splitAt(0.0005, 0.0));

    int covered = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        QVERIFY(i == 0 || pieces[i].first > pieces[i - 1].last);
        QVERIFY(pieces[i].points() < 2 * kFlank);
        covered += pieces[i].points();
    }
    QVERIFY(covered > kBeams / 2);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::EndPointFitTest)
#include "end_point_fit_test.moc"
