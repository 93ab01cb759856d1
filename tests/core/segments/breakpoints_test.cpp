// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/breakpoints.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QtTest>

#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

using Runs = std::vector<PointRun>;

SegmentParameters tenDegrees(double sigmas)
{
    SegmentParameters parameters;
    parameters.incidenceLimit = degrees(10.0);
    parameters.breakpointSigmas = sigmas;
    return parameters;
}

Runs runsOf(const ScanSlice& slice, double sigmas = 3.0, const NoiseParameters& noise = {0.008, 0.001, 0.0, 0.0})
{
    Runs runs;
    splitAtBreakpoints(pointsOf(slice, noise), slice.bearingStep, tenDegrees(sigmas), runs);
    return runs;
}

/// Eighty beams of a quarter degree about straight ahead, all at one range.
ScanSlice arc(double range)
{
    ScanSlice slice = emptySlice(degrees(80.0), degrees(0.25), 80);
    slice.ranges.assign(80, range);
    return slice;
}

}  // namespace

class BreakpointsTest : public QObject {
    Q_OBJECT

private slots:
    void breakpointDistanceIsEq3ByHand_data();
    void breakpointDistanceIsEq3ByHand();
    void breakpointDistanceStaysBoundedForCoarseScanners();
    void noStepCountsAsFinerThanAQuarterOfADegree();
    void aCoarseScannerSeesAWallAsOneRunAndEndsItBehindAPillar();
    void startsANewRunWhereAPillarHidesTheWall();
    void theRangeOfTheBeamBeforeSetsTheLimit();
    void aGapOfExactlyTheLimitIsABreakpoint();
    void aWallAtTheIncidenceLimitIsOneRun();
    void beamsWithoutEchoEndRuns();
    void rangesOutsideTheLimitsEndRuns();
    void singlePointsAreNoRuns();
    void twoPointsAreARun();
    void aSliceWithoutEchoesHasNoRuns();
    void aSliceWithoutBeamsOrOfOneBeamHasNoRuns();
    void runsOfTheSliceBeforeAreForgotten();
};

void BreakpointsTest::breakpointDistanceIsEq3ByHand_data()
{
    QTest::addColumn<double>("range");
    QTest::addColumn<double>("stepDegrees");
    QTest::addColumn<double>("expected");
    // ρ sin Δθ / sin(10° − Δθ) + 3 √(0.008² + (0.001 ρ)²), with a table of sines.
    QTest::newRow("1 m, 0.25 deg") << 1.0 << 0.25 << 0.00436331 / 0.16935050 + 3.0 * 0.00806226;
    QTest::newRow("6 m, 0.25 deg") << 6.0 << 0.25 << 6.0 * 0.00436331 / 0.16935050 + 3.0 * 0.01;
    QTest::newRow("15 m, 0.25 deg") << 15.0 << 0.25 << 15.0 * 0.00436331 / 0.16935050 + 3.0 * 0.017;
    QTest::newRow("6 m, 0.5 deg") << 6.0 << 0.5 << 6.0 * 0.00872654 / 0.16504761 + 3.0 * 0.01;
    QTest::newRow("6 m, 4 deg") << 6.0 << 4.0 << 6.0 * 0.06975647 / 0.10452846 + 3.0 * 0.01;
}

void BreakpointsTest::breakpointDistanceIsEq3ByHand()
{
    QFETCH(double, range);
    QFETCH(double, stepDegrees);
    QFETCH(double, expected);

    const double distance =
        breakpointDistance(range, degrees(stepDegrees), tenDegrees(3.0), {0.008, 0.001, degrees(0.02), 0.0});

    QVERIFY2(std::abs(distance - expected) < 1e-6 * range, qPrintable(QString::number(distance, 'g', 12)));
}

void BreakpointsTest::breakpointDistanceStaysBoundedForCoarseScanners()
{
    // Eq. (3) as printed divides by zero at Δθ = λ_u and is negative beyond.
    double before = 0.0;
    for (const double step : {1.0, 4.0, 5.0, 6.0, 9.0, 9.999, 10.0, 10.001, 12.0, 15.0}) {
        const double distance = breakpointDistance(4.0, degrees(step), tenDegrees(0.0), {});

        QVERIFY(std::isfinite(distance));
        QVERIFY(distance > before);
        QVERIFY(distance > 2.0 * 4.0 * std::sin(degrees(step) / 2.0));  // points of a circle stay together
        QVERIFY(distance < 4.0 * 4.0);
        before = distance;
    }
}

void BreakpointsTest::noStepCountsAsFinerThanAQuarterOfADegree()
{
    QCOMPARE(breakpointStep(degrees(0.01)), degrees(0.25));
    QCOMPARE(breakpointStep(degrees(0.25)), degrees(0.25));
    QCOMPARE(breakpointStep(degrees(0.5)), degrees(0.5));
}

void BreakpointsTest::aCoarseScannerSeesAWallAsOneRunAndEndsItBehindAPillar()
{
    const DrawnWall wall{{-4.0, 4.0}, {4.0, 4.0}};
    ScanSlice slice = drawn(emptySlice(degrees(50.0), degrees(8.0), 11), {wall});

    const Runs clear = runsOf(slice);
    slice.ranges[4] = 0.5;
    slice.ranges[5] = 0.5;
    const Runs hidden = runsOf(slice);

    // At 4 m a step of 8° allows any gap down to the pillar; at the pillar's own 0.5 m it does not.
    QCOMPARE(clear, (Runs{{0, 10}}));
    QCOMPARE(hidden, (Runs{{0, 5}, {6, 10}}));
}

