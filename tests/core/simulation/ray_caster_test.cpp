// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/ray_caster.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Dense>
#include <QtTest/QtTest>

#include "core/simulation/random.h"
#include "core/simulation/scene_builder.h"
#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

constexpr double kOffset = 0.05;

Eigen::Vector3d beam(double bearing)
{
    return {std::cos(bearing), std::sin(bearing), 0.0};
}

/// The range a ray measures, 0 without hit.
double rangeOf(const RayCaster& caster, const Eigen::Vector3d& direction)
{
    const auto hit = caster.cast(direction);
    return hit ? hit->range : 0.0;
}

/// Brute force in the sensor's frame: solves corner + a u + b v = origin + t direction for every rectangle, and a
/// textbook quadratic for every cylinder.
double bruteForceRange(const Scene& scene, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const RectangleSurface& r : scene.rectangles) {
        Eigen::Matrix3d m;
        m << r.edgeU, r.edgeV, -direction;
        const Eigen::Vector3d abt = m.fullPivLu().solve(origin - r.corner);
        const bool solved = (m * abt - (origin - r.corner)).norm() < 1e-9;
        if (solved && abt.x() >= 0.0 && abt.x() <= 1.0 && abt.y() >= 0.0 && abt.y() <= 1.0 && abt.z() > 0.0)
            nearest = std::min(nearest, abt.z());
    }
    for (const CylinderSurface& c : scene.cylinders) {
        const Eigen::Vector3d axis = c.axis.normalized();
        const auto across = [&axis](const Eigen::Vector3d& v) -> Eigen::Vector3d { return v - axis * axis.dot(v); };
        const Eigen::Vector3d d = across(direction);
        const Eigen::Vector3d o = across(origin - c.base);
        const double a = d.dot(d);
        const double b = 2.0 * d.dot(o);
        const double root = std::sqrt(b * b - 4.0 * a * (o.dot(o) - c.radius.squaredNorm()));
        for (const double t : {(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)}) {
            const Eigen::Vector3d p = origin + t * direction - c.base;
            double angle = std::atan2(axis.cross(c.radius).dot(p), c.radius.dot(p));
            if (angle < 0.0)
                angle += 2.0 * std::numbers::pi;
            if (t > 0.0 && p.dot(axis) >= 0.0 && p.dot(axis) <= c.axis.norm() && angle <= c.sweep)
                nearest = std::min(nearest, t);
        }
    }
    return std::isinf(nearest) ? 0.0 : nearest;
}

}  // namespace

class RayCasterTest : public QObject {
    Q_OBJECT

private slots:
    void aFrontalWallIsFartherAtASlant();
    void theLaserSitsOffThePitchAxis();
    void raysEndAtTheEdgeOfASurface();
    void theNearestSurfaceHidesWhatIsBehind();
    void aPoleIsHitOnItsNearSide();
    void aSectorIsHitOnlyWithinItsSweepAndHeight();
    void aBeamBetweenNeighbouringPiecesHitsOneOfThem();
    void rangesEqualThoseOfBruteForce_data();
    void rangesEqualThoseOfBruteForce();
    void cullingLosesNoHit_data();
    void cullingLosesNoHit();
};

void RayCasterTest::aFrontalWallIsFartherAtASlant()
{
    SceneBuilder room("test");
    room.wall("wall", {{10.0, 4.0}, {-10.0, 4.0}, -5.0, 5.0});
    const Scene scene = room.build({});

    const RayCaster caster(scene, allSurfaces(scene), degrees(90.0), kOffset);

    QVERIFY(std::abs(rangeOf(caster, beam(degrees(90.0))) - 4.0) < 1e-12);
    QVERIFY(std::abs(rangeOf(caster, beam(degrees(30.0))) - 8.0) < 1e-12);
    QVERIFY(std::abs(rangeOf(caster, beam(degrees(135.0))) - 4.0 * std::sqrt(2.0)) < 1e-12);
}

