// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/map_edits.h"

#include <QTest>

#include "app/mapping/map_floors.h"
#include "seen_room.h"
#include "tests/test_program.h"

using namespace planewright;

class MapEditsTest : public QObject {
    Q_OBJECT

private slots:
    void stopsAreOmittedOrderedAndGivenOdometry();
    void whatIsSaidLaterHolds();
    void aScanThatIsNotThereIsTold();
    void aRejectedMatchIsAPlaneOfItsOwn();
    void aForcedMatchHoldsAndTellsHowFarItIs();
    void aMatchThatCannotBeIsTold();
    void aFloorIsPlacedByOneOfItsStops();
    void aFloorIsLeftToOdometryAgain();
};

namespace {

constexpr const char* kFile = "room.pwscan";

StopEdit omit(int scan, bool on = true)
{
    MapEdit edit;
    edit.scan = scan;
    edit.on = on;
    return {kFile, edit};
}

StopEdit order(int scan, std::optional<int> before)
{
    MapEdit edit;
    edit.kind = MapEdit::Kind::Order;
    edit.scan = scan;
    edit.before = before;
    return {kFile, edit};
}

StopEdit odometry(int scan, const std::optional<Pose>& pose)
{
    MapEdit edit;
    edit.kind = MapEdit::Kind::Odometry;
    edit.scan = scan;
    edit.odometry = pose;
    return {kFile, edit};
}

StopEdit placeFloor(int scan, const std::optional<Pose>& pose)
{
    MapEdit edit;
    edit.kind = MapEdit::Kind::Floor;
    edit.scan = scan;
    edit.place = pose;
    return {kFile, edit};
}

StopEdit match(int scan, PlaneId plane, std::optional<SeenPlane> as)
{
    MapEdit edit;
    edit.kind = MapEdit::Kind::Match;
    edit.scan = scan;
    edit.plane = plane;
    edit.as = as;
    return {kFile, edit};
}

std::vector<StopInput> fourScans()
{
    std::vector<StopInput> inputs;
    for (int scan = 1; scan <= 4; ++scan)
        inputs.push_back({kFile, {scan, false}, "", 0, Pose{}});
    return inputs;
}

QList<int> scansOf(const std::vector<StopInput>& inputs)
{
    QList<int> scans;
    for (const StopInput& input : inputs)
        scans.push_back(*input.choice.scan);
    return scans;
}

/// Two stops in one room, 1 m apart.
std::vector<StopScan> twoStops()
{
    return {stopInRoom(1, {0.0, 0.0, 0.0}), stopInRoom(2, {0.0, 1.0, 0.0})};
}

MappedFloor mapOf(const std::vector<StopScan>& stops, const std::vector<StopEdit>& edits)
{
    MappingPlan plan;
    plan.parameters.flatness = 0.0;
    plan.edits = edits;
    auto mapped = mapFloors(stops, floorsOf(stops), {{0, Pose{}}}, plan);
    if (!mapped)
        qFatal("%s", mapped.error().message.c_str());
    return std::move(mapped->front());
}

}  // namespace

void MapEditsTest::stopsAreOmittedOrderedAndGivenOdometry()
{
    const Pose pose{Eigen::Quaterniond::Identity(), {1.0, 2.0, 3.0}};
    std::vector<std::string> problems;

    const auto left = withEdits(
        fourScans(), std::vector{omit(2), order(4, 1), order(1, std::nullopt), odometry(3, pose), odometry(4, {})},
        problems);

    QVERIFY(problems.empty());
    QCOMPARE(scansOf(left), QList<int>({4, 3, 1}));
    QVERIFY(!left[0].odometry);
    QCOMPARE(left[1].odometry->translation.y(), 2.0);
    QVERIFY(left[2].odometry);
}

void MapEditsTest::whatIsSaidLaterHolds()
{
    std::vector<std::string> problems;

    QCOMPARE(scansOf(withEdits(fourScans(), std::vector{omit(2), omit(3), omit(2, false)}, problems)),
             QList<int>({1, 2, 4}));
    QCOMPARE(scansOf(withEdits(fourScans(), std::vector{omit(2), omit(2)}, problems)), QList<int>({1, 3, 4}));
    QCOMPARE(scansOf(withEdits(fourScans(), std::vector{order(1, 3), order(1, 2)}, problems)),
             QList<int>({1, 2, 3, 4}));
    QCOMPARE(scansOf(withEdits(fourScans(), std::vector{order(3, 3), order(4, std::nullopt)}, problems)),
             QList<int>({1, 2, 3, 4}));
    QVERIFY(problems.empty());
}

