// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/merge_pieces.h"

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

/// Fixed tolerances only: 2° and a gap of 0.25 m, straight to 3 cm; none grows with the noise or the beams' spacing.
SegmentParameters fixedMergeTolerances()
{
    SegmentParameters parameters;
    parameters.splitDistance = 0.03;
    parameters.splitSigmas = 0.0;
    parameters.mergeAngle = degrees(2.0);
    parameters.mergeAngleSigmas = 0.0;
    parameters.mergeGap = 0.25;
    parameters.mergeGapSteps = 0.0;
    return parameters;
}

Pieces merged(const ScanSlice& slice, Pieces pieces, const SegmentParameters& parameters = fixedMergeTolerances(),
              const NoiseParameters& noise = kFineNoise)
{
    mergePieces(pointsOf(slice, noise), slice.bearingStep, parameters, pieces);
    return pieces;
}

const DrawnWall kFlatWall{{-6.0, 4.0}, {6.0, 4.0}};

/// A wall 4 m ahead, seen from 70° to 110° by a beam every quarter of a degree: 17.5 mm apart straight ahead.
ScanSlice flatWall()
{
    return drawn(emptySlice(degrees(70.0), degrees(0.25), 161), {kFlatWall});
}

void drop(ScanSlice& slice, int first, int last)
{
    for (int beam = first; beam <= last; ++beam)
        slice.ranges[static_cast<std::size_t>(beam)] = 0.0;
}

/// Two walls of 2 m that meet 4 m straight ahead; the left one, of larger bearings, turns back by an angle.
std::vector<DrawnWall> bend(double angle)
{
    return {{{2.0, 4.0}, {0.0, 4.0}}, {{0.0, 4.0}, {-2.0 * std::cos(angle), 4.0 + 2.0 * std::sin(angle)}}};
}

}  // namespace

class MergePiecesTest : public QObject {
    Q_OBJECT

private slots:
    void joinsAWallInterruptedByADropout();
    void joinsNeighboursWithoutAGap();
    void joinsAChainOfPiecesIntoOne();
    void nothingAndOnePieceStayAsTheyAre();
    void leavesTwoWallsAtTenDegreesApart();
    void leavesTheWallsOfACornerApart();
    void leavesAWallAndADoorBehindItApart();
    void leavesWallsOnBothSidesOfAPillarApart();
    void joinsNearlyParallelPiecesBelowTheAngleOnly();
    void theAngleGrowsWithTheNoiseOfShortPieces();
    void joinsGapsBelowTheLimitInMetresOnly();
    void joinsGapsBelowTheLimitInStepsOnly();
    void joinsOnlyNeighboursOfManyPieces();
};

void MergePiecesTest::joinsAWallInterruptedByADropout()
{
    ScanSlice slice = flatWall();
    drop(slice, 80, 84);

    QCOMPARE(merged(slice, {{0, 79}, {85, 160}}), (Pieces{{0, 160}}));
}

void MergePiecesTest::joinsNeighboursWithoutAGap()
{
    QCOMPARE(merged(flatWall(), {{0, 79}, {80, 160}}), (Pieces{{0, 160}}));
}

void MergePiecesTest::joinsAChainOfPiecesIntoOne()
{
    ScanSlice slice = flatWall();
    Pieces pieces;
    for (int first = 0; first < 160; first += 10) {
        pieces.push_back({first, first + 7});
        drop(slice, first + 8, first + 9);
    }

    QCOMPARE(merged(slice, pieces), (Pieces{{0, 157}}));
}

void MergePiecesTest::nothingAndOnePieceStayAsTheyAre()
{
    QCOMPARE(merged(flatWall(), {}), Pieces{});
    QCOMPARE(merged(flatWall(), {{3, 40}}), (Pieces{{3, 40}}));
}