void RayCasterTest::theLaserSitsOffThePitchAxis()
{
    SceneBuilder room("test");
    room.level("floor", -1.0, {-50.0, -50.0}, {50.0, 50.0});
    room.level("ceiling", 1.5, {-50.0, -50.0}, {50.0, 50.0});
    const Scene scene = room.build({});

    // Eq. (6): z = −ρ sin θ cos φ + d_l sin φ.
    for (const double tilt : {30.0, 60.0, 120.0, 150.0}) {
        const RayCaster caster(scene, allSurfaces(scene), degrees(tilt), kOffset);
        const double height = tilt < 90.0 ? -1.0 : 1.5;
        const double ahead = (kOffset * std::sin(degrees(tilt)) - height) / std::cos(degrees(tilt));
        QVERIFY(std::abs(rangeOf(caster, beam(degrees(90.0))) - ahead) < 1e-12);
        QVERIFY(std::abs(rangeOf(caster, beam(degrees(150.0))) - 2.0 * ahead) < 1e-11);
    }
}

void RayCasterTest::raysEndAtTheEdgeOfASurface()
{
    SceneBuilder room("test");
    room.wall("panel", {{1.0, 1.0}, {-1.0, 1.0}, -1.0, 1.0});
    const Scene scene = room.build({});

    const RayCaster caster(scene, allSurfaces(scene), degrees(90.0), kOffset);

    QVERIFY(caster.cast(beam(degrees(45.1))));
    QVERIFY(!caster.cast(beam(degrees(44.9))));
    QVERIFY(caster.cast(beam(degrees(134.9))));
    QVERIFY(!caster.cast(beam(degrees(135.1))));
    QVERIFY(!caster.cast(beam(degrees(-90.0))));
}

void RayCasterTest::theNearestSurfaceHidesWhatIsBehind()
{
    SceneBuilder room("test");
    const int wall = room.wall("wall", {{2.0, 3.0}, {-2.0, 3.0}, -1.0, 1.0});
    const int panel = room.wall("panel", {{2.0, 2.0}, {0.0, 2.0}, -1.0, 1.0});
    const Scene scene = room.build({});

    const RayCaster caster(scene, allSurfaces(scene), degrees(90.0), kOffset);

    QCOMPARE(caster.cast(beam(degrees(80.0)))->label, panel);
    QCOMPARE(caster.cast(beam(degrees(100.0)))->label, wall);
}

void RayCasterTest::aPoleIsHitOnItsNearSide()
{
    SceneBuilder room("test");
    room.pole({0.0, 3.0, -1.0}, {0.0, 0.0, 2.0}, 0.5);
    const Scene scene = room.build({});

    const RayCaster caster(scene, allSurfaces(scene), degrees(90.0), kOffset);

    const auto hit = caster.cast(beam(degrees(90.0)));
    QVERIFY(hit);
    QVERIFY(std::abs(hit->range - 2.5) < 1e-12);
    QCOMPARE(hit->label, kNotPlanar);
    // The tangents from the origin leave at asin(0.5/3) = 9.59° from the axis.
    QVERIFY(caster.cast(beam(degrees(90.0 + 9.5))));
    QVERIFY(!caster.cast(beam(degrees(90.0 + 9.7))));
}

void RayCasterTest::aSectorIsHitOnlyWithinItsSweepAndHeight()
{
    SceneBuilder room("test");
    // A quarter of a drum about the sensor, from straight ahead to the left, open above 0.5 m.
    room.cylinder({0.0, 0.0, -0.5}, {0.0, 0.0, 1.0}, {0.0, 2.0, 0.0}, degrees(90.0));
    const Scene scene = room.build({});

    const RayCaster level(scene, allSurfaces(scene), degrees(90.0), 0.0);
    const RayCaster upwards(scene, allSurfaces(scene), degrees(90.0 + 20.0), 0.0);

    QVERIFY(std::abs(rangeOf(level, beam(degrees(91.0))) - 2.0) < 1e-12);
    QVERIFY(std::abs(rangeOf(level, beam(degrees(179.0))) - 2.0) < 1e-12);
    QCOMPARE(rangeOf(level, beam(degrees(89.0))), 0.0);
    QCOMPARE(rangeOf(level, beam(degrees(181.0))), 0.0);
    QCOMPARE(rangeOf(upwards, beam(degrees(91.0))), 0.0);
}

