// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/track_map.h"

#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <QtTest>

#include "tests/core/planes/nodding_scan.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A wall that leans and is turned out of all axes.
const Surface kLeaning{Eigen::Vector3d{0.3, 0.9, -0.2}.normalized(), 3.0, 320, 400};

/// A scan whose slices see a surface with the noise of range and pitch.
NoddingScan noisyScan(const Surface& surface, int slices, std::uint64_t seed)
{
    NoddingScan scan;
    Random random(seed);
    for (int k = 0; k < slices; ++k) {
        const double tilt = degrees(85.0) + k * kTiltStep;
        const double error = scan.parameters.noise.pitch * random.normalPair().first;
        std::vector<SegmentStatistics> segments;
        for (const int firstBeam : {300, 350}) {
            const Surface part{surface.normal, surface.distance, firstBeam, firstBeam + 40};
            segments.push_back(seen(part, tilt + error, scan.parameters.noise));
            disturb(segments.back(), random);
        }
        scan.add(tilt, segments);
    }
    return scan;
}

std::vector<SegmentNumber> numbersTo(SegmentNumber end)
{
    std::vector<SegmentNumber> numbers(static_cast<std::size_t>(end));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

/// Lets a plane take in segments slice by slice, as a scan does.
void joinSlices(NoddingScan& scan, PlaneId id, int firstPlace, int lastPlace)
{
    for (int place = firstPlace; place <= lastPlace; ++place) {
        const TrackedSlice& slice = scan.map.slice(place);
        std::vector<SegmentNumber> numbers(static_cast<std::size_t>(slice.end - slice.first));
        std::iota(numbers.begin(), numbers.end(), slice.first);
        scan.map.join(scan.map.plane(id), numbers, place, scan.parameters);
    }
}

}  // namespace

class TrackMapTest : public QObject {
    Q_OBJECT

private slots:
    void segmentsAreNumberedOnOverTheSlices();
    void frameOfASliceIsThatOfItsMiddleBeam();
    void beamsOfInterlacedSlicesAreThoseOfTheFirst();
    void neighboursAreTwoSlicesOrThoseWithinOneAndAHalfDegrees_data();
    void neighboursAreTwoSlicesOrThoseWithinOneAndAHalfDegrees();
    void meanTiltStepCountsBothWays();
    void overlapsAreThoseOfAllSegmentsCompared();
    void aPlaneOwnsItsSegmentsAndLiesWhereTheyAre();
    void segmentsThatDetermineNoPlaneStayFree();
    void aJoinedPlaneIsThatOfItsMembersAtOnce();
    void segmentsOfOneSliceMayJoinOneByOne();
    void joiningAnEarlierSliceKeepsTheOrder();
    void everyJoinIsAChange();
    void aPlaneThatGrewThreefoldIsLinearisedAnew();
    void aPlaneThatTurnedIsLinearisedAnew();
    void anOldPlaneIsSolvedWithEveryFourthSlice();
    void rebuildLeavesOutWhatDoesNotCount();
    void rebuildForgetsWhereThePlaneWasSeen();
    void whatWasFoundOutHoldsUntilThePlaneOrTheParametersChange();
    void membersFollowTheirOwners();
    void dissolvedPlanesFreeTheirSegmentsAndKeepTheirNumber();
};

void TrackMapTest::segmentsAreNumberedOnOverTheSlices()
{
    NoddingScan scan;
    scan.see(degrees(80.0), {kWall, {{0.0, 1.0, 0.0}, 5.0, 410, 450}});
    scan.see(degrees(81.0), {});
    scan.see(degrees(82.0), {kWall});

    QCOMPARE(scan.map.slices(), 3);
    QCOMPARE(scan.map.segments(), 3);
    const std::array<std::pair<int, int>, 3> expected{{{0, 2}, {2, 2}, {2, 3}}};
    for (int place = 0; place < 3; ++place) {
        const TrackedSlice& slice = scan.map.slice(place);
        QCOMPARE(slice.step, place);
        QCOMPARE(std::pair(slice.first, slice.end), expected[static_cast<std::size_t>(place)]);
    }
    QCOMPARE(scan.map.segment(1).slice, 0);
    QCOMPARE(scan.map.segment(2).slice, 2);
    QCOMPARE(scan.map.segment(1).statistics.firstBeam, 410);
    QCOMPARE(scan.map.segment(0).owner, kNoPlane);
}

