// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/segment_run.h"

#include <cmath>

#include <QtTest>

#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

constexpr double kDepth = 0.34;
constexpr double kHeight = 0.16;
constexpr int kRows = 6;

/// A stair from 6 m ahead on, of which the laser sees the risers alone, each in six slices 25 mm apart.
Segments stair(int risers)
{
    Segments segments;
    for (int riser = 0; riser < risers; ++riser) {
        const Sheet sheet{
            {-2.0, 6.0 + kDepth * riser, kHeight * riser}, {4.0, 0.0, 0.0}, {0.0, 0.0, 0.025}, kRows, kRows * riser};
        segments = segments + sheet.segments();
    }
    return segments;
}

struct Flat {
    Eigen::Vector3d normal;
    double distance;
};

/// The slope through the middles of the risers.
Flat slope()
{
    const Eigen::Vector3d normal = Eigen::Vector3d(0.0, kHeight, -kDepth).normalized();
    return {normal, normal.dot(Eigen::Vector3d(0.0, 6.0, 0.0625))};
}

Flat riserAt(int riser)
{
    return {Eigen::Vector3d::UnitY(), 6.0 + kDepth * riser};
}

}  // namespace

class SegmentRunTest : public QObject {
    Q_OBJECT

private slots:
    void aRunIsTheRiserAroundASegment();
    void longStepsMakeNoRun();
    void otherBeamsMakeNoRun();
    void aCornerIsCutOff();
    void risersContestTheSlopeOverThem();
    void nothingContestsAPlaneAmongItsOwn();
    void aRunThatLeansLittleContestsNothing();
    void theShareIsThatOfThePlanesSegments();
};

void SegmentRunTest::aRunIsTheRiserAroundASegment()
{
    SegmentTable table;
    append(table, stair(3));

    const auto run = runAround(8, table, {});

    QVERIFY(run.has_value());
    QVERIFY((run->segments == std::vector<SegmentNumber>{6, 7, 8, 9, 10, 11}));
    QVERIFY(std::abs(std::abs(run->normal.y()) - 1.0) < 1e-9);
    QVERIFY(std::abs(std::abs(run->distance) - (6.0 + kDepth)) < 1e-9);
}

void SegmentRunTest::longStepsMakeNoRun()
{
    PlaneParameters parameters;
    parameters.runStep = 0.099;
    SegmentTable table;
    append(table, wall(6).segments());

    QVERIFY(!runAround(2, table, parameters));
    parameters.runStep = 0.101;
    QCOMPARE(runAround(2, table, parameters)->segments.size(), std::size_t{6});
}

void SegmentRunTest::otherBeamsMakeNoRun()
{
    Look beside;
    beside.firstBeam = 300;
    beside.lastBeam = 329;
    Segments segments = stair(1);
    for (int i = 0; i < kRows; i += 2) {
        segments[static_cast<std::size_t>(i)].firstBeam = beside.firstBeam;
        segments[static_cast<std::size_t>(i)].lastBeam = beside.lastBeam;
    }
    SegmentTable table;
    append(table, segments);

    // Slices 1, 3 and 5 see the same beams, two slices apart.
    QVERIFY((runAround(3, table, {})->segments == std::vector<SegmentNumber>{1, 3, 5}));
}

void SegmentRunTest::aCornerIsCutOff()
{
    // A wall of five slices, and from its foot on a floor in steps of 80 mm.
    const Segments segments = Sheet{{-2.0, 4.0, 0.2}, {4.0, 0.0, 0.0}, {0.0, 0.0, -0.04}, 5, 0}.segments() +
                              Sheet{{-2.0, 3.95, 0.0}, {4.0, 0.0, 0.0}, {0.0, -0.08, 0.0}, 5, 5}.segments();
    SegmentTable table;
    append(table, segments);

    const auto run = runAround(1, table, {});

    QVERIFY(run.has_value());
    QVERIFY(run->segments.front() == 0);
    QVERIFY(run->segments.back() <= 5);
    QVERIFY(std::abs(run->normal.y()) > std::cos(degrees(15.0)));
}

void SegmentRunTest::risersContestTheSlopeOverThem()
{
    SegmentTable table;
    append(table, stair(3));

    for (SegmentNumber i = 0; i < table.size(); ++i)
        QVERIFY(isContested(i, slope().normal, slope().distance, table, {}));
}

void SegmentRunTest::nothingContestsAPlaneAmongItsOwn()
{
    Random random(71);
    for (int trial = 0; trial < 20; ++trial) {
        Segments segments = stair(1);
        for (LineSegment& segment : segments) {
            const Eigen::Vector3d stray = 0.01 * anyVector(random);
            segment.start += stray;
            segment.end += stray;
        }
        SegmentTable table;
        append(table, segments);

        for (SegmentNumber i = 0; i < table.size(); ++i)
            QVERIFY(!isContested(i, riserAt(0).normal, riserAt(0).distance, table, {}));
    }
}

void SegmentRunTest::aRunThatLeansLittleContestsNothing()
{
    SegmentTable table;
    append(table, stair(1));
    const Flat below{{0.0, std::cos(degrees(14.0)), std::sin(degrees(14.0))}, 5.5};
    const Flat above{{0.0, std::cos(degrees(60.0)), std::sin(degrees(60.0))}, 2.9};

    QVERIFY(!isContested(2, below.normal, below.distance, table, {}));
    QVERIFY(isContested(2, above.normal, above.distance, table, {}));
}

void SegmentRunTest::theShareIsThatOfThePlanesSegments()
{
    SegmentTable table;
    append(table, stair(3));

    QCOMPARE(contestedShare({2, 3, 8, 9, 14, 15}, slope().normal, slope().distance, table, {}), 1.0);
    QCOMPARE(contestedShare({6, 7, 8, 9, 10, 11}, riserAt(1).normal, riserAt(1).distance, table, {}), 0.0);
    QCOMPARE(contestedShare({}, slope().normal, slope().distance, table, {}), 0.0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SegmentRunTest)
#include "segment_run_test.moc"
