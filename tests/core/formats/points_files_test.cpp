// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/points_files.h"

#include <cmath>
#include <sstream>

#include <QtTest>

#include "ply_parser.h"
#include "sample_scan.h"
#include "tests/test_program.h"

using namespace planewright;

class PointsFilesTest : public QObject {
    Q_OBJECT

private slots:
    void plyHasAVertexForEveryReturn();
    void pcdHasTheSamePoints();
    void aNoddingHeadTiltsFromBeamToBeam();
    void aFullDiskIsNotSilent();
};

void PointsFilesTest::plyHasAVertexForEveryReturn()
{
    const Recording recording = sampleScan();
    std::ostringstream out;

    QVERIFY(writePointsPly(out, recording, labelsOf(sampleSnapshot(), recording)).has_value());
    const PlyFile file = parsePly(out.str());

    QCOMPARE(file.bytesLeft, std::size_t(0));
    QCOMPARE(file.elements.size(), std::size_t(1));
    QCOMPARE(file.elements[0].properties,
             (std::vector<std::string>{"float x", "float y", "float z", "int plane_id", "int step"}));
    const auto& points = file.elements[0].values;
    QCOMPARE(points.size(), std::size_t(8));
    // Step 4 looks level: beam 0 at 30° and 2 m; the laser is 0.25 m above the pitch axis.
    QVERIFY(std::abs(points[0].at("x") - std::sqrt(3.0)) < 1e-6);
    QVERIFY(std::abs(points[0].at("y") - 1.0) < 1e-6);
    QVERIFY(std::abs(points[0].at("z") - 0.25) < 1e-6);
    QCOMPARE(points[0].at("plane_id"), 9.0);
    QCOMPARE(points[0].at("step"), 4.0);
    // Step 7 looks straight down: beam 2 at 90° and 1 m.
    QVERIFY(std::abs(points[5].at("x")) < 1e-6);
    QVERIFY(std::abs(points[5].at("y") - 0.25) < 1e-6);
    QVERIFY(std::abs(points[5].at("z") + 1.0) < 1e-6);
    QCOMPARE(points[5].at("plane_id"), 1.0);
    QCOMPARE(points[4].at("plane_id"), -1.0);
    QCOMPARE(points[4].at("step"), 7.0);
}

void PointsFilesTest::pcdHasTheSamePoints()
{
    const Recording recording = sampleScan();
    const Labels labels = labelsOf(sampleSnapshot(), recording);
    std::ostringstream ply;
    std::ostringstream pcd;

    QVERIFY(writePointsPly(ply, recording, labels).has_value());
    QVERIFY(writePointsPcd(pcd, recording, labels).has_value());

    const std::string head =
        "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z label step\nSIZE 4 4 4 4 4\nTYPE F F F "
        "I "
        "I\nCOUNT 1 1 1 1 1\nWIDTH 8\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 8\nDATA binary\n";
    QVERIFY(pcd.str().starts_with(head));
    const std::string bytes = pcd.str().substr(head.size());
    QCOMPARE(bytes.size(), std::size_t(8 * 20));
    QVERIFY(ply.str().ends_with("end_header\n" + bytes));
}

void PointsFilesTest::aNoddingHeadTiltsFromBeamToBeam()
{
    Recording recording = sampleScan();
    recording.slices.resize(1);
    recording.slices[0].tiltEnd = 0.0;  // from level at beam 0 to straight down at beam 4; beam 3 is at 22.5°
    std::ostringstream out;

    QVERIFY(writePointsPly(out, recording, {{-1, -1, -1, -1, -1}}).has_value());
    const auto point = parsePly(out.str()).elements[0].values.at(1);

    const double ahead = 2.0 * std::sin(degrees(120.0));
    QVERIFY(std::abs(point.at("x") + 1.0) < 1e-6);
    QVERIFY(std::abs(point.at("y") - (ahead * std::sin(degrees(22.5)) + 0.25 * std::cos(degrees(22.5)))) < 1e-6);
    QVERIFY(std::abs(point.at("z") - (-ahead * std::cos(degrees(22.5)) + 0.25 * std::sin(degrees(22.5)))) < 1e-6);
}

void PointsFilesTest::aFullDiskIsNotSilent()
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);

    QCOMPARE(writePointsPly(out, {}, {}).error().code, ErrorCode::NotWritten);
    QCOMPARE(writePointsPcd(out, {}, {}).error().code, ErrorCode::NotWritten);
}

PLANEWRIGHT_TEST(PointsFilesTest)
#include "points_files_test.moc"
