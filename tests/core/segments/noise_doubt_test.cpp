// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/noise_doubt.h"

#include <cmath>
#include <random>

#include <QtTest>

#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Slices of a wall straight ahead at 2 m whose ranges scatter by 9 mm.
Recording noisyWall(int slices)
{
    Recording recording;
    recording.description.rangeMin = 0.1;
    recording.description.rangeMax = 30.0;
    std::mt19937_64 random(11);
    for (int step = 0; step < slices; ++step) {
        ScanSlice slice = drawn(emptySlice(degrees(60.0), degrees(0.25), 241), {{{-3.0, 2.0}, {3.0, 2.0}}});
        slice.step = step;
        for (double& range : slice.ranges)
            range += 0.009 * normal(random);
        recording.slices.push_back(slice);
    }
    return recording;
}

NoiseParameters toldNoise(double constant)
{
    NoiseParameters noise;
    noise.rangeConstant = constant;
    noise.rangeProportional = 0.0;
    return noise;
}

}  // namespace

class NoiseDoubtTest : public QObject {
    Q_OBJECT

private slots:
    void noiseToldFarTooSmallIsDoubted_data();
    void noiseToldFarTooSmallIsDoubted();
    void noiseThatIsEstimatedIsNotDoubted();
    void fewSamplesTellNothing();
};

void NoiseDoubtTest::noiseToldFarTooSmallIsDoubted_data()
{
    QTest::addColumn<double>("told");
    QTest::newRow("2 mm") << 0.002;
    QTest::newRow("0.5 mm") << 0.0005;
    QTest::newRow("nothing") << 0.0;
}

void NoiseDoubtTest::noiseToldFarTooSmallIsDoubted()
{
    QFETCH(const double, told);

    const auto doubt = noiseDoubtOf(noisyWall(40), toldNoise(told));

    QVERIFY(doubt.has_value());
    QCOMPARE(doubt->told, told);
    QVERIFY2(std::abs(doubt->found - 0.009) < 0.001, qPrintable(QString::number(doubt->found)));
    // The mean of 2 m / cos x from −30° to 30°: 2 ln tan 60° / (π/6).
    QVERIFY(std::abs(doubt->range - 2.0 * 0.549306 / 0.523599) < 0.005);
}

void NoiseDoubtTest::noiseThatIsEstimatedIsNotDoubted()
{
    NoiseParameters estimated = toldNoise(0.002);
    estimated.estimated = true;

    QVERIFY(!noiseDoubtOf(noisyWall(40), estimated).has_value());
    QVERIFY(!noiseDoubtOf(noisyWall(40), toldNoise(0.006)).has_value());
    QVERIFY(!noiseDoubtOf(noisyWall(40), toldNoise(0.03)).has_value());
}

void NoiseDoubtTest::fewSamplesTellNothing()
{
    QVERIFY(!noiseDoubtOf(noisyWall(1), toldNoise(0.002)).has_value());
    QVERIFY(!noiseDoubtOf(Recording{}, toldNoise(0.002)).has_value());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::NoiseDoubtTest)
#include "noise_doubt_test.moc"
