// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/map_builder.h"

#include <algorithm>
#include <cmath>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/core/mapping/map_score.h"
#include "tests/core/mapping/simulated_floor.h"
#include "tests/test_program.h"

namespace planewright {

class MapBuilderTest : public QObject {
    Q_OBJECT

private slots:
    void twentyStopsAroundALoopMakeATrueMap();
    void theSameStopsGiveTheSameMap();
    void aLoopThatDriftedIsClosed();
    void adjustingAllChangesLittleOfWhatWasAdjustedOnTheWay();
    void thePlanesOfTheMapKnowWhereTheyWereSeen();
    void aMatchMadeByHandHolds();
    void aMatchMadeByHandTellsHowFarItIs();
    void whatCannotBeUsedIsNamed_data();
    void whatCannotBeUsedIsNamed();
};

namespace {

/// The walls of the simulation are flat.
MappingParameters flatWalls()
{
    MappingParameters parameters;
    parameters.flatness = 0.0;
    return parameters;
}

MapBuilder mapOf(const std::vector<SimulatedStop>& stops, const MappingParameters& parameters = flatWalls())
{
    MapBuilder builder(parameters);
    for (const SimulatedStop& stop : stops) {
        if (!builder.join(stop.stop))
            qFatal("A simulated stop was refused.");
    }
    return builder;
}

/// A ring of bare corridors, without doors or pillars.
FloorPlan bareRing()
{
    FloorPlan plan;
    plan.addLevel({-2.0, -2.0}, {22.0, 12.0}, 0.0, true);
    plan.addLevel({-2.0, -2.0}, {22.0, 12.0}, 2.8, false);
    const Eigen::Vector2d inner[4] = {{1.2, 1.2}, {1.2, 8.8}, {18.8, 8.8}, {18.8, 1.2}};
    const Eigen::Vector2d outer[4] = {{-1.2, -1.2}, {21.2, -1.2}, {21.2, 11.2}, {-1.2, 11.2}};
    for (std::size_t i = 0; i < 4; ++i) {
        plan.addWall(inner[i], inner[(i + 1) % 4], 0.0, 2.8);
        plan.addWall(outer[i], outer[(i + 1) % 4], 0.0, 2.8);
    }
    return plan;
}

}  // namespace

/// 60 m, odometry 2 % of the way and 1° on 10 m. Covariances are honest: errors of poses and planes over them have the
/// mean of their unknowns, within a fifth.
void MapBuilderTest::twentyStopsAroundALoopMakeATrueMap()
{
    std::vector<double> poseErrors;
    std::vector<double> planeErrors;
    int possible = 0;
    int made = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const FloorPlan plan = ringFloor(seed);
        const auto stops = seeFloor(plan, ringRoute(20, seed), {}, seed);

        MapBuilder builder = mapOf(stops);
        QVERIFY(builder.adjust());

        const MapScore score = scoreMap(builder.map(), stops, plan.planes());
        QCOMPARE(score.shifts.size(), std::size_t(19));
        QCOMPARE(score.wrong, 0);
        QVERIFY(meanOf(score.shifts) < 0.01);
        QVERIFY(meanOf(score.turns) < degrees(0.05));
        possible += score.possible;
        made += score.made;
        poseErrors.insert(poseErrors.end(), score.poseErrors.begin(), score.poseErrors.end());
        planeErrors.insert(planeErrors.end(), score.planeErrors.begin(), score.planeErrors.end());
    }
    QVERIFY(made >= 0.98 * possible);
    QVERIFY(std::abs(meanOf(poseErrors) / 6.0 - 1.0) < 0.2);
    QVERIFY(std::abs(meanOf(planeErrors) / 3.0 - 1.0) < 0.2);
}

void MapBuilderTest::theSameStopsGiveTheSameMap()
{
    const auto stops = seeFloor(ringFloor(1), ringRoute(6, 1), {}, 1);

    const MapBuilder first = mapOf(stops);
    const MapBuilder second = mapOf(stops);

    for (std::size_t i = 0; i < stops.size(); ++i) {
        QVERIFY(first.map().stops[i].pose.translation == second.map().stops[i].pose.translation);
        QVERIFY(first.map().stops[i].pose.rotation.coeffs() == second.map().stops[i].pose.rotation.coeffs());
    }
    QCOMPARE(first.map().planes.size(), second.map().planes.size());
}

