// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/recover_scanner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QtTest>

#include "core/geometry/pitch_axis.h"
#include "core/geometry/sensor_model.h"
#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

namespace {

/// The distance at which a ray from the origin meets a box-shaped room around it.
double rangeInRoom(const Eigen::Vector3d& ray)
{
    const Eigen::Vector3d half{2.5, 3.5, 1.25};
    return (half.array() / ray.array().abs().max(1e-12)).minCoeff();
}

CloudPoint pointAlong(const Eigen::Vector3d& ray, int beam)
{
    return {(rangeInRoom(ray.normalized()) * ray.normalized()).cast<float>(), beam};
}

/// A ray of Eq. (6) without a lever arm.
Eigen::Vector3d beamAt(double bearing, double tilt)
{
    return {std::cos(bearing), std::sin(bearing) * std::sin(tilt), -std::sin(bearing) * std::cos(tilt)};
}

/// The largest distance of a point from where the recording has it [m].
double largestOff(const CloudScan& cloud, const Recording& recording)
{
    const SensorModel sensor = sensorOf(recording.description);
    double largest = 0.0;
    for (const ScanSlice& slice : recording.slices) {
        for (const CloudPoint& point : cloud.slices[static_cast<std::size_t>(slice.step)]) {
            const auto beam = static_cast<std::size_t>(point.beam);
            const Eigen::Vector3d recorded = toCartesian(slice.ranges[beam], slice.bearing(beam), slice.tilt, sensor);
            largest = std::max(largest, (recorded - point.place.cast<double>()).norm());
        }
    }
    return largest;
}

/// What a nodding scanner of evenly spaced beams sees; `leftOut(slice, beam)` says where it has no return.
template <class LeftOut>
CloudScan noddingCloud(int slices, int beams, LeftOut leftOut)
{
    CloudScan cloud;
    cloud.beams = beams;
    for (int i = 0; i < slices; ++i) {
        CloudSlice& slice = cloud.slices.emplace_back();
        for (int k = 0; k < beams; ++k) {
            if (!leftOut(i, k))
                slice.push_back(pointAlong(beamAt(degrees(10.0 + 2.0 * k), degrees(40.0 + 3.0 * i)), k));
        }
    }
    return cloud;
}

const auto kAllThere = [](int, int) { return false; };

/// Floats hold a coordinate of 4 m to a quarter of a micrometre.
constexpr double kFloat = 3e-6;

}  // namespace

class RecoverScannerTest : public QObject {
    Q_OBJECT

private slots:
    void aNoddingScannerIsFoundAsItWas();
    void beamsAndSlicesWithoutReturnKeepTheirPlaces();
    void pointsWithoutNumbersGetTheirBeams();
    void aScannerThatTurnsAboutTheVerticalHasAVerticalAxis();
    void theRowsOfADepthCameraAreThoseOfAFlatImage();
    void unevenBearingsAreATable();
    void anAxisAtAnyAttitudeIsFound();
    void aWholeTurnKeepsTurning();
    void slicesInOnePlaneHaveNoAxis();
    void bearingsThatDoNotRiseAreRefused();
    void sweepsEndWhereTheBearingTurnsBack();
    void sweepsToAndFroAreOneScan_data();
    void sweepsToAndFroAreOneScan();
};

void RecoverScannerTest::aNoddingScannerIsFoundAsItWas()
{
    CloudScan cloud = noddingCloud(30, 81, kAllThere);

    const auto recording = recoverScanner(cloud);

    QVERIFY(recording);
    const ScanDescription& description = recording->description;
    QVERIFY(!description.isTurned());
    QVERIFY(!description.beamTable);
    QCOMPARE(description.beams, 81);
    QVERIFY(std::abs(description.firstBearing - degrees(10.0)) < 1e-7);
    QVERIFY(std::abs(description.bearingStep - degrees(2.0)) < 1e-8);
    QCOMPARE(recording->slices.size(), std::size_t(30));
    for (std::size_t i = 0; i < 30; ++i) {
        QCOMPARE(recording->slices[i].step, static_cast<int>(i));
        QVERIFY(std::abs(recording->slices[i].tilt - degrees(40.0 + 3.0 * static_cast<double>(i))) < 1e-6);
    }
    QVERIFY(largestOff(cloud, *recording) < kFloat);
}

void RecoverScannerTest::beamsAndSlicesWithoutReturnKeepTheirPlaces()
{
    CloudScan cloud = noddingCloud(20, 81, [](int slice, int beam) { return slice == 7 || beam < 2 || beam == 40; });

    const auto recording = recoverScanner(cloud);

    QVERIFY(recording);
    QCOMPARE(recording->slices.size(), std::size_t(19));
    QCOMPARE(recording->slices[7].step, 8);
    QVERIFY(std::abs(recording->slices[7].tilt - degrees(64.0)) < 1e-6);
    QVERIFY(std::abs(recording->description.firstBearing - degrees(10.0)) < 1e-6);
    QCOMPARE(recording->slices[0].ranges[40], 0.0);
    QVERIFY(recording->slices[0].ranges[41] > 1.0);
}

