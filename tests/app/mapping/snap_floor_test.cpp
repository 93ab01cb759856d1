// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/snap_floor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <QTest>

#include "core/pipeline/plane_extractor.h"
#include "core/simulation/building.h"
#include "core/simulation/nodding_scanner.h"
#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

using Vector = Eigen::Vector3d;

/// Four walls of 2 × 2 m of a room of 6 × 8 m about the origin (right, ahead, left, behind), and its floor, moved.
std::vector<FacedPlane> room(const Pose& moved = {})
{
    const std::array<Vector, 5> middles{Vector{3.0, 0.0, 0.0}, Vector{0.0, 4.0, 0.0}, Vector{-3.0, 0.0, 0.0},
                                        Vector{0.0, -4.0, 0.0}, Vector{0.0, 0.0, -1.5}};
    std::vector<FacedPlane> planes;
    for (const Vector& middle : middles) {
        const Vector normal = middle.normalized();
        const Vector along = std::abs(normal.x()) > 0.5 ? Vector::UnitY() : Vector::UnitX();
        const Vector across = normal.cross(along);
        FacedPlane& plane = planes.emplace_back();
        plane.normal = moved.rotation * normal;
        plane.distance = plane.normal.dot(moved * middle);
        plane.parts = {{{moved * (middle - along - across), moved * (middle + along - across),
                         moved * (middle + along + across), moved * (middle - along + across)},
                        {}}};
    }
    return planes;
}

Pose turned(double degreesLeft, const Vector& shift)
{
    return {Eigen::Quaterniond(Eigen::AngleAxisd(degrees(degreesLeft), Vector::UnitZ())), shift};
}

/// What a scanner finds there, in the frame of the floor.
std::vector<FacedPlane> planesSeenFrom(const Pose& pose, const Scene& scene)
{
    AcquisitionSettings settings;
    settings.tiltStep = degrees(0.4);
    settings.slices = 401;
    const SimulatedScan scan = simulate(scene, settings, {}, 11);
    PlaneExtractor extractor(sensorOf(scan.recording.description), {});
    for (const ScanSlice& slice : scan.recording.slices)
        extractor.advance(slice);
    const auto found = extractor.finish();
    std::vector<FacedPlane> planes;
    for (const auto& plane : found->planes)
        planes.push_back(moved({plane->normal, plane->distance, outlineOf(*plane, found->segments).parts}, pose));
    return planes;
}

}  // namespace

class SnapFloorTest : public QObject {
    Q_OBJECT

private slots:
    void aFloorSnapsOverTheSameWalls();
    void farFromTheOriginItTurnsWhereItIs();
    void withoutStairsHeightAndTiltStay();
    void stairsInFrontOfItTellItsHeight();
    void alongParallelWallsItStays();
    void wallsThatFaceTheOtherWayAreNoPartners();
    void wallsThatAreNotBesideEachOtherAreNoPartners();
    void aFloorTooFarAwayIsRefused();
};

void SnapFloorTest::aFloorSnapsOverTheSameWalls()
{
    const Pose off = turned(20.0, {0.8, -0.6, 3.0});

    const auto snap = snapFloor(room(off), room());

    QVERIFY(snap);
    const Pose there = snap->motion * off;
    QVERIFY(rotationVector(there.rotation).norm() < 1e-6);
    QVERIFY((there.translation - Vector(0.0, 0.0, 3.0)).norm() < 1e-6);
    QCOMPARE(snap->walls, 4);
    QVERIFY(snap->rms < 1e-6);
    QVERIFY(snap->isFixed);
}

void SnapFloorTest::farFromTheOriginItTurnsWhereItIs()
{
    const Pose place = turned(25.0, {400.0, -300.0, 0.0});
    const Pose off = place * turned(-2.0, {0.15, 0.1, 0.0});

    const auto snap = snapFloor(room(off), room(place));

    QVERIFY(snap);
    const Pose left = place.inverse() * snap->motion * off;
    QVERIFY(rotationVector(left.rotation).norm() < 1e-6);
    QVERIFY(left.translation.norm() < 1e-5);
    QVERIFY(snap->isFixed);
}