/// In bare corridors a scanner that sees 6 m far does not know how far it has gone, but for the corners.
void MapBuilderTest::aLoopThatDriftedIsClosed()
{
    const FloorPlan plan = bareRing();
    SightNoise noise;
    noise.reach = 6.0;
    const auto stops = seeFloor(plan, ringRoute(21, 5), noise, 5);
    MapBuilder builder(flatWalls());
    bool closed = false;
    for (const SimulatedStop& stop : stops) {
        const auto joined = builder.join(stop.stop);
        QVERIFY(joined);
        closed = closed || joined->closedLoop;
    }
    QVERIFY(closed);
    QVERIFY(builder.adjust());

    const MapScore score = scoreMap(builder.map(), stops, plan.planes());
    QCOMPARE(score.wrong, 0);
    // The last stop sees what the first one saw: floor, ceiling and the walls of their corridor.
    const auto isSeenBy = [](const MapPlane& plane, std::size_t stop) {
        return std::ranges::find(plane.sightings, stop, &Sighting::stop) != plane.sightings.end();
    };
    const auto shared = std::ranges::count_if(builder.map().planes, [&](const MapPlane& plane) {
        return isSeenBy(plane, 0) && isSeenBy(plane, stops.size() - 1);
    });
    QVERIFY2(shared >= 4, qPrintable(QString::number(shared)));
    // Back at the start the error is gone.
    QVERIFY2(score.shifts.back() < 0.03, qPrintable(QString::number(score.shifts.back())));
}

void MapBuilderTest::adjustingAllChangesLittleOfWhatWasAdjustedOnTheWay()
{
    const FloorPlan plan = ringFloor(2);
    const auto stops = seeFloor(plan, ringRoute(20, 2), {}, 2);
    MapBuilder builder = mapOf(stops);
    const BuildingMap before = builder.map();

    const auto done = builder.adjust();

    QVERIFY(done);
    QVERIFY(done->costAfter <= done->costBefore);
    for (std::size_t i = 0; i < stops.size(); ++i)
        QVERIFY((builder.map().stops[i].pose.translation - before.stops[i].pose.translation).norm() < 0.05);
    // The first stop is the frame.
    QVERIFY(builder.map().stops[0].pose.translation.isZero(0.0));
    QVERIFY(builder.map().stops[0].covariance.isZero(0.0));
}

void MapBuilderTest::thePlanesOfTheMapKnowWhereTheyWereSeen()
{
    const FloorPlan plan = bareRing();
    const auto stops = seeFloor(plan, ringRoute(20, 3), {}, 3);
    MapBuilder builder = mapOf(stops);
    QVERIFY(builder.adjust());

    // The outer wall of the first corridor is 22.4 m long and 2.8 m high; all rays end within the ring.
    double largest = 0.0;
    for (const MapPlane& plane : builder.map().planes) {
        if (std::abs(plane.parameters.normal.z()) > 0.5)
            continue;
        const auto parts = fusedOutline(builder.map(), plane);
        double length = 0.0;
        for (const Outline::Polygon& part : parts) {
            for (const Eigen::Vector3d& a : part.ring) {
                for (const Eigen::Vector3d& b : part.ring)
                    length = std::max(length, (a - b).norm());
                QVERIFY(std::abs(plane.parameters.normal.dot(a) - plane.parameters.distance) < 1e-9);
            }
        }
        largest = std::max(largest, length);
    }
    QVERIFY(largest > 21.0 && largest < std::hypot(22.4, 2.8) + 0.1);
}

