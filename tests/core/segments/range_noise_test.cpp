// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/range_noise.h"

#include <cmath>
#include <random>

#include <QtTest>

#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

const SensorModel kNoiseSensor{0.05, 0.1, 60.0};
constexpr int kSlices = 40;

/// A room of 5 m by 9 m as a slice sees it, with noise of these parts and every `missing`th beam without echo.
ScanSlice roomSlice(double constant, double proportional, std::uint64_t seed, std::size_t missing = 0)
{
    ScanSlice slice = drawn(emptySlice(degrees(-10.0), degrees(0.25), 801),
                            {{{-2.0, -1.0}, {-2.0, 8.0}}, {{-2.0, 8.0}, {3.0, 8.0}}, {{3.0, 8.0}, {3.0, -1.0}}});
    std::mt19937_64 random(seed);
    for (std::size_t i = 0; i < slice.ranges.size(); ++i) {
        double& range = slice.ranges[i];
        range += range > 0.0 ? std::hypot(constant, proportional * range) * normal(random) : 0.0;
        if (missing > 0 && i % missing == 0)
            range = 0.0;
    }
    return slice;
}

NoiseParameters found(double constant, double proportional, const NoiseParameters& told, std::size_t missing = 0)
{
    RangeNoise noise;
    for (int i = 0; i < kSlices; ++i)
        noise.add(roomSlice(constant, proportional, static_cast<std::uint64_t>(i), missing), kNoiseSensor, told);
    return noise.estimate(told);
}

bool within(double share, double a, double b)
{
    return std::abs(a / b - 1.0) < share;
}

}  // namespace

class RangeNoiseTest : public QObject {
    Q_OBJECT

private slots:
    void withoutSamplesWhatWasToldHolds();
    void constantNoiseIsFound_data();
    void constantNoiseIsFound();
    void noiseThatGrowsWithRangeIsFound();
    void fewFarRangesTellWhatManyNearOnesDoNot();
    void noiseOfASmallWorldIsFound();
    void missingBeamsAndEdgesDoNotCount();
    void aSixteenthOfWhatWasToldIsTheLeast();
    void rangesThatErrTogetherAreNeverBetterThanTold();
    void theShareIsThatOfAllRanges();
    void hostileSlicesAreSurvived();
};

void RangeNoiseTest::withoutSamplesWhatWasToldHolds()
{
    NoiseParameters told;
    told.rangeConstant = 0.007;
    told.rangeProportional = 0.002;

    const NoiseParameters estimate = RangeNoise().estimate(told);

    QVERIFY(within(1e-9, estimate.rangeConstant, 0.007));
    QVERIFY(within(1e-9, estimate.rangeProportional, 0.002));
}

void RangeNoiseTest::constantNoiseIsFound_data()
{
    QTest::addColumn<double>("sigma");
    for (const double sigma : {0.008, 0.01, 0.015, 0.03})
        QTest::addRow("%g mm", 1000.0 * sigma) << sigma;
}

void RangeNoiseTest::constantNoiseIsFound()
{
    QFETCH(double, sigma);

    const NoiseParameters estimate = found(sigma, 0.0, {});

    for (const double range : {3.0, 8.0})
        QVERIFY(within(0.1, std::sqrt(estimate.rangeVariance(range)), sigma));
}

void RangeNoiseTest::noiseThatGrowsWithRangeIsFound()
{
    const NoiseParameters estimate = found(0.004, 0.003, {});

    for (const double range : {2.0, 8.0})
        QVERIFY(within(0.1, std::sqrt(estimate.rangeVariance(range)), std::hypot(0.004, 0.003 * range)));
}

void RangeNoiseTest::fewFarRangesTellWhatManyNearOnesDoNot()
{
    // A wall 1 m away, seen up to 45° to either side, and a door of 0.25 m in it to one 3 m behind: noise that grows
    // with range is half of what is told at the near wall, so that all of it could be constant there, but not at the
    // far one.
    RangeNoise noise;
    for (std::uint64_t seed = 0; seed < kSlices; ++seed) {
        ScanSlice slice = drawn(emptySlice(degrees(45.0), degrees(0.25), 361),
                                {{{-1.1, 1.0}, {-0.12, 1.0}}, {{0.12, 1.0}, {1.1, 1.0}}, {{-2.0, 4.0}, {2.0, 4.0}}});
        std::mt19937_64 random(seed);
        for (double& range : slice.ranges)
            range += 0.0035 * range * normal(random);
        noise.add(slice, kNoiseSensor, {});
    }

    const NoiseParameters estimate = noise.estimate({});

    for (const double range : {1.0, 2.0, 4.0})
        QVERIFY(within(0.12, std::sqrt(estimate.rangeVariance(range)), 0.0035 * range));
}

