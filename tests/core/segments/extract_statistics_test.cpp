// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/extract_statistics.h"

#include <cmath>
#include <random>
#include <vector>

#include <QtTest>

#include "tests/core/params/preset_parameters.h"
#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

const SensorModel kStatisticsSensor{0.05, 0.1, 30.0};

std::vector<SegmentStatistics> segmentsOf(const ScanSlice& slice, const Parameters& parameters = precise())
{
    StatisticsExtractor extractor;
    std::vector<SegmentStatistics> segments;
    extractor.extract(slice, kStatisticsSensor, parameters, segments);
    return segments;
}

double distanceToCentroid(const DrawnWall& wall, const SegmentStatistics& segment)
{
    return distanceTo(wall, {segment.u, segment.v});
}

/// Angle between a segment and a wall [rad].
double angleTo(const DrawnWall& wall, const SegmentStatistics& segment)
{
    const Eigen::Vector2d along = (wall.to - wall.from).normalized();
    return std::abs(std::asin(crossed(along, {segment.directionU, segment.directionV})));
}

}  // namespace

class ExtractStatisticsTest : public QObject {
    Q_OBJECT

private slots:
    void aSliceWithoutEchoesHasNoSegments();
    void exactWallsAreExactSegments();
    void directionsRunTowardsHigherBearings();
    void aWallSeenAtAShallowAngleStaysWhole();
    void missingBeamsDoNotEndAWall();
    void aPillarEndsAWall();
    void aFineBearingStepDividesNoWall();
    void aDoorSetBackAFewCentimetresIsASegmentOfItsOwn();
    void aStepThatNoSinglePointShowsIsFound();
    void aMixedPixelEndsNoSegment();
    void aCurveIsNoStraightSegment();
    void aStrangerIsClippedAndWeighsLess();
    void informationIsTheSumOfInverseVariances();
    void informationIsHonest();
    void noiseAlongTheRayMovesNoLine_data();
    void noiseAlongTheRayMovesNoLine();
    void aLongRowOfTeethIsSurvived();
};

void ExtractStatisticsTest::aSliceWithoutEchoesHasNoSegments()
{
    QVERIFY(segmentsOf(emptySlice(0.0, degrees(0.25), 721)).empty());
    QVERIFY(segmentsOf(emptySlice(0.0, degrees(0.25), 0)).empty());
}

void ExtractStatisticsTest::exactWallsAreExactSegments()
{
    std::mt19937_64 random(3);
    const auto walls = randomWalls(8, random);

    const auto segments = segmentsOf(drawn(emptySlice(degrees(0.1), degrees(0.25), 300), walls));

    QVERIFY(segments.size() >= 4);
    for (const SegmentStatistics& segment : segments) {
        double nearest = 1.0;
        for (const DrawnWall& wall : walls) {
            if (distanceToCentroid(wall, segment) + angleTo(wall, segment) < nearest)
                nearest = distanceToCentroid(wall, segment) + angleTo(wall, segment);
        }
        QVERIFY2(nearest < 1e-4, qPrintable(QString::number(nearest)));
    }
}

void ExtractStatisticsTest::directionsRunTowardsHigherBearings()
{
    const auto segments = segmentsOf(drawn(emptySlice(degrees(60.0), degrees(0.25), 241), {{{3.0, 2.0}, {-3.0, 2.0}}}));

    QCOMPARE(segments.size(), std::size_t(1));
    QVERIFY(segments[0].directionU < -0.999999);
    QVERIFY(segments[0].start < 0.0 && segments[0].end > 0.0);
    // From bearing 60° to 120° at v = 2: u from 2/tan 60° to −2/tan 60°.
    QVERIFY(std::abs(segments[0].length() - 4.0 / std::tan(degrees(60.0))) < 1e-5);
}

