// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/building.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <QtTest>

#include "core/simulation/ray_caster.h"
#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

class BuildingTest : public QObject {
    Q_OBJECT

private slots:
    void aRouteGoesOnceRoundEachFloor();
    void odometryHasTheErrorsThatAreTold();
    void theStairwellIsTheSameOnAllFloors();
    void theFlightUpToAFloorIsSeenFromIt();
    void flightsStandNextToEachOtherByTurns();
    void theFirstStopOfAFloorLooksAtTheStairs();
    void theFloorIsAsFarBelowAsTheScannerIsHigh();
    void aStopSeesNoOtherSideOfTheWall();
    void theSeedMakesTheBuilding();
};

namespace {

std::optional<TruePlane> planeOf(const Scene& scene, const std::string& name)
{
    const auto found = std::ranges::find(scene.planes, name, &TruePlane::name);
    return found == scene.planes.end() ? std::nullopt : std::optional(*found);
}

/// How far it is straight down to the first surface.
double rangeDown(const Scene& scene)
{
    const RayCaster rays(scene, allSurfaces(scene), 0.0, 0.0);
    const auto hit = rays.cast(Eigen::Vector3d::UnitY());  // at bearing 90° and tilt 0°
    return hit ? hit->range : std::numeric_limits<double>::infinity();
}

}  // namespace

void BuildingTest::aRouteGoesOnceRoundEachFloor()
{
    const SimulatedBuilding building(4, 7);

    const auto route = building.route(70);

    QCOMPARE(route.size(), std::size_t(70));
    for (int floor = 0; floor < 4; ++floor) {
        std::vector<Pose> poses;
        for (const BuildingStop& stop : route) {
            if (stop.floor == floor)
                poses.push_back(stop.pose);
        }
        QVERIFY(poses.size() == 17 || poses.size() == 18);
        double way = 0.0;
        for (std::size_t i = 0; i < poses.size(); ++i) {
            const double leg = (poses[(i + 1) % poses.size()].translation - poses[i].translation).norm();
            QVERIFY(leg < 60.0 / 17.0 + 1.0);  // the last leg closes the loop
            way += leg;
        }
        // Corners are cut, and stops lie up to 0.3 m beside the middle.
        QVERIFY(way > 50.0 && way < 65.0);
    }
    QVERIFY(std::ranges::is_sorted(route, {}, &BuildingStop::floor));
}

/// 2 % of the way along either axis and 1° on 10 m, growing with the root of the way.
void BuildingTest::odometryHasTheErrorsThatAreTold()
{
    double shift = 0.0;
    double turn = 0.0;
    int motions = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const auto route = SimulatedBuilding(1, seed).route(20);
        QVERIFY(route.front().odometry.translation.isZero(0.0));
        for (std::size_t i = 1; i < route.size(); ++i) {
            const Pose truth = route[i - 1].pose.inverse() * route[i].pose;
            const Pose told = route[i - 1].odometry.inverse() * route[i].odometry;
            QCOMPARE(told.translation.z(), 0.0);
            const double way = truth.translation.norm();
            const Eigen::Vector2d off = (told.translation - truth.translation).head<2>();
            shift += off.squaredNorm() / (2.0 * std::pow(0.002 + 0.02 * way, 2));
            const double turned = (rotationVector(told.rotation) - rotationVector(truth.rotation)).z();
            turn += std::pow(turned / degrees(1.0), 2) / (way / 10.0);
            ++motions;
        }
    }
    // 760 motions: the mean of 2 · 760 squares is within 11 %, that of 760 within 15 %, at three standard deviations;
    // the scanner's tilt moves what wheels see by a hundredth of it.
    QVERIFY(std::abs(shift / motions - 1.0) < 0.13);
    QVERIFY(std::abs(turn / motions - 1.0) < 0.17);
}

void BuildingTest::theStairwellIsTheSameOnAllFloors()
{
    const SimulatedBuilding building(3, 2);
    const Pose pose{Eigen::Quaterniond::Identity(), {3.0, 0.0, 1.1}};
    const Scene lowest = building.sceneAt(0, pose);
    for (int floor = 1; floor < 3; ++floor) {
        const Scene scene = building.sceneAt(floor, pose);
        for (const char* name : {"stairwell left wall", "stairwell right wall", "stairwell end wall"}) {
            QVERIFY(planeOf(scene, name)->normal == planeOf(lowest, name)->normal);
            QCOMPARE(planeOf(scene, name)->distance, planeOf(lowest, name)->distance);
        }
    }
    // The bay is 3 m wide: from x = 8.4 to x = 11.4.
    QVERIFY(std::abs(planeOf(lowest, "stairwell left wall")->distance - 5.4) < 1e-12);
    QVERIFY(std::abs(planeOf(lowest, "stairwell right wall")->distance - 8.4) < 1e-12);
    // A flight leads to each floor above: none from the highest.
    QVERIFY(planeOf(building.sceneAt(1, pose), "step 16 tread"));
    QVERIFY(!planeOf(building.sceneAt(2, pose), "step 1 riser"));
}