void RecoverScannerTest::pointsWithoutNumbersGetTheirBeams()
{
    // Slice 0 begins at beam 3, and none has beam 50.
    const auto isMissing = [](int slice, int beam) { return beam == 50 || (slice == 0 && beam < 3); };
    const CloudScan numbered = noddingCloud(15, 81, isMissing);
    std::vector<Eigen::Vector3f> points;
    for (const CloudSlice& slice : numbered.slices) {
        for (const CloudPoint& point : slice)
            points.push_back(point.place);
    }
    CloudScan cloud;
    cloud.slices = splitSweeps(points);

    const auto recording = recoverScanner(cloud);

    QVERIFY(recording);
    QCOMPARE(cloud.beams, 81);
    QCOMPARE(cloud.slices.size(), numbered.slices.size());
    for (std::size_t i = 0; i < cloud.slices.size(); ++i) {
        QCOMPARE(cloud.slices[i].size(), numbered.slices[i].size());
        for (std::size_t k = 0; k < cloud.slices[i].size(); ++k)
            QCOMPARE(cloud.slices[i][k].beam, numbered.slices[i][k].beam);
    }
    QVERIFY(largestOff(cloud, *recording) < kFloat);
}

void RecoverScannerTest::aScannerThatTurnsAboutTheVerticalHasAVerticalAxis()
{
    CloudScan cloud;
    cloud.beams = 61;
    for (int i = 0; i < 40; ++i) {
        const double azimuth = degrees(4.0 * i);
        CloudSlice& slice = cloud.slices.emplace_back();
        for (int k = 0; k < 61; ++k) {
            const double elevation = degrees(-60.0 + 2.0 * k);
            slice.push_back(pointAlong(
                {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)},
                k));
        }
    }

    const auto recording = recoverScanner(cloud);

    QVERIFY(recording);
    // Bearings rise with the elevation where they count from straight down.
    QVERIFY((recording->description.attitude * Eigen::Vector3d::UnitX()).isApprox(-Eigen::Vector3d::UnitZ(), 1e-12));
    QVERIFY(std::abs(recording->description.firstBearing - degrees(30.0)) < 1e-6);
    QVERIFY(std::abs(std::abs(recording->slices[1].tilt - recording->slices[0].tilt) - degrees(4.0)) < 1e-6);
    QVERIFY(largestOff(cloud, *recording) < kFloat);
}

void RecoverScannerTest::theRowsOfADepthCameraAreThoseOfAFlatImage()
{
    // Columns from left to right, rows from top to bottom, 100 pixels of focal length, looking forward.
    CloudScan cloud;
    cloud.beams = 101;
    for (int row = -30; row <= 30; ++row) {
        CloudSlice& slice = cloud.slices.emplace_back();
        for (int column = -50; column <= 50; ++column)
            slice.push_back(pointAlong({column / 100.0, 1.0, -row / 100.0}, column + 50));
    }

    const auto recording = recoverScanner(cloud);

    QVERIFY(recording);
    const auto table = recording->description.beamTable;
    QVERIFY(table && table->imageTilt);
    QVERIFY(std::abs(*table->imageTilt - degrees(90.0)) < 1e-6);
    // In the middle row a column's ray is at atan(100 / column) to the right; the axis points to the left.
    for (int column = -50; column <= 50; ++column)
        QVERIFY(std::abs(table->bearings[static_cast<std::size_t>(column + 50)] - std::atan2(1.0, -column / 100.0)) <
                1e-6);
    QVERIFY(largestOff(cloud, *recording) < kFloat);
}

void RecoverScannerTest::unevenBearingsAreATable()
{
    const auto bearingOf = [](int beam) { return degrees(20.0 + 1.5 * beam + 0.3 * (beam % 3)); };
    CloudScan cloud;
    cloud.beams = 90;
    for (int i = 0; i < 25; ++i) {
        CloudSlice& slice = cloud.slices.emplace_back();
        for (int k = 0; k < 90; ++k)
            slice.push_back(pointAlong(beamAt(bearingOf(k), degrees(50.0 + 2.0 * i)), k));
    }

    const auto recording = recoverScanner(cloud);

    QVERIFY(recording);
    const auto table = recording->description.beamTable;
    QVERIFY(table && !table->imageTilt);
    for (int k = 0; k < 90; ++k)
        QVERIFY(std::abs(table->bearings[static_cast<std::size_t>(k)] - bearingOf(k)) < 1e-6);
    QVERIFY(largestOff(cloud, *recording) < kFloat);
}

void RecoverScannerTest::anAxisAtAnyAttitudeIsFound()
{
    const Eigen::Quaterniond attitude = Eigen::Quaterniond(0.8, 0.2, -0.5, 0.3).normalized();
    CloudScan cloud = noddingCloud(30, 81, kAllThere);
    for (CloudSlice& slice : cloud.slices) {
        for (CloudPoint& point : slice)
            point.place = (attitude * point.place.cast<double>()).cast<float>();
    }

    const auto recording = recoverScanner(cloud);

    QVERIFY(recording);
    const Eigen::Vector3d axis = recording->description.attitude * Eigen::Vector3d::UnitX();
    QVERIFY((axis - attitude * Eigen::Vector3d::UnitX()).norm() < 1e-6);
    QVERIFY(largestOff(cloud, *recording) < kFloat);
}