void TrackMapTest::frameOfASliceIsThatOfItsMiddleBeam()
{
    TrackMap map;
    ScanSlice slice = sliceAt(7, degrees(40.0));
    slice.tiltEnd = degrees(44.0);

    map.append(slice, kSensor, {});

    QCOMPARE(map.slice(0).step, 7);
    QVERIFY(std::abs(map.slice(0).frame.tilt - degrees(42.0)) < 1e-12);
}

void TrackMapTest::beamsOfInterlacedSlicesAreThoseOfTheFirst()
{
    TrackMap map;
    const std::vector<SegmentStatistics> segments{seen(kWall, degrees(80.0), {})};
    for (const int shift : {0, 3, -2}) {
        ScanSlice slice = sliceAt(map.slices(), degrees(80.0 + map.slices()));
        slice.firstBearing = 0.1 + shift * kBearingStep;
        map.append(slice, kSensor, segments);
    }

    QCOMPARE(map.bearingStep(), kBearingStep);
    QCOMPARE(std::pair(map.beams(0).first, map.beams(0).last), std::pair(320, 400));
    QCOMPARE(std::pair(map.beams(1).first, map.beams(1).last), std::pair(323, 403));
    QCOMPARE(std::pair(map.beams(2).first, map.beams(2).last), std::pair(318, 398));
}

void TrackMapTest::neighboursAreTwoSlicesOrThoseWithinOneAndAHalfDegrees_data()
{
    QTest::addColumn<double>("tiltStep");
    QTest::addColumn<int>("neighbours");

    QTest::newRow("coarse") << 1.16 << 2;
    QTest::newRow("three of 0.4 degrees are 1.2") << 0.4 << 3;
    QTest::newRow("five of 0.27 degrees are 1.35") << -0.27 << 5;
    QTest::newRow("eight at most") << 0.1 << 8;
    QTest::newRow("a head that rests") << 0.0 << 8;
}

void TrackMapTest::neighboursAreTwoSlicesOrThoseWithinOneAndAHalfDegrees()
{
    QFETCH(const double, tiltStep);
    QFETCH(const int, neighbours);
    NoddingScan scan;
    scan.nod(12, {}, degrees(80.0), degrees(tiltStep));

    for (int place = 0; place < 12; ++place) {
        QCOMPARE(scan.map.lookback(place), std::min(place, neighbours));
        QCOMPARE(scan.map.lookahead(place), std::min(11 - place, neighbours));
    }
}

void TrackMapTest::meanTiltStepCountsBothWays()
{
    NoddingScan scan;
    QCOMPARE(scan.map.meanTiltStep(), 0.0);
    scan.see(degrees(80.0), {});
    QCOMPARE(scan.map.meanTiltStep(), 0.0);

    for (const double tilt : {82.0, 85.0, 81.0})
        scan.see(degrees(tilt), {});

    QVERIFY(std::abs(scan.map.meanTiltStep() - degrees(3.0)) < 1e-12);
}

void TrackMapTest::overlapsAreThoseOfAllSegmentsCompared()
{
    Random random(21);
    for (int trial = 0; trial < 200; ++trial) {
        TrackMap map;
        for (int k = 0; k < 2; ++k) {
            std::vector<SegmentStatistics> segments;
            for (int beam = random.integer(0, 20); beam < 150; beam += random.integer(1, 12)) {
                SegmentStatistics s;
                s.firstBeam = beam;
                s.lastBeam = beam += random.integer(3, 25);
                segments.push_back(s);
            }
            ScanSlice slice = sliceAt(k, degrees(80.0 + k));
            slice.firstBearing = k * random.integer(-9, 9) * kBearingStep;
            map.append(slice, kSensor, segments);
        }
        const int first = random.integer(-10, 170);
        const int last = first + random.integer(0, 30);
        const int margin = random.integer(0, 8);

        std::vector<SegmentNumber> visited;
        map.visitOverlaps(1, {first, last}, margin, [&](SegmentNumber number) { visited.push_back(number); });

        std::vector<SegmentNumber> expected;
        for (SegmentNumber number = map.slice(1).first; number < map.segments(); ++number) {
            bool shares = false;
            for (int beam = map.beams(number).first; beam <= map.beams(number).last; ++beam)
                shares = shares || (beam >= first - margin && beam <= last + margin);
            if (shares)
                expected.push_back(number);
        }
        QVERIFY(visited == expected);
    }
}

