// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/nodding_scanner.h"

#include <cmath>

#include <QtTest/QtTest>

#include "core/geometry/sensor_model.h"
#include "core/simulation/scene_builder.h"
#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

constexpr std::uint64_t kSeed = 5;

Scene makeWallAndFloor()
{
    SceneBuilder room("test");
    room.level("floor", -1.0, {-40.0, -40.0}, {40.0, 40.0});
    room.wall("wall", {{40.0, 4.0}, {-40.0, 4.0}, -1.0, 40.0});
    return room.build({});
}

/// The distance of a point from the nearest cylinder's mantle.
double distanceToCylinders(const Scene& scene, const Eigen::Vector3d& point)
{
    double nearest = 1e9;
    for (const CylinderSurface& c : scene.cylinders) {
        const Eigen::Vector3d axis = c.axis.normalized();
        const Eigen::Vector3d offset = point - c.base;
        const double fromAxis = (offset - axis * axis.dot(offset)).norm();
        nearest = std::min(nearest, std::abs(fromAxis - c.radius.norm()));
    }
    return nearest;
}

}  // namespace

class NoddingScannerTest : public QObject {
    Q_OBJECT

private slots:
    void theRecordingSaysHowItWasTaken();
    void rangesFollowFromEquation6();
    void continuousNoddingTiltsDuringTheSlice();
    void rangesOutsideTheLimitsAreNoReturns();
    void noiseFreePointsLieOnTheirPlane_data();
    void noiseFreePointsLieOnTheirPlane();
    void theSameSeedGivesTheSameBits_data();
    void theSameSeedGivesTheSameBits();
    void anotherSeedGivesOtherRanges();
    void aSliceAloneEqualsThatOfTheScan();
    void anEmptySceneGivesOnlyZeros();
};

