// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/floor_plan.h"

#include <cmath>
#include <sstream>

#include <QTest>

#include "seen_room.h"
#include "tests/test_program.h"

using namespace planewright;

class FloorPlanTest : public QObject {
    Q_OBJECT

private slots:
    void eachFloorIsCutAboveItsOwn();
    void withoutAFloorTheScannerTellsTheHeight();
    void stopsKeepTheirNumbers();
    void aFloorHasAFileOfItsOwn();
};

namespace {

/// Two floors of one stop each, the upper one 3.2 m above the other.
std::vector<StopScan> twoFloors()
{
    std::vector<StopScan> stops{stopInRoom(1, Eigen::Vector3d::Zero()), stopInRoom(2, Eigen::Vector3d::Zero())};
    stops[1].floor = 1;
    return stops;
}

std::vector<MappedFloor> mapOf(const std::vector<StopScan>& stops)
{
    const Pose upper{Eigen::Quaterniond::Identity(), {0.0, 0.0, 3.2}};
    auto mapped = mapFloors(stops, floorsOf(stops), {{0, Pose{}}, {1, upper}}, {});
    if (!mapped)
        qFatal("%s", mapped.error().message.c_str());
    return std::move(*mapped);
}

}  // namespace

/// Floors lie 1.5 m below the scanners.
void FloorPlanTest::eachFloorIsCutAboveItsOwn()
{
    const auto stops = twoFloors();
    const auto floors = mapOf(stops);

    const FloorPlan lower = floorPlanOf(floors[0], stops, 1.0);
    const FloorPlan upper = floorPlanOf(floors[1], stops, 1.0);

    QVERIFY(lower.isFloorKnown && upper.isFloorKnown);
    QVERIFY(std::abs(lower.height - -0.5) < 1e-6);
    QVERIFY(std::abs(upper.height - 2.7) < 1e-6);
    QCOMPARE(upper.floor, 1);
    QCOMPARE(upper.planes.size(), std::size_t(6));
    std::ostringstream svg;
    QVERIFY(writeFloorPlan(svg, ".svg", upper, 100.0));
    QCOMPARE(QString::fromStdString(svg.str()).count("wall cut"), 4);
}

void FloorPlanTest::withoutAFloorTheScannerTellsTheHeight()
{
    auto stops = twoFloors();
    for (StopScan& stop : stops)
        stop.planes.erase(stop.planes.begin() + 4);
    const auto floors = mapOf(stops);

    const FloorPlan upper = floorPlanOf(floors[1], stops, 1.0);

    QVERIFY(!upper.isFloorKnown);
    QVERIFY(std::abs(upper.height - 3.2) < 1e-6);
}

void FloorPlanTest::stopsKeepTheirNumbers()
{
    const auto stops = twoFloors();
    const auto floors = mapOf(stops);

    const FloorPlan upper = floorPlanOf(floors[1], stops, 1.0);

    QCOMPARE(upper.stops.size(), std::size_t(1));
    QCOMPARE(upper.stops.front().number, 1);
}

void FloorPlanTest::aFloorHasAFileOfItsOwn()
{
    QCOMPARE(floorPlanPath("plans/house.dxf", 2), std::string("plans/house-floor-2.dxf"));
    QCOMPARE(floorPlanPath("a.b/plan.svg", -1), std::string("a.b/plan-floor--1.svg"));
}

PLANEWRIGHT_TEST(FloorPlanTest)
#include "floor_plan_test.moc"