void BreakpointsTest::startsANewRunWhereAPillarHidesTheWall()
{
    ScanSlice slice = arc(4.0);
    std::fill(slice.ranges.begin() + 30, slice.ranges.begin() + 50, 1.5);

    QCOMPARE(runsOf(slice), (Runs{{0, 29}, {30, 49}, {50, 79}}));
}

void BreakpointsTest::theRangeOfTheBeamBeforeSetsTheLimit()
{
    // From 2.0000 to 2.0513 m the gap is √(0.0513² + 4.1026·(2 sin 0.125°)²) = 0.052056 m; D_o is 0.051530 m at the
    // near point and 0.052852 m at the far one.
    ScanSlice outwards = arc(2.0);
    std::fill(outwards.ranges.begin() + 40, outwards.ranges.end(), 2.0513);
    ScanSlice inwards = arc(2.0513);
    std::fill(inwards.ranges.begin() + 40, inwards.ranges.end(), 2.0);

    QCOMPARE(runsOf(outwards, 0.0), (Runs{{0, 39}, {40, 79}}));
    QCOMPARE(runsOf(inwards, 0.0), (Runs{{0, 79}}));
}

void BreakpointsTest::aGapOfExactlyTheLimitIsABreakpoint()
{
    // Eq. (3) wants the gap to be less. A step of nothing leaves D_o = σ: ranges in eighths of a metre are exact.
    ScanSlice slice = emptySlice(0.0, 0.0, 4);
    slice.ranges = {4.0, 4.0625, 4.1875, 4.25};

    QCOMPARE(runsOf(slice, 1.0, {0.125, 0.0, 0.0, 0.0}), (Runs{{0, 1}, {2, 3}}));
}

void BreakpointsTest::aWallAtTheIncidenceLimitIsOneRun()
{
    // Rays that meet the wall at λ_u see points just D_o apart, so that 11° pass and 9° do not.
    const auto wallAt = [](double incidence) {
        const Eigen::Vector2d along{std::cos(degrees(90.0 - incidence)), std::sin(degrees(90.0 - incidence))};
        const Eigen::Vector2d middle{0.0, 4.0};
        // Eight beams inwards from the bearing of the given incidence; outwards it would become shallower.
        return drawn(emptySlice(degrees(90.0), degrees(0.25), 8), {{middle - 3.0 * along, middle + 3.0 * along}});
    };

    QCOMPARE(runsOf(wallAt(11.0), 0.0), (Runs{{0, 7}}));
    QVERIFY(runsOf(wallAt(7.0), 0.0).empty());
}

void BreakpointsTest::beamsWithoutEchoEndRuns()
{
    ScanSlice slice = arc(4.0);
    slice.ranges[0] = 0.0;
    slice.ranges[20] = 0.0;
    slice.ranges[50] = slice.ranges[51] = 0.0;
    slice.ranges[79] = 0.0;

    QCOMPARE(runsOf(slice), (Runs{{1, 19}, {21, 49}, {52, 78}}));
}

void BreakpointsTest::rangesOutsideTheLimitsEndRuns()
{
    ScanSlice slice = arc(0.1);
    slice.ranges[20] = 0.0999;
    slice.ranges[50] = std::numeric_limits<double>::quiet_NaN();
    slice.ranges[60] = std::numeric_limits<double>::infinity();
    ScanSlice far = arc(29.99);
    far.ranges[20] = 30.01;

    QCOMPARE(runsOf(slice), (Runs{{0, 19}, {21, 49}, {51, 59}, {61, 79}}));
    QCOMPARE(runsOf(far), (Runs{{0, 19}, {21, 79}}));
}

void BreakpointsTest::singlePointsAreNoRuns()
{
    ScanSlice spike = arc(4.0);
    spike.ranges[40] = 1.0;
    ScanSlice lonely = emptySlice(0.0, degrees(0.25), 5);
    lonely.ranges = {4.0, 0.0, 4.0, 0.0, 4.0};

    QCOMPARE(runsOf(spike), (Runs{{0, 39}, {41, 79}}));
    QVERIFY(runsOf(lonely).empty());
}

void BreakpointsTest::twoPointsAreARun()
{
    ScanSlice slice = emptySlice(0.0, degrees(0.25), 6);
    slice.ranges = {4.0, 4.0, 0.0, 0.0, 4.0, 4.0};

    QCOMPARE(runsOf(slice), (Runs{{0, 1}, {4, 5}}));
}

void BreakpointsTest::aSliceWithoutEchoesHasNoRuns()
{
    QVERIFY(runsOf(arc(0.0)).empty());
}

void BreakpointsTest::aSliceWithoutBeamsOrOfOneBeamHasNoRuns()
{
    ScanSlice one = emptySlice(0.0, degrees(0.25), 1);
    one.ranges = {4.0};

    QVERIFY(runsOf(emptySlice(0.0, degrees(0.25), 0)).empty());
    QVERIFY(runsOf(one).empty());
}

void BreakpointsTest::runsOfTheSliceBeforeAreForgotten()
{
    Runs runs{{3, 9}, {12, 40}};

    splitAtBreakpoints(pointsOf(arc(4.0)), degrees(0.25), tenDegrees(3.0), runs);

    QCOMPARE(runs, (Runs{{0, 79}}));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::BreakpointsTest)
#include "breakpoints_test.moc"
