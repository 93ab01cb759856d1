// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/scene_builder.h"

#include <cmath>
#include <numbers>

#include <QtTest/QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

double areaOf(const Scene& scene, int plane)
{
    double area = 0.0;
    for (const RectangleSurface& r : scene.rectangles)
        if (r.plane == plane)
            area += r.edgeU.norm() * r.edgeV.norm();
    return area;
}

bool holds(const TruePlane& plane, const Eigen::Vector3d& normal, double distance)
{
    return (plane.normal - normal).norm() < 1e-12 && std::abs(plane.distance - distance) < 1e-12;
}

}  // namespace

class SceneBuilderTest : public QObject {
    Q_OBJECT

private slots:
    void aWallIsOnePlaneAboutItsOpenings();
    void aRecessLiesBehindItsWall();
    void aBoxHasTheFacesAskedFor();
    void aTurnedBoxTurnsAboutItsCentre();
    void theSensorIsTheOriginAndLooksAlongY();
    void everyRectangleLiesInItsPlane();
    void onlyTheGlassLosesReturns();
};

void SceneBuilderTest::aWallIsOnePlaneAboutItsOpenings()
{
    SceneBuilder room("test");
    const WallPlan plan{{0.0, 3.0}, {4.0, 3.0}, 0.0, 2.5};

    // Not in order along the wall, one a door and one a window.
    const int wall = room.wall("wall", plan, {{2.5, 3.5, 1.0, 2.0}, {0.0, 0.9, 0.0, 2.0}});
    const Scene scene = room.build({});

    QCOMPARE(scene.planes.size(), std::size_t(1));
    QVERIFY(std::abs(areaOf(scene, wall) - (4.0 * 2.5 - 0.9 * 2.0 - 1.0 * 1.0)) < 1e-12);
    QVERIFY(holds(scene.planes[0], {0.0, 1.0, 0.0}, 3.0));
}

void SceneBuilderTest::aRecessLiesBehindItsWall()
{
    SceneBuilder room("test");
    // The room is on the left of a walk towards +y along x = 2: the recess goes to larger x.
    const WallPlan plan{{2.0, 0.0}, {2.0, 5.0}, 0.0, 2.5};

    room.recess("window", plan, {1.0, 2.5, 0.9, 2.1}, 0.2);
    const Scene scene = room.build({});

    QCOMPARE(scene.planes.size(), std::size_t(5));
    QVERIFY(holds(scene.planes[0], {1.0, 0.0, 0.0}, 2.2));
    QVERIFY(holds(scene.planes[1], {0.0, 1.0, 0.0}, 1.0));
    QVERIFY(holds(scene.planes[2], {0.0, 1.0, 0.0}, 2.5));
    QVERIFY(holds(scene.planes[3], {0.0, 0.0, 1.0}, 2.1));
    QVERIFY(holds(scene.planes[4], {0.0, 0.0, 1.0}, 0.9));
    QVERIFY(std::abs(areaOf(scene, 0) - 1.5 * 1.2) < 1e-12);
    QCOMPARE(scene.planes[4].name, std::string("window sill"));
}

void SceneBuilderTest::aBoxHasTheFacesAskedFor()
{
    SceneBuilder room("test");
    room.box("a", {{1.0, 2.0}, {0.4, 0.6, 0.8}, 0.5}, kHungOnWall | kBack);
    const Scene scene = room.build({});

    QCOMPARE(scene.planes.size(), std::size_t(6));
    QVERIFY(holds(scene.planes[0], {1.0, 0.0, 0.0}, 0.8));
    QVERIFY(holds(scene.planes[1], {1.0, 0.0, 0.0}, 1.2));
    QVERIFY(holds(scene.planes[2], {0.0, 1.0, 0.0}, 1.7));
    QVERIFY(holds(scene.planes[3], {0.0, 1.0, 0.0}, 2.3));
    QVERIFY(holds(scene.planes[4], {0.0, 0.0, 1.0}, 1.3));
    QVERIFY(holds(scene.planes[5], {0.0, 0.0, 1.0}, 0.5));

    SceneBuilder other("test");
    other.box("b", {{1.0, 2.0}, {0.4, 0.6, 0.8}}, kAgainstWall);
    QCOMPARE(other.build({}).planes.size(), std::size_t(4));
}

