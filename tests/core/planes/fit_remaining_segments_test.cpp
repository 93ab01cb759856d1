// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/fit_remaining_segments.h"

#include <QtTest>

#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Segments of a wall in slices 0 to 8; those from 4 on made a plane later, and the first four wait in clusters.
struct LateWall {
    Parameters parameters = lenient();
    PlaneMap map;
    Recorded recorded;

    explicit LateWall(const std::vector<SegmentNumber>& clusterOrder)
    {
        append(map.segments, wall(9).segments());
        cluster(clusterOrder, map, parameters);
        makePlane(map, {4, 5, 6, 7, 8}, parameters.planes);
        map.step = 9;
    }
};

}  // namespace

class FitRemainingSegmentsTest : public QObject {
    Q_OBJECT

private slots:
    void segmentsJoinPlanesBornAfterThem();
    void segmentsThatStillMatchNothingStayClustered();
    void orderOfTheClustersDoesNotMatter();
    void nothingHappensWithoutClusters();
    void everySegmentIsExplained();
};

void FitRemainingSegmentsTest::segmentsJoinPlanesBornAfterThem()
{
    LateWall late({0, 1, 2, 3});

    const int fitted = fitRemainingSegments(late.map, late.parameters, late.recorded.recorder);

    QCOMPARE(fitted, 4);
    QCOMPARE(late.map.planes[0].members().size(), std::size_t{9});
    for (SegmentNumber number = 0; number < 9; ++number)
        QCOMPARE(late.map.segments.owner(number), 0);
    QVERIFY(late.map.clusters.all().empty());
}

void FitRemainingSegmentsTest::segmentsThatStillMatchNothingStayClustered()
{
    LateWall late({0, 1, 2, 3});
    const Segments strangers{segmentBetween(9, {-1.0, 3.0, 0.9}, {1.0, 3.0, 0.9}),
                             segmentBetween(9, {2.0, 0.0, 0.9}, {2.0, 3.0, 0.9})};
    const auto numbers = append(late.map.segments, strangers);
    cluster(numbers, late.map, late.parameters);

    const int fitted = fitRemainingSegments(late.map, late.parameters, late.recorded.recorder);

    QCOMPARE(fitted, 4);
    QVERIFY(clusteredSegments(late.map) == numbers);
    QCOMPARE(late.map.segments.owner(numbers[0]), kNoPlane);
    QCOMPARE(late.map.segments.owner(numbers[1]), kNoPlane);
}

void FitRemainingSegmentsTest::orderOfTheClustersDoesNotMatter()
{
    // The plane is refitted on the way, so that the order in which segments join decides what it looks like.
    const auto fittedPlane = [](const std::vector<SegmentNumber>& order) {
        LateWall late({});
        Parameters parameters = late.parameters;
        parameters.assignment.refitEvery = 1;
        PlaneMap& map = late.map;
        const auto numbers = append(map.segments, {segmentBetween(9, {-1.0, 4.02, 0.9}, {1.0, 4.00, 0.9}),
                                                   segmentBetween(10, {-1.0, 3.99, 1.0}, {1.0, 4.02, 1.0}),
                                                   segmentBetween(11, {-1.0, 4.01, 1.1}, {1.0, 3.99, 1.1})});
        std::vector<SegmentNumber> ordered;
        for (const SegmentNumber i : order)
            ordered.push_back(numbers[static_cast<std::size_t>(i)]);
        cluster(ordered, map, parameters);
        fitRemainingSegments(map, parameters, late.recorded.recorder);
        return map.planes[0].publish(map.segments);
    };

    const auto forwards = fittedPlane({0, 1, 2});
    const auto mixed = fittedPlane({2, 0, 1});

    QCOMPARE(forwards->segments.size(), std::size_t{8});
    QVERIFY(forwards->segments == mixed->segments);
    QVERIFY(forwards->normal == mixed->normal);
    QCOMPARE(forwards->distance, mixed->distance);
}

void FitRemainingSegmentsTest::nothingHappensWithoutClusters()
{
    LateWall late({});

    QCOMPARE(fitRemainingSegments(late.map, late.parameters, late.recorded.recorder), 0);
    QCOMPARE(late.map.planes[0].members().size(), std::size_t{5});
    QVERIFY(late.recorded.report.decisions.empty());
}

void FitRemainingSegmentsTest::everySegmentIsExplained()
{
    LateWall late({3, 1, 0, 2});
    const auto stranger = append(late.map.segments, {segmentBetween(9, {-1.0, 3.0, 0.9}, {1.0, 3.0, 0.9})});
    cluster(stranger, late.map, late.parameters);

    fitRemainingSegments(late.map, late.parameters, late.recorded.recorder);

    const auto assigned = late.recorded.decisions(DecisionKind::Assign);
    const auto rejected = late.recorded.decisions(DecisionKind::Reject);
    QCOMPARE(assigned.size(), std::size_t{4});
    for (int step = 0; step < 4; ++step) {
        QVERIFY(segmentOf(assigned[static_cast<std::size_t>(step)].operands[0]) == (SegmentId{step, 0}));
        QVERIFY(allPass(assigned[static_cast<std::size_t>(step)].tests));
    }
    QCOMPARE(rejected.size(), std::size_t{1});
    QVERIFY(!failed(rejected[0].tests).empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::FitRemainingSegmentsTest)
#include "fit_remaining_segments_test.moc"
