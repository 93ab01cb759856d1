// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/triangulate.h"

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <QtTest>

#include "core/geometry/polygon_union.h"
#include "tests/core/geometry/seen_plane.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

using Ring = std::vector<Eigen::Vector3d>;

Outline outlineOfRings(const Ring& ring, const std::vector<Ring>& holes = {})
{
    Outline outline;
    outline.parts.push_back({ring, holes});
    return outline;
}

double areaOf(const Triangle& t, const Eigen::Vector3d& normal)
{
    return 0.5 * normal.dot((t[1] - t[0]).cross(t[2] - t[0]));
}

double areaOf(const std::vector<Triangle>& triangles, const Eigen::Vector3d& normal)
{
    double sum = 0.0;
    for (const Triangle& t : triangles)
        sum += areaOf(t, normal);
    return sum;
}

/// Even-odd rule over all rings, for a point in the plane z = 0.
bool isInside(const Outline& outline, const Eigen::Vector2d& p)
{
    bool inside = false;
    const auto walk = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Eigen::Vector3d& a = ring[i];
            const Eigen::Vector3d& b = ring[(i + 1) % ring.size()];
            if ((a.y() > p.y()) != (b.y() > p.y()) &&
                p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
                inside = !inside;
        }
    };
    for (const auto& part : outline.parts) {
        walk(part.ring);
        for (const Ring& hole : part.holes)
            walk(hole);
    }
    return inside;
}

int trianglesAround(const std::vector<Triangle>& triangles, const Eigen::Vector2d& p)
{
    int count = 0;
    for (const Triangle& t : triangles) {
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3d side = t[(i + 1) % 3] - t[i];
            inside = inside && side.x() * (p.y() - t[i].y()) - side.y() * (p.x() - t[i].x()) > 0.0;
        }
        count += inside ? 1 : 0;
    }
    return count;
}

/// A union of random squares on a grid: corners touch, edges run on, holes are frequent.
Outline randomBlocks(std::mt19937_64& random, double& area)
{
    constexpr int kSide = 8;
    std::vector<PlanarRing> squares;
    for (int x = 0; x < kSide; ++x) {
        for (int y = 0; y < kSide; ++y) {
            if (random() % 100 < 60)
                squares.push_back({{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
        }
    }
    area = static_cast<double>(squares.size());
    Outline outline;
    for (const PlanarPolygon& polygon : unionOf(squares)) {
        const auto lift = [](const PlanarRing& ring) {
            Ring lifted;
            for (const Eigen::Vector2d& p : ring)
                lifted.emplace_back(p.x(), p.y(), 0.0);
            return lifted;
        };
        Outline::Polygon part{lift(polygon.ring), {}};
        for (const PlanarRing& hole : polygon.holes)
            part.holes.push_back(lift(hole));
        outline.parts.push_back(part);
    }
    return outline;
}

}  // namespace

class TriangulateTest : public QObject {
    Q_OBJECT

private slots:
    void aRectangleIsTwoTriangles();
    void theTrianglesTurnLeftSeenFromTheNormal();
    void aHoleStaysOpen();
    void aHoleThatTouchesTheBorderStaysOpen();
    void verticesOnAStraightEdgeDoNoHarm();
    void nothingGivesNothing();
    void trianglesMeetEdgeToEdge();
    void randomBlocksAreCoveredOnceAndExactly();
    void aTiltedOutlineOfSegmentsIsCovered();
};

void TriangulateTest::aRectangleIsTwoTriangles()
{
    const Outline outline = outlineOfRings({{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}});

    const auto triangles = triangulate(outline, Eigen::Vector3d::UnitZ());

    QCOMPARE(triangles.size(), std::size_t(2));
    QVERIFY(std::abs(areaOf(triangles, Eigen::Vector3d::UnitZ()) - 6.0) < 1e-12);
}

void TriangulateTest::theTrianglesTurnLeftSeenFromTheNormal()
{
    const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
    const Outline outline = outlineOfRings({{0, 0, 1}, {0, 2, 1}, {1, 1, 1}, {3, 2, 1}, {3, 0, 1}});

    const auto triangles = triangulate(outline, down);

    QVERIFY(!triangles.empty());
    for (const Triangle& t : triangles) {
        QVERIFY(areaOf(t, down) > 0.0);
        for (const Eigen::Vector3d& corner : t)
            QVERIFY(std::abs(corner.z() - 1.0) < 1e-12);
    }
    // 3 × 2 less the notch (0, 2), (1, 1), (3, 2).
    QVERIFY(std::abs(areaOf(triangles, down) - 4.5) < 1e-12);
}

void TriangulateTest::aHoleStaysOpen()
{
    const Outline outline =
        outlineOfRings({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{{1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}}});

    const auto triangles = triangulate(outline, Eigen::Vector3d::UnitZ());

    QVERIFY(std::abs(areaOf(triangles, Eigen::Vector3d::UnitZ()) - 12.0) < 1e-12);
    QCOMPARE(trianglesAround(triangles, {2.1, 1.9}), 0);
    QCOMPARE(trianglesAround(triangles, {0.51, 2.03}), 1);
}

void TriangulateTest::aHoleThatTouchesTheBorderStaysOpen()
{
    // A diamond whose corners touch two sides and whose other corners are a second diamond's.
    const Outline outline = outlineOfRings(
        {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}},
        {{{0, 1, 0}, {1, 2, 0}, {2, 1, 0}, {1, 0, 0}}, {{2, 1, 0}, {3, 1.5, 0}, {4, 1, 0}, {3, 0.5, 0}}});

    const auto triangles = triangulate(outline, Eigen::Vector3d::UnitZ());

    QVERIFY(std::abs(areaOf(triangles, Eigen::Vector3d::UnitZ()) - (8.0 - 2.0 - 1.0)) < 1e-12);
}

void TriangulateTest::verticesOnAStraightEdgeDoNoHarm()
{
    const Outline outline =
        outlineOfRings({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}});

    const auto triangles = triangulate(outline, Eigen::Vector3d::UnitZ());

    QVERIFY(std::abs(areaOf(triangles, Eigen::Vector3d::UnitZ()) - 4.0) < 1e-12);
}