void MapEditsTest::aScanThatIsNotThereIsTold()
{
    std::vector<std::string> problems;

    const auto left = withEdits(fourScans(), std::vector{omit(9), order(1, 8)}, problems);

    QCOMPARE(left.size(), std::size_t(4));
    QCOMPARE(problems, (std::vector<std::string>{
                           "room.pwscan: an edit of the map names scan 9, which is not there; it is not applied",
                           "room.pwscan: an edit of the map names scan 8, which is not there; it is not applied"}));
}

void MapEditsTest::aRejectedMatchIsAPlaneOfItsOwn()
{
    const auto stops = twoStops();
    const MappedFloor usual = mapOf(stops, {});
    const MappedFloor edited = mapOf(stops, {match(2, 1, std::nullopt)});

    QVERIFY(usual.builder.map().stops[1].matches[1].state == MatchState::Matched);
    QCOMPARE(planesOfFloors({&usual, 1}, stops).size(), std::size_t(6));
    QVERIFY(edited.problems.empty());
    QVERIFY(edited.builder.map().stops[1].matches[1].state == MatchState::New);
    QCOMPARE(planesOfFloors({&edited, 1}, stops).size(), std::size_t(7));
}

/// What was rejected is matched again: the planes of both stops are the same, and nothing is between them.
void MapEditsTest::aForcedMatchHoldsAndTellsHowFarItIs()
{
    const auto stops = twoStops();

    const MappedFloor edited = mapOf(stops, {match(2, 1, std::nullopt), match(2, 1, SeenPlane{1, 1})});

    const MapMatch& matched = edited.builder.map().stops[1].matches[1];
    QVERIFY(edited.problems.empty());
    QVERIFY(matched.state == MatchState::Matched);
    QVERIFY(matched.plane == edited.builder.map().stops[0].matches[1].plane);
    QVERIFY(matched.chiSquare < 1e-3);
    QCOMPARE(planesOfFloors({&edited, 1}, stops).size(), std::size_t(6));
    QCOMPARE(edited.builder.map().planes[*matched.plane].sightings.size(), std::size_t(2));
}

void MapEditsTest::aMatchThatCannotBeIsTold()
{
    const auto stops = twoStops();

    const MappedFloor edited = mapOf(stops, {match(2, 99, std::nullopt), match(2, 1, SeenPlane{1, 77}),
                                             match(2, 1, SeenPlane{5, 0}), match(8, 1, {})});

    QCOMPARE(edited.problems.size(), std::size_t(3));
    QCOMPARE(edited.problems[0],
             std::string("room.pwscan, scan 2, P99: this plane is not in the map; its match by hand "
                         "is not applied"));
    QCOMPARE(edited.problems[1],
             std::string("room.pwscan, scan 2, P01: the map has no plane of room.pwscan, scan 1, P77 "
                         "that it was matched with; that match is not applied"));
    QVERIFY(edited.problems[2].find("room.pwscan, scan 5, P00") != std::string::npos);
    QVERIFY(edited.builder.map().stops[1].matches[1].state == MatchState::Matched);
}

void MapEditsTest::aFloorIsPlacedByOneOfItsStops()
{
    std::vector<StopScan> stops{stopInRoom(1, {0.0, 0.0, 0.0}), stopInRoom(2, {1.0, 0.5, 0.0}),
                                stopInRoom(3, {0.0, 0.0, 0.0}), stopInRoom(4, {-1.0, 2.0, 0.0})};
    stops[2].floor = stops[3].floor = 1;
    const std::vector<FloorScans> floors = floorsOf(stops);
    auto mapped = mapFloors(stops, floors, {{0, Pose{}}, {1, Pose{}}}, {});
    QVERIFY(mapped);
    const Pose place{Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ())), {4.0, 5.0, 3.2}};

    const auto byHand =
        floorsByHand(stops, std::vector{placeFloor(3, Pose{}), placeFloor(4, place), placeFloor(9, place), omit(1)});
    placeFloors(*mapped, byHand);

    QCOMPARE(byHand.size(), std::size_t(1));
    QCOMPARE((*mapped)[0].frame.translation, Eigen::Vector3d(0.0, 0.0, 0.0));
    const MappedFloor& upper = (*mapped)[1];
    const Pose fourth = upper.frame * upper.builder.map().stops[1].pose;
    QVERIFY((fourth.translation - place.translation).norm() < 1e-9);
    QVERIFY(fourth.rotation.angularDistance(place.rotation) < 1e-9);
}

void MapEditsTest::aFloorIsLeftToOdometryAgain()
{
    const std::vector<StopScan> stops{stopInRoom(1, {0.0, 0.0, 0.0})};
    QVERIFY(floorsByHand(stops, std::vector{placeFloor(1, Pose{}), placeFloor(1, std::nullopt)}).empty());
}

PLANEWRIGHT_TEST(MapEditsTest)
#include "map_edits_test.moc"
