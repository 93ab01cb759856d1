// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/lanes.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {
namespace {

/// Lanes that hold the powers of two from 1 to 32768, but for the one that is asked for: it holds 65536.
template <int Width>
LanesOf<Width> powersOfTwo(int most)
{
    LanesOf<Width> lanes;
    for (int i = 0; i < kLanes; ++i)
        lanes.part[i / Width][i % Width] = static_cast<float>(1 << (i == most ? 16 : i));
    return lanes;
}

/// Every lane adds one bit of its own, and each is the largest in turn.
template <int Width>
void checkWidth()
{
    QCOMPARE(powersOfTwo<Width>(-1).sum(), 65535.0F);
    for (int most = 0; most < kLanes; ++most)
        QCOMPARE(powersOfTwo<Width>(most).largest(), 65536.0F);
}

/// 2²⁴ + 1 is 2²⁴ in floats: which lanes are added first shows in the sum.
template <int Width>
float sumThatRounds()
{
    LanesOf<Width> lanes;
    lanes.part[0][0] = 16777216.0F;
    for (const int lane : {1, 2, 3})
        lanes.part[0][lane] = 1.0F;
    return lanes.sum();
}

}  // namespace

class LanesTest : public QObject {
    Q_OBJECT

private slots:
    void everyLaneCounts();
    void sumsRunInOneOrderWhateverTheWidth();
};

void LanesTest::everyLaneCounts()
{
    checkWidth<4>();
    checkWidth<8>();
    checkWidth<16>();
}

void LanesTest::sumsRunInOneOrderWhateverTheWidth()
{
    // (2²⁴ + 1) + (1 + 1): the first pair loses its 1, the second does not.
    QCOMPARE(sumThatRounds<4>(), 16777218.0F);
    QCOMPARE(sumThatRounds<8>(), 16777218.0F);
    QCOMPARE(sumThatRounds<16>(), 16777218.0F);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::LanesTest)
#include "lanes_test.moc"
