// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/slice_trace.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <QtTest>

#include "core/segments/extract_line_segments.h"
#include "core/segments/extract_statistics.h"
#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

const SensorModel kTracedSensor{0.1, 0.1, 30.0};

/// Fixed tolerances of one method or the other: straight to 3 cm, at least 0.2 m and 7 points of 0.25°.
Parameters tracedTolerances(bool precise)
{
    Parameters parameters;
    parameters.method.estimator = precise ? Estimator::Likelihood : Estimator::EndPoints;
    parameters.noise = kFineNoise;
    parameters.segments.incidenceLimit = degrees(10.0);
    parameters.segments.breakpointSigmas = 3.0;
    parameters.segments.splitDistance = 0.03;
    parameters.segments.splitSigmas = 5.0;
    parameters.segments.minLength = 0.2;
    parameters.segments.minPoints = 7;
    return parameters;
}

SliceTrace traced(const ScanSlice& slice, bool precise = false)
{
    return traceSlice(slice, kTracedSensor, tracedTolerances(precise));
}

/// An arc around the laser: 4 m away, straight to 1 cm for seven degrees.
ScanSlice arcOf(int beams)
{
    ScanSlice slice = emptySlice(degrees(80.0), degrees(0.25), beams);
    std::fill(slice.ranges.begin(), slice.ranges.end(), 4.0);
    return slice;
}

/// Two walls that meet at (0, 2), at beam 90 of 181, one of them going back by 45° from there.
ScanSlice cornerSlice()
{
    return drawn(emptySlice(degrees(45.0), degrees(0.5), 181), {{{2.0, 2.0}, {0.0, 2.0}}, {{0.0, 2.0}, {-2.0, 4.0}}});
}

/// First and last beams of the pieces that became segments.
std::vector<std::pair<int, int>> keptBeams(const SliceTrace& trace)
{
    std::vector<std::pair<int, int>> beams;
    for (const TracedPiece& piece : trace.pieces) {
        if (piece.segment >= 0)
            beams.emplace_back(piece.firstBeam, piece.lastBeam);
    }
    return beams;
}

std::vector<std::pair<int, int>> extractedBeams(const ScanSlice& slice, const Parameters& parameters)
{
    std::vector<std::pair<int, int>> beams;
    if (parameters.method.estimator == Estimator::Likelihood) {
        std::vector<SegmentStatistics> segments;
        StatisticsExtractor().extract(slice, kTracedSensor, parameters, segments);
        for (const SegmentStatistics& segment : segments)
            beams.emplace_back(segment.firstBeam, segment.lastBeam);
    } else {
        for (const LineSegment& segment : LineSegmentExtractor().extract(slice, kTracedSensor, parameters))
            beams.emplace_back(segment.firstBeam, segment.lastBeam);
    }
    return beams;
}

void bothMethods()
{
    QTest::addColumn<bool>("precise");
    QTest::newRow("paper") << false;
    QTest::newRow("precise") << true;
}

}  // namespace

class SliceTraceTest : public QObject {
    Q_OBJECT

private slots:
    void aSliceWithoutEchoesGivesNothing_data() { bothMethods(); }
    void aSliceWithoutEchoesGivesNothing();
    void aPillarMakesThreeRunsAndTwoBreakpoints_data() { bothMethods(); }
    void aPillarMakesThreeRunsAndTwoBreakpoints();
    void aPieceIsDiscardedForItsLength();
    void aPieceIsDiscardedForItsPoints_data() { bothMethods(); }
    void aPieceIsDiscardedForItsPoints();
    void anEchoAloneIsNoRun();
    void missingBeamsEndARunOrAreBridged();
    void aCornerIsASplitPoint_data() { bothMethods(); }
    void aCornerIsASplitPoint();
    void aStepTooSmallForChordsIsABend();
    void whatIsTracedIsWhatIsExtracted_data() { bothMethods(); }
    void whatIsTracedIsWhatIsExtracted();
    void everyEchoHasOnePlace_data() { bothMethods(); }
    void everyEchoHasOnePlace();
    void aPointThatNoLineTakesIsToldItsDistance();
    void aPointThatTurnsItsLineIsToldItsVariances();
    void discardedPiecesAreRejected_data() { bothMethods(); }
    void discardedPiecesAreRejected();
    void aTraceIsEmptiedForAnotherSlice();
    void noiseOfASnapshotTakesTheParametersPlace();
};

