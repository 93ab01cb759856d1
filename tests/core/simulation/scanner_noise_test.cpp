// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <vector>

#include <QtTest/QtTest>

#include "core/simulation/nodding_scanner.h"
#include "core/simulation/scene_builder.h"
#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

/// Sums of a sample, held against a normal distribution of mean 0 at 5 standard deviations of either estimate.
struct Sample {
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;

    void add(double x)
    {
        sum += x;
        squares += x * x;
        count += 1.0;
    }
    bool agreesWith(double sigma) const
    {
        const double estimate = std::sqrt(squares / count);
        return std::abs(sum / count) < 5.0 * sigma / std::sqrt(count) &&
               std::abs(estimate - sigma) < 5.0 * sigma / std::sqrt(2.0 * count);
    }
};

/// Many beams that all look in one direction, level.
AcquisitionSettings staring(double bearing, int beams, int slices)
{
    AcquisitionSettings settings;
    settings.firstTilt = degrees(90.0);
    settings.tiltStep = 0.0;
    settings.firstBearing = bearing;
    settings.bearingStep = 0.0;
    settings.beams = beams;
    settings.slices = slices;
    settings.pitchAxisOffset = 0.0;
    return settings;
}

Scene makeFrontalWall(double distance)
{
    SceneBuilder room("test");
    room.wall("wall", {{40.0, distance}, {-40.0, distance}, -40.0, 40.0});
    return room.build({});
}

/// A panel at 2 m on the left of straight ahead, a wall at 4 m behind it.
Scene makeEdge(bool upright)
{
    SceneBuilder room("test");
    if (upright)
        room.wall("panel", {{0.0, 2.0}, {-5.0, 2.0}, -5.0, 5.0});
    else
        room.wall("panel", {{5.0, 2.0}, {-5.0, 2.0}, -5.0, 0.0});
    room.wall("wall", {{40.0, 4.0}, {-40.0, 4.0}, -40.0, 40.0});
    return room.build({});
}

}  // namespace

class ScannerNoiseTest : public QObject {
    Q_OBJECT

private slots:
    void rangeNoiseHasItsSigma_data();
    void rangeNoiseHasItsSigma();
    void bearingNoiseHasItsSigmaAndIsIndependent();
    void pitchNoiseIsOneDrawForAllBeamsOfASlice();
    void dropoutsHaveTheirRate();
    void glassLosesItsShareAsWell();
    void pixelsMixWithinHalfAFootprintOfAnEdgeAndNowhereElse();
    void pixelsMixAtLevelEdgesToo();
    void mixingIsForgivenWithinThreeSigma();
    void aCreaseMixesNothing();
};

void ScannerNoiseTest::rangeNoiseHasItsSigma_data()
{
    QTest::addColumn<QString>("profile");
    QTest::addColumn<double>("distance");
    QTest::addColumn<double>("sigma");
    QTest::newRow("default at 10 m") << "default" << 10.0 << std::sqrt(0.008 * 0.008 + 0.01 * 0.01);
    QTest::newRow("P at 5 m") << "P" << 5.0 << 0.015;
    QTest::newRow("S at 5 m") << "S" << 5.0 << 0.010;
    QTest::newRow("S at 15 m") << "S" << 15.0 << 0.030;
    QTest::newRow("A at 5 m") << "A" << 5.0 << 0.030;
    QTest::newRow("A at 15 m") << "A" << 15.0 << 0.050;
}

void ScannerNoiseTest::rangeNoiseHasItsSigma()
{
    QFETCH(QString, profile);
    QFETCH(double, distance);
    QFETCH(double, sigma);
    SimulationNoise noise = simulationNoise(profile.toStdString()).value();
    noise.bearing = 0.0;
    noise.pitch = 0.0;
    noise.dropout = 0.0;

    const SimulatedScan scan = simulate(makeFrontalWall(distance), staring(degrees(90.0), 20000, 1), noise, 1);

    Sample sample;
    for (const double range : scan.recording.slices[0].ranges)
        sample.add(range - distance);
    QVERIFY(sample.agreesWith(sigma));
}

