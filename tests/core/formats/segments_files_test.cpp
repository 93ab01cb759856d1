// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/segments_files.h"

#include <sstream>

#include <QtTest>

#include "ply_parser.h"
#include "sample_scan.h"
#include "tests/test_program.h"

using namespace planewright;

class SegmentsFilesTest : public QObject {
    Q_OBJECT

private slots:
    void csvHasARowForEverySegment();
    void plyHasAnEdgeForEverySegment();
    void aFullDiskIsNotSilent();
};

void SegmentsFilesTest::csvHasARowForEverySegment()
{
    std::ostringstream out;

    QVERIFY(writeSegmentsCsv(out, sampleSnapshot()).has_value());

    QCOMPARE(out.str(), std::string("step,segment,ux,uy,uz,vx,vy,vz,points,rms_m,cluster,plane\n"
                                    "4,0,1.5,1,0.25,-0.333333333,1,0,4,0.0035,-1,9\n"
                                    "7,0,1.5,2,0.25,-0.333333333,2,0,2,0.0035,2,-1\n"
                                    "7,1,1.5,3,0.25,-0.333333333,3,0,3,0.0035,-1,1\n"
                                    "8,0,1.5,4,0.25,-0.333333333,4,0,5,0.0035,-1,1\n"));
}

void SegmentsFilesTest::plyHasAnEdgeForEverySegment()
{
    std::ostringstream out;

    QVERIFY(writeSegmentsPly(out, sampleSnapshot()).has_value());
    const PlyFile file = parsePly(out.str());

    QCOMPARE(file.bytesLeft, std::size_t(0));
    QCOMPARE(file.elements.size(), std::size_t(2));
    QCOMPARE(file.elements[0].properties, (std::vector<std::string>{"double x", "double y", "double z"}));
    QCOMPARE(file.elements[0].values.size(), std::size_t(8));
    QCOMPARE(file.elements[1].name, std::string("edge"));
    QCOMPARE(file.elements[1].properties, (std::vector<std::string>{"int vertex1", "int vertex2", "int plane_id"}));
    QCOMPARE(file.elements[1].values.size(), std::size_t(4));
    const auto& edge = file.elements[1].values[1];  // segment 7.0
    QCOMPARE(edge.at("plane_id"), -1.0);
    const auto& start = file.elements[0].values.at(static_cast<std::size_t>(edge.at("vertex1")));
    const auto& end = file.elements[0].values.at(static_cast<std::size_t>(edge.at("vertex2")));
    QCOMPARE(start, (std::map<std::string, double>{{"x", 1.5}, {"y", 2.0}, {"z", 0.25}}));
    QCOMPARE(end, (std::map<std::string, double>{{"x", -1.0 / 3.0}, {"y", 2.0}, {"z", 0.0}}));
    QCOMPARE(file.elements[1].values[0].at("plane_id"), 9.0);
}

void SegmentsFilesTest::aFullDiskIsNotSilent()
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);

    QCOMPARE(writeSegmentsCsv(out, {}).error().code, ErrorCode::NotWritten);
    QCOMPARE(writeSegmentsPly(out, {}).error().code, ErrorCode::NotWritten);
}

PLANEWRIGHT_TEST(SegmentsFilesTest)
#include "segments_files_test.moc"
