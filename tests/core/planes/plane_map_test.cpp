// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_map.h"

#include <cmath>

#include <QtTest>

#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {

class PlaneMapTest : public QObject {
    Q_OBJECT

private slots:
    void makingAPlaneMarksItsSegments();
    void planesAreFoundByTheirId();
    void segmentsOfPlanesAreRemovedFromTheClusters();
    void segmentsOfLikeDirectionAreClusteredTogether();
    void clusteringIsExplained();
};

void PlaneMapTest::makingAPlaneMarksItsSegments()
{
    PlaneMap map;
    map.nextPlane = 3;
    append(map.segments, wall(6).segments());

    makePlane(map, {1, 2, 4}, lenient().planes);

    QCOMPARE(map.nextPlane, 4);
    for (SegmentNumber number = 0; number < 6; ++number)
        QCOMPARE(map.segments.owner(number), number == 1 || number == 2 || number == 4 ? 3 : kNoPlane);
}

void PlaneMapTest::planesAreFoundByTheirId()
{
    PlaneMap map;
    makePlanes(map, {wall(4).segments(), wall(4, 1.0).segments(), wall(4, 2.0).segments()}, lenient().planes);
    map.planes.erase(map.planes.begin());

    QCOMPARE(map.plane(1).id(), 1);
    QCOMPARE(map.plane(2).id(), 2);
    QVERIFY(std::abs(map.plane(2).distance() - 6.0) < 1e-9);
}

void PlaneMapTest::segmentsOfPlanesAreRemovedFromTheClusters()
{
    const Parameters parameters = lenient();
    PlaneMap map;
    const auto numbers = append(map.segments, wall(6).segments());
    cluster(numbers, map, parameters);
    makePlane(map, {0, 2, 3}, parameters.planes);

    map.removeOwnedFromClusters();

    QVERIFY((clusteredSegments(map) == std::vector<SegmentNumber>{1, 4, 5}));
}

void PlaneMapTest::segmentsOfLikeDirectionAreClusteredTogether()
{
    const Parameters parameters = lenient();
    PlaneMap map;
    LineSegment backwards = segmentBetween(1, {1.0, 2.0, 0.0}, {-1.0, 2.0, 0.0});
    const auto numbers = append(map.segments, {segmentBetween(0, {-1.0, 4.0, 0.0}, {1.0, 4.0, 0.0}), backwards,
                                               segmentBetween(2, {0.0, 4.0, 0.0}, {0.0, 4.0, 1.0})});

    cluster(numbers, map, parameters);

    QCOMPARE(map.clusters.all().size(), std::size_t{2});
    QCOMPARE(map.clusters.all()[0].members.size(), std::size_t{2});
    QCOMPARE(map.clusters.all()[1].members[0].segment, numbers[2]);
}

void PlaneMapTest::clusteringIsExplained()
{
    const Parameters parameters = lenient();
    PlaneMap map;
    Recorded recorded;
    const Eigen::Vector3d turned{std::cos(degrees(6.0)), std::sin(degrees(6.0)), 0.0};
    const auto numbers = append(map.segments, {segmentBetween(0, {0.0, 4.0, 0.0}, {1.0, 4.0, 0.0}),
                                               segmentBetween(1, {0.0, 2.0, 0.0}, {turned.x(), 2.0 + turned.y(), 0.0}),
                                               segmentBetween(2, {0.0, 4.0, 0.0}, {0.0, 4.0, 1.0})});

    addToClusters(numbers, map, parameters.clusters, recorded.recorder);

    const auto decisions = recorded.decisions(DecisionKind::Cluster);
    QCOMPARE(decisions.size(), std::size_t{3});
    const auto similarity = [&](std::size_t i) { return testOf(decisions[i].tests, "direction_similarity"); };
    QCOMPARE(similarity(0).value, 0.0);
    QVERIFY(!similarity(0).pass());
    QVERIFY(std::abs(similarity(1).value - std::cos(degrees(6.0))) < 1e-12);
    QVERIFY(std::abs(similarity(1).limit - std::cos(degrees(10.0))) < 1e-12);
    QVERIFY(similarity(1).pass());
    QVERIFY(!similarity(2).pass());
    for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY(segmentOf(decisions[i].operands[0]) == (SegmentId{static_cast<int>(i), 0}));
        QCOMPARE(clusterOf(decisions[i].result[0]), i == 2 ? 1 : 0);
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PlaneMapTest)
#include "plane_map_test.moc"
