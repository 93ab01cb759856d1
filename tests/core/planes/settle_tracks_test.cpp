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
#include "tests/core/planes/one_wall.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

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

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SettleTracksTest)
#include "settle_tracks_test.moc"