void TriangulateTest::nothingGivesNothing()
{
    QVERIFY(triangulate({}, Eigen::Vector3d::UnitZ()).empty());
    QVERIFY(triangulate(outlineOfRings({{0, 0, 0}, {1, 0, 0}}), Eigen::Vector3d::UnitZ()).empty());
    QVERIFY(triangulate(outlineOfRings({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), Eigen::Vector3d::UnitZ()).empty());
}

void TriangulateTest::trianglesMeetEdgeToEdge()
{
    std::mt19937_64 random(11);
    double area = 0.0;
    const auto triangles = triangulate(randomBlocks(random, area), Eigen::Vector3d::UnitZ());

    // No corner of a triangle lies within a side of another one.
    for (const Triangle& t : triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3d side = t[(i + 1) % 3] - t[i];
            for (const Triangle& other : triangles) {
                for (const Eigen::Vector3d& corner : other) {
                    const double along = side.dot(corner - t[i]) / side.squaredNorm();
                    const bool within =
                        along > 1e-9 && along < 1.0 - 1e-9 && (corner - t[i] - along * side).norm() < 1e-12;
                    QVERIFY(!within || std::min(along, 1.0 - along) * side.norm() < 1e-5);
                }
            }
        }
    }
}

void TriangulateTest::randomBlocksAreCoveredOnceAndExactly()
{
    std::mt19937_64 random(3);
    for (int trial = 0; trial < 200; ++trial) {
        double area = 0.0;
        const Outline outline = randomBlocks(random, area);

        const auto triangles = triangulate(outline, Eigen::Vector3d::UnitZ());

        double shoelace = 0.0;
        for (const auto& part : outline.parts) {
            shoelace += areaSeenFrom(Eigen::Vector3d::UnitZ(), part.ring);
            for (const auto& hole : part.holes)
                shoelace += areaSeenFrom(Eigen::Vector3d::UnitZ(), hole);
        }
        QVERIFY(std::abs(areaOf(triangles, Eigen::Vector3d::UnitZ()) - shoelace) < 1e-7);
        // Where blocks touch at a corner only, closing cracks adds a few cm²: less than one block in a hundred.
        QVERIFY(std::abs(shoelace - area) < 0.01 * area);
        for (int probe = 0; probe < 50; ++probe) {
            const Eigen::Vector2d p{static_cast<double>(random() % 79999) * 1e-4 + 0.00003,
                                    static_cast<double>(random() % 79999) * 1e-4 + 0.00007};
            QCOMPARE(trianglesAround(triangles, p), isInside(outline, p) ? 1 : 0);
        }
    }
}

void TriangulateTest::aTiltedOutlineOfSegmentsIsCovered()
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, 1.0, -0.3).normalized()).toRotationMatrix();
    pose.translation() = Eigen::Vector3d(3.0, 5.0, 4.0);
    SeenPlane seen(pose);
    for (int k = 0; k <= 20; ++k) {
        if (k >= 6 && k <= 14)
            seen.row(k, 0.1 * k, {{0.02 * (k % 3), 1.0}, {2.0, 3.0}});
        else
            seen.row(k, 0.1 * k, {{0.02 * (k % 3), 3.0}});
    }
    const Outline outline = seen.outline();

    const auto triangles = triangulate(outline, seen.plane.normal);

    QVERIFY(std::abs(areaOf(triangles, seen.plane.normal) - outline.area) < 1e-7);
    for (const Triangle& t : triangles) {
        for (const Eigen::Vector3d& corner : t)
            QVERIFY(std::abs(seen.plane.normal.dot(corner) - seen.plane.distance) < 1e-12);
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::TriangulateTest)
#include "triangulate_test.moc"