void MergePiecesTest::leavesTwoWallsAtTenDegreesApart()
{
    // Even where the joined piece would be straight enough: by 10° the bend leaves its chord by 17 cm.
    const ScanSlice slice = drawn(emptySlice(degrees(70.0), degrees(0.25), 151), bend(degrees(10.0)));
    SegmentParameters lenient = fixedMergeTolerances();
    lenient.splitDistance = 1.0;

    QCOMPARE(merged(slice, {{0, 80}, {81, 150}}), (Pieces{{0, 80}, {81, 150}}));
    QCOMPARE(merged(slice, {{0, 80}, {81, 150}}, lenient), (Pieces{{0, 80}, {81, 150}}));
}

void MergePiecesTest::leavesTheWallsOfACornerApart()
{
    // The corner lies at 104.04°, between beams 136 and 137.
    const ScanSlice slice =
        drawn(emptySlice(degrees(70.0), degrees(0.25), 201), {{{2.0, 4.0}, {-1.0, 4.0}}, {{-1.0, 4.0}, {-1.0, 0.5}}});
    SegmentParameters lenient = fixedMergeTolerances();
    lenient.splitDistance = 5.0;

    QCOMPARE(merged(slice, {{0, 136}, {137, 200}}), (Pieces{{0, 136}, {137, 200}}));
    QCOMPARE(merged(slice, {{0, 136}, {137, 200}}, lenient), (Pieces{{0, 136}, {137, 200}}));
}

void MergePiecesTest::leavesAWallAndADoorBehindItApart()
{
    // Parallel, and only 6 cm apart: neither the angle nor the gap tells them from one wall.
    const ScanSlice slice =
        drawn(emptySlice(degrees(60.0), degrees(0.25), 160), {{{6.0, 4.0}, {0.0, 4.0}}, {{0.1, 4.06}, {-1.0, 4.06}}});
    const ScanSlice mirrored =
        drawn(emptySlice(degrees(80.25), degrees(0.25), 160), {{{-6.0, 4.0}, {0.0, 4.0}}, {{-0.1, 4.06}, {1.0, 4.06}}});
    SegmentParameters lenient = fixedMergeTolerances();
    lenient.splitDistance = 0.07;

    QCOMPARE(merged(mirrored, {{0, 38}, {39, 159}}), (Pieces{{0, 38}, {39, 159}}));
    QCOMPARE(merged(mirrored, {{0, 38}, {39, 159}}, lenient), (Pieces{{0, 159}}));
    QCOMPARE(merged(slice, {{0, 119}, {120, 159}}), (Pieces{{0, 119}, {120, 159}}));
    QCOMPARE(merged(slice, {{0, 119}, {120, 159}}, lenient), (Pieces{{0, 159}}));
}

void MergePiecesTest::leavesWallsOnBothSidesOfAPillarApart()
{
    ScanSlice slice = flatWall();
    for (int beam = 76; beam <= 84; ++beam)
        slice.ranges[static_cast<std::size_t>(beam)] = 1.5;
    ScanSlice unseen = flatWall();
    drop(unseen, 76, 84);

    QCOMPARE(merged(slice, {{0, 75}, {76, 84}, {85, 160}}), (Pieces{{0, 75}, {76, 84}, {85, 160}}));
    QCOMPARE(merged(slice, {{0, 75}, {85, 160}}), (Pieces{{0, 75}, {85, 160}}));
    QCOMPARE(merged(unseen, {{0, 75}, {85, 160}}), (Pieces{{0, 160}}));
}

void MergePiecesTest::joinsNearlyParallelPiecesBelowTheAngleOnly()
{
    const Pieces pieces{{0, 80}, {81, 150}};
    const ScanSlice less = drawn(emptySlice(degrees(70.0), degrees(0.25), 151), bend(degrees(1.9)));
    const ScanSlice more = drawn(emptySlice(degrees(70.0), degrees(0.25), 151), bend(degrees(2.1)));
    const ScanSlice other = drawn(emptySlice(degrees(70.0), degrees(0.25), 151), bend(degrees(-2.1)));
    SegmentParameters lenient = fixedMergeTolerances();
    lenient.splitDistance = 0.2;

    QCOMPARE(merged(less, pieces, lenient), (Pieces{{0, 150}}));
    QCOMPARE(merged(more, pieces, lenient), pieces);
    QCOMPARE(merged(other, pieces, lenient), pieces);
}

