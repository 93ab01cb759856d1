// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/beam_kernels.h"

#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A noisy slice round the laser with a few beams without echo, as the kernels take it.
struct Beams {
    std::vector<double> ranges;
    std::vector<float> cosine, sine, range, u, v, relativeVariance;
    int inside = 0;

    explicit Beams(int count, std::uint64_t seed)
    {
        std::mt19937_64 random(seed);
        const auto size = static_cast<std::size_t>(count);
        for (int i = 0; i < count; ++i) {
            const double bearing = degrees(0.25) * i;
            const double wall = 2.0 + 0.5 * std::sin(3.0 * bearing) + (i % 97 > 80 ? 0.7 : 0.0);
            ranges.push_back(i % 31 == 30 ? 0.0 : wall + 0.01 * normal(random));
            cosine.push_back(static_cast<float>(std::cos(bearing)));
            sine.push_back(static_cast<float>(std::sin(bearing)));
        }
        for (auto* array : {&range, &u, &v, &relativeVariance})
            array->resize(size + 15);
    }

    BeamArrays arrays() const { return {u.data(), v.data(), relativeVariance.data()}; }

    void place(const BeamKernels& kernels)
    {
        inside = kernels.place(ranges.data(), cosine.data(), sine.data(), static_cast<int>(ranges.size()), 0.1F, 30.0F,
                               64e-6F, 1e-6F, range.data(), u.data(), v.data(), relativeVariance.data());
    }
};

Beams placedBy(const BeamKernels& kernels, int count, std::uint64_t seed)
{
    Beams beams(count, seed);
    beams.place(kernels);
    return beams;
}

/// The same bits, not only the same value.
bool same(float a, float b)
{
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

bool same(const ChordSums& a, const ChordSums& b)
{
    return same(a.weight, b.weight) && same(a.t, b.t) && same(a.h, b.h) && same(a.tt, b.tt) && same(a.th, b.th) &&
           same(a.hh, b.hh);
}

ChordF chordOf(const Beams& beams, int first, int last)
{
    const auto a = static_cast<std::size_t>(first);
    const auto b = static_cast<std::size_t>(last);
    const float du = beams.u[b] - beams.u[a];
    const float dv = beams.v[b] - beams.v[a];
    const float length = std::sqrt(du * du + dv * dv);
    return {beams.u[a], beams.v[a], du / length, dv / length};
}

constexpr DeviationLimits kLimits{1e-4F, 20.25F, 1.2e-7F};
constexpr WeightModel kModel{1.9F, 0.3F, 64e-6F, 1e-6F, 1.2e-7F};

}  // namespace

class BeamKernelsTest : public QObject {
    Q_OBJECT

private slots:
    void theFastestIsTheLastOfThoseAvailable();
    void everyKindGivesTheSameBits();
    void pointsAreWhereTheRayEnds();
    void gapsAreThoseOfEq3();
    void theFarthestPointIsThatOfBruteForce();
    void sumsAreThoseOfBruteForce();
    void weightsAreTheInverseOfThePredictedVariance();
};

void BeamKernelsTest::theFastestIsTheLastOfThoseAvailable()
{
    QVERIFY(!availableBeamKernels().empty());
    QCOMPARE(availableBeamKernels().front().name, "Baseline");
    QCOMPARE(beamKernels().name, availableBeamKernels().back().name);
}

void BeamKernelsTest::everyKindGivesTheSameBits()
{
    const BeamKernels& baseline = availableBeamKernels().front();
    for (const BeamKernels& kernels : availableBeamKernels()) {
        for (const int count : {1, 2, 3, 7, 15, 16, 17, 31, 33, 100, 721, 1081}) {
            const Beams expected = placedBy(baseline, count, 5);
            const Beams beams = placedBy(kernels, count, 5);
            QCOMPARE(beams.inside, expected.inside);
            for (std::size_t i = 0; i < beams.u.size(); ++i) {
                QVERIFY(same(beams.u[i], expected.u[i]) && same(beams.v[i], expected.v[i]));
                QVERIFY(same(beams.range[i], expected.range[i]));
                QVERIFY(same(beams.relativeVariance[i], expected.relativeVariance[i]));
            }

            std::vector<std::uint8_t> marks(beams.u.size());
            std::vector<std::uint8_t> expectedMarks(beams.u.size());
            kernels.markMissing(beams.range.data(), count, marks.data());
            for (int i = 0; i < count; ++i)
                QCOMPARE(marks[static_cast<std::size_t>(i)], i % 31 == 30 ? 1 : 0);
            kernels.markGaps(beams.arrays(), beams.range.data(), count, 0.03F, 3.0F, marks.data());
            baseline.markGaps(beams.arrays(), beams.range.data(), count, 0.03F, 3.0F, expectedMarks.data());
            QCOMPARE(marks, expectedMarks);

            for (int first = 0; first < count; first += 1 + count / 9) {
                const int last = count - 1 - first / 3;
                if (last <= first)
                    continue;
                const ChordF chord = chordOf(beams, first, last);
                QCOMPARE(kernels.farthest(beams.arrays(), first, last, chord, kLimits),
                         baseline.farthest(beams.arrays(), first, last, chord, kLimits));
                QVERIFY(same(kernels.sums(beams.arrays(), first, last, chord),
                             baseline.sums(beams.arrays(), first, last, chord)));
                QVERIFY(same(kernels.weightedSums(beams.arrays(), first, last, chord, kModel),
                             baseline.weightedSums(beams.arrays(), first, last, chord, kModel)));
            }
        }
    }
}