void SliceTraceTest::aSliceWithoutEchoesGivesNothing()
{
    QFETCH(bool, precise);

    const SliceTrace trace = traced(emptySlice(0.0, degrees(0.5), 100), precise);

    QVERIFY(trace.runs.empty());
    QVERIFY(trace.breaks.empty());
    QVERIFY(trace.pieces.empty());
}

void SliceTraceTest::aPillarMakesThreeRunsAndTwoBreakpoints()
{
    QFETCH(bool, precise);
    ScanSlice slice = arcOf(80);
    std::fill(slice.ranges.begin() + 30, slice.ranges.begin() + 50, 1.5);

    const SliceTrace trace = traced(slice, precise);

    QCOMPARE(trace.runs.size(), std::size_t(3));
    QCOMPARE(trace.runs[1].firstBeam, 30);
    QCOMPARE(trace.runs[1].lastBeam, 49);
    QCOMPARE(trace.runs[1].points, 20);
    QCOMPARE(trace.breaks.size(), std::size_t(2));
    QCOMPARE(trace.breaks[0].before, 29);
    QCOMPARE(trace.breaks[0].after, 30);
    QVERIFY(!trace.breaks[0].missing);
    // Law of cosines for 4 m, 1.5 m and 0.25°; then 4 m sin 0.25° / sin 9.75° and three sigmas of 1 mm.
    QVERIFY(std::abs(trace.breaks[0].gap - std::sqrt(16.0 + 2.25 - 12.0 * std::cos(degrees(0.25)))) < 1e-6);
    QVERIFY(std::abs(trace.breaks[0].limit - 0.10606) < 1e-4);
    // The way back is told from the pillar's side, where the limit is 1.5/4 of that.
    QVERIFY(std::abs(trace.breaks[1].limit - (0.375 * 0.10306 + 0.003)) < 1e-4);
}

void SliceTraceTest::aPieceIsDiscardedForItsLength()
{
    ScanSlice slice = arcOf(80);
    std::fill(slice.ranges.begin() + 30, slice.ranges.begin() + 50, 1.5);

    const SliceTrace trace = traced(slice);

    QCOMPARE(trace.pieces.size(), std::size_t(3));
    QCOMPARE(trace.pieces[0].segment, 0);
    QCOMPARE(trace.pieces[2].segment, 1);
    const TracedPiece& pillar = trace.pieces[1];
    QCOMPARE(pillar.fate, PieceFate::TooShort);
    QCOMPARE(pillar.segment, -1);
    QCOMPARE(pillar.points, 20);
    // A chord of 19 · 0.25° at 1.5 m.
    const double chord = 3.0 * std::sin(degrees(0.5 * 19 * 0.25));
    QVERIFY(std::abs(pillar.length - chord) < 1e-9);
    QCOMPARE(pillar.tests.size(), std::size_t(2));
    QCOMPARE(pillar.tests[0].name, std::string_view("points"));
    QVERIFY(pillar.tests[0].pass());
    QCOMPARE(pillar.tests[1].name, std::string_view("length"));
    QVERIFY(std::abs(pillar.tests[1].value - chord) < 1e-9);
    QCOMPARE(pillar.tests[1].limit, 0.2);
    QVERIFY(!pillar.tests[1].pass());
}

void SliceTraceTest::aPieceIsDiscardedForItsPoints()
{
    QFETCH(bool, precise);
    // Five echoes between gaps of 0.3 m: more than what is merged.
    ScanSlice slice = drawn(emptySlice(degrees(78.0), degrees(0.25), 100), {{{3.0, 4.0}, {-3.0, 4.0}}});
    for (int beam = 30; beam < 69; ++beam)
        slice.ranges[static_cast<std::size_t>(beam)] *= beam < 47 || beam > 51 ? 0.0 : 1.0;

    const SliceTrace trace = traced(slice, precise);

    QCOMPARE(trace.pieces.size(), std::size_t(3));
    QCOMPARE(trace.pieces[1].firstBeam, 47);
    QCOMPARE(trace.pieces[1].lastBeam, 51);
    QCOMPARE(trace.pieces[1].fate, PieceFate::TooFewPoints);
    QCOMPARE(trace.pieces[1].tests[0].value, 5.0);
    QCOMPARE(trace.pieces[1].tests[0].limit, 7.0);
    QVERIFY(!trace.pieces[1].tests[0].pass());
}

