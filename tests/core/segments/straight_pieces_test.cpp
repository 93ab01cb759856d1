// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/straight_pieces.h"

#include <cmath>
#include <vector>

#include <QtTest>

#include "tests/core/params/preset_parameters.h"
#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

const SensorModel kPiecesSensor{0.05, 0.1, 30.0};
constexpr int kShortest = 4;

/// A slice straight ahead, 60° wide, of 241 beams.
ScanSlice ahead()
{
    return emptySlice(degrees(60.0), degrees(0.25), 241);
}

Parameters withNoise(double sigma)
{
    Parameters parameters = precise();
    parameters.noise.rangeConstant = sigma;
    parameters.noise.rangeProportional = 0.0;
    return parameters;
}

std::vector<LinePiece> piecesOf(const ScanSlice& slice, const Parameters& parameters)
{
    BeamPoints points(beamKernels());
    points.take(slice, kPiecesSensor, parameters);
    StraightPieces straight;
    const auto pieces = straight.divide(points, kShortest, parameters);
    return {pieces.begin(), pieces.end()};
}

const DrawnWall kWall{{3.0, 3.0}, {-3.0, 3.0}};

}  // namespace

class StraightPiecesTest : public QObject {
    Q_OBJECT

private slots:
    void noiseDoesNotDivideAWall();
    void aStrangerDoesNotDivideAWall();
    void aStepOfTwoSigmasDividesAWallOfManyPoints();
    void aCornerDividesWhereItIs();
    void aLineIsThatOfItsMoments();
    void runsTooShortArePassedOver();
};

void StraightPiecesTest::noiseDoesNotDivideAWall()
{
    int divided = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed)
        divided += piecesOf(noisy(drawn(ahead(), {kWall}), 0.01, seed), withNoise(0.01)).size() == 1 ? 0 : 1;

    // One line explains its points but for 0.3 % of walls (χ² beyond three standard deviations), where two may do so
    // much better: one of 300 to be expected, and five or more once in 250 such tests.
    QVERIFY2(divided < 5, qPrintable(QString::number(divided)));
}

void StraightPiecesTest::aStrangerDoesNotDivideAWall()
{
    for (const int beam : {30, 100, 120, 210}) {
        ScanSlice slice = noisy(drawn(ahead(), {kWall}), 0.01, 5);
        slice.ranges[static_cast<std::size_t>(beam)] += 0.055;

        const auto pieces = piecesOf(slice, withNoise(0.01));

        QCOMPARE(pieces.size(), std::size_t{1});
        QCOMPARE(pieces[0].points(), 241);
    }
}

void StraightPiecesTest::aStepOfTwoSigmasDividesAWallOfManyPoints()
{
    // Ranges one σ too long and too short in turn: χ² of 241 points about the right lines is 241 at most. The best line
    // across a step h in the middle strays by h²/16 on average, 60 for two σ, which is less than what chance adds to
    // χ² of 239 in one of a thousand (66), and more than chance gives a second line.
    constexpr double kSigma = 0.01;
    ScanSlice slice =
        drawn(ahead(), {{{3.0, 3.0}, {0.0, 3.0}}, {{0.0, 3.0 + 2.0 * kSigma}, {-3.0, 3.0 + 2.0 * kSigma}}});
    for (std::size_t i = 0; i < slice.ranges.size(); ++i)
        slice.ranges[i] += i % 2 == 0 ? kSigma : -kSigma;

    const auto pieces = piecesOf(slice, withNoise(kSigma));

    QCOMPARE(pieces.size(), std::size_t{2});
    QVERIFY2(std::abs(pieces[1].first - 120) <= 6, qPrintable(QString::number(pieces[1].first)));

    // Of a scanner whose ranges err together it is no step.
    Parameters together = withNoise(kSigma);
    together.noise.systematic = 0.0015;
    QCOMPARE(piecesOf(slice, together).size(), std::size_t{1});
}

void StraightPiecesTest::aCornerDividesWhereItIs()
{
    // Straight ahead, beam 120, at 3 m; the walls lean 30° from it on both sides.
    const double far = 3.0 - 2.0 * std::tan(degrees(30.0));
    const std::vector<DrawnWall> walls{{{2.0, far}, {0.0, 3.0}}, {{0.0, 3.0}, {-2.0, far}}};

    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto pieces = piecesOf(noisy(drawn(ahead(), walls), 0.001, seed), withNoise(0.001));

        QCOMPARE(pieces.size(), std::size_t{2});
        // Neighbours at the corner are 13 mm apart along walls that part by 60°: a beam past it is 11 standard
        // deviations off the other wall.
        QVERIFY(std::abs(pieces[0].last - 120) <= 1);
        QVERIFY(std::abs(pieces[1].first - 120) <= 1);
        QVERIFY(pieces[0].last < pieces[1].first);
    }
}

void StraightPiecesTest::aLineIsThatOfItsMoments()
{
    std::mt19937_64 random(4);
    const Parameters parameters = withNoise(0.004);
    const ScanSlice slice =
        noisy(drawn(emptySlice(degrees(0.1), degrees(0.25), 300), randomWalls(6, random)), 0.004, 9);

    const auto pieces = piecesOf(slice, parameters);

    QVERIFY(pieces.size() >= 3);
    for (const LinePiece& piece : pieces) {
        const MomentLine line = lineOf(piece.moments);
        QCOMPARE(piece.line.directionU, line.directionU);
        QCOMPARE(piece.line.directionV, line.directionV);
        QCOMPARE(piece.line.across, line.across);
        QCOMPARE(piece.variance, centroidVariance(line, piece.moments, parameters.noise));
        QCOMPARE(piece.moments.count, static_cast<double>(piece.points()));
    }
}

void StraightPiecesTest::runsTooShortArePassedOver()
{
    ScanSlice slice = ahead();
    for (std::size_t beam = 100; beam < 100 + kShortest - 1; ++beam)
        slice.ranges[beam] = 2.0;
    QVERIFY(piecesOf(slice, withNoise(0.01)).empty());
    slice.ranges[100 + kShortest - 1] = 2.0;
    QCOMPARE(piecesOf(slice, withNoise(0.01)).size(), std::size_t{1});
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::StraightPiecesTest)
#include "straight_pieces_test.moc"
