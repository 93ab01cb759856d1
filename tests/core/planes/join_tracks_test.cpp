// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <QtTest>

#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Slices that see surfaces and a plane of each, and one more slice that is to be joined.
struct Joining {
    NoddingScan scan;
    std::vector<PlaneId> ids;

    explicit Joining(const std::vector<Surface>& surfaces, int slices = 6)
    {
        scan.nod(slices, surfaces);
        for (std::size_t i = 0; i < surfaces.size(); ++i)
            ids.push_back(scan.makePlane(scan.column(static_cast<int>(i), 0, slices - 1), surfaces[i]));
    }

    /// Sees surfaces in the next slice.
    void see(const std::vector<Surface>& surfaces)
    {
        scan.see(degrees(85.0) + scan.map.slices() * kTiltStep, surfaces);
    }
    std::vector<SegmentNumber> join() { return joinTracks(scan.map, scan.parameters, scan.recorded.recorder); }
    void joinRest(int firstSlice) { joinRemaining(scan.map, firstSlice, scan.parameters, scan.recorded.recorder); }
    PlaneId owner(SegmentNumber number) const { return scan.map.segment(number).owner; }
    PlaneId lastOwner() const { return owner(scan.map.segments() - 1); }
    double joinChi(PlaneId id, SegmentNumber number)
    {
        return scan.map.joinChi(scan.map.plane(id), number, scan.parameters.noise, scan.parameters.flatnessFloor());
    }
};

}  // namespace

class JoinTracksTest : public QObject {
    Q_OBJECT

private slots:
    void aSegmentOfThePlaneItFacesJoins();
    void aSegmentTenCentimetresOffIsLeft();
    void theGateIsTheOneOfTheParameters();
    void theNearerOfTwoPlanesWins_data();
    void theNearerOfTwoPlanesWins();
    void aNearSliceThatFitsWellIsEnough();
    void threeBeamsBesideAPlaneStillFaceIt();
    void oneSliceWithoutThePlaneIsBridgedAndTwoAreNot_data();
    void oneSliceWithoutThePlaneIsBridgedAndTwoAreNot();
    void aKnownPlaneIsJoinedAcrossAGap_data();
    void aKnownPlaneIsJoinedAcrossAGap();
    void acrossAGapTheGateIsNarrower();
    void whatAloneWouldTurnAPlaneJoinsOnlyToADirectionOfTheRoom_data();
    void whatAloneWouldTurnAPlaneJoinsOnlyToADirectionOfTheRoom();
    void aKnownPlaneOutOfSightIsNotJoined_data();
    void aKnownPlaneOutOfSightIsNotJoined();
    void segmentsOfOneSliceJoinTogether();
    void decisionsTellTheNumbersCompared();
    void firstSliceHasNothingToJoin();
    void leftoverSegmentsJoinPlanesBeforeAndAfter();
    void leftoverSegmentsOfTheFirstSliceFaceTwoSlicesToo();
    void leftoverSegmentsOfEarlierSlicesStayAsTheyAre();
    void leftoverSegmentsJoinKnownPlanesSeenAboutThen_data();
    void leftoverSegmentsJoinKnownPlanesSeenAboutThen();
    void leftoverSegmentsThatFitNothingStayFree();
    void leftoverSegmentsAreAskedAgainWhenSomethingChanged();
    void mirroredScansAreJoinedAlike();
};

void JoinTracksTest::aSegmentOfThePlaneItFacesJoins()
{
    Joining joining({kWall});
    joining.see({kWall});

    const Numbers left = joining.join();

    QVERIFY(left.empty());
    QCOMPARE(joining.lastOwner(), joining.ids[0]);
    QCOMPARE(joining.scan.map.plane(0).slices, 7);
    QVERIFY(disagreement(joining.scan.map).empty());
    QVERIFY(apart(joining.scan.map.plane(0).estimate, kWall) < 1e-9);
}

void JoinTracksTest::aSegmentTenCentimetresOffIsLeft()
{
    Joining joining({kWall});
    joining.see({wallBy(320, 400, 0.1)});

    const Numbers left = joining.join();

    QVERIFY((left == Numbers{6}));
    QCOMPARE(joining.lastOwner(), kNoPlane);
    QCOMPARE(joining.scan.map.plane(0).members.size(), std::size_t{6});
    QVERIFY(apart(joining.scan.map.plane(0).estimate, kWall) < 1e-9);
}