void SliceTraceTest::anEchoAloneIsNoRun()
{
    ScanSlice slice = arcOf(61);
    slice.ranges[30] = 2.0;

    const SliceTrace trace = traced(slice);

    QCOMPARE(trace.runs.size(), std::size_t(3));
    QCOMPARE(trace.runs[1].points, 1);
    QCOMPARE(trace.pieces[1].firstBeam, 30);
    QCOMPARE(trace.pieces[1].fate, PieceFate::TooFewPoints);
    QCOMPARE(trace.pieces[1].tests[0].name, std::string_view("points_of_run"));
    QCOMPARE(trace.pieces[1].tests[0].limit, 2.0);
}

void SliceTraceTest::missingBeamsEndARunOrAreBridged()
{
    ScanSlice slice = arcOf(61);
    slice.ranges[30] = 0.0;

    const SliceTrace paper = traced(slice);
    const SliceTrace precise = traced(slice, true);

    QCOMPARE(paper.breaks.size(), std::size_t(1));
    QVERIFY(paper.breaks[0].missing);
    QCOMPARE(paper.breaks[0].before, 29);
    QCOMPARE(paper.breaks[0].after, 31);
    // Two pieces of 30 beams, whether they are joined again or not.
    QCOMPARE(paper.joins.size() + keptBeams(paper).size(), std::size_t(2));
    QVERIFY(precise.breaks.empty());
}

void SliceTraceTest::aCornerIsASplitPoint()
{
    QFETCH(bool, precise);

    const SliceTrace trace = traced(cornerSlice(), precise);

    QCOMPARE(trace.runs.size(), std::size_t(1));
    QCOMPARE(trace.splits.size(), std::size_t(1));
    QCOMPARE(trace.splits[0].beam, 90);
    QCOMPARE(trace.splits[0].test.name, std::string_view("chord_distance"));
    // The last beam, at 116.5°, meets x + y = 2 at a range of 2 / (cos + sin); the chord goes there from (2, 2).
    const double range = 2.0 / (std::cos(degrees(116.5)) + std::sin(degrees(116.5)));
    const Eigen::Vector2d chord{range * std::cos(degrees(116.5)) - 2.0, range * std::sin(degrees(116.5)) - 2.0};
    const double distance = std::abs(crossed(chord.normalized(), Eigen::Vector2d{-2.0, 0.0}));
    QVERIFY(std::abs(trace.splits[0].test.value - distance) < 1e-5);
    QCOMPARE(QString::number(trace.splits[0].test.limit, 'f', 6), QStringLiteral("0.030000"));
    QCOMPARE(keptBeams(trace).size(), std::size_t(2));
    QVERIFY(std::abs(keptBeams(trace)[0].second - 90) <= 1);
}

void SliceTraceTest::aStepTooSmallForChordsIsABend()
{
    // Half of a wall stands back by 2 cm, less than a point may be off its chord, with noise of a millimetre.
    Parameters parameters = tracedTolerances(true);
    parameters.segments.splitDistance = 0.05;
    const ScanSlice slice = noisy(
        drawn(emptySlice(degrees(60.0), degrees(0.25), 241), {{{2.0, 2.0}, {0.0, 2.0}}, {{0.0, 2.02}, {-2.0, 2.02}}}),
        0.001, 4);

    const SliceTrace trace = traceSlice(slice, kTracedSensor, parameters);

    const auto bend = std::find_if(trace.splits.begin(), trace.splits.end(),
                                   [](const TracedSplit& split) { return split.test.name == "two_lines_gain"; });
    QVERIFY(bend != trace.splits.end());
    QVERIFY(std::abs(bend->beam - 120) <= 3);
    QVERIFY(bend->test.pass());
}

