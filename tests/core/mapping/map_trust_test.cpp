// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <QtTest>

#include "core/mapping/map_builder.h"
#include "core/mapping/uncertain_plane.h"
#include "core/types/angle.h"
#include "tests/core/mapping/map_score.h"
#include "tests/core/mapping/simulated_floor.h"
#include "tests/test_program.h"

namespace planewright {

/// What goes wrong on the way: the map may be unsure, and says so; it is never wrong and sure.
class MapTrustTest : public QObject {
    Q_OBJECT

private slots:
    void odometryTenTimesWorseThanToldIsNoticed();
    void aStopTurnedInASquareRoomIsUnsure();
    void aStopTurnedInAnotherRoomIsPutRight();
    void movedFurnitureIsNotTakenForTheOldOne();
    void furnitureThatIsGoneIsSeenThrough();
    void aWallOfGlassIsSeenThrough();
    void aBareCorridorSaysThatOdometryAloneKnowsTheWay();
    void withoutOdometryAStopIsPlacedWhereItIsTheOnlyPlace();
    void withoutOdometryASquareRoomPlacesNothing();
    void afterAStopThatIsNotPlacedOdometryGoesOn();
};

namespace {

/// A room with its middle at the origin, 2.8 m high.
FloorPlan roomPlan(double halfX, double halfY)
{
    FloorPlan plan;
    plan.addLevel({-halfX, -halfY}, {halfX, halfY}, 0.0, true);
    plan.addLevel({-halfX, -halfY}, {halfX, halfY}, 2.8, false);
    const Eigen::Vector2d corners[4] = {{-halfX, -halfY}, {halfX, -halfY}, {halfX, halfY}, {-halfX, halfY}};
    for (std::size_t i = 0; i < 4; ++i)
        plan.addWall(corners[i], corners[(i + 1) % 4], 0.0, 2.8);
    return plan;
}

Pose standing(double x, double y, double heading)
{
    return {Eigen::Quaterniond(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ())), {x, y, 1.1}};
}

MapBuilder builderOfFlatWalls()
{
    MappingParameters parameters;
    parameters.flatness = 0.0;
    return MapBuilder(parameters);
}

/// Odometry that tells of another motion than the true one.
void tellMotion(Stop& stop, const Pose& motion)
{
    stop.odometry = Motion{motion, odometryCovariance(motion, {})};
}

bool isRight(const MapStop& stop, const SimulatedStop& truth, const SimulatedStop& first)
{
    const Vector6d error = errorBetween(first.truth.inverse() * truth.truth, stop.pose);
    return error.tail<3>().norm() < 0.03 && error.head<3>().norm() < degrees(0.3);
}

/// True where a stop stands right against one that came before; a part of the map that rests on odometry is off as a
/// whole.
bool isRightAgainstAnother(const BuildingMap& map, const std::vector<SimulatedStop>& stops, std::size_t number)
{
    for (std::size_t other = 0; other < number; ++other) {
        const Vector6d error = errorBetween(stops[other].truth.inverse() * stops[number].truth,
                                            map.stops[other].pose.inverse() * map.stops[number].pose);
        if (map.stops[other].isPlaced() && error.tail<3>().norm() < 0.03 && error.head<3>().norm() < degrees(0.3))
            return true;
    }
    return false;
}

}  // namespace

void MapTrustTest::odometryTenTimesWorseThanToldIsNoticed()
{
    int contradicted = 0;
    for (std::uint64_t seed = 21; seed <= 23; ++seed) {
        const FloorPlan plan = ringFloor(seed);
        SightNoise noise;
        noise.odometryScale = 10.0;
        const auto stops = seeFloor(plan, ringRoute(20, seed), noise, seed);
        MapBuilder builder = builderOfFlatWalls();
        for (const SimulatedStop& stop : stops)
            QVERIFY(builder.join(stop.stop));

        for (std::size_t i = 1; i < stops.size(); ++i) {
            const MapStop& stop = builder.map().stops[i];
            contradicted += stop.trust == StopTrust::AgainstOdometry ? 1 : 0;
            const bool isSure = stop.trust == StopTrust::Planes || stop.trust == StopTrust::AgainstOdometry;
            QVERIFY2(!isSure || isRightAgainstAnother(builder.map(), stops, i),
                     qPrintable(QString("seed %1 stop %2").arg(seed).arg(i)));
        }
        QVERIFY(builder.adjust());
    }
    QVERIFY(contradicted > 20);
}