void SnapFloorTest::withoutStairsHeightAndTiltStay()
{
    const auto snap = snapFloor(room(turned(1.0, {0.1, 0.0, 7.0})), room());
    QVERIFY(snap);
    QVERIFY(!snap->height);
    QCOMPARE(snap->motion.translation.z(), 0.0);
    QVERIFY(std::abs(rotationVector(snap->motion.rotation).z() + degrees(1.0)) < 1e-6);
    QCOMPARE(rotationVector(snap->motion.rotation).head<2>().norm(), 0.0);
}

/// From the lower floor a scanner sees the flight from its foot, from the upper one the upper half of it.
void SnapFloorTest::stairsInFrontOfItTellItsHeight()
{
    const SimulatedBuilding building(2, 3);
    std::vector<std::vector<FacedPlane>> floors;
    for (const BuildingStop& stop : building.route(2))
        floors.push_back(planesSeenFrom(stop.pose, building.sceneAt(stop.floor, stop.pose)));
    const Pose storey{Eigen::Quaterniond::Identity(), {0.0, 0.0, SimulatedBuilding::kStoreyHeight}};
    const Pose off = turned(3.0, {0.4, -0.3, -0.9}) * storey;
    std::ranges::transform(floors[1], floors[1].begin(), [&](const FacedPlane& plane) { return moved(plane, off); });

    const auto snap = snapFloor(floors[1], floors[0]);

    QVERIFY(snap && snap->height);
    QVERIFY(snap->height->surfaces >= 3);
    const Pose left = snap->motion * off * storey.inverse();
    // Slices are 0.4° apart: 4 cm on a riser that is 6 m away.
    QVERIFY2(std::abs(left.translation.z()) < 0.03, qPrintable(QString::number(left.translation.z())));
}

void SnapFloorTest::alongParallelWallsItStays()
{
    std::vector<FacedPlane> sides = room();
    sides.resize(3);
    sides.erase(sides.begin() + 1);  // right and left are there, ahead and behind not

    const auto snap = snapFloor(room(turned(0.0, {0.3, 0.2, 0.0})), sides);

    QVERIFY(snap);
    QCOMPARE(snap->walls, 2);
    QVERIFY(!snap->isFixed);
    QVERIFY(std::abs(snap->motion.translation.x() + 0.3) < 1e-6);
    QVERIFY(std::abs(snap->motion.translation.y()) < 1e-6);
}

void SnapFloorTest::wallsThatFaceTheOtherWayAreNoPartners()
{
    // The other sides of the same walls.
    std::vector<FacedPlane> others = room();
    for (FacedPlane& plane : others) {
        plane.normal = -plane.normal;
        plane.distance = -plane.distance;
    }
    QVERIFY(!snapFloor(room(), others));
}

void SnapFloorTest::wallsThatAreNotBesideEachOtherAreNoPartners()
{
    // The walls are 2 m wide: 1.6 m along themselves the right and left ones overlap by 0.4 m only.
    std::vector<FacedPlane> sides = room(turned(0.0, {0.0, 1.6, 0.0}));
    sides.resize(3);
    sides.erase(sides.begin() + 1);
    QVERIFY(!snapFloor(sides, room()));
    sides = room(turned(0.0, {0.0, 1.4, 0.0}));
    sides.resize(3);
    sides.erase(sides.begin() + 1);
    QVERIFY(snapFloor(sides, room()));
}

void SnapFloorTest::aFloorTooFarAwayIsRefused()
{
    const auto snap = snapFloor(room(turned(0.0, {3.2, 3.2, 0.0})), room());
    QVERIFY(!snap);
    QCOMPARE(snap.error().code, ErrorCode::Usage);
    QVERIFY(!snapFloor({}, room()));
    QVERIFY(!snapFloor(room(), {}));
}

PLANEWRIGHT_TEST(SnapFloorTest)
#include "snap_floor_test.moc"
