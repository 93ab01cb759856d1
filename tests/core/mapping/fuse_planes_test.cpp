// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/fuse_planes.h"

#include <memory>

#include <QtTest>

#include "core/mapping/map_changes.h"
#include "core/types/angle.h"
#include "tests/core/mapping/known_planes.h"
#include "tests/test_program.h"

namespace planewright {

class FusePlanesTest : public QObject {
    Q_OBJECT

private slots:
    void twoPiecesOfAWallBecomeOne();
    void wallsThatDifferStayApart();
    void wallsThatDoNotMeetStayApart();
    void whatOneStopSawApartStaysApart();
    void whatWasDecidedByHandStays();
    void whatMayBeOneOfTwoStaysOpen();
    void anOpenPlaneJoinsTheOneItFits();
    void anOpenPlaneThatFitsNothingIsNew();
};

namespace {

constexpr double kGap = 0.05;

/// A wall x = distance, seen from the origin's side, from y = low to y = high and 2.5 m high.
ObservedPlane wallAt(double distance, double low, double high)
{
    ObservedPlane wall;
    wall.parameters = planeKnownTo(Eigen::Vector3d::UnitX(), distance, degrees(0.05), 0.003);
    wall.parts.push_back(
        {{{distance, low, 0.0}, {distance, high, 0.0}, {distance, high, 2.5}, {distance, low, 2.5}}, {}});
    return wall;
}

/// Stops that all stand at the origin, each with its walls as planes of the map of its own.
struct FusedMap {
    BuildingMap map;
    std::vector<StopExtents> extents;

    void addStop(std::vector<ObservedPlane> walls, MatchState state = MatchState::New)
    {
        auto stop = std::make_shared<Stop>();
        stop->id = static_cast<int>(map.stops.size());
        stop->planes = std::move(walls);
        MapStop& added = map.stops.emplace_back();
        added.stop = stop;
        added.trust = StopTrust::Planes;
        added.covariance = 1e-8 * Matrix6d::Identity();
        added.matches.resize(stop->planes.size());
        extents.push_back(extentsOf(*stop));
        for (std::size_t i = 0; i < added.matches.size(); ++i) {
            map.stops.back().matches[i].state = state;
            if (state != MatchState::Open)
                map.stops.back().matches[i].plane = addPlane(map, {map.stops.size() - 1, i});
        }
    }

    int fuse()
    {
        return fusePlanes(
            map, extents,
            [this](std::size_t) {
                std::vector<std::size_t> all(map.stops.size());
                for (std::size_t i = 0; i < all.size(); ++i)
                    all[i] = i;
                return all;
            },
            kGap);
    }

    std::size_t planes() const
    {
        return static_cast<std::size_t>(
            std::ranges::count_if(map.planes, [](const MapPlane& plane) { return !plane.sightings.empty(); }));
    }
};

}  // namespace

void FusePlanesTest::twoPiecesOfAWallBecomeOne()
{
    FusedMap fused;
    fused.addStop({wallAt(4.0, 0.0, 2.0)});
    fused.addStop({wallAt(4.003, 1.5, 5.0)});

    QCOMPARE(fused.fuse(), 1);

    QCOMPARE(fused.planes(), std::size_t(1));
    QCOMPARE(fused.map.planes[0].sightings.size(), std::size_t(2));
    QCOMPARE(*fused.map.stops[1].matches[0].plane, std::size_t(0));
    QCOMPARE(fused.map.stops[0].matches[0].state, MatchState::New);
    QCOMPARE(fused.map.stops[1].matches[0].state, MatchState::Matched);
}

/// 3 cm are seven of their standard deviations.
void FusePlanesTest::wallsThatDifferStayApart()
{
    FusedMap fused;
    fused.addStop({wallAt(4.0, 0.0, 2.0)});
    fused.addStop({wallAt(4.03, 1.5, 5.0)});

    QCOMPARE(fused.fuse(), 0);
    QCOMPARE(fused.planes(), std::size_t(2));
}

void FusePlanesTest::wallsThatDoNotMeetStayApart()
{
    FusedMap fused;
    fused.addStop({wallAt(4.0, 0.0, 2.0)});
    fused.addStop({wallAt(4.0, 2.5, 5.0)});

    QCOMPARE(fused.fuse(), 0);
    QCOMPARE(fused.planes(), std::size_t(2));
}

/// A panel on a wall, 2 cm before it: to one scan two planes, however well a third sighting fits both.
void FusePlanesTest::whatOneStopSawApartStaysApart()
{
    FusedMap fused;
    fused.addStop({wallAt(4.0, 0.0, 2.0), wallAt(3.98, 0.5, 1.5)});

    QCOMPARE(fused.fuse(), 0);
    QCOMPARE(fused.planes(), std::size_t(2));
}

void FusePlanesTest::whatWasDecidedByHandStays()
{
    FusedMap fused;
    fused.addStop({wallAt(4.0, 0.0, 2.0)});
    fused.addStop({wallAt(4.003, 1.5, 5.0)});
    fused.map.stops[1].matches[0].isByHand = true;

    QCOMPARE(fused.fuse(), 0);
    QCOMPARE(fused.planes(), std::size_t(2));
}

void FusePlanesTest::whatMayBeOneOfTwoStaysOpen()
{
    FusedMap fused;
    fused.addStop({wallAt(4.0, 0.0, 2.0), wallAt(3.98, 1.0, 3.0)});
    fused.addStop({wallAt(3.99, 0.5, 2.5)}, MatchState::Open);

    QCOMPARE(fused.fuse(), 0);
    QCOMPARE(fused.map.stops[1].matches[0].state, MatchState::Open);
}

void FusePlanesTest::anOpenPlaneJoinsTheOneItFits()
{
    FusedMap fused;
    fused.addStop({wallAt(4.0, 0.0, 2.0)});
    fused.addStop({wallAt(4.002, 0.5, 2.5)}, MatchState::Open);
    fused.map.stops[1].matches[0].rivals = {0};

    QCOMPARE(fused.fuse(), 1);

    QCOMPARE(fused.map.stops[1].matches[0].state, MatchState::Matched);
    QCOMPARE(*fused.map.stops[1].matches[0].plane, std::size_t(0));
    QVERIFY(fused.map.stops[1].matches[0].rivals.empty());
    QCOMPARE(fused.map.planes[0].sightings.size(), std::size_t(2));
}

void FusePlanesTest::anOpenPlaneThatFitsNothingIsNew()
{
    FusedMap fused;
    fused.addStop({wallAt(4.0, 0.0, 2.0)});
    fused.addStop({wallAt(4.3, 0.5, 2.5)}, MatchState::Open);

    QCOMPARE(fused.fuse(), 1);

    QCOMPARE(fused.map.stops[1].matches[0].state, MatchState::New);
    QCOMPARE(fused.planes(), std::size_t(2));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::FusePlanesTest)
#include "fuse_planes_test.moc"
