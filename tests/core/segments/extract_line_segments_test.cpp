// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/extract_line_segments.h"

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <QtTest>

#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

const SensorModel kSensor{0.1, 0.1, 30.0};

/// Fixed tolerances, so that nothing here depends on the defaults: straight to 3 cm, at least 0.2 m and 7 points.
Parameters fixedTolerances()
{
    Parameters parameters;
    parameters.noise = kFineNoise;
    parameters.segments.incidenceLimit = degrees(10.0);
    parameters.segments.breakpointSigmas = 3.0;
    parameters.segments.splitDistance = 0.03;
    parameters.segments.splitSigmas = 0.0;
    parameters.segments.mergeAngle = degrees(2.0);
    parameters.segments.mergeGap = 0.25;
    parameters.segments.mergeGapSteps = 0.0;
    parameters.segments.minLength = 0.2;
    parameters.segments.minPoints = 7;
    return parameters;
}

Segments extracted(const ScanSlice& slice, const Parameters& parameters = fixedTolerances())
{
    return LineSegmentExtractor().extract(slice, kSensor, parameters);
}

/// Eq. (6) as printed.
Eigen::Vector3d eq6(double range, double bearing, double tilt)
{
    const double quarter = degrees(90.0);
    return {range * std::cos(bearing),
            range * std::sin(bearing) * std::cos(tilt - quarter) + kSensor.pitchAxisOffset * std::cos(tilt),
            range * std::sin(bearing) * std::sin(tilt - quarter) + kSensor.pitchAxisOffset * std::sin(tilt)};
}

/// C of Eq. (15) with J by central differences of Eq. (6).
Eigen::Matrix3d numericCovariance(double range, double bearing, double tilt, const NoiseParameters& noise)
{
    constexpr double kStep = 1e-5;
    Eigen::Matrix3d jacobian;
    jacobian.col(0) = eq6(range + kStep, bearing, tilt) - eq6(range - kStep, bearing, tilt);
    jacobian.col(1) = eq6(range, bearing + kStep, tilt) - eq6(range, bearing - kStep, tilt);
    jacobian.col(2) = eq6(range, bearing, tilt + kStep) - eq6(range, bearing, tilt - kStep);
    jacobian /= 2.0 * kStep;
    const Eigen::Vector3d variances{std::pow(noise.rangeConstant, 2) + std::pow(noise.rangeProportional * range, 2),
                                    std::pow(noise.bearing, 2), std::pow(noise.pitch, 2)};
    return jacobian * variances.asDiagonal() * jacobian.transpose();
}

const DrawnWall kWallAhead{{-9.0, 4.0}, {9.0, 4.0}};

/// A wall 4 m ahead seen from 45° to 135°, that is from (4, 4) to (−4, 4), by a scanner that looks 30° down.
ScanSlice wallAhead()
{
    ScanSlice slice = drawn(emptySlice(degrees(45.0), degrees(0.25), 361), {kWallAhead});
    slice.tilt = degrees(60.0);
    return slice;
}

/// Walls of a room with noise of 8 mm and every twentieth beam missing.
ScanSlice noisyRoom(std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    ScanSlice slice = drawn(emptySlice(degrees(0.0), degrees(0.25), 721),
                            {{{3.0, -1.0}, {3.0, 4.0}}, {{3.0, 4.0}, {-2.0, 4.0}}, {{-2.0, 4.0}, {-2.0, -1.0}}});
    for (double& range : slice.ranges)
        range = uniform(random) < 0.05 ? 0.0 : range + 0.008 * normal(random);
    slice.step = 17;
    slice.tilt = degrees(72.0);
    return slice;
}

}  // namespace

class ExtractLineSegmentsTest : public QObject {
    Q_OBJECT

private slots:
    void endPointsAreEq6ByHand();
    void theDirectionIsTheUnitVectorFromEndToStart();
    void shorterThanTheLeastLengthIsNoSegment();
    void fewerThanTheLeastPointsIsNoSegment();
    void pointsAreTheEchoesBetweenTheEndPoints();
    void segmentsComeInBearingOrderWithTheStepsIds();
    void aSliceWithoutWallsHasNoSegments();
    void momentsAreThoseOfThePointsInSpace();
    void theRmsIsTheSpreadOfThePointsAboutTheirLine();
    void endPointsHaveTheCovarianceOfEq15();
    void theDirectionsSigmaIsTheEndPointsOverTheLength();
    void theViewpointIsTheLaserOnItsArm();
    void aTiltThatMovesDuringTheSliceIsEachEndPointsOwn();
    void whatAPillarHidesIsShadowed();
    void freeEndsAndCornersAreNotShadowed();
    void anExtractorIsReusedSliceAfterSlice();
};

