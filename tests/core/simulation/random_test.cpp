// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/random.h"

#include <array>
#include <cmath>

#include <QtTest/QtTest>

#include "tests/test_program.h"

using namespace planewright;

class RandomTest : public QObject {
    Q_OBJECT

private slots:
    void sameSeedAndStreamGiveTheSameNumbers();
    void neighbouringSeedsAndStreamsAreUnrelated();
    void uniformIsUniform();
    void integersAreAllThereAndNoOthers();
    void normalsHaveMeanZeroAndVarianceOne();
};

void RandomTest::sameSeedAndStreamGiveTheSameNumbers()
{
    Random a(7, 3);
    Random b(7, 3);

    for (int i = 0; i < 100; ++i)
        QCOMPARE(a.uniform(), b.uniform());
}

void RandomTest::neighbouringSeedsAndStreamsAreUnrelated()
{
    constexpr int kCount = 10000;
    for (const std::array<std::uint64_t, 2>& other : {std::array<std::uint64_t, 2>{8, 3}, {7, 4}, {3, 7}}) {
        Random a(7, 3);
        Random b(other[0], other[1]);
        double sum = 0.0;
        for (int i = 0; i < kCount; ++i)
            sum += (a.uniform() - 0.5) * (b.uniform() - 0.5);
        // The product of two independent uniforms has standard deviation 1/12.
        QVERIFY(std::abs(sum / kCount) < 5.0 / 12.0 / std::sqrt(kCount));
    }
}

void RandomTest::uniformIsUniform()
{
    constexpr int kCount = 100000;
    Random random(1);
    std::array<int, 10> histogram{};

    for (int i = 0; i < kCount; ++i) {
        const double u = random.uniform(-1.0, 1.0);
        QVERIFY(u >= -1.0 && u < 1.0);
        ++histogram[static_cast<std::size_t>((u + 1.0) * 5.0)];
    }

    for (const int count : histogram)
        QVERIFY(std::abs(count - kCount / 10) < 5.0 * std::sqrt(kCount * 0.1 * 0.9));
}

void RandomTest::integersAreAllThereAndNoOthers()
{
    Random random(2);
    std::array<int, 4> histogram{};

    for (int i = 0; i < 4000; ++i) {
        const int n = random.integer(-1, 2);
        QVERIFY(n >= -1 && n <= 2);
        ++histogram[static_cast<std::size_t>(n + 1)];
    }

    for (const int count : histogram)
        QVERIFY(std::abs(count - 1000) < 5.0 * std::sqrt(4000 * 0.25 * 0.75));
}

void RandomTest::normalsHaveMeanZeroAndVarianceOne()
{
    constexpr int kPairs = 100000;
    Random random(3);
    double sum = 0.0;
    double squares = 0.0;
    double fourth = 0.0;
    double cross = 0.0;

    for (int i = 0; i < kPairs; ++i) {
        const Random::Pair pair = random.normalPair();
        for (const double x : {pair.first, pair.second}) {
            sum += x;
            squares += x * x;
            fourth += x * x * x * x;
        }
        cross += pair.first * pair.second;
    }

    // Standard deviations of the sample moments of a normal distribution: 1, √2 and √96 over √N.
    const double n = 2.0 * kPairs;
    QVERIFY(std::abs(sum / n) < 5.0 / std::sqrt(n));
    QVERIFY(std::abs(squares / n - 1.0) < 5.0 * std::sqrt(2.0 / n));
    QVERIFY(std::abs(fourth / n - 3.0) < 5.0 * std::sqrt(96.0 / n));
    QVERIFY(std::abs(cross / kPairs) < 5.0 / std::sqrt(kPairs));
}

PLANEWRIGHT_TEST(RandomTest)
#include "random_test.moc"
