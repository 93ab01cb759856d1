// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/place_by_planes.h"

#include <algorithm>
#include <cmath>

#include <QtTest>

#include "tests/core/mapping/known_planes.h"
#include "tests/test_program.h"

namespace planewright {

class PlaceByPlanesTest : public QObject {
    Q_OBJECT

private slots:
    void aRoomOfItsOwnShapeHasOnePlace();
    void aSquareRoomHasFour();
    void aRectangularRoomHasTwo();
    void aPlaceOutOfReachIsNotFound();
    void aBareCorridorIsNotFixedAlongIt();
    void aStopThatLiesOnItsSideIsFoundIfThatIsAllowed();
    void planesThatDoNotMeetAreNoPairs();
};

namespace {

using Planes = std::vector<WeighedPlane>;

bool meetAlways(std::size_t /*seen*/, std::size_t /*known*/, const Pose& /*pose*/)
{
    return true;
}

WeighedPlane weighed(const Eigen::Vector3d& normal, double distance, double area)
{
    return {planeKnownTo(normal, distance, 1e-3, 3e-3), area};
}

/// Floor and ceiling 2.6 m apart, walls at x = ±halfX and y = ±halfY, seen from inside.
Planes roomOf(double halfX, double halfY)
{
    return {weighed({0.0, 0.0, -1.0}, 1.0, 20.0),  weighed({0.0, 0.0, 1.0}, 1.6, 20.0),
            weighed({1.0, 0.0, 0.0}, halfX, 10.0), weighed({-1.0, 0.0, 0.0}, halfX, 10.0),
            weighed({0.0, 1.0, 0.0}, halfY, 12.0), weighed({0.0, -1.0, 0.0}, halfY, 12.0)};
}

Planes seenAt(const Pose& pose, const Planes& known)
{
    Planes seen;
    for (const WeighedPlane& plane : known) {
        seen.push_back({inMap(plane.parameters, pose.inverse()), plane.area});
        seen.back().parameters.covariance = plane.parameters.covariance;
    }
    return seen;
}

/// Off the middle, turned by half a radian.
const Pose& offTheMiddle()
{
    static const Pose pose = poseAt({0.7, -0.4, 0.05}, {0.0, 0.0, 0.5});
    return pose;
}

std::size_t withAllPairs(const std::vector<Placement>& placements, std::size_t pairs)
{
    return static_cast<std::size_t>(std::ranges::count_if(
        placements, [pairs](const Placement& placement) { return placement.pairs.size() == pairs; }));
}

}  // namespace

void PlaceByPlanesTest::aRoomOfItsOwnShapeHasOnePlace()
{
    Planes known = roomOf(3.0, 2.0);
    known.push_back(weighed({0.8, 0.6, 0.0}, 3.2, 3.0));

    const auto placements = placeByPlanes(seenAt(offTheMiddle(), known), known, {}, meetAlways);

    QVERIFY(!placements.empty());
    QVERIFY(errorBetween(offTheMiddle(), placements[0].pose).norm() < 1e-6);
    QVERIFY(placements[0].fixed);
    QCOMPARE(placements[0].pairs.size(), std::size_t(7));
    QCOMPARE(withAllPairs(placements, 7), std::size_t(1));
    for (const auto& [i, j] : placements[0].pairs)
        QCOMPARE(i, j);
}

/// Turned by quarters about the middle, the place of the stop with it.
void PlaceByPlanesTest::aSquareRoomHasFour()
{
    const Planes known = roomOf(2.5, 2.5);

    const auto placements = placeByPlanes(seenAt(offTheMiddle(), known), known, {}, meetAlways);

    QCOMPARE(withAllPairs(placements, 6), std::size_t(4));
    for (int quarter = 0; quarter < 4; ++quarter) {
        const Pose turned =
            poseAt(Eigen::Vector3d::Zero(), {0.0, 0.0, degrees(90.0) * (quarter < 3 ? quarter : -1)}) * offTheMiddle();
        QVERIFY(std::ranges::any_of(placements, [&](const Placement& placement) {
            return errorBetween(turned, placement.pose).norm() < 1e-6;
        }));
    }
}

void PlaceByPlanesTest::aRectangularRoomHasTwo()
{
    const Planes known = roomOf(3.0, 2.0);

    const auto placements = placeByPlanes(seenAt(offTheMiddle(), known), known, {}, meetAlways);

    QCOMPARE(withAllPairs(placements, 6), std::size_t(2));
}

/// Turned by half a turn the stop would stand 1.6 m away.
void PlaceByPlanesTest::aPlaceOutOfReachIsNotFound()
{
    const Planes known = roomOf(3.0, 2.0);
    PlacementSearch search;
    search.about = offTheMiddle();
    search.reach = 1.0;

    const auto placements = placeByPlanes(seenAt(offTheMiddle(), known), known, search, meetAlways);

    QCOMPARE(withAllPairs(placements, 6), std::size_t(1));
    search.reach = 2.0;
    QCOMPARE(withAllPairs(placeByPlanes(seenAt(offTheMiddle(), known), known, search, meetAlways), 6), std::size_t(2));
}

void PlaceByPlanesTest::aBareCorridorIsNotFixedAlongIt()
{
    Planes known = roomOf(1.2, 50.0);
    known.resize(4);  // the ends are out of sight
    PlacementSearch search;
    search.about = Pose{offTheMiddle().rotation, offTheMiddle().translation + Eigen::Vector3d(0.1, 0.3, 0.0)};
    search.reach = 2.0;

    const auto placements = placeByPlanes(seenAt(offTheMiddle(), known), known, search, meetAlways);

    QVERIFY(!placements.empty());
    QVERIFY(!placements[0].fixed);
    QVERIFY(std::abs(placements[0].pose.translation.x() - offTheMiddle().translation.x()) < 1e-3);
    QVERIFY(std::abs(placements[0].pose.translation.y() - search.about->translation.y()) < 1e-3);
    // Nothing says where along it, so without a place to begin with there is none.
    QVERIFY(placeByPlanes(seenAt(offTheMiddle(), known), known, {}, meetAlways).empty());
}

void PlaceByPlanesTest::aStopThatLiesOnItsSideIsFoundIfThatIsAllowed()
{
    Planes known = roomOf(3.0, 2.0);
    known.push_back(weighed({0.8, 0.6, 0.0}, 3.2, 3.0));
    const Pose lying = poseAt({0.7, -0.4, 0.05}, {degrees(80.0), 0.0, 0.0});
    PlacementSearch any;
    any.tilt = degrees(180.0);

    const auto found = placeByPlanes(seenAt(lying, known), known, any, meetAlways);

    QVERIFY(!found.empty());
    QVERIFY(errorBetween(lying, found[0].pose).norm() < 1e-6);
    for (const Placement& placement : placeByPlanes(seenAt(lying, known), known, {}, meetAlways))
        QVERIFY(placement.pairs.size() < 7);
}

void PlaceByPlanesTest::planesThatDoNotMeetAreNoPairs()
{
    const Planes known = roomOf(2.5, 2.5);
    const auto onlyTheFirstTurn = [](std::size_t seen, std::size_t of, const Pose& /*pose*/) { return seen == of; };

    const auto placements = placeByPlanes(seenAt(offTheMiddle(), known), known, {}, onlyTheFirstTurn);

    QCOMPARE(withAllPairs(placements, 6), std::size_t(1));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PlaceByPlanesTest)
#include "place_by_planes_test.moc"