void ExtractLineSegmentsTest::endPointsAreEq6ByHand()
{
    const Segments segments = extracted(wallAhead());

    // v = 4 ahead at φ = 60°: y = 4 sin 60° + 0.1 cos 60°, z = −4 cos 60° + 0.1 sin 60°.
    const double r3 = std::sqrt(3.0);
    QCOMPARE(segments.size(), std::size_t(1));
    QCOMPARE(segments[0].firstBeam, 0);
    QCOMPARE(segments[0].lastBeam, 360);
    QVERIFY((segments[0].start - Eigen::Vector3d(4.0, 2.0 * r3 + 0.05, -2.0 + 0.05 * r3)).norm() < 1e-12);
    QVERIFY((segments[0].end - Eigen::Vector3d(-4.0, 2.0 * r3 + 0.05, -2.0 + 0.05 * r3)).norm() < 1e-12);
}

void ExtractLineSegmentsTest::theDirectionIsTheUnitVectorFromEndToStart()
{
    QVERIFY((extracted(wallAhead())[0].direction - Eigen::Vector3d::UnitX()).norm() < 1e-12);

    const Segments segments = extracted(noisyRoom(41));

    QVERIFY(!segments.empty());
    for (const LineSegment& segment : segments) {
        QVERIFY(std::abs(segment.direction.norm() - 1.0) < 1e-14);
        QVERIFY((segment.length() * segment.direction - (segment.start - segment.end)).norm() < 1e-12);
    }
}

void ExtractLineSegmentsTest::shorterThanTheLeastLengthIsNoSegment()
{
    // From 70° to 110° the wall measures 2 · 4 tan 20° = 2.91176 m.
    const ScanSlice slice = drawn(emptySlice(degrees(70.0), degrees(0.25), 161), {kWallAhead});
    Parameters shorter = fixedTolerances();
    shorter.segments.minLength = 2.9117;
    Parameters longer = fixedTolerances();
    longer.segments.minLength = 2.9118;

    QCOMPARE(extracted(slice, shorter).size(), std::size_t(1));
    QVERIFY(extracted(slice, longer).empty());
}

void ExtractLineSegmentsTest::fewerThanTheLeastPointsIsNoSegment()
{
    const ScanSlice slice = drawn(emptySlice(degrees(70.0), degrees(0.25), 161), {kWallAhead});
    Parameters as = fixedTolerances();
    as.segments.minPoints = 161;
    Parameters more = fixedTolerances();
    more.segments.minPoints = 162;

    QCOMPARE(extracted(slice, as).size(), std::size_t(1));
    QVERIFY(extracted(slice, more).empty());
}

void ExtractLineSegmentsTest::pointsAreTheEchoesBetweenTheEndPoints()
{
    // Four beams of a dropout do not count, neither as points of the segment nor towards the least number.
    ScanSlice slice = drawn(emptySlice(degrees(70.0), degrees(0.25), 161), {kWallAhead});
    for (std::size_t beam : {50u, 51u, 100u, 101u})
        slice.ranges[beam] = 0.0;
    Parameters as = fixedTolerances();
    as.segments.minPoints = 157;
    Parameters more = fixedTolerances();
    more.segments.minPoints = 158;

    const Segments segments = extracted(slice, as);

    QCOMPARE(segments.size(), std::size_t(1));
    QCOMPARE(segments[0].firstBeam, 0);
    QCOMPARE(segments[0].lastBeam, 160);
    QCOMPARE(segments[0].points, 157);
    QCOMPARE(segments[0].moments.count, 157.0);
    QVERIFY(extracted(slice, more).empty());
}

void ExtractLineSegmentsTest::segmentsComeInBearingOrderWithTheStepsIds()
{
    // Corners at 53.13° and at 116.57°; a post of 10 cm before the middle wall is too small for a segment of its own.
    ScanSlice slice = drawn(emptySlice(0.0, degrees(0.25), 721), {{{3.0, -1.0}, {3.0, 4.0}},
                                                                  {{3.0, 4.0}, {-2.0, 4.0}},
                                                                  {{-2.0, 4.0}, {-2.0, -1.0}},
                                                                  {{0.05, 2.0}, {-0.05, 2.0}}});
    slice.step = 42;

    const Segments segments = extracted(slice);

    QCOMPARE(segments.size(), std::size_t(4));
    for (int i = 0; i < 4; ++i) {
        const LineSegment& segment = segments[static_cast<std::size_t>(i)];
        QVERIFY((segment.id == SegmentId{42, i}));
        QVERIFY(segment.firstBeam < segment.lastBeam);
        QVERIFY(i == 0 || segment.firstBeam > segments[static_cast<std::size_t>(i - 1)].lastBeam);
    }
    QCOMPARE(segments[0].lastBeam, 212);
    QCOMPARE(segments[3].firstBeam, 467);
}