void TrackMapTest::aPlaneOwnsItsSegmentsAndLiesWhereTheyAre()
{
    NoddingScan scan;
    scan.nod(4, {kWall, {{0.0, 1.0, 0.0}, 5.0, 410, 450}});

    const PlaneId id = scan.makePlane({6, 0, 4}, {Eigen::Vector3d{0.01, 1.0, 0.01}.normalized(), 3.99});

    QCOMPARE(id, 0);
    const PlaneTrack& plane = scan.map.plane(id);
    QVERIFY((plane.members == std::vector<SegmentNumber>{0, 4, 6}));
    QCOMPARE(plane.points, std::int64_t{3 * 81});
    QCOMPARE(plane.slices, 3);
    QCOMPARE(plane.fitted, 3);
    QCOMPARE(plane.bornStep, 3);
    QCOMPARE(plane.changedStep, 3);
    QVERIFY(disagreement(scan.map).empty());
    // It was 0.8° off: what one linearisation leaves is of that squared.
    QVERIFY(apart(plane.estimate, kWall) < 1e-3);
}

void TrackMapTest::segmentsThatDetermineNoPlaneStayFree()
{
    NoddingScan scan;
    scan.nod(3, {kWall});

    // Of no segment nothing is known.
    QCOMPARE(scan.makePlane({}, kWall), kNoPlane);
    QVERIFY(scan.map.planes().empty());
    QCOMPARE(scan.makePlane({0, 1, 2}, kWall), 0);
}

void TrackMapTest::aJoinedPlaneIsThatOfItsMembersAtOnce()
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        NoddingScan scan = noisyScan(kLeaning, 9, seed);
        scan.parameters.noise.systematic = 0.003;
        const PlaneId id = scan.makePlane(numbersTo(8), kLeaning);

        joinSlices(scan, id, 4, 8);

        // Nine slices are less than three times four: it is still linearised where it was made.
        const PlaneTrack& plane = scan.map.plane(id);
        QVERIFY2(disagreement(scan.map).empty(), disagreement(scan.map).c_str());
        const PlaneEstimate whole = solvedFrom(PlaneEstimate(kLeaning.normal, kLeaning.distance), numbersTo(18),
                                               scan.map, scan.parameters.noise, 0.003);
        QVERIFY(nearlyEqual(plane.estimate, whole, 1e-9));
        QVERIFY(std::abs(plane.estimate.chi() - whole.chi()) < 1e-6);
        QCOMPARE(plane.fitted, 18);
        QVERIFY(apart(plane.estimate, kLeaning) > 1e-6);  // noise was there
    }
}

void TrackMapTest::segmentsOfOneSliceMayJoinOneByOne()
{
    NoddingScan together = noisyScan(kLeaning, 5, 3);
    together.parameters.noise.systematic = 0.003;
    NoddingScan single = together;
    const PlaneId id = together.makePlane(numbersTo(6), kLeaning);
    QCOMPARE(single.makePlane(numbersTo(6), kLeaning), id);

    joinSlices(together, id, 3, 4);
    for (const SegmentNumber number : {7, 9, 8, 6})
        single.map.join(single.map.plane(id), std::span{&number, 1}, 4, single.parameters);

    QVERIFY2(disagreement(single.map).empty(), disagreement(single.map).c_str());
    QVERIFY(nearlyEqual(single.map.plane(id).estimate, together.map.plane(id).estimate, 1e-9));
    QCOMPARE(single.map.plane(id).slices, 5);
    QCOMPARE(single.map.plane(id).fitted, 10);
}

void TrackMapTest::joiningAnEarlierSliceKeepsTheOrder()
{
    NoddingScan scan = noisyScan(kWall, 6, 4);
    const PlaneId id = scan.makePlane({6, 7, 8, 9}, kWall);

    joinSlices(scan, id, 1, 1);
    joinSlices(scan, id, 5, 5);
    joinSlices(scan, id, 0, 0);

    QVERIFY2(disagreement(scan.map).empty(), disagreement(scan.map).c_str());
    QCOMPARE(scan.map.plane(id).slices, 5);
    QCOMPARE(scan.map.plane(id).lastSlice, 5);
}