void SliceTraceTest::whatIsTracedIsWhatIsExtracted()
{
    QFETCH(bool, precise);
    const Parameters parameters = tracedTolerances(precise);
    std::mt19937_64 random(11);
    for (int round = 0; round < 50; ++round) {
        const ScanSlice slice = noisy(drawn(emptySlice(0.0, degrees(0.25), 721), randomWalls(9, random)), 0.004, 31);

        const SliceTrace trace = traceSlice(slice, kTracedSensor, parameters);

        QCOMPARE(keptBeams(trace), extractedBeams(slice, parameters));
        for (std::size_t i = 0, next = 0; i < trace.pieces.size(); ++i) {
            const TracedPiece& piece = trace.pieces[i];
            const bool allPass =
                std::all_of(piece.tests.begin(), piece.tests.end(), [](const Test& test) { return test.pass(); });
            QCOMPARE(piece.segment >= 0, piece.fate == PieceFate::Segment);
            QCOMPARE(allPass, piece.fate == PieceFate::Segment);
            if (piece.segment >= 0)
                QCOMPARE(piece.segment, static_cast<int>(next++));
        }
        for (const TracedSplit& split : trace.splits)
            QVERIFY(split.test.pass());
        for (const TracedBreak& gap : trace.breaks)
            QVERIFY(gap.missing || gap.gap >= gap.limit);
    }
}

void SliceTraceTest::everyEchoHasOnePlace()
{
    QFETCH(bool, precise);
    std::mt19937_64 random(12);
    for (int round = 0; round < 50; ++round) {
        ScanSlice slice = noisy(drawn(emptySlice(0.0, degrees(0.25), 721), randomWalls(9, random)), 0.01, 32);
        for (double& range : slice.ranges)
            range = uniform(random) < 0.03 ? 0.0 : uniform(random) < 0.03 ? range + 0.5 : range;

        const SliceTrace trace = traced(slice, precise);

        QCOMPARE(trace.breaks.size() + 1, trace.runs.size());
        for (int beam = 0; beam < 721; ++beam) {
            const auto holds = [beam](const auto& part) { return part.firstBeam <= beam && beam <= part.lastBeam; };
            const bool hasEcho = kTracedSensor.hasEcho(slice.ranges[static_cast<std::size_t>(beam)]);
            const auto runs = std::count_if(trace.runs.begin(), trace.runs.end(), holds);
            const auto pieces = std::count_if(trace.pieces.begin(), trace.pieces.end(), holds);
            QVERIFY2(!hasEcho || (runs == 1 && pieces == 1),
                     qPrintable(QString("beam %1: %2 runs, %3 pieces").arg(beam).arg(runs).arg(pieces)));
        }
    }
}

/// Two walls that meet ahead at (0, 2), both 45° to the ray, and between them a point that is as far from either.
void SliceTraceTest::aPointThatNoLineTakesIsToldItsDistance()
{
    ScanSlice slice =
        drawn(emptySlice(degrees(45.0), degrees(0.5), 181), {{{4.0, 6.0}, {0.0, 2.0}}, {{0.0, 2.0}, {-4.0, 6.0}}});
    slice.ranges[90] -= 0.0302 * std::sqrt(2.0);

    const SliceTrace trace = traced(slice);

    // Their far ends are met at 56.3° and 123.7°.
    QCOMPARE(keptBeams(trace), (std::vector<std::pair<int, int>>{{23, 89}, {91, 157}}));
    QCOMPARE(trace.pieces.size(), std::size_t(3));
    const TracedPiece& stranger = trace.pieces[1];
    QCOMPARE(stranger.firstBeam, 90);
    QCOMPARE(stranger.fate, PieceFate::OffTheLines);
    QCOMPARE(stranger.tests.size(), std::size_t(1));
    QCOMPARE(stranger.tests[0].name, std::string_view("line_distance"));
    QVERIFY(std::abs(stranger.tests[0].value - 0.0302) < 1e-6);
    QCOMPARE(stranger.tests[0].limit, 0.03);
    QVERIFY(!stranger.tests[0].pass());
}

