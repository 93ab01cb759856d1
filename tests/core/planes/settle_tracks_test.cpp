// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <memory>
#include <string_view>
#include <vector>

#include <QtTest>

#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"

namespace planewright {
namespace {

using Numbers = std::vector<SegmentNumber>;
using Names = std::vector<std::string_view>;

/// A wall 4 m ahead that beams 320 to 400 meet.
const Surface kWall{};

Surface wallBy(int firstBeam, int lastBeam, double shift = 0.0)
{
    return {kWall.normal, kWall.distance + shift, firstBeam, lastBeam};
}

/// Ten slices of two walls side by side, the second farther by so much [m]; a segment of the first belongs to the
/// plane of the second.
struct Strayed {
    static constexpr SegmentNumber kStray = 8;
    NoddingScan scan;

    explicit Strayed(double shift)
    {
        scan.nod(10, {wallBy(300, 352), wallBy(353, 405, shift)});
        Numbers first;
        Numbers second{kStray};
        for (SegmentNumber number = 0; number < 20; ++number) {
            if (number != kStray)
                (number % 2 == 0 ? first : second).push_back(number);
        }
        scan.makePlane(first, kWall);
        scan.makePlane(second, wallBy(353, 405, shift));
    }

    double joinChi(PlaneId id)
    {
        return scan.map.joinChi(scan.map.plane(id), kStray, scan.parameters.noise, scan.parameters.flatnessFloor());
    }
    void split() { splitTracks(scan.map, scan.parameters, scan.recorded.recorder); }
    PlaneId owner() const { return scan.map.segment(kStray).owner; }
};

/// Slices of one wall and the plane of all.
struct OneWall {
    NoddingScan scan;

    explicit OneWall(int slices, const Surface& surface = kWall, double firstTilt = degrees(85.0),
                     double tiltStep = kTiltStep)
    {
        scan.nod(slices, {surface}, firstTilt, tiltStep);
        make(surface);
    }
    /// Makes the plane once more, after its segments were changed.
    void make(const Surface& surface)
    {
        if (!scan.map.planes().empty())
            scan.map.dissolve(scan.map.planes().front().id);
        scan.makePlane(scan.column(0, 0, scan.map.slices() - 1), surface);
    }
    PlaneTrack& plane() { return scan.map.planes().front(); }
    SegmentStatistics& segment(SegmentNumber number) { return scan.map.segment(number).statistics; }
    void thin() { thinTracks(scan.map, scan.parameters, scan.recorded.recorder); }
    void drop() { dropUnfounded(scan.map, scan.parameters, scan.recorded.recorder); }