void JoinTracksTest::theGateIsTheOneOfTheParameters()
{
    for (const double factor : {0.99, 1.01}) {
        Joining joining({kWall});
        joining.scan.parameters.likelihood.apartGate = 0.1;
        joining.see({wallBy(320, 400, 0.01)});
        joining.scan.parameters.likelihood.joinGate = factor * joining.joinChi(0, 6);

        joining.join();

        QCOMPARE(joining.lastOwner(), factor > 1.0 ? 0 : kNoPlane);
    }
}

void JoinTracksTest::theNearerOfTwoPlanesWins_data()
{
    QTest::addColumn<double>("shift");
    QTest::addColumn<int>("plane");

    // Two walls side by side, 2 cm apart; a segment across both.
    QTest::newRow("nearer to the first") << 0.008 << 0;
    QTest::newRow("nearer to the second") << 0.012 << 1;
}

void JoinTracksTest::theNearerOfTwoPlanesWins()
{
    QFETCH(const double, shift);
    QFETCH(const int, plane);
    Joining joining({wallBy(300, 360), wallBy(361, 421, 0.02)});
    joining.see({wallBy(330, 391, shift)});
    QVERIFY(std::max(joining.joinChi(0, 12), joining.joinChi(1, 12)) < joining.scan.parameters.likelihood.joinGate);

    joining.join();

    QCOMPARE(joining.lastOwner(), plane);
}

void JoinTracksTest::aNearSliceThatFitsWellIsEnough()
{
    // A segment lies on the wall that was hidden in the slice before, and beside another that was not.
    const auto joining = [](double shift) {
        Joining made({wallBy(300, 352, shift), wallBy(353, 405)}, 5);
        made.see({wallBy(300, 352, shift)});
        made.join();
        made.see({wallBy(330, 380)});
        return made;
    };
    for (const double chi : {3.9, 4.1}) {
        // χ² goes with the square of the distance.
        double shift = 0.01;
        for (int round = 0; round < 8; ++round)
            shift *= std::sqrt(chi / joining(shift).joinChi(0, 11));
        Joining made = joining(shift);
        QVERIFY(std::abs(made.joinChi(0, 11) - chi) < 0.01);
        QVERIFY(made.joinChi(1, 11) < 0.01);

        made.join();

        QCOMPARE(made.lastOwner(), chi < 4.0 ? 0 : 1);
    }
}

void JoinTracksTest::threeBeamsBesideAPlaneStillFaceIt()
{
    for (const int gap : {2, 3, 4}) {
        Joining joining({kWall});
        joining.scan.parameters.likelihood.knownAngle = 0.0;
        joining.see({wallBy(400 + gap, 450)});

        joining.join();

        QCOMPARE(joining.lastOwner(), gap <= 3 ? 0 : kNoPlane);
    }
}

void JoinTracksTest::oneSliceWithoutThePlaneIsBridgedAndTwoAreNot_data()
{
    QTest::addColumn<int>("missing");
    QTest::addColumn<double>("tiltStep");
    QTest::addColumn<bool>("joins");

    QTest::newRow("one") << 1 << 1.16 << true;
    QTest::newRow("two") << 2 << 1.16 << false;
    // Slices within a degree and a half count as neighbours too.
    QTest::newRow("two of a fine scan") << 2 << 0.4 << true;
    QTest::newRow("three of a fine scan") << 3 << 0.4 << false;
}

void JoinTracksTest::oneSliceWithoutThePlaneIsBridgedAndTwoAreNot()
{
    QFETCH(const int, missing);
    QFETCH(const double, tiltStep);
    QFETCH(const bool, joins);
    NoddingScan scan;
    scan.parameters.likelihood.knownAngle = 0.0;
    scan.nod(6, {kWall}, degrees(85.0), degrees(tiltStep));
    scan.makePlane(scan.column(0, 0, 5), kWall);
    for (int k = 0; k < missing; ++k)
        scan.see(degrees(85.0 + (6 + k) * tiltStep), {});
    scan.see(degrees(85.0 + (6 + missing) * tiltStep), {kWall});

    joinTracks(scan.map, scan.parameters, scan.recorded.recorder);

    QCOMPARE(scan.map.segment(6).owner, joins ? 0 : kNoPlane);
}

void JoinTracksTest::aKnownPlaneIsJoinedAcrossAGap_data()
{
    QTest::addColumn<double>("factor");

    QTest::newRow("known") << 1.01;
    QTest::newRow("not known well enough") << 0.99;
}