void ExtractLineSegmentsTest::aSliceWithoutWallsHasNoSegments()
{
    QVERIFY(extracted(emptySlice(0.0, degrees(0.25), 721)).empty());
    QVERIFY(extracted(emptySlice(0.0, degrees(0.25), 0)).empty());
}

void ExtractLineSegmentsTest::momentsAreThoseOfThePointsInSpace()
{
    const ScanSlice slice = noisyRoom(42);

    const Segments segments = extracted(slice);

    QVERIFY(segments.size() >= 3);
    for (const LineSegment& segment : segments) {
        std::vector<Eigen::Vector3d> points;
        for (auto beam = static_cast<std::size_t>(segment.firstBeam);
             beam <= static_cast<std::size_t>(segment.lastBeam); ++beam) {
            if (slice.ranges[beam] > 0.0)
                points.push_back(eq6(slice.ranges[beam], slice.bearing(beam), slice.tilt));
        }
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& point : points)
            mean += point / static_cast<double>(points.size());
        Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
        for (const Eigen::Vector3d& point : points)
            scatter += (point - mean) * (point - mean).transpose();
        QCOMPARE(segment.points, static_cast<int>(points.size()));
        QCOMPARE(segment.moments.count, static_cast<double>(points.size()));
        QVERIFY((segment.moments.mean - mean).norm() < 1e-11);
        QVERIFY((segment.moments.scatter - scatter).norm() < 1e-9);
    }
}

void ExtractLineSegmentsTest::theRmsIsTheSpreadOfThePointsAboutTheirLine()
{
    const Segments segments = extracted(noisyRoom(43));

    QVERIFY(segments.size() >= 3);
    for (const LineSegment& segment : segments) {
        // Of the scatter's eigenvalues the least is 0, since the points lie in the slice; the next is across the line.
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(segment.moments.scatter);
        QVERIFY(std::abs(segment.rms - std::sqrt(solver.eigenvalues()[1] / segment.points)) < 1e-8);
        QVERIFY(segment.rms > 0.001 && segment.rms < 0.02);
    }
}

void ExtractLineSegmentsTest::endPointsHaveTheCovarianceOfEq15()
{
    Parameters parameters = fixedTolerances();
    parameters.noise = {0.01, 0.002, degrees(0.05), degrees(0.1)};
    const ScanSlice slice = noisyRoom(44);

    const Segments segments = extracted(slice, parameters);

    QVERIFY(segments.size() >= 3);
    for (const LineSegment& segment : segments) {
        const auto first = static_cast<std::size_t>(segment.firstBeam);
        const auto last = static_cast<std::size_t>(segment.lastBeam);
        const Eigen::Matrix3d start =
            numericCovariance(slice.ranges[first], slice.bearing(first), slice.tilt, parameters.noise);
        const Eigen::Matrix3d end =
            numericCovariance(slice.ranges[last], slice.bearing(last), slice.tilt, parameters.noise);
        QVERIFY((segment.startCovariance - start).norm() < 1e-7 * start.norm());
        QVERIFY((segment.endCovariance - end).norm() < 1e-7 * end.norm());
    }
}

void ExtractLineSegmentsTest::theDirectionsSigmaIsTheEndPointsOverTheLength()
{
    // Rays at 45° carry half of σ_ρ² across the wall: √(½ + ½) · 10 mm over 8 m. Bearings add (ρ σ_θ)²/2 at each end,
    // ρ = 4 √2 m: 16 σ_θ².
    Parameters rangeOnly = fixedTolerances();
    rangeOnly.noise = {0.01, 0.0, 0.0, 0.0};
    Parameters both = fixedTolerances();
    both.noise = {0.01, 0.0, 0.001, 0.5};

    QVERIFY(std::abs(extracted(wallAhead(), rangeOnly)[0].directionSigma - 0.01 / 8.0) < 1e-12);
    QVERIFY(std::abs(extracted(wallAhead(), both)[0].directionSigma - std::sqrt(1e-4 + 32e-6) / 8.0) < 1e-12);
}

void ExtractLineSegmentsTest::theViewpointIsTheLaserOnItsArm()
{
    const Eigen::Vector3d viewpoint = extracted(wallAhead())[0].viewpoint;

    // d_l (0, cos 60°, sin 60°)
    QVERIFY((viewpoint - Eigen::Vector3d(0.0, 0.05, 0.05 * std::sqrt(3.0))).norm() < 1e-14);
}

