// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/minimum_rectangle.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {
namespace {

double uniform(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Area of the box around points in axes turned by an angle.
double boxArea(const PlanarRing& points, double angle)
{
    const Eigen::Vector2d u{std::cos(angle), std::sin(angle)};
    const Eigen::Vector2d v{-u.y(), u.x()};
    Eigen::Vector2d least = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector2d most = -least;
    for (const Eigen::Vector2d& p : points) {
        const Eigen::Vector2d q{u.dot(p), v.dot(p)};
        least = least.cwiseMin(q);
        most = most.cwiseMax(q);
    }
    return (most - least).prod();
}

}  // namespace

class MinimumRectangleTest : public QObject {
    Q_OBJECT

private slots:
    void theHullOfASquareIsItsCorners();
    void theHullOfALineIsItsEnds();
    void aTurnedRectangleIsFound();
    void noTurnedBoxIsSmaller();
    void ofEqualAreasTheLeastPerimeterWins();
    void aPointHasNoSides();
};

void MinimumRectangleTest::theHullOfASquareIsItsCorners()
{
    const PlanarRing hull = convexHull({{1, 1}, {0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {0, 2}, {2, 1}});

    QVERIFY((hull == PlanarRing{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

void MinimumRectangleTest::theHullOfALineIsItsEnds()
{
    QVERIFY((convexHull({{2, 2}, {0, 0}, {1, 1}, {3, 3}}) == PlanarRing{{0, 0}, {3, 3}}));
}

void MinimumRectangleTest::aTurnedRectangleIsFound()
{
    const double angle = 0.4;
    const Eigen::Vector2d u{std::cos(angle), std::sin(angle)};
    const Eigen::Vector2d v{-u.y(), u.x()};
    const Eigen::Vector2d o{5.0, -3.0};

    const RectangleSides sides = minimumRectangle(convexHull({o, o + 3.0 * u, o + 3.0 * u + 2.0 * v, o + 2.0 * v}));

    QVERIFY(std::abs(sides.along * sides.across - 6.0) < 1e-12);
    const bool alongU = std::abs(sides.direction.dot(u)) > 0.5;
    QVERIFY(std::abs((alongU ? sides.along : sides.across) - 3.0) < 1e-12);
    QVERIFY(std::abs(sides.direction.dot(u) * sides.direction.dot(v)) < 1e-12);
}

void MinimumRectangleTest::noTurnedBoxIsSmaller()
{
    std::mt19937_64 random(5);
    for (int trial = 0; trial < 40; ++trial) {
        PlanarRing points;
        for (int i = 0; i < 4 + trial % 20; ++i)
            points.emplace_back(3.0 * uniform(random), uniform(random));

        const RectangleSides sides = minimumRectangle(convexHull(points));

        const double area = sides.along * sides.across;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 1800; ++i)
            least = std::min(least, boxArea(points, i * std::numbers::pi / 3600.0));
        QVERIFY(area <= least + 1e-12);
        QVERIFY(least < area * 1.005);
        const double angle = std::atan2(sides.direction.y(), sides.direction.x());
        QVERIFY(std::abs(boxArea(points, angle) - area) < 1e-12);
    }
}

void MinimumRectangleTest::ofEqualAreasTheLeastPerimeterWins()
{
    // Boxes on each side of a triangle have twice its area; 3 + 4 is less than 5 + 2.4.
    const RectangleSides sides = minimumRectangle(convexHull({{0, 0}, {3, 0}, {0, 4}}));

    QVERIFY(std::abs(sides.along + sides.across - 7.0) < 1e-12);
}

void MinimumRectangleTest::aPointHasNoSides()
{
    const RectangleSides sides = minimumRectangle(convexHull({{1, 2}, {1, 2}}));

    QCOMPARE(sides.along, 0.0);
    QCOMPARE(sides.across, 0.0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MinimumRectangleTest)
#include "minimum_rectangle_test.moc"