void TrackMapTest::everyJoinIsAChange()
{
    NoddingScan scan = noisyScan(kWall, 4, 5);
    const PlaneId id = scan.makePlane(numbersTo(6), kWall);
    const std::uint64_t revision = scan.map.plane(id).revision;
    scan.map.plane(id).published = std::make_shared<const Plane>();

    const SegmentNumber number = 6;
    scan.map.join(scan.map.plane(id), std::span{&number, 1}, 17, scan.parameters);

    QVERIFY(scan.map.plane(id).revision > revision);
    QVERIFY(scan.map.plane(id).published == nullptr);
    QCOMPARE(scan.map.plane(id).changedStep, 17);
}

void TrackMapTest::aPlaneThatGrewThreefoldIsLinearisedAnew()
{
    NoddingScan scan;
    scan.nod(10, {kWall});
    // Linearised 1.2° beside the wall, where angles of 0.02 rad leave an error of about their square.
    const PlaneId id = scan.makePlane({0, 1, 2}, {Eigen::Vector3d{0.02, 1.0, 0.0}.normalized(), 4.0});

    joinSlices(scan, id, 3, 8);
    const double before = scan.map.plane(id).estimate.angleFromLinearisation();
    joinSlices(scan, id, 9, 9);

    QVERIFY(std::abs(before - 0.02) < 1e-3);
    const PlaneTrack& plane = scan.map.plane(id);
    QVERIFY(plane.estimate.angleFromLinearisation() < 1e-3);
    QCOMPARE(plane.linearisedAt, std::int64_t{10 * 81});
    QVERIFY(apart(plane.estimate, kWall) < 1e-6);
}

void TrackMapTest::aPlaneThatTurnedIsLinearisedAnew()
{
    for (const double turn : {0.029, 0.031}) {
        NoddingScan scan;
        scan.nod(5, {kWall});
        const Surface beside{Eigen::Vector3d{std::sin(turn), std::cos(turn), 0.0}, 4.0};
        const PlaneId id = scan.makePlane({0, 1, 2, 3}, beside);

        joinSlices(scan, id, 4, 4);

        // Angles are told along the tangents: a turn by its tangent.
        const double angle = scan.map.plane(id).estimate.angleFromLinearisation();
        QVERIFY(turn < 0.03 ? std::abs(angle - std::tan(turn)) < 1e-4 : angle < 1e-3);
    }
}

void TrackMapTest::anOldPlaneIsSolvedWithEveryFourthSlice()
{
    NoddingScan scan;
    scan.nod(19, {kWall});
    const PlaneId id = scan.makePlane(numbersTo(10), kWall);
    for (SegmentNumber number = 10; number < 19; ++number)
        disturb(scan.map.segment(number).statistics, 0.01, 0.0);
    std::vector<int> moved;
    double distance = scan.map.plane(id).estimate.distance();

    for (int place = 10; place < 19; ++place) {
        joinSlices(scan, id, place, place);
        if (std::exchange(distance, scan.map.plane(id).estimate.distance()) != scan.map.plane(id).estimate.distance())
            moved.push_back(place);
    }

    QVERIFY((moved == std::vector<int>{13, 17}));
}

void TrackMapTest::rebuildLeavesOutWhatDoesNotCount()
{
    NoddingScan scan;
    scan.nod(6, {kWall});
    disturb(scan.map.segment(3).statistics, 0.05, 0.0);
    const PlaneId id = scan.makePlane(numbersTo(6), kWall);
    PlaneTrack& plane = scan.map.plane(id);
    const PlaneEstimate before = plane.estimate;
    QVERIFY(apart(before, kWall) > 1e-3);

    const std::vector<SegmentNumber> others{0, 1, 2, 4, 5};
    QVERIFY(scan.map.rebuild(plane, scan.map.together(others), scan.parameters.noise, 0.0));

    QCOMPARE(plane.fitted, 5);
    QCOMPARE(plane.members.size(), std::size_t{6});
    QVERIFY(disagreement(scan.map).empty());
    QVERIFY(nearlyEqual(plane.estimate, solvedFrom(before, others, scan.map, scan.parameters.noise, 0.0), 1e-12));
    // Nothing counts: the plane stays as it was.
    const double distance = plane.estimate.distance();
    QVERIFY(!scan.map.rebuild(plane, scan.map.together({}), scan.parameters.noise, 0.0));
    QCOMPARE(plane.estimate.distance(), distance);
    QCOMPARE(plane.fitted, 5);
}