void JoinTracksTest::aKnownPlaneIsJoinedAcrossAGap()
{
    QFETCH(const double, factor);
    Joining joining({kWall});
    joining.scan.parameters.likelihood.knownAngle =
        factor * std::sqrt(joining.scan.map.plane(0).estimate.normalVariance());
    joining.see({wallBy(440, 480)});

    joining.join();

    QCOMPARE(joining.lastOwner(), factor > 1.0 ? 0 : kNoPlane);
}

void JoinTracksTest::acrossAGapTheGateIsNarrower()
{
    // The wall goes on behind a door, 1 cm set back there.
    Joining joining({kWall}, 12);
    joining.see({wallBy(440, 480, 0.01)});
    Joining facing({kWall}, 12);
    facing.see({wallBy(395, 435, 0.01)});
    for (Joining* each : {&joining, &facing}) {
        const double chi = each->joinChi(0, 12);
        QVERIFY(chi > each->scan.parameters.likelihood.apartGate && chi < each->scan.parameters.likelihood.joinGate);
    }

    joining.join();
    facing.join();

    QCOMPARE(joining.lastOwner(), kNoPlane);
    QCOMPARE(facing.lastOwner(), 0);
}

void JoinTracksTest::whatAloneWouldTurnAPlaneJoinsOnlyToADirectionOfTheRoom_data()
{
    QTest::addColumn<double>("shift");
    QTest::addColumn<bool>("wall");
    QTest::addColumn<double>("systematic");
    QTest::addColumn<bool>("joins");

    QTest::newRow("in line, and a wall is parallel to both") << 0.0 << true << 0.0 << true;
    QTest::newRow("in line, but nothing is parallel") << 0.0 << false << 0.0 << false;
    QTest::newRow("the same of ranges that err together") << 0.0 << false << 0.0001 << true;
    QTest::newRow("out of line, and not parallel to the wall then") << 0.08 << true << 0.0 << false;
}

void JoinTracksTest::whatAloneWouldTurnAPlaneJoinsOnlyToADirectionOfTheRoom()
{
    QFETCH(const double, shift);
    QFETCH(const bool, wall);
    QFETCH(const double, systematic);
    QFETCH(const bool, joins);
    // Six beams at 4 m are 9 cm wide: with 9 mm of noise their line turns by 9 mm / 73 mm, the root of the sum of
    // squares from their middle, and 30 of them by 1.3° about the upright, a little less where they look up and see the
    // wall wider. That is some 40 mm at another face 1.9 m beside; what is 8 cm off there turns the plane by 2.4°, far
    // out of the wall's direction.
    const Surface jamb = wallBy(400, 405);
    const Surface behind = wallBy(500, 560, 2.0);
    Joining joining(wall ? std::vector{jamb, behind} : std::vector{jamb}, 30);
    QVERIFY(std::sqrt(joining.scan.map.plane(0).estimate.normalVariance()) > degrees(0.9));
    QVERIFY(std::sqrt(joining.scan.map.plane(0).estimate.normalVariance()) <
            joining.scan.parameters.likelihood.knownAngle);
    joining.see({wallBy(295, 300, shift)});
    QVERIFY(joining.joinChi(0, joining.scan.map.segments() - 1) < joining.scan.parameters.likelihood.apartGate);
    joining.scan.parameters.noise.systematic = systematic;

    joining.join();

    QCOMPARE(joining.lastOwner(), joins ? 0 : kNoPlane);
}

void JoinTracksTest::aKnownPlaneOutOfSightIsNotJoined_data()
{
    QTest::addColumn<int>("slices");

    QTest::newRow("eight slices on") << 8;
    QTest::newRow("nine slices on") << 9;
}

void JoinTracksTest::aKnownPlaneOutOfSightIsNotJoined()
{
    QFETCH(const int, slices);
    Joining joining({kWall});
    for (int k = 1; k < slices; ++k)
        joining.see({});
    joining.see({kWall});

    joining.join();

    QCOMPARE(joining.lastOwner(), slices <= 8 ? 0 : kNoPlane);
}

void JoinTracksTest::segmentsOfOneSliceJoinTogether()
{
    NoddingScan scan;
    scan.nod(6, {wallBy(300, 340), wallBy(345, 385)});
    Numbers members(12);
    std::iota(members.begin(), members.end(), 0);
    scan.makePlane(members, kWall);
    scan.see(degrees(85.0) + 6.0 * kTiltStep, {wallBy(300, 340, 0.002), wallBy(345, 385, -0.001)});

    QVERIFY(joinTracks(scan.map, scan.parameters, scan.recorded.recorder).empty());

    // They share the slice's pitch error, as the plane of all segments at once has it.
    members.insert(members.end(), {12, 13});
    const PlaneEstimate whole =
        solvedFrom(PlaneEstimate(kWall.normal, kWall.distance), members, scan.map, scan.parameters.noise, 0.0);
    QVERIFY(scan.map.plane(0).members == members);
    QVERIFY(nearlyEqual(scan.map.plane(0).estimate, whole, 1e-9));
}