/// A wall 2 m ahead whose last point stands out by 4 mm, with noise of 1 mm.
void SliceTraceTest::aPointThatTurnsItsLineIsToldItsVariances()
{
    ScanSlice slice = drawn(emptySlice(degrees(70.0), degrees(0.25), 161), {{{2.0, 2.0}, {-2.0, 2.0}}});
    // At 110° the wall is 2 m / sin 110° away.
    slice.ranges[160] -= 0.004 / std::sin(degrees(110.0));

    const SliceTrace trace = traced(slice, true);

    QCOMPARE(keptBeams(trace), (std::vector<std::pair<int, int>>{{0, 159}}));
    QCOMPARE(trace.pieces.size(), std::size_t(2));
    const Test& told = trace.pieces[1].tests.at(0);
    QCOMPARE(told.name, std::string_view("line_chi2"));
    QVERIFY(!told.pass());
    // The variance of what a line through the other 160 points foretells, from x = 2 / tan: as the line is met at
    // right angles in its middle, it is σ² (1 + 1/n + (x − x̄)²/Σ(x − x̄)²).
    double mean = 0.0;
    for (int i = 0; i < 160; ++i)
        mean += 2.0 / std::tan(degrees(70.0 + 0.25 * i)) / 160.0;
    double spread = 0.0;
    for (int i = 0; i < 160; ++i)
        spread += std::pow(2.0 / std::tan(degrees(70.0 + 0.25 * i)) - mean, 2);
    const double along = 1.996 / std::tan(degrees(110.0)) - mean;
    const double leverage = 1.0 + 1.0 / 160.0 + along * along / spread;
    const double expected = 16.0 / leverage;
    QVERIFY2(std::abs(told.value - expected) < 1e-3 * expected,
             qPrintable(QString("%1 against %2").arg(told.value).arg(expected)));
    QCOMPARE(told.limit, 6.25);
}

void SliceTraceTest::discardedPiecesAreRejected()
{
    QFETCH(bool, precise);
    std::mt19937_64 random(13);
    ScanSlice slice = noisy(drawn(emptySlice(0.0, degrees(0.25), 721), randomWalls(9, random)), 0.01, 33);
    for (double& range : slice.ranges)
        range = uniform(random) < 0.03 ? range + 0.5 : range;
    const SliceTrace trace = traced(slice, precise);
    std::vector<const TracedPiece*> discarded;
    for (const TracedPiece& piece : trace.pieces) {
        if (piece.segment < 0)
            discarded.push_back(&piece);
    }
    QVERIFY(discarded.size() > 3);
    StepReport report;
    const StepClock none;
    StepRecorder recorder(report, none, true);
    recorder.begin(Phase::Extract);

    tellDiscarded(trace, 17, recorder);

    QCOMPARE(report.decisions.size(), discarded.size());
    for (std::size_t i = 0; i < discarded.size(); ++i) {
        const Decision& told = report.decisions[i];
        QCOMPARE(told.phase, Phase::Extract);
        QCOMPARE(told.kind, DecisionKind::Reject);
        QVERIFY(told.result.empty());
        QCOMPARE(told.operands.size(), std::size_t(1));
        const auto& piece = std::get<PieceRef>(told.operands[0]);
        QCOMPARE(piece.step, 17);
        QCOMPARE(piece.firstBeam, discarded[i]->firstBeam);
        QCOMPARE(piece.lastBeam, discarded[i]->lastBeam);
        QCOMPARE(told.tests.size(), discarded[i]->tests.size());
        QVERIFY(std::any_of(told.tests.begin(), told.tests.end(), [](const Test& test) { return !test.pass(); }));
    }
}

void SliceTraceTest::aTraceIsEmptiedForAnotherSlice()
{
    SliceTrace trace = traced(cornerSlice());
    QVERIFY(!trace.splits.empty() && !trace.pieces.empty());

    trace.clear();

    QVERIFY(trace.runs.empty() && trace.breaks.empty() && trace.splits.empty() && trace.joins.empty() &&
            trace.pieces.empty());
}

void SliceTraceTest::noiseOfASnapshotTakesTheParametersPlace()
{
    const Parameters parameters = withNoise(tracedTolerances(true), {0.02, 0.003, 0.004, true});

    QCOMPARE(parameters.noise.rangeConstant, 0.02);
    QCOMPARE(parameters.noise.rangeProportional, 0.003);
    QCOMPARE(parameters.noise.pitch, 0.004);
    QCOMPARE(parameters.noise.bearing, kFineNoise.bearing);
    QCOMPARE(parameters.segments.splitDistance, 0.03);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SliceTraceTest)
#include "slice_trace_test.moc"