void RecoverScannerTest::aWholeTurnKeepsTurning()
{
    CloudScan cloud;
    cloud.beams = 31;
    for (int i = 0; i < 120; ++i) {
        CloudSlice& slice = cloud.slices.emplace_back();
        for (int k = 0; k < 31; ++k)
            slice.push_back(pointAlong(beamAt(degrees(30.0 + 4.0 * k), degrees(3.0 * i)), k));
    }

    const auto recording = recoverScanner(cloud);

    QVERIFY(recording);
    for (std::size_t i = 1; i < 120; ++i)
        QVERIFY(std::abs(recording->slices[i].tilt - recording->slices[i - 1].tilt - degrees(3.0)) < 1e-6);
    QVERIFY(largestOff(cloud, *recording) < kFloat);
}

void RecoverScannerTest::slicesInOnePlaneHaveNoAxis()
{
    CloudScan cloud = noddingCloud(1, 81, kAllThere);
    cloud.slices.push_back(cloud.slices.front());

    const auto recording = recoverScanner(cloud);

    QVERIFY(!recording);
    QCOMPARE(recording.error().code, ErrorCode::Unreadable);
}

void RecoverScannerTest::bearingsThatDoNotRiseAreRefused()
{
    CloudScan cloud = noddingCloud(10, 20, kAllThere);
    for (CloudSlice& slice : cloud.slices)
        std::swap(slice[4].place, slice[9].place);

    const auto recording = recoverScanner(cloud);

    QVERIFY(!recording);
    QCOMPARE(recording.error().code, ErrorCode::Unreadable);
}

void RecoverScannerTest::sweepsEndWhereTheBearingTurnsBack()
{
    std::vector<Eigen::Vector3f> points;
    for (const double tilt : {80.0, 90.0, 100.0}) {
        for (double bearing = 30.0; bearing <= 150.0; bearing += 10.0)
            points.push_back(beamAt(degrees(bearing), degrees(tilt)).cast<float>());
    }

    const std::vector<CloudSlice> slices = splitSweeps(points);

    QCOMPARE(slices.size(), std::size_t(3));
    for (const CloudSlice& slice : slices)
        QCOMPARE(slice.size(), std::size_t(13));
}

void RecoverScannerTest::sweepsToAndFroAreOneScan_data()
{
    QTest::addColumn<int>("atTurns");
    QTest::newRow("both sweeps measure the beam at the turn") << 0;
    QTest::newRow("the sweep back begins one beam on") << 1;
    QTest::newRow("no returns at the turns, but for the first of the sweep back") << 2;
}

/// Beams from 10 to 170 degrees; odd slices are swept from the last to the first.
void RecoverScannerTest::sweepsToAndFroAreOneScan()
{
    QFETCH(int, atTurns);
    const auto isMissing = [&](int slice, int beam) {
        const bool isBack = slice % 2 == 1;
        const int fromStart = isBack ? 80 - beam : beam;
        if (atTurns == 1)
            return slice > 0 && fromStart == 0;
        return atTurns == 2 && (isBack ? beam : 80 - beam) < 3;
    };
    CloudScan numbered = noddingCloud(16, 81, isMissing);
    std::vector<Eigen::Vector3f> points;
    for (std::size_t i = 0; i < numbered.slices.size(); ++i) {
        CloudSlice swept = numbered.slices[i];
        if (i % 2 == 1)
            std::reverse(swept.begin(), swept.end());
        for (const CloudPoint& point : swept)
            points.push_back(point.place);
    }
    CloudScan cloud;
    cloud.slices = splitSweeps(points);

    const auto recording = recoverScanner(cloud);

    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(cloud.beams, 81);
    QCOMPARE(cloud.slices.size(), numbered.slices.size());
    // Which way the axis points decides from which side beams are counted.
    const bool isMirrored = (recording->description.attitude * Eigen::Vector3d::UnitX()).x() < 0.0;
    for (std::size_t i = 0; i < cloud.slices.size(); ++i) {
        QCOMPARE(cloud.slices[i].size(), numbered.slices[i].size());
        for (std::size_t k = 0; k < cloud.slices[i].size(); ++k) {
            const std::size_t other = isMirrored ? cloud.slices[i].size() - 1 - k : k;
            QCOMPARE(cloud.slices[i][k].place, numbered.slices[i][other].place);
            QCOMPARE(cloud.slices[i][k].beam,
                     isMirrored ? 80 - numbered.slices[i][other].beam : numbered.slices[i][other].beam);
        }
    }
    QVERIFY(largestOff(cloud, *recording) < kFloat);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::RecoverScannerTest)
#include "recover_scanner_test.moc"
