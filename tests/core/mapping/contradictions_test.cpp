// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/contradictions.h"

#include <cmath>
#include <memory>
#include <vector>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/core/mapping/known_planes.h"
#include "tests/test_program.h"

namespace planewright {

class ContradictionsTest : public QObject {
    Q_OBJECT

private slots:
    void sightingsThatAgreeStay();
    void theOneThatContradictsIsLeftOpen();
    void itIsLeftOpenHoweverSureItIs();
    void allThatContradictTheMostAreLeftOpen();
    void whatIsALittleOffStays();
    void ofTwoSightingsNoneIsTheWrongOne();
    void whatAgreesOtherwiseBecomesAPlaneOfItsOwn();
    void whatMayBeOfEitherIsLeftOpen();
    void whereItMayBeAnotherOneNobodyIsSure();
    void amongManyTheOneIsFound();
    void whatWasMatchedByHandStays();
};

namespace {

/// How far a stop says that a wall x = 5 m is off [m], and how sure it is [m].
struct Told {
    double off = 0.0;
    double sigma = 0.002;
};

/// Stops at the origin that see one wall, all of them one plane of the map.
BuildingMap mapOf(const std::vector<Told>& all)
{
    BuildingMap map;
    map.planes.emplace_back();
    for (std::size_t n = 0; n < all.size(); ++n) {
        auto stop = std::make_shared<Stop>();
        ObservedPlane wall;
        const double place = 5.0 + all[n].off;
        wall.parameters = planeKnownTo(Eigen::Vector3d::UnitX(), place, degrees(0.05), all[n].sigma);
        wall.parts.push_back({{{place, -1.0, -1.0}, {place, 1.0, -1.0}, {place, 1.0, 1.0}, {place, -1.0, 1.0}}, {}});
        stop->planes.push_back(wall);
        MapStop& added = map.stops.emplace_back();
        added.stop = stop;
        added.trust = n == 0 ? StopTrust::First : StopTrust::Planes;
        added.matches.push_back({n == 0 ? MatchState::New : MatchState::Matched, 0, {}, 0.0, false});
        map.planes[0].sightings.push_back({n, 0});
    }
    map.planes[0].parameters = map.stops[0].stop->planes[0].parameters;
    return map;
}

/// The stops whose sighting is left open.
std::vector<std::size_t> openIn(const BuildingMap& map)
{
    std::vector<std::size_t> open;
    for (std::size_t n = 0; n < map.stops.size(); ++n) {
        if (map.stops[n].matches[0].state == MatchState::Open)
            open.push_back(n);
    }
    return open;
}

}  // namespace

void ContradictionsTest::sightingsThatAgreeStay()
{
    BuildingMap map = mapOf({{0.001}, {-0.002}, {0.003}, {-0.004}});

    QCOMPARE(divideContradictions(map), 0);

    QVERIFY(openIn(map).empty());
    QCOMPARE(map.planes[0].sightings.size(), std::size_t{4});
}

void ContradictionsTest::theOneThatContradictsIsLeftOpen()
{
    BuildingMap map = mapOf({{0.001}, {0.030}, {-0.001}, {0.0}});

    QCOMPARE(divideContradictions(map), 1);

    QVERIFY(openIn(map) == std::vector<std::size_t>{1});
    const MapMatch& match = map.stops[1].matches[0];
    QVERIFY(!match.plane);
    QVERIFY(match.rivals == std::vector<std::size_t>{0});
    QVERIFY(match.chiSquare > 50.0);
    QCOMPARE(map.planes[0].sightings.size(), std::size_t{3});
    for (const Sighting& sighting : map.planes[0].sightings)
        QVERIFY(sighting.stop != 1);
}

void ContradictionsTest::itIsLeftOpenHoweverSureItIs()
{
    BuildingMap map = mapOf({{0.001}, {-0.001}, {0.040, 0.0002}});

    QCOMPARE(divideContradictions(map), 1);

    QVERIFY(openIn(map) == std::vector<std::size_t>{2});
}

void ContradictionsTest::allThatContradictTheMostAreLeftOpen()
{
    BuildingMap map = mapOf({{0.0}, {0.030}, {0.0}, {-0.060}, {0.001}, {-0.001}});

    QCOMPARE(divideContradictions(map), 2);

    QVERIFY((openIn(map) == std::vector<std::size_t>{1, 3}));
    QCOMPARE(map.planes.size(), std::size_t{1});
}

/// Five standard deviations are less than what makes it sure.
void ContradictionsTest::whatIsALittleOffStays()
{
    BuildingMap map = mapOf({{0.0}, {0.010}, {0.0}, {-0.060}, {0.001}, {-0.001}});

    QCOMPARE(divideContradictions(map), 1);

    QVERIFY(openIn(map) == std::vector<std::size_t>{3});
}

void ContradictionsTest::ofTwoSightingsNoneIsTheWrongOne()
{
    BuildingMap map = mapOf({{0.0}, {0.050}});

    QCOMPARE(divideContradictions(map), 0);
}

void ContradictionsTest::whatAgreesOtherwiseBecomesAPlaneOfItsOwn()
{
    BuildingMap map = mapOf({{0.050}, {0.0}, {0.001}, {0.051}, {-0.001}});

    QCOMPARE(divideContradictions(map), 2);

    QVERIFY(openIn(map).empty());
    QCOMPARE(map.planes.size(), std::size_t{2});
    const auto isOf = [&](std::size_t stop, std::size_t plane, MatchState state) {
        const MapMatch& match = map.stops[stop].matches[0];
        return match.plane == plane && match.state == state;
    };
    // The three keep the plane, which another stop saw first now.
    QVERIFY(isOf(1, 0, MatchState::New) && isOf(2, 0, MatchState::Matched) && isOf(4, 0, MatchState::Matched));
    QVERIFY(isOf(0, 1, MatchState::New) && isOf(3, 1, MatchState::Matched));
    QVERIFY(std::abs(map.planes[1].parameters.distance - 5.0505) < 2e-4);
}

void ContradictionsTest::whatMayBeOfEitherIsLeftOpen()
{
    BuildingMap map = mapOf({{0.0}, {0.050}, {0.001}, {0.051}, {-0.001}, {0.025, 0.050}});

    QCOMPARE(divideContradictions(map), 3);

    QVERIFY(openIn(map) == std::vector<std::size_t>{5});
    QVERIFY((map.stops[5].matches[0].rivals == std::vector<std::size_t>{0, 1}));
    QCOMPARE(map.planes[0].sightings.size(), std::size_t{3});
    QCOMPARE(map.planes[1].sightings.size(), std::size_t{2});
}

void ContradictionsTest::amongManyTheOneIsFound()
{
    std::vector<Told> all;
    for (int i = 0; i < 300; ++i)
        all.push_back({0.001 * (i % 5 - 2)});
    all[170].off = 0.030;
    BuildingMap map = mapOf(all);

    QCOMPARE(divideContradictions(map), 1);

    QVERIFY(openIn(map) == std::vector<std::size_t>{170});
}

/// The third is so unsure that it agrees with either of the others.
void ContradictionsTest::whereItMayBeAnotherOneNobodyIsSure()
{
    BuildingMap map = mapOf({{0.0}, {0.050}, {0.025, 0.050}});

    QCOMPARE(divideContradictions(map), 0);
}

void ContradictionsTest::whatWasMatchedByHandStays()
{
    BuildingMap map = mapOf({{0.001}, {0.030}, {-0.001}, {0.0}});
    map.stops[1].matches[0].isByHand = true;

    QCOMPARE(divideContradictions(map), 0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ContradictionsTest)
#include "contradictions_test.moc"