void JoinTracksTest::decisionsTellTheNumbersCompared()
{
    Joining joining({kWall, {Eigen::Vector3d{-1.0, 0.0, 0.0}, 3.0, 560, 600}});
    joining.see({wallBy(320, 400, 0.003), wallBy(430, 470, 0.5)});
    const double chi = joining.joinChi(0, 12);

    joining.join();

    const auto assigned = joining.scan.recorded.decisions(DecisionKind::Assign);
    const auto rejected = joining.scan.recorded.decisions(DecisionKind::Reject);
    QCOMPARE(assigned.size(), std::size_t{1});
    QCOMPARE(segmentOf(assigned[0].operands.at(0)), (SegmentId{6, 0}));
    QCOMPARE(planeOf(assigned[0].operands.at(1)), 0);
    QCOMPARE(planeOf(assigned[0].result.at(0)), 0);
    QVERIFY(allPass(assigned[0].tests));
    QCOMPARE(testOf(assigned[0].tests, "join_chi2").value, chi);
    QCOMPARE(testOf(assigned[0].tests, "join_chi2").limit, joining.scan.parameters.likelihood.joinGate);
    QCOMPARE(rejected.size(), std::size_t{1});
    QCOMPARE(segmentOf(rejected[0].operands.at(0)), (SegmentId{6, 1}));
}

void JoinTracksTest::firstSliceHasNothingToJoin()
{
    NoddingScan scan;
    scan.see(degrees(85.0), {kWall, wallBy(420, 460)});

    QVERIFY((joinTracks(scan.map, scan.parameters, scan.recorded.recorder) == Numbers{0, 1}));
}

void JoinTracksTest::leftoverSegmentsJoinPlanesBeforeAndAfter()
{
    // The plane was made of slices 4 to 6; the wall was there from slice 2 to 8.
    NoddingScan scan;
    scan.parameters.likelihood.knownAngle = 0.0;
    scan.nod(2, {}, degrees(83.0));
    scan.nod(7, {kWall});
    scan.makePlane({2, 3, 4}, kWall);

    joinRemaining(scan.map, 0, scan.parameters, scan.recorded.recorder);

    QCOMPARE(scan.map.plane(0).members.size(), std::size_t{7});
    QVERIFY2(disagreement(scan.map).empty(), disagreement(scan.map).c_str());
    QVERIFY(apart(scan.map.plane(0).estimate, kWall) < 1e-9);
}

void JoinTracksTest::leftoverSegmentsOfTheFirstSliceFaceTwoSlicesToo()
{
    for (const int missing : {1, 5}) {
        // Slice 1 or, of the same scan the other way round, slice 5 does not see the wall.
        NoddingScan scan;
        scan.parameters.likelihood.knownAngle = 0.0;
        for (int k = 0; k < 7; ++k)
            scan.see(degrees(85.0) + k * kTiltStep, k == missing ? std::vector<Surface>{} : std::vector{kWall});
        const Numbers middle = missing == 1 ? Numbers{1, 2, 3, 4, 5} : Numbers{0, 1, 2, 3, 4};
        scan.makePlane(middle, kWall);

        joinRemaining(scan.map, 0, scan.parameters, scan.recorded.recorder);

        QCOMPARE(scan.map.plane(0).members.size(), std::size_t{6});
    }
}

void JoinTracksTest::leftoverSegmentsOfEarlierSlicesStayAsTheyAre()
{
    NoddingScan scan;
    scan.nod(9, {kWall});
    scan.makePlane({3, 4, 5}, kWall);

    joinRemaining(scan.map, 7, scan.parameters, scan.recorded.recorder);

    QVERIFY((scan.map.plane(0).members == Numbers{3, 4, 5, 7, 8}));
    // Slices from before the first on are all slices.
    joinRemaining(scan.map, -3, scan.parameters, scan.recorded.recorder);
    QCOMPARE(scan.map.plane(0).members.size(), std::size_t{9});
}

void JoinTracksTest::leftoverSegmentsJoinKnownPlanesSeenAboutThen_data()
{
    QTest::addColumn<int>("place");
    QTest::addColumn<bool>("joins");

    // The wall is seen in slices 10 to 29.
    QTest::newRow("nine slices before") << 1 << false;
    QTest::newRow("eight slices before") << 2 << true;
    QTest::newRow("while it was seen first") << 12 << true;
    QTest::newRow("eight slices after") << 37 << true;
    QTest::newRow("nine slices after") << 38 << false;
}