void MergePiecesTest::theAngleGrowsWithTheNoiseOfShortPieces()
{
    // Pieces of 20 points on 0.332 m, noise 10 mm: √12 · 0.01/(0.332 √20) = 0.0233 rad each, 1.89° for the difference;
    // three of these are 5.7°. A bend of 4.5° is then nothing but noise; one of 7° is not.
    const Pieces pieces{{60, 79}, {80, 99}};
    const NoiseParameters noise{0.01, 0.0, 0.0, 0.0};
    SegmentParameters sigmas = fixedMergeTolerances();
    sigmas.mergeAngleSigmas = 3.0;
    const auto bent = [](double angle) {
        return drawn(emptySlice(degrees(70.0), degrees(0.25), 151), bend(degrees(angle)));
    };

    QCOMPARE(merged(bent(4.5), pieces, sigmas, noise), (Pieces{{60, 99}}));
    QCOMPARE(merged(bent(4.5), pieces, fixedMergeTolerances(), noise), pieces);
    QCOMPARE(merged(bent(7.0), pieces, sigmas, noise), pieces);
}

void MergePiecesTest::joinsGapsBelowTheLimitInMetresOnly()
{
    // Straight ahead the points of beams 14 apart lie 4·2·tan 1.75° = 0.2444 m apart, of 15 apart more than 0.26 m.
    ScanSlice slice = flatWall();
    drop(slice, 74, 86);
    ScanSlice wider = flatWall();
    drop(wider, 73, 86);

    QCOMPARE(merged(slice, {{0, 73}, {87, 160}}), (Pieces{{0, 160}}));
    QCOMPARE(merged(wider, {{0, 72}, {87, 160}}), (Pieces{{0, 72}, {87, 160}}));
}

void MergePiecesTest::joinsGapsBelowTheLimitInStepsOnly()
{
    // A beam every degree on a wall 10 m ahead: 0.175 m from point to point, more than the 0.1 m of the fixed limit.
    ScanSlice slice = drawn(emptySlice(degrees(70.0), degrees(1.0), 41), {{{-9.0, 10.0}, {9.0, 10.0}}});
    drop(slice, 20, 22);  // four steps from 19 to 23
    SegmentParameters fixed = fixedMergeTolerances();
    fixed.mergeGap = 0.1;
    SegmentParameters threeSteps = fixed;
    threeSteps.mergeGapSteps = 3.0;
    SegmentParameters fiveSteps = fixed;
    fiveSteps.mergeGapSteps = 5.0;
    const Pieces pieces{{0, 19}, {23, 40}};

    QCOMPARE(merged(slice, pieces, fixed), pieces);
    QCOMPARE(merged(slice, pieces, threeSteps), pieces);
    QCOMPARE(merged(slice, pieces, fiveSteps), (Pieces{{0, 40}}));
}

void MergePiecesTest::joinsOnlyNeighboursOfManyPieces()
{
    // A corner at beam 80 in a wall with two dropouts on either side: two pieces remain.
    ScanSlice slice = drawn(emptySlice(degrees(70.0), degrees(0.25), 151), bend(degrees(30.0)));
    Pieces pieces{{0, 20}, {23, 40}, {43, 79}, {81, 95}, {98, 110}, {112, 140}};
    for (std::size_t i = 1; i < pieces.size(); ++i)
        drop(slice, pieces[i - 1].last + 1, pieces[i].first - 1);

    QCOMPARE(merged(slice, pieces), (Pieces{{0, 79}, {81, 140}}));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MergePiecesTest)
#include "merge_pieces_test.moc"