void ExtractStatisticsTest::aWallSeenAtAShallowAngleStaysWhole()
{
    // A side wall at u = 1 m: at bearing 2° rays meet it at 2°, and neighbours are 3.6 m apart.
    const auto segments =
        segmentsOf(drawn(emptySlice(degrees(2.0), degrees(0.25), 300), {{{1.0, -40.0}, {1.0, 40.0}}}));

    QCOMPARE(segments.size(), std::size_t(1));
    QCOMPARE(segments[0].points, 300);
}

void ExtractStatisticsTest::missingBeamsDoNotEndAWall()
{
    ScanSlice slice = drawn(emptySlice(degrees(60.0), degrees(0.25), 241), {{{3.0, 2.0}, {-3.0, 2.0}}});
    for (const std::size_t beam : {40U, 100U, 101U, 102U, 103U, 170U})
        slice.ranges[beam] = 0.0;

    const auto segments = segmentsOf(slice);

    QCOMPARE(segments.size(), std::size_t(1));
    QCOMPARE(segments[0].points, 235);
    QCOMPARE(segments[0].lastBeam, 240);
}

void ExtractStatisticsTest::aPillarEndsAWall()
{
    const auto segments = segmentsOf(
        drawn(emptySlice(degrees(60.0), degrees(0.25), 241), {{{3.0, 4.0}, {-3.0, 4.0}}, {{0.2, 2.0}, {-0.2, 2.0}}}));

    QCOMPARE(segments.size(), std::size_t(3));
    QVERIFY(std::abs(segments[1].v - 2.0) < 1e-5);
    QVERIFY(segments[1].startsFree && segments[1].endsFree);
    QVERIFY(!segments[0].endsFree && !segments[2].startsFree);
}

void ExtractStatisticsTest::aFineBearingStepDividesNoWall()
{
    // Points are 0.7 mm apart and stray by 9 mm: neighbours are as far apart as noise happens to put them, once in some
    // hundred by more than what a step of 0.01° and three standard deviations would allow.
    ScanSlice slice =
        drawn(emptySlice(degrees(60.0), degrees(0.01), 6001), {{{3.0, 4.0}, {-3.0, 4.0}}, {{0.2, 2.0}, {-0.2, 2.0}}});
    std::mt19937_64 random(1);
    for (double& range : slice.ranges)
        range += 0.009 * normal(random);

    const auto segments = segmentsOf(slice);

    QCOMPARE(segments.size(), std::size_t(3));
    // From bearing arctan(2 / 0.2), 84.29°, to its mirror image.
    QVERIFY(std::abs(segments[1].firstBeam - 2429) <= 2 && std::abs(segments[1].lastBeam - 3571) <= 2);
    QVERIFY(segments[1].startsFree && segments[1].endsFree);
}

void ExtractStatisticsTest::aDoorSetBackAFewCentimetresIsASegmentOfItsOwn()
{
    const std::vector<DrawnWall> walls{{{3.0, 2.0}, {0.45, 2.0}},
                                       {{0.45, 2.0}, {0.45, 2.07}},
                                       {{0.45, 2.07}, {-0.45, 2.07}},
                                       {{-0.45, 2.07}, {-0.45, 2.0}},
                                       {{-0.45, 2.0}, {-3.0, 2.0}}};

    const auto segments = segmentsOf(noisy(drawn(emptySlice(degrees(50.0), degrees(0.25), 321), walls), 0.008, 7));

    const auto door = std::find_if(segments.begin(), segments.end(), [](const SegmentStatistics& segment) {
        return segment.u > -0.1 && segment.u < 0.1 && segment.points > 60;
    });
    QVERIFY(door != segments.end());
    QVERIFY(std::abs(door->v - 2.07) < 0.004);
}