void JoinTracksTest::leftoverSegmentsJoinKnownPlanesSeenAboutThen()
{
    QFETCH(const int, place);
    QFETCH(const bool, joins);
    NoddingScan scan;
    for (int k = 0; k < 40; ++k) {
        std::vector<Surface> surfaces;
        if (k >= 10 && k < 30)
            surfaces.push_back(kWall);
        if (k == place)
            surfaces.push_back(wallBy(440, 480));  // across a door
        scan.see(degrees(60.0) + k * kTiltStep, surfaces);
    }
    const SegmentNumber lone = scan.map.slice(place).end - 1;
    scan.makePlane(scan.column(0, 10, 29), kWall);

    joinRemaining(scan.map, 0, scan.parameters, scan.recorded.recorder);

    QCOMPARE(scan.map.segment(lone).owner, joins ? 0 : kNoPlane);
}

void JoinTracksTest::leftoverSegmentsAreAskedAgainWhenSomethingChanged()
{
    // A gate so wide that it takes the segment in is not asked for as long as nobody tells that it has changed.
    for (const bool planeChanges : {false, true}) {
        Surface off = kWall;
        off.distance += 0.1;
        Joining wall({kWall});
        wall.see({off});
        wall.joinRest(0);
        QCOMPARE(wall.lastOwner(), kNoPlane);
        wall.scan.parameters.likelihood.joinGate = 1e9;
        wall.joinRest(0);
        QCOMPARE(wall.lastOwner(), kNoPlane);

        if (planeChanges)
            wall.scan.map.rebuild(wall.scan.map.plane(wall.ids[0]), wall.scan.parameters);
        else
            wall.scan.map.parametersChanged();
        wall.joinRest(0);

        QCOMPARE(wall.lastOwner(), wall.ids[0]);
    }
}

void JoinTracksTest::leftoverSegmentsThatFitNothingStayFree()
{
    Joining joining({kWall, wallBy(420, 460, 0.1)});
    const std::size_t before = joining.scan.map.plane(0).members.size();
    joining.see({wallBy(320, 400, 0.3), wallBy(420, 460, 0.6)});

    joining.joinRest(0);

    QVERIFY(joining.scan.recorded.report.decisions.empty());
    QCOMPARE(joining.owner(12), kNoPlane);
    QCOMPARE(joining.owner(13), kNoPlane);
    QCOMPARE(joining.scan.map.plane(0).members.size(), before);
    QCOMPARE(joining.scan.map.plane(0).changedStep, 5);
}

void JoinTracksTest::mirroredScansAreJoinedAlike()
{
    const std::vector<Surface> surfaces{wallBy(300, 360), wallBy(361, 421, 0.02)};
    const std::vector<Surface> next{wallBy(300, 325, 0.004), wallBy(330, 391, 0.009), wallBy(396, 415, 0.1)};
    const auto mirrored = [](std::vector<Surface> all) {
        std::reverse(all.begin(), all.end());
        for (Surface& surface : all)
            surface = {{-surface.normal.x(), surface.normal.y(), surface.normal.z()},
                       surface.distance,
                       kBeams - 1 - surface.lastBeam,
                       kBeams - 1 - surface.firstBeam};
        return all;
    };
    Joining left(surfaces);
    Joining right(mirrored(surfaces));
    left.see(next);
    right.see(mirrored(next));

    left.join();
    right.join();

    const std::array<PlaneId, 3> expected{0, 0, kNoPlane};
    for (int i = 0; i < 3; ++i) {
        const PlaneId mirror = right.owner(14 - i);
        QCOMPARE(left.owner(12 + i), expected[static_cast<std::size_t>(i)]);
        QCOMPARE(mirror == kNoPlane ? kNoPlane : 1 - mirror, expected[static_cast<std::size_t>(i)]);
    }
    for (const PlaneId id : {0, 1}) {
        const PlaneEstimate& a = left.scan.map.plane(id).estimate;
        const PlaneEstimate& b = right.scan.map.plane(1 - id).estimate;
        QVERIFY(std::abs(a.distance() - b.distance()) < 1e-12);
        QVERIFY((a.normal() - Eigen::Vector3d(-b.normal().x(), b.normal().y(), b.normal().z())).norm() < 1e-12);
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::JoinTracksTest)
#include "join_tracks_test.moc"
