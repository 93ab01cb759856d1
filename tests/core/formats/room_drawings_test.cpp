// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/room_drawings.h"

#include <algorithm>
#include <cmath>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/core/formats/sample_planes.h"
#include "tests/test_program.h"

namespace planewright {

class RoomDrawingsTest : public QObject {
    Q_OBJECT

private slots:
    void drawingsAreSquaredToTheLargestWall();
    void aSideShowsWhatIsThere();
    void aPlanCutsWallsAtItsHeight();
};

namespace {

/// A wall of 2 m × 1 m above z = 0 about a point of the plane that faces the scanner from a level direction.
PlaneResult wallTowards(const Eigen::Vector2d& direction, PlaneId id, double area = 2.0)
{
    auto plane = std::make_shared<Plane>();
    plane->id = id;
    plane->normal << direction.normalized(), 0.0;
    plane->distance = 3.0;
    const Eigen::Vector3d middle = 3.0 * plane->normal;
    const Eigen::Vector3d along{-plane->normal.y(), plane->normal.x(), 0.0};
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    PlaneResult result;
    result.plane = plane;
    result.className = "wall";
    result.outline.parts = {{{middle - along, middle + along, middle + along + up, middle - along + up}, {}}};
    result.outline.area = area;
    result.outline.centroid = middle + 0.5 * up;
    return result;
}

const RoomDrawing* drawingOf(const std::vector<RoomDrawing>& drawings, std::string_view title)
{
    const auto found = std::find_if(drawings.begin(), drawings.end(), [&](const auto& d) { return d.title == title; });
    return found == drawings.end() ? nullptr : &*found;
}

bool has(const RoomDrawing* drawing, std::string_view part)
{
    return drawing != nullptr && drawing->svg.find(part) != std::string::npos;
}

}  // namespace

void RoomDrawingsTest::drawingsAreSquaredToTheLargestWall()
{
    QCOMPARE(squaredDirection({}), Eigen::Vector2d(Eigen::Vector2d::UnitY()));
    // Of a wall at 30° from x towards y the quarter turn nearest to y is 30° from it, towards −x.
    const std::vector<PlaneResult> planes{wallTowards({std::cos(degrees(30.0)), std::sin(degrees(30.0))}, 1, 9.0),
                                          wallTowards({0.0, 1.0}, 2)};
    const Eigen::Vector2d direction = squaredDirection(planes);
    QVERIFY((direction - Eigen::Vector2d(-std::sin(degrees(30.0)), std::cos(degrees(30.0)))).norm() < 1e-12);
}

void RoomDrawingsTest::aSideShowsWhatIsThere()
{
    const std::vector<PlaneResult> planes{wallTowards({0.0, 1.0}, 1), wallTowards({1.0, 0.0}, 2)};

    const auto drawings = roomDrawings(planes, 0.5, 500.0);

    QVERIFY(has(drawingOf(drawings, "Front"), ">P01<"));
    QVERIFY(!has(drawingOf(drawings, "Front"), ">P02<"));
    QVERIFY(has(drawingOf(drawings, "Right"), ">P02<"));
    QVERIFY(drawingOf(drawings, "Back") == nullptr);
    QVERIFY(drawingOf(drawings, "Left") == nullptr);
    QVERIFY(has(drawingOf(drawings, "Front"), "class=\"wall area\""));
    QVERIFY(has(drawingOf(drawings, "Front"), "class=\"wall edge\""));  // the wall to the right, seen along itself
}

/// From the scanner at (0, 0) to the wall from (−1, 3) to (1, 3) the plan is 2 m × 3 m; 590 pixels of 640 are for the
/// three metres.
void RoomDrawingsTest::aPlanCutsWallsAtItsHeight()
{
    const std::vector<PlaneResult> planes{wallTowards({0.0, 1.0}, 1)};

    const auto low = roomDrawings(planes, 0.5, 450.0);
    const auto high = roomDrawings(planes, 1.5, 450.0);

    // Cut from end to end, in either direction.
    QVERIFY(has(drawingOf(low, "Plan"), "<path class=\"wall cut\" d=\"M12.00 12.00L405.33 12.00\"/>") ||
            has(drawingOf(low, "Plan"), "<path class=\"wall cut\" d=\"M405.33 12.00L12.00 12.00\"/>"));
    QVERIFY(!has(drawingOf(high, "Plan"), "class=\"wall cut\""));
    QVERIFY(has(drawingOf(high, "Plan"), "class=\"wall edge\""));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::RoomDrawingsTest)
#include "room_drawings_test.moc"