void RayCasterTest::aBeamBetweenNeighbouringPiecesHitsOneOfThem()
{
    SceneBuilder room("test");
    const double third = 1.0 / 3.0;
    room.wall("wall", {{1.0, 0.7}, {-1.0, 0.9}, -1.0, 1.0}, {{third, 2.0 * third, 0.3, 0.6}});
    const Scene scene = room.build({});

    const Eigen::Vector2d seam = Eigen::Vector2d(1.0, 0.7) + third * Eigen::Vector2d(-2.0, 0.2).normalized();
    const RayCaster caster(scene, allSurfaces(scene), degrees(90.0), 0.0);

    for (int i = -20; i <= 20; ++i)
        QVERIFY(caster.cast(beam(std::atan2(seam.y(), seam.x()) + i * 1e-16)));
}

void RayCasterTest::rangesEqualThoseOfBruteForce_data()
{
    QTest::addColumn<QString>("name");
    for (const std::string_view name : sceneNames())
        QTest::newRow(std::string(name).c_str()) << QString::fromStdString(std::string(name));
}

void RayCasterTest::rangesEqualThoseOfBruteForce()
{
    QFETCH(QString, name);
    const Scene scene = makeScene(name.toStdString(), 3).value();
    Random random(11);

    for (int i = 0; i < 60; ++i) {
        const double tilt = random.uniform(0.0, degrees(180.0));
        const RayCaster caster(scene, allSurfaces(scene), tilt, kOffset);
        const Eigen::Vector3d ahead(0.0, std::sin(tilt), -std::cos(tilt));
        const Eigen::Vector3d origin = kOffset * Eigen::Vector3d(0.0, std::cos(tilt), std::sin(tilt));
        for (int j = 0; j < 60; ++j) {
            const double bearing = random.uniform(degrees(-45.0), degrees(225.0));
            const Eigen::Vector3d direction = std::cos(bearing) * Eigen::Vector3d::UnitX() + std::sin(bearing) * ahead;
            const double expected = bruteForceRange(scene, origin, direction);
            QVERIFY(std::abs(rangeOf(caster, beam(bearing)) - expected) < 1e-9);
        }
    }
}

void RayCasterTest::cullingLosesNoHit_data()
{
    rangesEqualThoseOfBruteForce_data();
}

void RayCasterTest::cullingLosesNoHit()
{
    QFETCH(QString, name);
    const Scene scene = makeScene(name.toStdString(), 4).value();
    Random random(12);

    for (int i = 0; i < 100; ++i) {
        const double tilt = random.uniform(0.0, degrees(180.0));
        const double spread = i % 2 == 0 ? 1.1e-3 : degrees(1.0);
        const SurfaceSelection near = surfacesNear(scene, tilt, kOffset, spread);
        // Both turned within the spread and tipped out of the slice plane within it.
        const double turned = tilt + random.uniform(-0.5, 0.5) * spread;
        const RayCaster culled(scene, near, turned, kOffset);
        const RayCaster all(scene, allSurfaces(scene), turned, kOffset);
        for (int j = 0; j < 200; ++j) {
            const double bearing = random.uniform(degrees(-45.0), degrees(225.0));
            const double off = random.uniform(-0.5, 0.5) * spread;
            Eigen::Vector3d direction = std::cos(off) * beam(bearing);
            direction.z() = std::sin(off);
            QCOMPARE(rangeOf(culled, direction), rangeOf(all, direction));
        }
        QVERIFY(near.rectangles.size() <= scene.rectangles.size());
    }
}

PLANEWRIGHT_TEST(RayCasterTest)
#include "ray_caster_test.moc"