void ExtractStatisticsTest::aStepThatNoSinglePointShowsIsFound()
{
    // 50 mm of depth in noise of 15 mm: less than the 4.5 standard deviations at which a single point splits.
    const std::vector<DrawnWall> walls{{{1.5, 2.0}, {0.1, 2.0}}, {{0.1, 2.05}, {-1.2, 2.05}}};
    Parameters parameters = precise();
    parameters.noise.rangeConstant = 0.015;

    const auto segments =
        segmentsOf(noisy(drawn(emptySlice(degrees(55.0), degrees(0.25), 261), walls), 0.015, 5), parameters);

    QCOMPARE(segments.size(), std::size_t{2});
    for (std::size_t i = 0; i < 2; ++i) {
        QVERIFY(distanceToCentroid(walls[i], segments[i]) < 4.0 * 0.015 / std::sqrt(segments[i].points));
        QVERIFY(angleTo(walls[i], segments[i]) < 4.0 / std::sqrt(segments[i].slopeInformation));
    }
    // The step is 0.1 m right of straight ahead at 2 m: after 32 degrees of the slice's, to a few beams.
    QVERIFY(std::abs(segments[0].lastBeam - 128) <= 8);
}

void ExtractStatisticsTest::aMixedPixelEndsNoSegment()
{
    ScanSlice slice = drawn(emptySlice(degrees(60.0), degrees(0.25), 241), {{{3.0, 2.0}, {-3.0, 2.0}}});
    slice.ranges[0] += 0.06;  // too little for a breakpoint, far too much for noise
    slice.ranges[240] += 0.06;

    const auto segments = segmentsOf(noisy(slice, 0.001, 2));

    QCOMPARE(segments.size(), std::size_t(1));
    // Up to three good points next to each may go with it.
    QVERIFY(segments[0].firstBeam >= 1 && segments[0].firstBeam <= 4);
    QVERIFY(segments[0].lastBeam <= 239 && segments[0].lastBeam >= 236);
}

void ExtractStatisticsTest::aCurveIsNoStraightSegment()
{
    ScanSlice slice = emptySlice(degrees(45.0), degrees(0.25), 361);
    slice.ranges.assign(361, 3.0);

    const auto segments = segmentsOf(slice);

    QVERIFY(segments.size() >= 4);
    for (const SegmentStatistics& segment : segments)
        QVERIFY(segment.length() < 1.5);
}

void ExtractStatisticsTest::aStrangerIsClippedAndWeighsLess()
{
    // One wall, one point of it 4 σ off: below the split threshold, yet no point of the line.
    const ScanSlice wall = drawn(emptySlice(degrees(75.0), degrees(0.25), 121), {{{3.0, 2.0}, {-3.0, 2.0}}});
    ScanSlice slice = noisy(wall, 0.004, 9);
    for (std::size_t beam = 55; beam < 60; ++beam)
        slice.ranges[beam] = wall.ranges[beam] + 0.034;

    const auto segments = segmentsOf(slice);

    QCOMPARE(segments.size(), std::size_t(1));
    QVERIFY(std::abs(segments[0].v - 2.0) < 0.0025);
}

void ExtractStatisticsTest::informationIsTheSumOfInverseVariances()
{
    // Ranges differ by 2 here, so that every point has its own weight.
    const ScanSlice slice = drawn(emptySlice(degrees(30.0), degrees(0.25), 241), {{{8.0, 2.0}, {-8.0, 2.0}}});
    const Parameters parameters = precise();
    double expected = 0.0;
    for (std::size_t beam = 0; beam < slice.ranges.size(); ++beam) {
        const double sine = std::sin(slice.bearing(beam));
        const double range = slice.ranges[beam];
        const double tangential = range * parameters.noise.bearing * std::cos(slice.bearing(beam));
        expected += 1.0 / (sine * sine * parameters.noise.rangeVariance(range) + tangential * tangential);
    }

    const auto segments = segmentsOf(slice);

    QCOMPARE(segments.size(), std::size_t(1));
    QVERIFY(std::abs(segments[0].offsetInformation / expected - 1.0) < 1e-4);
}

