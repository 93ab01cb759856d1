// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/neighbourhood.h"

#include <QtTest>

#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

LineSegment between(const Eigen::Vector3d& start, const Eigen::Vector3d& end)
{
    return segmentBetween(0, start, end);
}

LineSegment onBeams(int step, int first, int last)
{
    Look look;
    look.firstBeam = first;
    look.lastBeam = last;
    return segmentBetween(step, {0.0, 4.0, 0.0}, {1.0, 4.0, 0.0}, look);
}

double distanceToPoint(const LineSegment& segment, const Eigen::Vector3d& point)
{
    const Eigen::Vector3d along = segment.end - segment.start;
    const double place = std::clamp(along.dot(point - segment.start) / along.squaredNorm(), 0.0, 1.0);
    return (segment.start + place * along - point).norm();
}

/// The distance to b is convex along a: the smallest by ternary search.
double slowDistance(const LineSegment& a, const LineSegment& b)
{
    double low = 0.0;
    double high = 1.0;
    const auto at = [&](double place) { return distanceToPoint(b, a.start + place * (a.end - a.start)); };
    for (int i = 0; i < 200; ++i) {
        const double third = (high - low) / 3.0;
        if (at(low + third) < at(high - third))
            high -= third;
        else
            low += third;
    }
    return at(0.5 * (low + high));
}

bool face(const LineSegment& a, const LineSegment& b)
{
    const bool there = faceEachOther(a, b);
    const bool back = faceEachOther(b, a);
    if (there != back)
        qWarning("faceEachOther depends on the order");
    return there && back;
}

}  // namespace

class NeighbourhoodTest : public QObject {
    Q_OBJECT

private slots:
    void distanceOfParallelSegmentsIsThatOfTheirLines();
    void distanceOfSegmentsEndToEndIsTheGap();
    void crossingSegmentsTouch();
    void distanceOfSkewSegmentsIsThatOfTheirLinesWhereThoseAreNearest();
    void distanceIsThatOfASlowSearch();
    void segmentsWhoseBeamsOverlapFaceEachOther();
    void segmentsThatShareOneBeamFaceEachOther();
    void segmentsBesideEachOtherDoNotFace();
    void segmentsHiddenFromEachOtherOnBothSidesFace();
    void segmentsHiddenOnOneSideOnlyDoNotFace();
    void segmentsOfFarSlicesDoNotFace();
};

void NeighbourhoodTest::distanceOfParallelSegmentsIsThatOfTheirLines()
{
    const LineSegment a = between({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0});
    const LineSegment b = between({3.0, 0.3, 0.4}, {1.0, 0.3, 0.4});

    QVERIFY(std::abs(segmentDistance(a, b) - 0.5) < 1e-15);
}

void NeighbourhoodTest::distanceOfSegmentsEndToEndIsTheGap()
{
    const LineSegment a = between({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0});
    const LineSegment b = between({2.7, 0.0, 0.0}, {4.0, 0.0, 0.0});

    QVERIFY(std::abs(segmentDistance(a, b) - 0.7) < 1e-15);
    QVERIFY(std::abs(segmentDistance(b, a) - 0.7) < 1e-15);
}

void NeighbourhoodTest::crossingSegmentsTouch()
{
    const LineSegment a = between({-1.0, -1.0, 5.0}, {1.0, 1.0, 5.0});
    const LineSegment b = between({-1.0, 1.0, 5.0}, {1.0, -1.0, 5.0});

    QVERIFY(segmentDistance(a, b) < 1e-15);
}

void NeighbourhoodTest::distanceOfSkewSegmentsIsThatOfTheirLinesWhereThoseAreNearest()
{
    const LineSegment a = between({-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    const LineSegment over = between({0.5, -1.0, 0.25}, {0.5, 1.0, 0.25});
    const LineSegment beside = between({1.3, 0.4, -1.0}, {1.3, 0.4, 1.0});

    QVERIFY(std::abs(segmentDistance(a, over) - 0.25) < 1e-15);
    QVERIFY(std::abs(segmentDistance(a, beside) - 0.5) < 1e-15);
}

void NeighbourhoodTest::distanceIsThatOfASlowSearch()
{
    constexpr double kHair = 1e-5;  // the closed form loses digits between lines that are parallel but for a hair
    Random random(11);
    for (int i = 0; i < 2000; ++i) {
        const LineSegment a = between(anyVector(random), anyVector(random));
        LineSegment b = between(anyVector(random), anyVector(random));
        if (i % 4 == 0)  // parallel
            b.end = b.start + random.uniform(-2.0, 2.0) * (a.end - a.start);
        if (i % 4 == 1)  // parallel but for a hair
            b.end = b.start + random.uniform(-2.0, 2.0) * (a.end - a.start) + 1e-5 * anyVector(random);

        QVERIFY(std::abs(segmentDistance(a, b) - slowDistance(a, b)) < kHair);
        QVERIFY(std::abs(segmentDistance(b, a) - segmentDistance(a, b)) < kHair);
    }
}

void NeighbourhoodTest::segmentsWhoseBeamsOverlapFaceEachOther()
{
    QVERIFY(face(onBeams(3, 100, 200), onBeams(4, 150, 250)));
    QVERIFY(face(onBeams(3, 100, 200), onBeams(4, 120, 130)));
    QVERIFY(face(onBeams(3, 100, 200), onBeams(3 + kNeighbourSlices, 150, 250)));
}

void NeighbourhoodTest::segmentsThatShareOneBeamFaceEachOther()
{
    QVERIFY(face(onBeams(3, 100, 200), onBeams(4, 200, 300)));
}

void NeighbourhoodTest::segmentsBesideEachOtherDoNotFace()
{
    QVERIFY(!face(onBeams(3, 100, 200), onBeams(4, 201, 300)));
}

void NeighbourhoodTest::segmentsHiddenFromEachOtherOnBothSidesFace()
{
    LineSegment left = onBeams(3, 100, 200);
    LineSegment right = onBeams(4, 260, 300);
    left.endShadowed = true;
    right.startShadowed = true;

    QVERIFY(face(left, right));
}

void NeighbourhoodTest::segmentsHiddenOnOneSideOnlyDoNotFace()
{
    LineSegment left = onBeams(3, 100, 200);
    LineSegment right = onBeams(4, 260, 300);
    left.endShadowed = true;
    right.endShadowed = true;
    left.startShadowed = true;

    QVERIFY(!face(left, right));
}

void NeighbourhoodTest::segmentsOfFarSlicesDoNotFace()
{
    QVERIFY(!face(onBeams(3, 100, 200), onBeams(4 + kNeighbourSlices, 100, 200)));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::NeighbourhoodTest)
#include "neighbourhood_test.moc"