void ScannerNoiseTest::bearingNoiseHasItsSigmaAndIsIndependent()
{
    SimulationNoise noise;
    noise.bearing = degrees(0.072);

    // A wall at 45°: the range 3/sin θ gives the bearing away.
    const SimulatedScan scan = simulate(makeFrontalWall(3.0), staring(degrees(45.0), 20000, 1), noise, 2);

    Sample sample;
    Sample products;
    double before = 0.0;
    for (const double range : scan.recording.slices[0].ranges) {
        const double error = std::asin(3.0 / range) - degrees(45.0);
        sample.add(error);
        products.add(error * before);
        before = error;
    }
    QVERIFY(sample.agreesWith(noise.bearing));
    QVERIFY(std::abs(products.sum / products.count) < 5.0 * noise.bearing * noise.bearing / std::sqrt(products.count));
}

void ScannerNoiseTest::pitchNoiseIsOneDrawForAllBeamsOfASlice()
{
    SceneBuilder room("test");
    room.level("floor", -1.0, {-40.0, -40.0}, {40.0, 40.0});
    AcquisitionSettings settings = staring(degrees(60.0), 31, 4000);
    settings.bearingStep = degrees(2.0);
    settings.firstTilt = degrees(60.0);
    SimulationNoise noise;
    noise.pitch = degrees(0.084);

    const SimulatedScan scan = simulate(room.build({}), settings, noise, 3);

    // Without d_l the floor is met where ρ sin θ cos φ = 1: every beam gives away the same φ.
    Sample sample;
    for (const ScanSlice& slice : scan.recording.slices) {
        QCOMPARE(slice.tilt, degrees(60.0));
        const double tilt = std::acos(1.0 / (slice.ranges[0] * std::sin(slice.bearing(0))));
        for (std::size_t beam = 1; beam < slice.ranges.size(); ++beam)
            QVERIFY(std::abs(slice.ranges[beam] * std::sin(slice.bearing(beam)) * std::cos(tilt) - 1.0) < 1e-12);
        sample.add(tilt - degrees(60.0));
    }
    QVERIFY(sample.agreesWith(noise.pitch));
}

void ScannerNoiseTest::dropoutsHaveTheirRate()
{
    SimulationNoise noise;
    noise.dropout = 0.004;

    const SimulatedScan scan = simulate(makeFrontalWall(3.0), staring(degrees(90.0), 1000, 100), noise, 4);

    int lost = 0;
    for (std::size_t k = 0; k < 100; ++k)
        for (std::size_t beam = 0; beam < 1000; ++beam) {
            const bool none = scan.recording.slices[k].ranges[beam] == 0.0;
            QCOMPARE(scan.labels[k][beam], none ? kNoTruePlane : 0);
            lost += none ? 1 : 0;
        }
    QVERIFY(std::abs(lost - 400) < 5.0 * std::sqrt(100000 * 0.004 * 0.996));
}

void ScannerNoiseTest::glassLosesItsShareAsWell()
{
    SceneBuilder room("test");
    room.makeGlass(room.wall("pane", {{5.0, 3.0}, {-5.0, 3.0}, -5.0, 5.0}), 0.5);
    SimulationNoise noise;
    noise.dropout = 0.2;

    const SimulatedScan scan = simulate(room.build({}), staring(degrees(90.0), 10000, 1), noise, 5);

    int left = 0;
    for (const double range : scan.recording.slices[0].ranges)
        left += range > 0.0 ? 1 : 0;
    QVERIFY(std::abs(left - 4000) < 5.0 * std::sqrt(10000 * 0.4 * 0.6));
}