void RangeNoiseTest::noiseOfASmallWorldIsFound()
{
    // The room at a tenth of its size and of its noise, told the noise of the large one.
    RangeNoise noise;
    for (std::uint64_t seed = 0; seed < kSlices; ++seed) {
        ScanSlice slice = roomSlice(0.008, 0.001, seed);
        for (double& range : slice.ranges)
            range *= 0.1;
        noise.add(slice, {0.005, 0.01, 6.0}, {});
    }

    const NoiseParameters estimate = noise.estimate({});

    for (const double range : {2.0, 8.0})
        QVERIFY(within(0.12, std::sqrt(estimate.rangeVariance(0.1 * range)), 0.1 * std::hypot(0.008, 0.001 * range)));
}

void RangeNoiseTest::missingBeamsAndEdgesDoNotCount()
{
    // With every fifth beam missing two of five triples are whole; the two corners of the room are in both.
    const NoiseParameters estimate = found(0.012, 0.0, {}, 5);

    QVERIFY(within(0.1, std::sqrt(estimate.rangeVariance(3.0)), 0.012));
}

void RangeNoiseTest::aSixteenthOfWhatWasToldIsTheLeast()
{
    NoiseParameters told;
    told.rangeConstant = 0.02;
    told.rangeProportional = 0.004;

    const NoiseParameters estimate = found(0.0, 0.0, told);

    QVERIFY(within(1e-9, estimate.rangeConstant, 0.00125));
    QVERIFY(within(1e-9, estimate.rangeProportional, 0.00025));
}

void RangeNoiseTest::rangesThatErrTogetherAreNeverBetterThanTold()
{
    NoiseParameters told;
    told.rangeConstant = 0.01;
    told.rangeProportional = 0.001;
    told.systematic = 0.001;

    const NoiseParameters estimate = found(0.002, 0.0, told);

    QVERIFY(within(1e-9, estimate.rangeConstant, 0.01));
    QVERIFY(within(1e-9, estimate.rangeProportional, 0.001));
}

/// Told 10 mm and 0.1 %, found half of both.
void RangeNoiseTest::theShareIsThatOfAllRanges()
{
    NoiseParameters told;
    told.rangeConstant = 0.01;
    told.rangeProportional = 0.001;
    NoiseParameters half = told;
    half.rangeConstant = 0.005;
    half.rangeProportional = 0.0005;
    RangeNoise noise;

    QCOMPARE(noise.share(half, told), 1.0);
    ScanSlice wall = emptySlice(0.0, degrees(0.25), 721);
    for (std::size_t i = 0; i < wall.ranges.size(); ++i)
        wall.ranges[i] = 4.0 / std::max(0.2, std::sin(wall.bearing(i)));
    noise.add(wall, kNoiseSensor, told);

    QVERIFY(noise.samples() > 100);
    QVERIFY(within(1e-12, noise.share(half, told), 0.5));
    QVERIFY(within(1e-12, noise.share(told, told), 1.0));
}

void RangeNoiseTest::hostileSlicesAreSurvived()
{
    RangeNoise noise;
    noise.add(emptySlice(0.0, degrees(0.25), 0), kNoiseSensor, {});
    noise.add(emptySlice(0.0, degrees(0.25), 1), kNoiseSensor, {});
    noise.add(emptySlice(0.0, degrees(0.25), 721), kNoiseSensor, {});
    ScanSlice wild = emptySlice(0.0, degrees(0.25), 4001);
    for (std::size_t i = 0; i < wild.ranges.size(); ++i)
        wild.ranges[i] = i % 3 == 0 ? 59.9 : 0.11;
    noise.add(wild, kNoiseSensor, {});

    const NoiseParameters estimate = noise.estimate({});

    QVERIFY(std::isfinite(estimate.rangeConstant) && std::isfinite(estimate.rangeProportional));
    NoiseParameters none;
    none.rangeConstant = none.rangeProportional = 0.0;
    const NoiseParameters ofNone = noise.estimate(none);
    QVERIFY(std::isfinite(ofNone.rangeConstant) && std::isfinite(ofNone.rangeProportional));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::RangeNoiseTest)
#include "range_noise_test.moc"