void ExtractStatisticsTest::informationIsHonest()
{
    const DrawnWall wall{{3.0, 2.2}, {-3.0, 1.8}};
    const ScanSlice exact = drawn(emptySlice(degrees(55.0), degrees(0.25), 281), {wall});
    const Eigen::Vector2d along = (wall.to - wall.from).normalized();
    Parameters parameters = precise();
    parameters.noise = {0.01, 0.0, 0.0, 0.0};
    double place = 0.0;
    double slope = 0.0;
    double chi = 0.0;
    int runs = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const auto segments = segmentsOf(noisy(exact, 0.01, seed), parameters);
        if (segments.size() != 1)
            continue;  // the threshold splits a straight wall now and then
        const SegmentStatistics& s = segments[0];
        const double offset = crossed(along, {s.u - wall.from.x(), s.v - wall.from.y()});
        const double turn = crossed(along, {s.directionU, s.directionV});
        place += offset * offset * s.offsetInformation;
        slope += turn * turn * s.slopeInformation;
        chi += s.chi / (s.points - 2.0);
        ++runs;
    }

    // Means of 300 squares of standard normals have a standard deviation of 0.08.
    QVERIFY(runs > 280);
    QVERIFY2(std::abs(place / runs - 1.0) < 0.3, qPrintable(QString::number(place / runs)));
    QVERIFY2(std::abs(slope / runs - 1.0) < 0.3, qPrintable(QString::number(slope / runs)));
    QVERIFY2(std::abs(chi / runs - 1.0) < 0.05, qPrintable(QString::number(chi / runs)));
}

void ExtractStatisticsTest::noiseAlongTheRayMovesNoLine_data()
{
    QTest::addColumn<double>("firstBearing");
    QTest::addColumn<int>("beams");

    QTest::newRow("one weight for all") << 110.0 << 80;
    QTest::newRow("a weight for each point") << 90.0 << 250;
}

void ExtractStatisticsTest::noiseAlongTheRayMovesNoLine()
{
    // Noise of 2 % of the range: a wall 1.5 m ahead, seen to its left.
    QFETCH(const double, firstBearing);
    QFETCH(const int, beams);
    constexpr int kDraws = 2000;
    const ScanSlice exact =
        drawn(emptySlice(degrees(firstBearing), degrees(0.25), beams), {{{2.0, 1.5}, {-20.0, 1.5}}});
    Parameters parameters = precise();
    parameters.noise = {0.03, 0.0, 0.0, 0.0};
    double place = 0.0;
    double slope = 0.0;
    int segments = 0;
    for (std::uint64_t seed = 1; seed <= kDraws; ++seed) {
        const auto found = segmentsOf(noisy(exact, 0.03, seed), parameters);
        if (found.size() != 1)
            continue;  // the threshold splits a straight wall now and then
        place += (found[0].v - 1.5) * std::sqrt(found[0].offsetInformation);
        slope += found[0].directionV * std::sqrt(found[0].slopeInformation);
        ++segments;
    }

    // Means of so many standard normals have a standard deviation of 0.023.
    QVERIFY(segments > kDraws * 9 / 10);
    QVERIFY2(std::abs(place / segments) < 0.1, qPrintable(QString::number(place / segments)));
    QVERIFY2(std::abs(slope / segments) < 0.1, qPrintable(QString::number(slope / segments)));
}

void ExtractStatisticsTest::aLongRowOfTeethIsSurvived()
{
    ScanSlice slice = emptySlice(0.0, degrees(180.0) / 65535, 65536);
    for (std::size_t beam = 0; beam < slice.ranges.size(); ++beam)
        slice.ranges[beam] = 5.0 + (beam % 2 == 0 ? 0.05 : -0.05);

    const auto segments = segmentsOf(slice);

    for (const SegmentStatistics& segment : segments)
        QVERIFY(std::isfinite(segment.u) && std::isfinite(segment.slopeInformation) && std::isfinite(segment.chi));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ExtractStatisticsTest)
#include "extract_statistics_test.moc"