/// Odometry has not noticed a quarter turn; four walls at equal distances do not tell.
void MapTrustTest::aStopTurnedInASquareRoomIsUnsure()
{
    const FloorPlan plan = roomPlan(2.5, 2.5);
    Random random(31);
    SimulatedStop first = seeFrom(plan, standing(0.0, 0.0, 0.0), {}, random);
    SimulatedStop second = seeFrom(plan, standing(0.0, 0.0, degrees(90.0)), {}, random);
    tellMotion(second.stop, {Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()});
    MapBuilder builder = builderOfFlatWalls();
    QVERIFY(builder.join(first.stop));

    const auto joined = builder.join(second.stop);

    QVERIFY(joined);
    QCOMPARE(joined->trust, StopTrust::OdometryDecides);
    const Pose truth = first.truth.inverse() * second.truth;
    QVERIFY(std::ranges::any_of(builder.map().stops[1].alternatives,
                                [&](const Pose& pose) { return errorBetween(truth, pose).norm() < 0.02; }));
}

void MapTrustTest::aStopTurnedInAnotherRoomIsPutRight()
{
    FloorPlan plan = roomPlan(3.0, 2.5);
    plan.addBox({-2.4, 1.9}, {0.8, 0.6}, 2.0, 0.0);
    plan.addBox({2.0, -2.0}, {0.5, 0.7}, 1.2, 0.3);
    Random random(32);
    SimulatedStop first = seeFrom(plan, standing(0.0, 0.0, 0.0), {}, random);
    SimulatedStop second = seeFrom(plan, standing(0.05, 0.0, degrees(90.0)), {}, random);
    tellMotion(second.stop, {Eigen::Quaterniond::Identity(), {0.05, 0.0, 0.0}});
    MapBuilder builder = builderOfFlatWalls();
    QVERIFY(builder.join(first.stop));

    const auto joined = builder.join(second.stop);

    QCOMPARE(joined->trust, StopTrust::AgainstOdometry);
    QVERIFY(isRight(builder.map().stops[1], second, first));
    QVERIFY(!builder.map().stops[1].odometry);
}

/// A cupboard moved by 15 cm, as much as odometry may be off on 5 m.
void MapTrustTest::movedFurnitureIsNotTakenForTheOldOne()
{
    FloorPlan before = roomPlan(4.0, 3.0);
    before.addBox({2.0, 2.0}, {1.0, 0.6}, 1.8, 0.0);
    FloorPlan after = roomPlan(4.0, 3.0);
    after.addBox({2.15, 1.85}, {1.0, 0.6}, 1.8, 0.0);
    Random random(33);
    SimulatedStop first = seeFrom(before, standing(-2.0, -1.0, 0.0), {}, random);
    SimulatedStop second = seeFrom(after, standing(1.0, -1.5, 0.3), {}, random);
    tellMotion(second.stop, first.truth.inverse() * second.truth);
    MapBuilder builder = builderOfFlatWalls();
    QVERIFY(builder.join(first.stop));

    QVERIFY(builder.join(second.stop));

    const MapStop& stop = builder.map().stops[1];
    QVERIFY(isRight(stop, second, first));
    int furniture = 0;
    for (std::size_t i = 0; i < stop.matches.size(); ++i) {
        const int number = second.planes[i];
        // Floor, ceiling and four walls, then the box: its top has not moved.
        const bool hasMoved =
            number >= 6 && std::abs(after.planes()[static_cast<std::size_t>(number)].normal.z()) < 0.5;
        furniture += hasMoved ? 1 : 0;
        QCOMPARE(stop.matches[i].state == MatchState::Matched, !hasMoved);
    }
    QVERIFY(furniture >= 1);
}

void MapTrustTest::furnitureThatIsGoneIsSeenThrough()
{
    FloorPlan before = roomPlan(4.0, 3.0);
    before.addBox({1.0, 0.0}, {0.6, 1.6}, 2.0, 0.0);
    const FloorPlan after = roomPlan(4.0, 3.0);
    Random random(34);
    SimulatedStop first = seeFrom(before, standing(-2.0, 0.0, 0.0), {}, random);
    SimulatedStop second = seeFrom(after, standing(-1.5, 0.1, 0.0), {}, random);
    tellMotion(second.stop, first.truth.inverse() * second.truth);
    MapBuilder builder = builderOfFlatWalls();
    QVERIFY(builder.join(first.stop));

    QVERIFY(builder.join(second.stop));

    int through = 0;
    for (std::size_t i = 0; i < first.planes.size(); ++i) {
        const MapPlane& plane = builder.map().planes[*builder.map().stops[0].matches[i].plane];
        // Planes from number 6 on are the box's.
        QVERIFY(first.planes[i] >= 6 || plane.seenThrough.empty());
        through += plane.seenThrough == std::vector<std::size_t>{1} ? 1 : 0;
    }
    QVERIFY(through >= 1);
}