void BeamKernelsTest::pointsAreWhereTheRayEnds()
{
    const Beams beams = placedBy(beamKernels(), 721, 1);
    int echoes = 0;
    for (std::size_t i = 0; i < beams.ranges.size(); ++i) {
        const double bearing = degrees(0.25) * static_cast<double>(i);
        echoes += beams.ranges[i] > 0.0 ? 1 : 0;
        QVERIFY(std::abs(static_cast<double>(beams.u[i]) - beams.ranges[i] * std::cos(bearing)) < 1e-6);
        QVERIFY(std::abs(static_cast<double>(beams.v[i]) - beams.ranges[i] * std::sin(bearing)) < 1e-6);
    }
    QCOMPARE(beams.inside, echoes);
}

void BeamKernelsTest::gapsAreThoseOfEq3()
{
    const Beams beams = placedBy(beamKernels(), 721, 2);
    std::vector<std::uint8_t> marks(721);

    beamKernels().markGaps(beams.arrays(), beams.range.data(), 721, 0.03F, 3.0F, marks.data());

    QCOMPARE(marks[0], std::uint8_t{1});
    for (std::size_t i = 1; i < 721; ++i) {
        const double before = beams.ranges[i - 1];
        if (before == 0.0 || beams.ranges[i] == 0.0) {
            QCOMPARE(marks[i], std::uint8_t{1});
            continue;
        }
        const double gap = std::hypot(static_cast<double>(beams.u[i] - beams.u[i - 1]),
                                      static_cast<double>(beams.v[i] - beams.v[i - 1]));
        const double limit = 0.03 * before + 3.0 * std::hypot(0.008, 0.001 * before);
        if (std::abs(gap - limit) > 1e-4)  // elsewhere rounding may decide
            QCOMPARE(marks[i] != 0, gap > limit);
    }
}

void BeamKernelsTest::theFarthestPointIsThatOfBruteForce()
{
    const Beams beams = placedBy(beamKernels(), 721, 3);
    const ChordF chord = chordOf(beams, 62, 91);
    int farthest = -1;
    double largest = 0.0;
    for (int i = 62; i <= 91; ++i) {
        const double u = static_cast<double>(beams.u[static_cast<std::size_t>(i)]);
        const double v = static_cast<double>(beams.v[static_cast<std::size_t>(i)]);
        const double normalU = -static_cast<double>(chord.directionV);
        const double normalV = static_cast<double>(chord.directionU);
        const double deviation =
            std::abs(normalU * (u - static_cast<double>(chord.u)) + normalV * (v - static_cast<double>(chord.v)));
        const double cosine = (normalU * u + normalV * v) / std::hypot(u, v);
        const double range = std::hypot(u, v);
        const double variance =
            cosine * cosine * (64e-6 + 1e-6 * range * range) + (1.0 - cosine * cosine) * range * range * 1.2e-7;
        if (deviation > std::max(0.01, 4.5 * std::sqrt(variance)) && deviation > largest) {
            largest = deviation;
            farthest = i;
        }
    }

    QVERIFY(farthest > 62);
    QCOMPARE(beamKernels().farthest(beams.arrays(), 62, 91, chord, kLimits), farthest);
    QCOMPARE(beamKernels().farthest(beams.arrays(), 62, 91, chord, {100.0F, 0.0F, 0.0F}), -1);
}

void BeamKernelsTest::sumsAreThoseOfBruteForce()
{
    const Beams beams = placedBy(beamKernels(), 100, 4);
    const ChordF chord = chordOf(beams, 3, 25);
    double t1 = 0.0;
    double h2 = 0.0;
    double th = 0.0;
    for (std::size_t i = 3; i <= 25; ++i) {
        const double du = static_cast<double>(beams.u[i]) - static_cast<double>(chord.u);
        const double dv = static_cast<double>(beams.v[i]) - static_cast<double>(chord.v);
        const double t = static_cast<double>(chord.directionU) * du + static_cast<double>(chord.directionV) * dv;
        const double h = static_cast<double>(chord.directionU) * dv - static_cast<double>(chord.directionV) * du;
        t1 += t;
        h2 += h * h;
        th += t * h;
    }

    const ChordSums sums = beamKernels().sums(beams.arrays(), 3, 25, chord);

    QCOMPARE(sums.weight, 23.0F);
    QVERIFY(std::abs(static_cast<double>(sums.t) - t1) < 1e-5);
    QVERIFY(std::abs(static_cast<double>(sums.hh) - h2) < 1e-7);
    QVERIFY(std::abs(static_cast<double>(sums.th) - th) < 1e-6);
}

void BeamKernelsTest::weightsAreTheInverseOfThePredictedVariance()
{
    // Three points of a wall 2 m ahead, at u = −1, 0 and 3: of the ray's noise the share (2/ρ)² lies across the wall.
    std::vector<float> u{-1.0F, 0.0F, 3.0F};
    std::vector<float> v{2.0F, 2.0F, 2.0F};
    std::vector<float> unused(3, 0.0F);
    for (auto* array : {&u, &v, &unused})
        array->resize(3 + 15);
    const WeightModel model{2.0F, 1.0F, 1e-4F, 1e-6F, 1e-7F};
    double expected = 0.0;
    for (const double x : {-1.0, 0.0, 3.0}) {
        const double range2 = 4.0 + x * x;
        expected += 1.0 / (4.0 / range2 * (1e-4 + 1e-6 * range2) + x * x / range2 * range2 * 1e-7);
    }

    const ChordSums sums =
        beamKernels().weightedSums({u.data(), v.data(), unused.data()}, 0, 2, {-1.0F, 2.0F, 1.0F, 0.0F}, model);

    QVERIFY(std::abs(static_cast<double>(sums.weight) / expected - 1.0) < 1e-5);
    QCOMPARE(sums.hh, 0.0F);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::BeamKernelsTest)
#include "beam_kernels_test.moc"