void ExtractLineSegmentsTest::aTiltThatMovesDuringTheSliceIsEachEndPointsOwn()
{
    // 161 beams while the head nods from 60° to 68°; the wall is seen by beams 40 to 120, from 80° to 100°, a quarter
    // to three quarters on: at 62° and 66°, with 64° in its middle.
    const double half = 4.0 * std::tan(degrees(10.0)) + 1e-6;
    ScanSlice slice = drawn(emptySlice(degrees(70.0), degrees(0.25), 161), {{{-half, 4.0}, {half, 4.0}}});
    slice.tilt = degrees(60.0);
    slice.tiltEnd = degrees(68.0);
    Parameters parameters = fixedTolerances();
    parameters.noise = {0.001, 0.0, degrees(0.05), degrees(0.1)};

    const Segments segments = extracted(slice, parameters);

    const double range = 4.0 / std::cos(degrees(10.0));
    QCOMPARE(segments.size(), std::size_t(1));
    const LineSegment& segment = segments[0];
    QCOMPARE(segment.firstBeam, 40);
    QCOMPARE(segment.lastBeam, 120);
    QVERIFY((segment.start - eq6(range, degrees(80.0), degrees(62.0))).norm() < 1e-12);
    QVERIFY((segment.end - eq6(range, degrees(100.0), degrees(66.0))).norm() < 1e-12);
    const Eigen::Matrix3d start = numericCovariance(range, degrees(80.0), degrees(62.0), parameters.noise);
    const Eigen::Matrix3d end = numericCovariance(range, degrees(100.0), degrees(66.0), parameters.noise);
    QVERIFY((segment.startCovariance - start).norm() < 1e-7 * start.norm());
    QVERIFY((segment.endCovariance - end).norm() < 1e-7 * end.norm());
    QVERIFY((segment.viewpoint - eq6(0.0, 0.0, degrees(64.0))).norm() < 1e-12);
    QVERIFY((segment.moments.mean - eq6(4.0, degrees(90.0), degrees(64.0))).norm() < 1e-11);
    QVERIFY(std::abs(segment.direction.norm() - 1.0) < 1e-14);
}

void ExtractLineSegmentsTest::whatAPillarHidesIsShadowed()
{
    const ScanSlice slice =
        drawn(emptySlice(degrees(45.0), degrees(0.25), 361), {kWallAhead, {{0.3, 2.0}, {-0.3, 2.0}}});

    const Segments segments = extracted(slice);

    // The wall to the right of the pillar, the pillar itself, the wall to its left.
    QCOMPARE(segments.size(), std::size_t(3));
    QVERIFY(!segments[0].startShadowed && segments[0].endShadowed);
    QVERIFY(!segments[1].startShadowed && !segments[1].endShadowed);
    QVERIFY(segments[2].startShadowed && !segments[2].endShadowed);
}

void ExtractLineSegmentsTest::freeEndsAndCornersAreNotShadowed()
{
    // A wall that ends in open air on one side and in a corner on the other.
    const ScanSlice slice =
        drawn(emptySlice(0.0, degrees(0.25), 481), {{{2.0, 4.0}, {-1.0, 4.0}}, {{-1.0, 4.0}, {-1.0, 0.0}}});

    const Segments segments = extracted(slice);

    QCOMPARE(segments.size(), std::size_t(2));
    for (const LineSegment& segment : segments)
        QVERIFY(!segment.startShadowed && !segment.endShadowed);
}

void ExtractLineSegmentsTest::anExtractorIsReusedSliceAfterSlice()
{
    LineSegmentExtractor extractor;
    for (const std::uint64_t seed : {45u, 46u, 47u}) {
        ScanSlice slice = noisyRoom(seed);
        slice.ranges.resize(721 - 100 * (seed - 45));
        int echoes = 0;
        for (const double range : slice.ranges)
            echoes += range > 0.0 ? 1 : 0;

        const Segments segments = extractor.extract(slice, kSensor, fixedTolerances());

        const Segments fresh = extracted(slice);
        QCOMPARE(extractor.echoes(), echoes);
        QCOMPARE(segments.size(), fresh.size());
        for (std::size_t i = 0; i < segments.size(); ++i) {
            QVERIFY(segments[i].id == fresh[i].id);
            QVERIFY(segments[i].start == fresh[i].start && segments[i].end == fresh[i].end);
            QVERIFY(segments[i].moments.scatter == fresh[i].moments.scatter);
        }
    }
    QVERIFY(extractor.extract(emptySlice(0.0, degrees(1.0), 9), kSensor, fixedTolerances()).empty());
    QCOMPARE(extractor.echoes(), 0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ExtractLineSegmentsTest)
#include "extract_line_segments_test.moc"