void BuildingTest::theFlightUpToAFloorIsSeenFromIt()
{
    const SimulatedBuilding building(2, 2);
    // Above the middle of the flight, 0.5 m over the upper floor; and as far over its edge.
    const Eigen::Vector3d place(10.9, 3.6, 0.5);
    const Scene upper = building.sceneAt(1, {Eigen::Quaterniond::Identity(), place});
    const Scene lower = building.sceneAt(0, {Eigen::Quaterniond::Identity(), place + Eigen::Vector3d(0.0, 0.0, 3.2)});
    const Scene beside = building.sceneAt(1, {Eigen::Quaterniond::Identity(), {9.9, 3.6, 0.5}});

    // Tread 8 is 1.6 m above the lower floor.
    for (const Scene* scene : {&upper, &lower})
        QVERIFY(std::abs(rangeDown(*scene) - 2.1) < 1e-9);
    QVERIFY(std::abs(rangeDown(beside) - 0.5) < 1e-9);
    const std::optional<TruePlane> above = planeOf(upper, "step down 11 riser");
    const std::optional<TruePlane> below = planeOf(lower, "step 11 riser");
    QVERIFY(above && below);
    QVERIFY((above->normal - below->normal).norm() < 1e-12);
    QVERIFY(std::abs(above->distance - below->distance) < 1e-12);
}

void BuildingTest::flightsStandNextToEachOtherByTurns()
{
    const SimulatedBuilding building(3, 2);
    // Over the tenth tread, which is 2 m high.
    const auto heightBelow = [&](int floor, double x) {
        const Scene scene = building.sceneAt(floor, {Eigen::Quaterniond::Identity(), {x, 1.5 + 9.5 * 0.28, 2.5}});
        return 2.5 - rangeDown(scene);
    };
    QVERIFY(std::abs(heightBelow(0, 10.9) - 2.0) < 1e-9);
    QVERIFY(std::abs(heightBelow(0, 9.9)) < 1e-9);
    QVERIFY(std::abs(heightBelow(1, 9.9) - 2.0) < 1e-9);
    QVERIFY(std::abs(heightBelow(1, 10.9) + 1.2) < 1e-9);
    QVERIFY(std::abs(heightBelow(2, 9.9) + 1.2) < 1e-9);
    QVERIFY(std::abs(heightBelow(2, 10.9)) < 1e-9);
}

void BuildingTest::theFirstStopOfAFloorLooksAtTheStairs()
{
    for (const BuildingStop& stop : SimulatedBuilding(3, 2).route(3)) {
        // Half a metre about (10.4, 0), and 0.2 rad about +y, which is the scanner's own.
        QVERIFY((stop.pose.translation - Eigen::Vector3d(10.4, 0.0, 1.1)).norm() < 0.5);
        QVERIFY((stop.pose.rotation * Eigen::Vector3d::UnitY()).y() > std::cos(0.21));
    }
}

void BuildingTest::theFloorIsAsFarBelowAsTheScannerIsHigh()
{
    const SimulatedBuilding building(1, 5);
    const Pose level{rotationAbout({0.0, 0.0, 0.4}), {10.0, 0.0, 1.25}};

    const std::optional<TruePlane> floor = planeOf(building.sceneAt(0, level), "floor");

    QVERIFY((floor->normal - Eigen::Vector3d(0.0, 0.0, -1.0)).norm() < 1e-12);
    QVERIFY(std::abs(floor->distance - 1.25) < 1e-12);
    // Turned a quarter of the way to the left, the scanner has the outer wall of its corridor on its right.
    const Pose quarter{rotationAbout({0.0, 0.0, degrees(90.0)}), {10.0, 0.0, 1.25}};
    const std::optional<TruePlane> wall = planeOf(building.sceneAt(0, quarter), "front wall");
    QVERIFY((wall->normal - Eigen::Vector3d(-1.0, 0.0, 0.0)).norm() < 1e-12);
    QVERIFY(std::abs(wall->distance - 1.2) < 1e-12);
}

/// The wall between corridor and rooms has two faces, 15 cm apart.
void BuildingTest::aStopSeesNoOtherSideOfTheWall()
{
    const SimulatedBuilding building(1, 5);
    const Scene scene = building.sceneAt(0, {Eigen::Quaterniond::Identity(), {10.0, 0.0, 1.25}});

    const std::optional<TruePlane> face = planeOf(scene, "front wall");
    const std::optional<TruePlane> back = planeOf(scene, "front wall back");

    QVERIFY(std::abs(back->distance - face->distance - 0.15) < 1e-12);
    QVERIFY((back->normal - face->normal).norm() < 1e-12);
}

void BuildingTest::theSeedMakesTheBuilding()
{
    const Pose pose{Eigen::Quaterniond::Identity(), {10.0, 0.0, 1.25}};
    const auto distances = [&](std::uint64_t seed) {
        std::vector<double> all;
        for (const TruePlane& plane : SimulatedBuilding(1, seed).sceneAt(0, pose).planes)
            all.push_back(plane.distance);
        return all;
    };

    QVERIFY(distances(3) == distances(3));
    QVERIFY(distances(3) != distances(4));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::BuildingTest)
#include "building_test.moc"