void NoddingScannerTest::theRecordingSaysHowItWasTaken()
{
    AcquisitionSettings settings = acquisitionSettings("table10-4").value();
    settings.slices = 3;

    const SimulatedScan scan = simulate(makeWallAndFloor(), settings, {}, kSeed);

    const ScanDescription& d = scan.recording.description;
    QCOMPARE(d.beams, 881);
    QCOMPARE(d.firstBearing, degrees(-20.0));
    QCOMPARE(d.bearingStep, degrees(0.25));
    QCOMPARE(d.rangeMin, 0.1);
    QCOMPARE(d.rangeMax, 30.0);
    QCOMPARE(d.pitchAxisOffset, 0.05);
    QCOMPARE(d.scanner, std::string("UTM-30LX"));
    QCOMPARE(scan.recording.slices.size(), std::size_t(3));
    const ScanSlice& last = scan.recording.slices[2];
    QCOMPARE(last.step, 2);
    QCOMPARE(last.time.count(), 50'000);
    QVERIFY(std::abs(toDegrees(last.tilt) - 12.32) < 1e-12);
    QVERIFY(!last.tiltEnd);
    QCOMPARE(last.ranges.size(), std::size_t(881));
    QCOMPARE(scan.labels[2].size(), std::size_t(881));
}

void NoddingScannerTest::rangesFollowFromEquation6()
{
    AcquisitionSettings settings;
    settings.firstTilt = degrees(60.0);
    settings.tiltStep = degrees(30.0);
    settings.slices = 2;
    settings.firstBearing = degrees(30.0);
    settings.bearingStep = degrees(60.0);
    settings.beams = 2;

    const SimulatedScan scan = simulate(makeWallAndFloor(), settings, {}, kSeed);

    // Downwards by 30°: −ρ sin θ cos φ + d_l sin φ = −1, met 1.8 m ahead, before the wall.
    const double ahead = (1.0 + 0.05 * std::sin(degrees(60.0))) / std::cos(degrees(60.0));
    QVERIFY(std::abs(scan.recording.slices[0].ranges[0] - 2.0 * ahead) < 1e-12);
    QVERIFY(std::abs(scan.recording.slices[0].ranges[1] - ahead) < 1e-12);
    QCOMPARE(scan.labels[0][1], 0);
    // Level: the wall at 4 m.
    QVERIFY(std::abs(scan.recording.slices[1].ranges[0] - 8.0) < 1e-12);
    QVERIFY(std::abs(scan.recording.slices[1].ranges[1] - 4.0) < 1e-12);
    QCOMPARE(scan.labels[1][1], 1);
}

void NoddingScannerTest::continuousNoddingTiltsDuringTheSlice()
{
    AcquisitionSettings settings;
    settings.firstTilt = degrees(40.0);
    settings.tiltStep = degrees(2.0);
    settings.slices = 4;
    settings.continuous = true;

    const SimulatedScan scan = simulate(makeWallAndFloor(), settings, {}, kSeed);

    int onFloor = 0;
    const SensorModel sensor = sensorOf(scan.recording.description);
    for (std::size_t k = 0; k < scan.recording.slices.size(); ++k) {
        const ScanSlice& slice = scan.recording.slices[k];
        QVERIFY(slice.tiltEnd);
        QVERIFY(std::abs(*slice.tiltEnd - slice.tilt - degrees(2.0)) < 1e-15);
        for (std::size_t beam = 0; beam < slice.ranges.size(); ++beam) {
            if (scan.labels[k][beam] != 0)
                continue;
            // In the middle of the slice the head has made half its way.
            const double tilt = degrees(40.0 + 2.0 * (static_cast<double>(k) + static_cast<double>(beam) / 720.0));
            QVERIFY(std::abs(toCartesian(slice.ranges[beam], slice.bearing(beam), tilt, sensor).z() + 1.0) < 1e-11);
            ++onFloor;
        }
    }
    QVERIFY(onFloor > 2000);
}

void NoddingScannerTest::rangesOutsideTheLimitsAreNoReturns()
{
    SceneBuilder room("test");
    room.wall("near", {{1.0, 0.09}, {0.0, 0.09}, -1.0, 1.0});
    room.wall("far", {{0.0, 29.0}, {-29.0, 29.0}, -1.0, 1.0});
    AcquisitionSettings settings;
    settings.firstTilt = degrees(90.0);
    settings.slices = 1;

    const SimulatedScan scan = simulate(room.build({}), settings, {}, kSeed);

    for (std::size_t beam = 0; beam < 721; ++beam) {
        const double range = scan.recording.slices[0].ranges[beam];
        const double bearing = degrees(0.25 * static_cast<double>(beam));
        // The near wall hides what is behind it, also where it is too near itself; on the axis nothing is met.
        const bool right = bearing < degrees(89.9);
        const bool left = bearing > degrees(90.1) && bearing < degrees(134.9);
        const double distance = right ? 0.09 / std::sin(bearing) : 29.0 / std::sin(bearing);
        const bool reaches = right ? distance * std::cos(bearing) < 1.0 : left;
        if (!right && !left)
            continue;
        const bool seen = reaches && distance >= 0.1 && distance <= 30.0;
        QCOMPARE(range > 0.0, seen);
        QCOMPARE(scan.labels[0][beam] >= 0, seen);
    }
}

void NoddingScannerTest::noiseFreePointsLieOnTheirPlane_data()
{
    QTest::addColumn<QString>("name");
    for (const std::string_view name : sceneNames())
        QTest::newRow(std::string(name).c_str()) << QString::fromStdString(std::string(name));
}

void NoddingScannerTest::noiseFreePointsLieOnTheirPlane()
{
    QFETCH(QString, name);
    const Scene scene = makeScene(name.toStdString(), 2).value();
    const AcquisitionSettings settings = acquisitionSettings("table10-4").value();

    const SimulatedScan scan = simulate(scene, settings, simulationNoise("none").value(), kSeed);

    const SensorModel sensor = sensorOf(scan.recording.description);
    for (std::size_t k = 0; k < scan.recording.slices.size(); ++k) {
        const ScanSlice& slice = scan.recording.slices[k];
        for (std::size_t beam = 0; beam < slice.ranges.size(); ++beam) {
            const int label = scan.labels[k][beam];
            QCOMPARE(label == kNoTruePlane, slice.ranges[beam] == 0.0);
            const Eigen::Vector3d point = toCartesian(slice.ranges[beam], slice.bearing(beam), slice.tilt, sensor);
            if (label >= 0) {
                const TruePlane& plane = scene.planes[static_cast<std::size_t>(label)];
                QVERIFY(std::abs(plane.normal.dot(point) - plane.distance) < 1e-12);
            } else if (label == kNotPlanar) {
                QVERIFY(distanceToCylinders(scene, point) < 1e-9);
            }
        }
    }
}

void NoddingScannerTest::theSameSeedGivesTheSameBits_data()
{
    noiseFreePointsLieOnTheirPlane_data();
}

void NoddingScannerTest::theSameSeedGivesTheSameBits()
{
    QFETCH(QString, name);
    const SimulationNoise noise = simulationNoise("default").value();

    const SimulatedScan a = simulate(makeScene(name.toStdString(), 6).value(), {}, noise, 9);
    const SimulatedScan b = simulate(makeScene(name.toStdString(), 6).value(), {}, noise, 9);

    QCOMPARE(a.labels, b.labels);
    for (std::size_t k = 0; k < a.recording.slices.size(); ++k)
        QCOMPARE(a.recording.slices[k].ranges, b.recording.slices[k].ranges);
}

void NoddingScannerTest::anotherSeedGivesOtherRanges()
{
    const SimulationNoise noise = simulationNoise("default").value();
    const Scene scene = makeScene("corridor", 6).value();

    const SimulatedScan a = simulate(scene, {}, noise, 9);
    const SimulatedScan b = simulate(scene, {}, noise, 10);

    for (std::size_t k = 0; k < a.recording.slices.size(); ++k)
        QVERIFY(a.recording.slices[k].ranges != b.recording.slices[k].ranges);
}

void NoddingScannerTest::aSliceAloneEqualsThatOfTheScan()
{
    const SimulationNoise noise = simulationNoise("default").value();
    const Scene scene = makeScene("office", 6).value();

    const SimulatedScan scan = simulate(scene, {}, noise, 9);
    const SimulatedSlice alone = simulateSlice(scene, {}, noise, 9, 100);

    QCOMPARE(alone.slice.ranges, scan.recording.slices[100].ranges);
    QCOMPARE(alone.slice.tilt, scan.recording.slices[100].tilt);
    QCOMPARE(alone.labels, scan.labels[100]);
}

void NoddingScannerTest::anEmptySceneGivesOnlyZeros()
{
    const SimulatedScan scan = simulate(makeScene("empty", 1).value(), {}, simulationNoise("default").value(), kSeed);

    for (std::size_t k = 0; k < scan.recording.slices.size(); ++k) {
        QCOMPARE(scan.recording.slices[k].ranges, std::vector<double>(721, 0.0));
        QCOMPARE(scan.labels[k], std::vector<int>(721, kNoTruePlane));
    }
}

PLANEWRIGHT_TEST(NoddingScannerTest)
#include "nodding_scanner_test.moc"