void SceneBuilderTest::aTurnedBoxTurnsAboutItsCentre()
{
    SceneBuilder room("test");
    room.box("a", {{1.0, 2.0}, {0.4, 0.6, 0.8}, 0.0, degrees(90.0)}, kRight | kFront);
    const Scene scene = room.build({});

    // After a quarter turn to the left the right side looks along +y and the front along +x.
    QVERIFY(holds(scene.planes[0], {0.0, 1.0, 0.0}, 2.2));
    QVERIFY(holds(scene.planes[1], {1.0, 0.0, 0.0}, 1.3));
}

void SceneBuilderTest::theSensorIsTheOriginAndLooksAlongY()
{
    SceneBuilder room("test");
    room.wall("left", {{0.0, 4.0}, {0.0, 0.0}, 0.0, 2.0});
    room.level("floor", 0.0, {0.0, 0.0}, {3.0, 4.0});
    room.pole({0.0, 1.0, 0.0}, {0.0, 0.0, 2.0}, 0.1);

    const Scene scene = room.build({{2.0, 1.0, 0.9}, degrees(90.0)});

    // Turned to the left by a quarter, the sensor looks at the left wall, 2 m ahead.
    QVERIFY(holds(scene.planes[0], {0.0, 1.0, 0.0}, 2.0));
    QVERIFY(holds(scene.planes[1], {0.0, 0.0, -1.0}, 0.9));
    QVERIFY((scene.cylinders[0].base - Eigen::Vector3d(0.0, 2.0, -0.9)).norm() < 1e-12);
    QVERIFY((scene.cylinders[0].axis - Eigen::Vector3d(0.0, 0.0, 2.0)).norm() < 1e-12);
    QCOMPARE(scene.cylinders[0].sweep, 2.0 * std::numbers::pi);
}

void SceneBuilderTest::everyRectangleLiesInItsPlane()
{
    SceneBuilder room("test");
    room.box("a", {{1.0, 2.0}, {0.4, 0.6, 0.8}, 0.1, 0.3}, kStanding | kBottom);
    room.wall("wall", {{0.3, 3.0}, {4.0, 3.7}, 0.0, 2.5}, {{0.5, 1.4, 0.0, 2.0}});
    const Scene scene = room.build({{0.4, 0.5, 1.0}, -0.2});

    for (const RectangleSurface& r : scene.rectangles) {
        const TruePlane& plane = scene.planes[static_cast<std::size_t>(r.plane)];
        for (const Eigen::Vector3d& corner : {r.corner, Eigen::Vector3d(r.corner + r.edgeU + r.edgeV)})
            QVERIFY(std::abs(plane.normal.dot(corner) - plane.distance) < 1e-12);
        QVERIFY(std::abs(plane.normal.dot(r.edgeU)) < 1e-12);
        QVERIFY(plane.distance >= 0.0);
    }
}

void SceneBuilderTest::onlyTheGlassLosesReturns()
{
    SceneBuilder room("test");
    room.level("floor", 0.0, {0.0, 0.0}, {3.0, 4.0});
    room.makeGlass(room.wall("pane", {{0.0, 4.0}, {3.0, 4.0}, 0.0, 2.0}), 0.7);
    const Scene scene = room.build({});

    QCOMPARE(scene.rectangles[0].dropout, 0.0);
    QCOMPARE(scene.rectangles[1].dropout, 0.7);
}

PLANEWRIGHT_TEST(SceneBuilderTest)
#include "scene_builder_test.moc"