void ScannerNoiseTest::pixelsMixWithinHalfAFootprintOfAnEdgeAndNowhereElse()
{
    AcquisitionSettings settings = staring(degrees(89.5), 2001, 1);
    settings.bearingStep = degrees(1.0) / 2000.0;
    SimulationNoise noise;
    noise.mixedPixels = true;

    const SimulatedScan scan = simulate(makeEdge(true), settings, noise, 6);

    int mixed = 0;
    for (std::size_t beam = 0; beam < 2001; ++beam) {
        const double bearing = settings.firstBearing + static_cast<double>(beam) * settings.bearingStep;
        const double fromEdge = bearing - degrees(90.0);
        if (std::abs(fromEdge) < 1e-9 || std::abs(std::abs(fromEdge) - 1.1e-3) < 1e-9)
            continue;
        const double range = scan.recording.slices[0].ranges[beam];
        const double centre = (fromEdge > 0.0 ? 2.0 : 4.0) / std::sin(bearing);
        if (std::abs(fromEdge) < 1.1e-3) {
            // The greater half of the footprint sees what the centre sees.
            const double other = (fromEdge > 0.0 ? 4.0 : 2.0) / std::sin(bearing);
            QVERIFY(std::abs(range - centre) <= 0.5 * std::abs(other - centre) + 0.01);
            QCOMPARE(scan.labels[0][beam], kNoTruePlane);
            ++mixed;
        } else {
            QVERIFY(std::abs(range - centre) < 1e-12);
            QCOMPARE(scan.labels[0][beam], fromEdge > 0.0 ? 0 : 1);
        }
    }
    // 2.2 mrad in steps of 0.0005°.
    QVERIFY(std::abs(mixed - 252) <= 2);
}

void ScannerNoiseTest::pixelsMixAtLevelEdgesToo()
{
    AcquisitionSettings settings = staring(degrees(60.0), 3, 3);
    settings.bearingStep = degrees(30.0);
    settings.firstTilt = degrees(90.0) - 2e-3;
    settings.tiltStep = 1.5e-3;
    SimulationNoise noise;
    noise.mixedPixels = true;

    const SimulatedScan scan = simulate(makeEdge(false), settings, noise, 7);

    // 2 mrad below the panel's upper edge, 0.5 below it, 1 above; the edge is level, so at 60° it is nearer by sin 60°
    // in the angle that the beam's width is measured in.
    QCOMPARE(scan.labels[0], (std::vector<int>{0, 0, 0}));
    QCOMPARE(scan.labels[1], (std::vector<int>{-1, -1, -1}));
    QCOMPARE(scan.labels[2], (std::vector<int>{-1, -1, -1}));
}

void ScannerNoiseTest::mixingIsForgivenWithinThreeSigma()
{
    AcquisitionSettings settings = staring(degrees(89.95), 201, 1);
    settings.bearingStep = degrees(0.1) / 200.0;
    SimulationNoise noise;
    noise.mixedPixels = true;
    noise.rangeConstant = 0.2;

    const SimulatedScan scan = simulate(makeEdge(true), settings, noise, 8);

    // Depths differ by 2 m, of which at most half is mixed in: more than 3 σ for some beams, less for others.
    int forgiven = 0;
    int foreign = 0;
    for (const int label : scan.labels[0])
        (label == kNoTruePlane ? foreign : forgiven) += 1;
    QVERIFY(forgiven > 0);
    QVERIFY(foreign > 0);
}

void ScannerNoiseTest::aCreaseMixesNothing()
{
    SceneBuilder room("test");
    room.wall("left", {{0.0, 3.0}, {-4.0, 1.0}, -5.0, 5.0});
    room.wall("right", {{4.0, 1.0}, {0.0, 3.0}, -5.0, 5.0});
    AcquisitionSettings settings = staring(degrees(89.0), 201, 1);
    settings.bearingStep = degrees(0.01);
    SimulationNoise noise;
    noise.rangeConstant = 0.008;
    SimulationNoise mixing = noise;
    mixing.mixedPixels = true;

    const Scene scene = room.build({});
    const SimulatedScan plain = simulate(scene, settings, noise, 9);
    const SimulatedScan mixed = simulate(scene, settings, mixing, 9);

    QCOMPARE(mixed.recording.slices[0].ranges, plain.recording.slices[0].ranges);
    QCOMPARE(mixed.labels, plain.labels);
}

PLANEWRIGHT_TEST(ScannerNoiseTest)
#include "scanner_noise_test.moc"