void MapBuilderTest::aMatchMadeByHandHolds()
{
    const auto stops = seeFloor(ringFloor(1), ringRoute(3, 1), {}, 1);
    MapBuilder builder = mapOf(stops);
    const auto& matches = builder.map().stops[1].matches;
    const auto matched =
        std::ranges::find_if(matches, [](const MapMatch& match) { return match.state == MatchState::Matched; });
    QVERIFY(matched != matches.end());
    const auto plane = static_cast<std::size_t>(matched - matches.begin());
    const std::size_t was = *matched->plane;
    const std::size_t seenBefore = builder.map().planes[was].sightings.size();

    // Rejected: a plane of its own; then accepted again.
    QVERIFY(builder.match(1, plane, std::nullopt));
    QVERIFY(*builder.map().stops[1].matches[plane].plane != was);
    QCOMPARE(builder.map().planes[was].sightings.size(), seenBefore - 1);
    QVERIFY(builder.adjust());
    QVERIFY(builder.match(1, plane, was));
    QCOMPARE(*builder.map().stops[1].matches[plane].plane, was);
    QCOMPARE(builder.map().planes[was].sightings.size(), seenBefore);
    QVERIFY(builder.adjust());

    QVERIFY(!builder.match(1, plane, std::size_t(100000)));
    QVERIFY(!builder.match(77, 0, std::nullopt));
}

/// Two parallel walls that one stop sees straight ahead, 0.1 m apart, each known to 10 mm: 0.1² / (2 · 0.01²) = 50.
void MapBuilderTest::aMatchMadeByHandTellsHowFarItIs()
{
    Stop stop;
    for (const double distance : {2.0, 2.1}) {
        ObservedPlane& plane = stop.planes.emplace_back();
        plane.parameters.normal = Eigen::Vector3d::UnitX();
        plane.parameters.distance = distance;
        plane.parameters.tangents.col(0) = Eigen::Vector3d::UnitY();
        plane.parameters.tangents.col(1) = Eigen::Vector3d::UnitZ();
        plane.parameters.covariance = 1e-4 * Eigen::Matrix3d::Identity();
        plane.parts = {
            {{{distance, 1.0, 1.0}, {distance, -1.0, 1.0}, {distance, -1.0, -1.0}, {distance, 1.0, -1.0}}, {}}};
    }
    MapBuilder builder(flatWalls());
    QVERIFY(builder.join(stop));

    QVERIFY(builder.match(0, 1, builder.map().stops[0].matches[0].plane));

    QVERIFY(std::abs(builder.map().stops[0].matches[1].chiSquare - 50.0) < 1e-6);
}

void MapBuilderTest::whatCannotBeUsedIsNamed_data()
{
    QTest::addColumn<int>("fault");
    QTest::addColumn<QString>("named");
    QTest::newRow("normal") << 0 << "normal is not of length 1";
    QTest::newRow("tangents") << 1 << "tangents are not at right angles";
    QTest::newRow("distance") << 2 << "distance is not a number from 0 up";
    QTest::newRow("covariance") << 3 << "covariance is not positive definite";
    QTest::newRow("outline") << 4 << "a corner that is not a number";
    QTest::newRow("odometry") << 5 << "odometry is not a motion";
    QTest::newRow("odometry's covariance") << 6 << "covariance of its odometry is not positive definite";
}

void MapBuilderTest::whatCannotBeUsedIsNamed()
{
    QFETCH(int, fault);
    QFETCH(QString, named);
    Stop stop = seeFloor(ringFloor(1), ringRoute(3, 1), {}, 1)[1].stop;
    MapBuilder builder;
    ObservedPlane& plane = stop.planes[2];
    switch (fault) {
        case 0:
            plane.parameters.normal *= 1.1;
            break;
        case 1:
            plane.parameters.tangents.col(0) = plane.parameters.normal;
            break;
        case 2:
            plane.parameters.distance = -1.0;
            break;
        case 3:
            plane.parameters.covariance.setZero();
            break;
        case 4:
            plane.parts[0].ring[0].x() = NAN;
            break;
        case 5:
            stop.odometry->pose.translation.y() = INFINITY;
            break;
        default:
            stop.odometry->covariance(0, 0) = -1.0;
            break;
    }

    const auto joined = builder.join(stop);

    QVERIFY(!joined);
    QCOMPARE(joined.error().code, ErrorCode::Unreadable);
    const QString message = QString::fromStdString(joined.error().message);
    QVERIFY2(message.contains(named), qPrintable(message));
    QVERIFY(message.startsWith("Stop 1: "));
    QVERIFY(builder.map().stops.empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MapBuilderTest)
#include "map_builder_test.moc"
