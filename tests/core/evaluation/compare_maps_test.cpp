// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/compare_maps.h"

#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

class CompareMapsTest : public QObject {
    Q_OBJECT

private slots:
    void aMapIsItself();
    void planesPairByOverlapBeforeAngle();
    void whatIsTooFarApartIsNoPair();
    void aPlaneInPiecesNamesWhoHasThem();
    void nothingIsLikeNothing();
};

namespace {

/// Beams of a slice that see a plane.
struct Seen {
    PlaneId plane;
    int step;
    int first;
    int last;
};

/// Planes n = (sin a, cos a, 0), d, of ids and angles a [deg], seen by these beams.
Snapshot mapOf(const std::vector<std::tuple<PlaneId, double, double>>& planes, const std::vector<Seen>& beams)
{
    std::map<int, std::shared_ptr<Segments>> slices;
    std::map<PlaneId, std::vector<SegmentId>> members;
    for (const Seen& seen : beams) {
        auto& slice = slices[seen.step];
        if (!slice)
            slice = std::make_shared<Segments>();
        LineSegment segment;
        segment.id = {seen.step, static_cast<int>(slice->size())};
        segment.firstBeam = seen.first;
        segment.lastBeam = seen.last;
        members[seen.plane].push_back(segment.id);
        slice->push_back(segment);
    }
    Snapshot map;
    for (const auto& [step, segments] : slices)
        map.segments.append(step, segments);
    for (const auto& [id, angle, distance] : planes) {
        auto plane = std::make_shared<Plane>();
        plane->id = id;
        plane->normal = {std::sin(degrees(angle)), std::cos(degrees(angle)), 0.0};
        plane->distance = distance;
        plane->segments = members[id];
        map.planes.push_back(plane);
    }
    return map;
}

}  // namespace

void CompareMapsTest::aMapIsItself()
{
    const Snapshot map = mapOf({{3, 0.0, 2.0}, {7, 90.0, 1.0}}, {{3, 0, 0, 9}, {7, 0, 10, 19}, {3, 1, 0, 4}});

    const MapComparison comparison = compareMaps(map, map);

    QCOMPARE(comparison.pairs.size(), std::size_t(2));
    QCOMPARE(comparison.pairs[1].a, 7);
    QCOMPARE(comparison.pairs[1].b, 7);
    QCOMPARE(comparison.pairs[0].overlap, 1.0);
    QCOMPARE(comparison.errors.angle.max, 0.0);
    QVERIFY(comparison.onlyA.empty() && comparison.onlyB.empty());
}

/// Plane 1 has 30 beams; 20 of them are plane 5's, which is 2° off, and 10 are plane 6's, which is parallel.
void CompareMapsTest::planesPairByOverlapBeforeAngle()
{
    const Snapshot a = mapOf({{1, 0.0, 2.0}}, {{1, 4, 0, 29}});
    const Snapshot b = mapOf({{5, 2.0, 2.05}, {6, 0.0, 2.0}}, {{5, 4, 0, 19}, {6, 4, 20, 29}});

    const MapComparison comparison = compareMaps(a, b);

    QCOMPARE(comparison.pairs.size(), std::size_t(1));
    QCOMPARE(comparison.pairs[0].b, 5);
    QCOMPARE(comparison.pairs[0].overlap, 20.0 / 30.0);
    QVERIFY(std::abs(comparison.pairs[0].difference.angle - degrees(2.0)) < 1e-12);
    QVERIFY(std::abs(comparison.pairs[0].difference.distance - 0.05) < 1e-12);
    QCOMPARE(comparison.onlyB.size(), std::size_t(1));
    QCOMPARE(comparison.onlyB[0].plane, 6);
    QCOMPARE(comparison.onlyB[0].nearest, 1);
    QCOMPARE(comparison.onlyB[0].share, 1.0);
}

void CompareMapsTest::whatIsTooFarApartIsNoPair()
{
    const std::vector<Seen> beams{{1, 0, 0, 9}};
    const Snapshot a = mapOf({{1, 0.0, 2.0}}, beams);
    QVERIFY(compareMaps(a, mapOf({{1, 6.0, 2.0}}, beams)).pairs.empty());
    QVERIFY(compareMaps(a, mapOf({{1, 0.0, 2.2}}, beams)).pairs.empty());
    QCOMPARE(compareMaps(a, mapOf({{1, 0.0, 2.2}}, beams), {{degrees(5.0), 0.3}, 0.25}).pairs.size(), std::size_t(1));
    // 2 of 18 beams in common.
    QVERIFY(compareMaps(a, mapOf({{1, 0.0, 2.0}}, {{1, 0, 8, 17}})).pairs.empty());
    // The same beams of another slice.
    QVERIFY(compareMaps(a, mapOf({{1, 0.0, 2.0}}, {{1, 1, 0, 9}})).pairs.empty());
}

/// 100 beams in five pieces of 20: none has a quarter of them.
void CompareMapsTest::aPlaneInPiecesNamesWhoHasThem()
{
    const Snapshot a = mapOf({{1, 0.0, 2.0}}, {{1, 0, 0, 99}});
    std::vector<std::tuple<PlaneId, double, double>> planes;
    std::vector<Seen> beams;
    for (int piece = 0; piece < 5; ++piece) {
        planes.emplace_back(piece, 0.0, 2.0);
        beams.push_back({piece, 0, 20 * piece, 20 * piece + 19});
    }

    const MapComparison comparison = compareMaps(a, mapOf(planes, beams));

    QVERIFY(comparison.pairs.empty());
    QCOMPARE(comparison.onlyA.size(), std::size_t(1));
    QCOMPARE(comparison.onlyA[0].share, 0.2);
    QCOMPARE(comparison.onlyB.size(), std::size_t(5));
}

void CompareMapsTest::nothingIsLikeNothing()
{
    const MapComparison comparison = compareMaps({}, mapOf({{1, 0.0, 2.0}}, {}));

    QVERIFY(comparison.pairs.empty());
    QCOMPARE(comparison.onlyB.size(), std::size_t(1));
    QCOMPARE(comparison.onlyB[0].nearest, kNoPlane);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::CompareMapsTest)
#include "compare_maps_test.moc"