void TrackMapTest::rebuildForgetsWhereThePlaneWasSeen()
{
    NoddingScan scan = noisyScan(kLeaning, 5, 6);
    const PlaneId id =
        scan.makePlane(numbersTo(8), {(kLeaning.normal + Eigen::Vector3d{0.05, 0.0, 0.0}).normalized(), 3.0});
    PlaneTrack& plane = scan.map.plane(id);
    scan.map.joinChi(plane, 8, scan.parameters.noise, 0.002);

    scan.map.rebuild(plane, scan.parameters);

    const double expected = plane.estimate.joinChi(plane.estimate.inSlice(scan.map.slice(4).frame),
                                                   scan.map.segment(8).statistics, scan.parameters.noise, 0.002);
    QCOMPARE(scan.map.joinChi(plane, 8, scan.parameters.noise, 0.002), expected);
}

void TrackMapTest::whatWasFoundOutHoldsUntilThePlaneOrTheParametersChange()
{
    NoddingScan scan;
    scan.nod(8, {kWall});
    const PlaneId growing = scan.makePlane({0, 1, 2}, kWall);
    const PlaneId resting = scan.makePlane({5, 6, 7}, kWall);
    const std::int64_t found = scan.map.moment();
    const auto holds = [&](PlaneId id) { return scan.map.holds(scan.map.plane(id), found); };

    QVERIFY(!scan.map.holds(scan.map.plane(resting), -1));  // was never found out
    QVERIFY(holds(growing) && holds(resting));
    joinSlices(scan, growing, 3, 3);
    QVERIFY(!holds(growing) && holds(resting));
    scan.map.rebuild(scan.map.plane(resting), scan.parameters);
    QVERIFY(!holds(resting));
    const std::int64_t later = scan.map.moment();
    scan.map.parametersChanged();
    QVERIFY(!scan.map.holds(scan.map.plane(resting), later));
}

void TrackMapTest::membersFollowTheirOwners()
{
    NoddingScan scan;
    scan.nod(8, {kWall});
    const PlaneId first = scan.makePlane({0, 1, 2}, kWall);
    const PlaneId second = scan.makePlane({3, 4, 5}, kWall);
    scan.makePlane({6, 7}, kWall);

    scan.map.segment(1).owner = second;
    scan.map.segment(4).owner = kNoPlane;
    scan.map.segment(6).owner = first;
    scan.map.segment(7).owner = first;
    const std::vector<PlaneId> changed{second, first, 2, first};
    const std::vector<PlaneTrack*> left = scan.map.collectMembers(changed, 30);

    QVERIFY((left == std::vector{&scan.map.plane(first), &scan.map.plane(second)}));
    QVERIFY((scan.planeIds() == std::vector<PlaneId>{first, second}));
    QVERIFY((scan.map.plane(first).members == std::vector<SegmentNumber>{0, 2, 6, 7}));
    QVERIFY((scan.map.plane(second).members == std::vector<SegmentNumber>{1, 3, 5}));
    QVERIFY(disagreement(scan.map).empty());
    QCOMPARE(scan.map.plane(first).changedStep, 30);
}

void TrackMapTest::dissolvedPlanesFreeTheirSegmentsAndKeepTheirNumber()
{
    NoddingScan scan;
    scan.nod(9, {kWall});
    for (int k = 0; k < 3; ++k)
        scan.makePlane({3 * k, 3 * k + 1, 3 * k + 2}, kWall);

    scan.map.dissolve(1);

    QVERIFY((scan.planeIds() == std::vector<PlaneId>{0, 2}));
    for (SegmentNumber number = 0; number < 9; ++number)
        QCOMPARE(scan.map.segment(number).owner, number / 3 == 1 ? kNoPlane : number / 3);
    QVERIFY(disagreement(scan.map).empty());
    scan.map.dissolve(2);
    QCOMPARE(scan.makePlane({3, 4, 5}, kWall), 3);
    QVERIFY(disagreement(scan.map).empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::TrackMapTest)
#include "track_map_test.moc"