    /// The tests that the plane was dropped for; empty where it was not.
    Names droppedFor()
    {
        drop();
        const auto decisions = scan.recorded.decisions(DecisionKind::NoFit);
        return decisions.empty() ? Names{} : failed(decisions.front().tests);
    }
    double reducedChi()
    {
        double sum = 0.0;
        for (const SegmentNumber number : plane().members)
            sum += plane().estimate.residualChi(plane().estimate.inSlice(scan.map.slice(number).frame), segment(number),
                                                scan.parameters.noise, scan.parameters.flatnessFloor());
        return sum / (2.0 * static_cast<double>(plane().members.size()) - 3.0);
    }
};

}  // namespace

class SettleTracksTest : public QObject {
    Q_OBJECT

private slots:
    void aSegmentOfTheNeighbourGoesOver();
    void aSegmentThatFitsNothingIsSetFree();
    void aContentSegmentStays();
    void aSegmentGoesWhereTheOtherIsBetterByTwo();
    void aSegmentOffWithinTheGateGoesToABetterPlane();
    void onlyPlanesNextToASegmentAreAsked();
    void planesThatLoseNothingStayAsTheyAre();
    void theWorstSegmentsAreThinnedOut();
    void thinningEndsWhereTheRestIsExplained();
    void threeSegmentsAndMoreThanSixtyAreNotThinned_data();
    void threeSegmentsAndMoreThanSixtyAreNotThinned();
    void aFoundedPlaneStays();
    void aPlaneFillsItsSolidAngle();
    void aPlaneHasItsSegmentsAndSlices();
    void aPairNeedsTwoSlicesOnly();
    void aNarrowPlaneThatStandsFreeIsAPole_data();
    void aNarrowPlaneThatStandsFreeIsAPole();
    void aPlaneExplainsItsSegments();
    void aPlaneOfManySegmentsNeedNotExplainThem();
    void aPlaneIsOfStraightSegments_data();
    void aPlaneIsOfStraightSegments();
    void aPlaneIsMetAtMoreThanAGrazingAngle_data();
    void aPlaneIsMetAtMoreThanAGrazingAngle();
    void droppedPlanesFreeTheirSegments();
    void lastFitIsWithoutSegmentsBeyondTheGate();
    void lastFitHasNoFloor();
    void lastFitIsPublished();
};

void SettleTracksTest::aSegmentOfTheNeighbourGoesOver()
{
    Strayed strayed(0.05);
    const double there = strayed.joinChi(1);
    const double here = strayed.joinChi(0);

    strayed.split();

    QCOMPARE(strayed.owner(), 0);
    QVERIFY2(disagreement(strayed.scan.map).empty(), disagreement(strayed.scan.map).c_str());
    QVERIFY(apart(strayed.scan.map.plane(0).estimate, kWall) < 1e-9);
    QVERIFY(apart(strayed.scan.map.plane(1).estimate, wallBy(353, 405, 0.05)) < 1e-5);
    const auto& decisions = strayed.scan.recorded.report.decisions;
    QCOMPARE(decisions.size(), std::size_t{1});
    QVERIFY(decisions[0].kind == DecisionKind::Assign);
    QCOMPARE(segmentOf(decisions[0].operands.at(0)), (SegmentId{4, 0}));
    QCOMPARE(planeOf(decisions[0].operands.at(1)), 1);
    QCOMPARE(planeOf(decisions[0].result.at(0)), 0);
    QVERIFY(allPass(decisions[0].tests));
    QCOMPARE(testOf(decisions[0].tests, "join_chi2").value, here);
    QCOMPARE(testOf(decisions[0].tests, "join_chi2").limit, there - 2.0);
}

void SettleTracksTest::aSegmentThatFitsNothingIsSetFree()
{
    OneWall wall(10);
    disturb(wall.segment(4), 0.05, 0.0);
    wall.make(kWall);
    const double chi = wall.scan.map.joinChi(wall.plane(), 4, wall.scan.parameters.noise, 0.002);

    splitTracks(wall.scan.map, wall.scan.parameters, wall.scan.recorded.recorder);

    QCOMPARE(wall.scan.map.segment(4).owner, kNoPlane);
    QCOMPARE(wall.plane().members.size(), std::size_t{9});
    QVERIFY(disagreement(wall.scan.map).empty());
    QVERIFY(apart(wall.plane().estimate, kWall) < 1e-5);
    const auto& decisions = wall.scan.recorded.report.decisions;
    QCOMPARE(decisions.size(), std::size_t{1});
    QVERIFY(decisions[0].kind == DecisionKind::Reject);
    QVERIFY(decisions[0].result.empty());
    QCOMPARE(testOf(decisions[0].tests, "join_chi2").value, chi);
    QCOMPARE(testOf(decisions[0].tests, "join_chi2").limit, wall.scan.parameters.likelihood.joinGate);
    QVERIFY(!allPass(decisions[0].tests));
}

void SettleTracksTest::aContentSegmentStays()
{
    Strayed strayed(0.002);
    QVERIFY(strayed.joinChi(1) < 2.0 && strayed.joinChi(0) < strayed.joinChi(1));

    strayed.split();

    QCOMPARE(strayed.owner(), 1);
}

void SettleTracksTest::aSegmentGoesWhereTheOtherIsBetterByTwo()
{
    for (const double gain : {1.9, 2.1}) {
        // It lies on the other plane at first; moved towards its own by halving, the other is better by so much.
        Strayed strayed(0.02);
        const SegmentStatistics on = strayed.scan.map.segment(Strayed::kStray).statistics;
        double low = -0.02;
        for (double half = 0.01; half > 1e-9; half *= 0.5) {
            SegmentStatistics& s = strayed.scan.map.segment(Strayed::kStray).statistics;
            s = on;
            disturb(s, low + half, 0.0);
            low += strayed.joinChi(1) - strayed.joinChi(0) < gain ? half : 0.0;
        }
        QVERIFY(strayed.joinChi(1) > 2.0);
        QVERIFY(std::abs(strayed.joinChi(1) - strayed.joinChi(0) - gain) < 1e-3);

        strayed.split();

        QCOMPARE(strayed.owner(), gain > 2.0 ? 0 : 1);
    }
}

void SettleTracksTest::aSegmentOffWithinTheGateGoesToABetterPlane()
{
    Strayed strayed(0.012);
    QVERIFY(strayed.joinChi(1) > 3.0 && strayed.joinChi(1) < strayed.scan.parameters.likelihood.joinGate);

    strayed.split();

    QCOMPARE(strayed.owner(), 0);
    QVERIFY(disagreement(strayed.scan.map).empty());
}

void SettleTracksTest::onlyPlanesNextToASegmentAreAsked()
{
    // The plane that the segment lies on is seen three slices on at the nearest: neighbours are two slices.
    for (const int distance : {2, 3}) {
        NoddingScan scan;
        scan.nod(6, {wallBy(300, 355)});
        scan.nod(distance - 1, {}, degrees(85.0) + 6 * kTiltStep);
        scan.nod(6, {wallBy(300, 355, 0.05)}, degrees(85.0) + (5 + distance) * kTiltStep);
        disturb(scan.map.segment(5).statistics, -0.05, 0.0);
        scan.makePlane({0, 1, 2, 3, 4, 5}, kWall);
        scan.makePlane({6, 7, 8, 9, 10, 11}, wallBy(300, 355, 0.05));

        splitTracks(scan.map, scan.parameters, scan.recorded.recorder);

        QCOMPARE(scan.map.segment(5).owner, distance == 2 ? 1 : kNoPlane);
    }
}

void SettleTracksTest::planesThatLoseNothingStayAsTheyAre()
{
    OneWall wall(10);
    const std::uint64_t revision = wall.plane().revision;

    splitTracks(wall.scan.map, wall.scan.parameters, wall.scan.recorded.recorder);
    wall.thin();

    QCOMPARE(wall.plane().revision, revision);
    QCOMPARE(wall.plane().members.size(), std::size_t{10});
    QVERIFY(wall.scan.recorded.report.decisions.empty());
}

void SettleTracksTest::theWorstSegmentsAreThinnedOut()
{
    OneWall wall(12);
    disturb(wall.segment(3), 0.02, 0.0);
    disturb(wall.segment(7), -0.05, 0.0);
    wall.make(kWall);
    const double reduced = wall.reducedChi();

    wall.thin();

    QVERIFY((wall.plane().members == Numbers{0, 1, 2, 4, 5, 6, 8, 9, 10, 11}));
    QCOMPARE(wall.plane().fitted, 10);
    QVERIFY2(disagreement(wall.scan.map).empty(), disagreement(wall.scan.map).c_str());
    QVERIFY(apart(wall.plane().estimate, kWall) < 1e-5);
    const auto splits = wall.scan.recorded.decisions(DecisionKind::Split);
    QCOMPARE(splits.size(), std::size_t{2});
    QCOMPARE(segmentOf(splits[0].operands.at(1)), (SegmentId{7, 0}));
    QCOMPARE(segmentOf(splits[1].operands.at(1)), (SegmentId{3, 0}));
    QVERIFY(allPass(splits[0].tests) && allPass(splits[1].tests));
    QCOMPARE(wall.scan.recorded.report.counts.splits, 1);
    const Test test = testOf(splits[0].tests, "reduced_chi2");
    QVERIFY(std::abs(test.value / reduced - 1.0) < 1e-12);
    // 12 segments have 2·12 − 3 degrees of freedom.
    QVERIFY(std::abs(test.limit - (1.0 + 3.0 * std::sqrt(2.0 / 21.0))) < 1e-12);
}

void SettleTracksTest::thinningEndsWhereTheRestIsExplained()
{
    OneWall wall(10);
    for (const SegmentNumber number : {1, 4, 6})
        disturb(wall.segment(number), 0.002, 0.0);
    disturb(wall.segment(8), 0.05, 0.0);
    wall.make(kWall);

    wall.thin();

    QVERIFY((wall.plane().members == Numbers{0, 1, 2, 3, 4, 5, 6, 7, 9}));
    QVERIFY(wall.reducedChi() > 0.1);
}

void SettleTracksTest::threeSegmentsAndMoreThanSixtyAreNotThinned_data()
{
    QTest::addColumn<int>("slices");
    QTest::addColumn<bool>("thinned");

    QTest::newRow("three") << 3 << false;
    QTest::newRow("four") << 4 << true;
    QTest::newRow("sixty") << 60 << true;
    QTest::newRow("sixty-one") << 61 << false;
}

void SettleTracksTest::threeSegmentsAndMoreThanSixtyAreNotThinned()
{
    QFETCH(const int, slices);
    QFETCH(const bool, thinned);
    OneWall wall(slices, kWall, degrees(60.0), degrees(1.0));
    disturb(wall.segment(1), 0.3, 0.0);
    wall.make(kWall);

    wall.thin();

    QCOMPARE(wall.plane().members.size() < static_cast<std::size_t>(slices), thinned);
}

void SettleTracksTest::aFoundedPlaneStays()
{
    OneWall wall(10);

    QVERIFY(wall.droppedFor().empty());

    QCOMPARE(wall.scan.map.planes().size(), std::size_t{1});
    QVERIFY(wall.scan.recorded.report.decisions.empty());
}

void SettleTracksTest::aPlaneFillsItsSolidAngle()
{
    // 0.0106 sr of 0.25° × 1.16° each are 120 points.
    QVERIFY(OneWall(3, wallBy(320, 359)).droppedFor().empty());
    QVERIFY((OneWall(3, wallBy(320, 358)).droppedFor() == Names{"points"}));

    // Twelve points are the least.
    OneWall few(3, wallBy(320, 323));
    OneWall fewer(3, wallBy(320, 322));
    few.scan.parameters.likelihood.minSolidAngle = 0.0;
    fewer.scan.parameters.likelihood.minSolidAngle = 0.0;
    QVERIFY(few.droppedFor().empty());
    QVERIFY((fewer.droppedFor() == Names{"points"}));
}

void SettleTracksTest::aPlaneHasItsSegmentsAndSlices()
{
    OneWall segments(4);
    segments.scan.parameters.planes.minSegments = 5;
    QVERIFY((segments.droppedFor() == Names{"segments"}));

    OneWall slices(4);
    slices.scan.parameters.planes.minSlices = 5;
    QVERIFY((slices.droppedFor() == Names{"slices"}));

    OneWall enough(5);
    enough.scan.parameters.planes.minSegments = 5;
    enough.scan.parameters.planes.minSlices = 5;
    QVERIFY(enough.droppedFor().empty());
}

void SettleTracksTest::aPairNeedsTwoSlicesOnly()
{
    OneWall wall(2);
    OneWall pair(2);
    pair.plane().ofPair = true;

    QVERIFY((wall.droppedFor() == Names{"segments", "slices"}));
    QVERIFY(pair.droppedFor().empty());
}

void SettleTracksTest::aNarrowPlaneThatStandsFreeIsAPole_data()
{
    QTest::addColumn<int>("beams");
    QTest::addColumn<int>("freeSlices");
    QTest::addColumn<bool>("pole");

    // A beam is 4 m · 0.25° = 17.5 mm wide, or a little more where the wall is met obliquely: 12 cm are six of them.
    QTest::newRow("narrow and free in 13 of 20 slices") << 7 << 13 << true;
    QTest::newRow("narrow and free in 12 of 20 slices") << 7 << 12 << false;
    QTest::newRow("nine beams wide and free in all slices") << 9 << 20 << false;
}

void SettleTracksTest::aNarrowPlaneThatStandsFreeIsAPole()
{
    QFETCH(const int, beams);
    QFETCH(const int, freeSlices);
    QFETCH(const bool, pole);
    OneWall wall(20, wallBy(360, 359 + beams), degrees(80.0));
    for (SegmentNumber number = 0; number < 20; ++number) {
        wall.segment(number).startsFree = number < freeSlices;
        wall.segment(number).endsFree = true;
    }

    QVERIFY(wall.droppedFor() == (pole ? Names{"free_strip_share"} : Names{}));

    if (pole)
        QCOMPARE(testOf(wall.scan.recorded.report.decisions[0].tests, "free_strip_share").value, freeSlices / 20.0);
}

void SettleTracksTest::aPlaneExplainsItsSegments()
{
    // Three segments have three degrees of freedom: 1 + 3·√(2/3) is the limit.
    OneWall wall(3);
    const double limit = 1.0 + 3.0 * std::sqrt(2.0 / 3.0);
    disturb(wall.segment(1), 0.0, 0.004);
    wall.make(kWall);
    const double part = wall.reducedChi() / limit;
    QVERIFY(part > 0.0);

    for (const double factor : {0.95, 1.05}) {
        // χ² goes with the square of what a segment is turned by.
        OneWall turned(3);
        disturb(turned.segment(1), 0.0, std::atan(0.004 * std::sqrt(factor / part)));
        turned.make(kWall);
        const double reduced = turned.reducedChi();
        QVERIFY(std::abs(reduced / (factor * limit) - 1.0) < 0.02);

        QVERIFY(turned.droppedFor() == (factor > 1.0 ? Names{"reduced_chi2"} : Names{}));

        if (factor > 1.0) {
            const Test test = testOf(turned.scan.recorded.report.decisions[0].tests, "reduced_chi2");
            QVERIFY(std::abs(test.value / reduced - 1.0) < 1e-12);
            QVERIFY(std::abs(test.limit - limit) < 1e-12);
        }
    }
}

void SettleTracksTest::aPlaneOfManySegmentsNeedNotExplainThem()
{
    for (const int slices : {60, 61}) {
        OneWall wall(slices, kWall, degrees(60.0), degrees(1.0));
        for (SegmentNumber number = 0; number < slices; ++number)
            disturb(wall.segment(number), number % 2 == 0 ? 0.02 : -0.02, 0.0);
        wall.make(kWall);

        QVERIFY(wall.droppedFor() == (slices == 60 ? Names{"reduced_chi2"} : Names{}));
    }
}

void SettleTracksTest::aPlaneIsOfStraightSegments_data()
{
    QTest::addColumn<double>("chi");
    QTest::addColumn<int>("segments");
    QTest::addColumn<bool>("dropped");

    // 81 points have 79 degrees of freedom: they are straight up to 2·(79 + 4·√158) = 258.6.
    QTest::newRow("six of ten bent") << 259.0 << 6 << true;
    QTest::newRow("half of them bent") << 259.0 << 5 << false;
    QTest::newRow("all of them nearly bent") << 258.0 << 10 << false;
}

void SettleTracksTest::aPlaneIsOfStraightSegments()
{
    QFETCH(const double, chi);
    QFETCH(const int, segments);
    QFETCH(const bool, dropped);
    OneWall wall(10);
    for (SegmentNumber number = 0; number < segments; ++number)
        wall.segment(number).chi = chi;

    QVERIFY(wall.droppedFor() == (dropped ? Names{"bent_share"} : Names{}));
}

void SettleTracksTest::aPlaneIsMetAtMoreThanAGrazingAngle_data()
{
    QTest::addColumn<double>("below");
    QTest::addColumn<bool>("dropped");

    // Straight ahead a floor is met at the angle by which the slice looks down: 0.1° less and more than this. At less
    // than 3° no segment can be told to belong, either.
    QTest::newRow("2.9 degrees") << 2.9 << true;
    QTest::newRow("3.1 degrees") << 3.1 << false;
}

void SettleTracksTest::aPlaneIsMetAtMoreThanAGrazingAngle()
{
    QFETCH(const double, below);
    QFETCH(const bool, dropped);
    OneWall floor(3, {-Eigen::Vector3d::UnitZ(), 0.2, 355, 365}, degrees(90.0 - below - 0.1), degrees(0.1));
    floor.scan.parameters.likelihood.minSolidAngle = 0.0;

    QVERIFY(floor.droppedFor() == (dropped ? Names{"reduced_chi2", "incidence"} : Names{}));
}

void SettleTracksTest::droppedPlanesFreeTheirSegments()
{
    NoddingScan scan;
    scan.nod(5, {wallBy(300, 303), wallBy(320, 400), wallBy(410, 413)});
    for (int i = 0; i < 3; ++i)
        scan.makePlane(scan.column(i, 0, 4), kWall);

    dropUnfounded(scan.map, scan.parameters, scan.recorded.recorder);

    QVERIFY((scan.planeIds() == std::vector<PlaneId>{1}));
    QVERIFY(disagreement(scan.map).empty());
    const auto decisions = scan.recorded.decisions(DecisionKind::NoFit);
    QCOMPARE(decisions.size(), std::size_t{2});
    QCOMPARE(planeOf(decisions[0].operands.at(0)), 0);
    QCOMPARE(planeOf(decisions[1].operands.at(0)), 2);
    QCOMPARE(testOf(decisions[0].tests, "points").value, 20.0);
}

void SettleTracksTest::lastFitIsWithoutSegmentsBeyondTheGate()
{
    OneWall wall(20, kWall, degrees(80.0));
    disturb(wall.segment(9), 0.03, 0.0);
    wall.make(kWall);
    QVERIFY(apart(wall.plane().estimate, kWall) > 1e-4);

    refineTracks(wall.scan.map, wall.scan.parameters);

    QCOMPARE(wall.plane().fitted, 19);
    QCOMPARE(wall.plane().members.size(), std::size_t{20});
    QVERIFY(disagreement(wall.scan.map).empty());
    QVERIFY(apart(wall.plane().estimate, kWall) < 1e-6);
}

void SettleTracksTest::lastFitHasNoFloor()
{
    OneWall wall(10);
    wall.scan.parameters.noise.systematic = 0.01;
    wall.make(kWall);
    const PlaneEstimate start(kWall.normal, kWall.distance);
    const Numbers members = wall.plane().members;
    QVERIFY(nearlyEqual(wall.plane().estimate,
                        solvedFrom(start, members, wall.scan.map, wall.scan.parameters.noise, 0.01), 1e-9));

    refineTracks(wall.scan.map, wall.scan.parameters);

    QVERIFY(nearlyEqual(wall.plane().estimate,
                        solvedFrom(start, members, wall.scan.map, wall.scan.parameters.noise, 0.0), 1e-9));
}

void SettleTracksTest::lastFitIsPublished()
{
    OneWall wall(20, kWall, degrees(80.0));
    disturb(wall.segment(9), 0.03, 0.0);
    wall.make(kWall);
    const auto before = publishedPlane(wall.plane(), wall.scan.map);

    refineTracks(wall.scan.map, wall.scan.parameters);

    const auto after = publishedPlane(wall.plane(), wall.scan.map);
    QVERIFY(after->normal == wall.plane().estimate.normal());
    QVERIFY(after->normal != before->normal);
    QVERIFY(after->revision > before->revision);
}

}  // namespace planewright

QTEST_GUILESS_MAIN(planewright::SettleTracksTest)
#include "settle_tracks_test.moc"