/// One stop has the glass, the next one what lies behind it.
void MapTrustTest::aWallOfGlassIsSeenThrough()
{
    FloorPlan glass = roomPlan(5.0, 2.0);
    glass.addWall({1.0, -2.0}, {1.0, 2.0}, 0.0, 2.8);
    const FloorPlan clear = roomPlan(5.0, 2.0);
    Random random(35);
    SimulatedStop first = seeFrom(glass, standing(-2.0, 0.0, 0.0), {}, random);
    SimulatedStop second = seeFrom(clear, standing(-1.0, 0.3, 0.0), {}, random);
    tellMotion(second.stop, first.truth.inverse() * second.truth);
    MapBuilder builder = builderOfFlatWalls();
    QVERIFY(builder.join(first.stop));

    QVERIFY(builder.join(second.stop));

    QVERIFY(isRight(builder.map().stops[1], second, first));
    for (std::size_t i = 0; i < first.planes.size(); ++i) {
        const MapPlane& plane = builder.map().planes[*builder.map().stops[0].matches[i].plane];
        QCOMPARE(!plane.seenThrough.empty(), first.planes[i] == 6);
    }
}

void MapTrustTest::aBareCorridorSaysThatOdometryAloneKnowsTheWay()
{
    FloorPlan plan = roomPlan(60.0, 1.2);
    Random random(36);
    SimulatedStop first = seeFrom(plan, standing(-2.0, 0.0, 0.0), {}, random);
    SimulatedStop second = seeFrom(plan, standing(2.0, 0.2, 0.1), {}, random);
    Vector6d error = Vector6d::Zero();
    error[3] = 0.05;
    const Pose motion = withError(first.truth.inverse() * second.truth, error);
    tellMotion(second.stop, motion);
    MapBuilder builder = builderOfFlatWalls();
    QVERIFY(builder.join(first.stop));

    QVERIFY(builder.join(second.stop));

    const MapStop& stop = builder.map().stops[1];
    QVERIFY(!stop.strength.shift.weakestSigma || *stop.strength.shift.weakestSigma > 0.5);
    QVERIFY(std::abs(stop.strength.shift.weakest.x()) > 0.999);
    QVERIFY(std::abs(stop.pose.translation.x() - motion.translation.x()) < 0.01);
    const double told = std::sqrt(stop.covariance(3, 3));
    QVERIFY(told > 0.9 * 0.08 && told < 1.1 * 0.081);  // 2 % of 4 m
    QVERIFY(std::sqrt(stop.covariance(4, 4)) < 0.005);
}

void MapTrustTest::withoutOdometryAStopIsPlacedWhereItIsTheOnlyPlace()
{
    const FloorPlan plan = ringFloor(41);
    auto stops = seeFloor(plan, ringRoute(20, 41), {}, 41);
    stops.resize(4);
    stops[2].stop.odometry.reset();
    MapBuilder builder = builderOfFlatWalls();
    for (const SimulatedStop& stop : stops)
        QVERIFY(builder.join(stop.stop));

    QCOMPARE(builder.map().stops[2].trust, StopTrust::Planes);
    QVERIFY(isRight(builder.map().stops[2], stops[2], stops[0]));
    QVERIFY(isRight(builder.map().stops[3], stops[3], stops[0]));
}

void MapTrustTest::withoutOdometryASquareRoomPlacesNothing()
{
    const FloorPlan plan = roomPlan(2.5, 2.5);
    Random random(42);
    MapBuilder builder = builderOfFlatWalls();
    QVERIFY(builder.join(seeFrom(plan, standing(0.0, 0.0, 0.0), {}, random).stop));

    const auto joined = builder.join(seeFrom(plan, standing(0.6, -0.3, 0.4), {}, random).stop);

    QVERIFY(joined);
    QCOMPARE(joined->trust, StopTrust::Unplaced);
    QCOMPARE(builder.map().stops[1].alternatives.size(), std::size_t(4));
    QCOMPARE(joined->matched + joined->fresh, 0);
}

/// A stop that saw nothing of use cannot be placed by itself; the one after it is two ways away from the last that was.
void MapTrustTest::afterAStopThatIsNotPlacedOdometryGoesOn()
{
    const FloorPlan plan = ringFloor(43);
    auto stops = seeFloor(plan, ringRoute(20, 43), {}, 43);
    stops.resize(4);
    stops[2].stop.planes.clear();
    stops[2].planes.clear();
    MapBuilder builder = builderOfFlatWalls();
    for (const SimulatedStop& stop : stops)
        QVERIFY(builder.join(stop.stop));

    QCOMPARE(builder.map().stops[2].trust, StopTrust::OdometryAlone);
    const MapStop& next = builder.map().stops[3];
    QVERIFY(next.trust == StopTrust::Planes || next.trust == StopTrust::OdometryDecides);
    const Vector6d error = errorBetween(stops[0].truth.inverse() * stops[3].truth, next.pose);
    QVERIFY(error.tail<3>().norm() < 0.1);
    QVERIFY(error.dot(next.covariance.llt().solve(error)) < chiSquareLimit(6));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MapTrustTest)
#include "map_trust_test.moc"
