// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <QtTest>

#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

const Surface kGround{-Eigen::Vector3d::UnitZ(), 1.1, 250, 480};
constexpr int kLowest = 10;  // slices that see the ground alone
constexpr int kHigher = 20;  // slices above the one where it meets the jamb
constexpr double kMeeting = degrees(45.0);

/// Where the slice at kMeeting meets the ground, ahead [m].
double meetingPlace()
{
    const SliceFrame frame = frameOf(kMeeting, kSensor);
    const double v = (kGround.distance + frame.origin.z()) / -frame.ahead.z();
    return frame.origin.y() + v * frame.ahead.y();
}

/// A jamb, 1.5° wide, that stands on the ground and looks at the scanner, so much farther than the slice's line there.
Surface jambBehind(double line)
{
    return {Eigen::Vector3d::UnitY(), meetingPlace() + line, 500, 506};
}

/// A scan of a jamb on the ground, whose plane (1) has taken that line of the ground (0).
struct JambOnGround {
    NoddingScan scan;
    SegmentNumber line = 0;
    Numbers jamb;

    /// The ground goes on behind the jamb, or ends with the line.
    explicit JambOnGround(double behind, bool groundGoesOn = true)
    {
        const Surface upright = jambBehind(behind);
        Numbers ground;
        for (int place = 0; place < kLowest + 1 + kHigher; ++place) {
            const double tilt = kMeeting + (place - kLowest) * kTiltStep;
            std::vector<Surface> seen;
            if (place <= kLowest || (groundGoesOn && place < kLowest + 10))
                seen.push_back(kGround);
            if (place > kLowest)
                seen.push_back(upright);
            const SegmentNumber first = scan.see(tilt, seen);
            if (place == kLowest)
                line = first;
            else if (seen.front().firstBeam == kGround.firstBeam)
                ground.push_back(first);
            if (place > kLowest)
                jamb.push_back(first + static_cast<SegmentNumber>(seen.size()) - 1);
        }
        QCOMPARE(scan.makePlane(ground, kGround), PlaneId{0});
        Numbers taken = jamb;
        taken.push_back(line);
        std::ranges::sort(taken);
        QCOMPARE(scan.makePlane(taken, upright), PlaneId{1});
    }
    void settle() { settleDecisive(scan.map, scan.parameters, scan.recorded.recorder); }
    PlaneId ownerOfLine() const { return scan.map.segment(line).owner; }
    PlaneTrack& plane(PlaneId id) { return scan.map.plane(id); }
};

/// Minus twice the logarithm of the density of a segment's distance and slope by a plane, from what that says of the
/// segment's two ends.
double devianceOf(SegmentNumber number, PlaneTrack& plane, NoddingScan& scan)
{
    const TrackedSegment& s = scan.map.segment(number);
    const SegmentStatistics& statistics = s.statistics;
    const SliceFrame& frame = scan.map.slice(s.slice).frame;
    const double half = 0.5 * statistics.length();
    Eigen::Matrix<double, 2, 3> ends;
    for (const int side : {-1, 1}) {
        const Eigen::Vector3d end = frame.pointAt(statistics.u + side * half * statistics.directionU,
                                                  statistics.v + side * half * statistics.directionV);
        ends.row(side < 0 ? 0 : 1) << plane.estimate.tangents().col(0).dot(end),
            plane.estimate.tangents().col(1).dot(end), -1.0;
    }
    const Eigen::Matrix2d ofEnds = ends * plane.estimate.covariance() * ends.transpose();
    Eigen::Matrix2d toMiddle;
    toMiddle << 0.5, 0.5, -0.5 / half, 0.5 / half;
    Eigen::Matrix2d covariance = toMiddle * ofEnds * toMiddle.transpose();
    const double floor = scan.parameters.flatnessFloor();
    const double steepness = scan.map.seenIn(plane, s.slice).steepness;
    covariance(0, 0) += steepness * (1.0 / statistics.offsetInformation + floor * floor);
    covariance(1, 1) += steepness * (1.0 / statistics.slopeInformation + std::pow(2.0 * floor / half, 2));
    const double chi = scan.map.joinChi(plane, number, scan.parameters.noise, floor);
    return chi + std::log(std::pow(2.0 * std::numbers::pi, 2) * covariance.determinant());
}

}  // namespace

class SettleDecisiveTest : public QObject {
    Q_OBJECT

private slots:
    void aLineOfTheGroundInAJambsPlaneIsTheGrounds();
    void whatItTurnedTurnsBack();
    void whatItsOwnPlaneForetellsAsWellStays();
    void whatNoOtherPlaneForetellsStays();
    void twoSlicesThatDecideTogetherLeaveTogether();
    void aHalfOfAPlaneIsNotAskedByTheOtherHalf();
    void whatWasDecidedIsTold();
    void aPlaneOnBothSidesHasOddsOfAHundredToOne();
};

void SettleDecisiveTest::aLineOfTheGroundInAJambsPlaneIsTheGrounds()
{
    JambOnGround scene(0.0);
    const double before = scene.plane(1).estimate.normalVariance();

    scene.settle();

    QCOMPARE(scene.ownerOfLine(), PlaneId{0});
    QVERIFY(scene.plane(1).members == scene.jamb);
    // Seven points across 4 cm tell the normal to degrees, the line across 1.5 m told it to a fraction of one.
    const double after = scene.plane(1).estimate.normalVariance();
    QVERIFY2(before < std::pow(degrees(0.25), 2), qPrintable(QString::number(toDegrees(std::sqrt(before)))));
    QVERIFY2(after > std::pow(degrees(1.0), 2), qPrintable(QString::number(toDegrees(std::sqrt(after)))));
    QCOMPARE(disagreement(scene.scan.map), std::string{});
}

void SettleDecisiveTest::whatItTurnedTurnsBack()
{
    JambOnGround scene(0.01);
    QVERIFY(apart(scene.plane(1).estimate, jambBehind(0.01)) > 0.005);

    scene.settle();

    QCOMPARE(scene.ownerOfLine(), PlaneId{0});
    QVERIFY(apart(scene.plane(1).estimate, jambBehind(0.01)) < 1e-3);
}

void SettleDecisiveTest::whatItsOwnPlaneForetellsAsWellStays()
{
    // A wall as wide as the ground; the line is one of its eleven.
    NoddingScan scan;
    const Surface wall{Eigen::Vector3d::UnitY(), meetingPlace(), 250, 480};
    Numbers ground;
    Numbers wide;
    for (int place = 0; place < 2 * kLowest + 1; ++place) {
        const SegmentNumber number =
            scan.see(kMeeting + (place - kLowest) * kTiltStep, {place < kLowest ? kGround : wall});
        (place < kLowest ? ground : wide).push_back(number);
    }
    scan.makePlane(ground, kGround);
    scan.makePlane(wide, wall);

    settleDecisive(scan.map, scan.parameters, scan.recorded.recorder);

    QVERIFY(scan.map.plane(1).members == wide);
    QVERIFY(scan.recorded.report.decisions.empty());
}

void SettleDecisiveTest::whatNoOtherPlaneForetellsStays()
{
    // The ground is 5 cm lower than the line.
    JambOnGround scene(0.0);
    NoddingScan& scan = scene.scan;
    const Surface lower{kGround.normal, kGround.distance + 0.05, 250, 480};
    Numbers members = scan.map.plane(0).members;
    scan.map.dissolve(0);
    for (const SegmentNumber number : members) {
        TrackedSegment& s = scan.map.segment(number);
        s.statistics = seen(lower, scan.map.slice(s.slice).frame.tilt, scan.parameters.noise);
    }
    QCOMPARE(scan.makePlane(members, lower), PlaneId{2});

    scene.settle();

    QCOMPARE(scene.ownerOfLine(), PlaneId{1});
}

/// Of two pieces of a wall in a jamb's plane each foretells the other.
void SettleDecisiveTest::twoSlicesThatDecideTogetherLeaveTogether()
{
    NoddingScan scan;
    const Surface jamb{kWall.normal, kWall.distance, 430, 436};
    scan.nod(21, {kWall, jamb});
    Numbers wall = scan.column(0, 0, 20);
    Numbers narrow = scan.column(1, 0, 20);
    const Numbers taken{wall[10], wall[11]};
    wall.erase(wall.begin() + 10, wall.begin() + 12);
    narrow.insert(narrow.end(), taken.begin(), taken.end());
    std::ranges::sort(narrow);
    scan.makePlane(wall, kWall);
    scan.makePlane(narrow, jamb);

    settleDecisive(scan.map, scan.parameters, scan.recorded.recorder);

    for (const SegmentNumber number : taken)
        QCOMPARE(scan.map.segment(number).owner, PlaneId{0});
    QCOMPARE(disagreement(scan.map), std::string{});
}

void SettleDecisiveTest::aHalfOfAPlaneIsNotAskedByTheOtherHalf()
{
    // The line and three others, or four: a part of them is asked by as many at least.
    const auto ownerAmong = [](std::size_t others) {
        JambOnGround scene(0.0);
        for (std::size_t i = others; i < scene.jamb.size(); ++i)
            scene.scan.map.free(scene.jamb[i]);
        for (PlaneTrack* plane : scene.scan.map.collectMembers(std::vector<PlaneId>{1}, 0))
            scene.scan.map.rebuild(*plane, scene.scan.parameters);
        scene.settle();
        return scene.ownerOfLine();
    };
    QCOMPARE(ownerAmong(3), PlaneId{1});
    QCOMPARE(ownerAmong(4), PlaneId{0});
}

void SettleDecisiveTest::whatWasDecidedIsTold()
{
    JambOnGround scene(0.0);
    JambOnGround without(0.0);
    without.scan.map.free(without.line);
    for (PlaneTrack* plane : without.scan.map.collectMembers(std::vector<PlaneId>{1}, 0))
        without.scan.map.rebuild(*plane, without.scan.parameters);

    scene.settle();

    const std::vector<Decision> decisions = scene.scan.recorded.decisions(DecisionKind::Assign);
    QVERIFY(!decisions.empty());
    const Decision& decision = decisions.front();
    QCOMPARE(planeOf(decision.operands.at(1)), PlaneId{1});
    QCOMPARE(planeOf(decision.result.at(0)), PlaneId{0});
    const Test& told = decision.tests.front();
    QCOMPARE(told.name, std::string_view{"deviance"});
    // By the ground, which is on both sides of it.
    const double byGround = devianceOf(without.line, without.plane(0), without.scan) - 2.0 * std::log(100.0);
    QVERIFY2(std::abs(told.value - byGround) < 1e-6, qPrintable(QString("%1 %2").arg(told.value).arg(byGround)));
    // By the rest of the jamb, less 2; it was linearised where the line was in it.
    const double byJamb = devianceOf(without.line, without.plane(1), without.scan) - 2.0;
    QVERIFY2(std::abs(told.limit - byJamb) < 0.3, qPrintable(QString("%1 %2").arg(told.limit).arg(byJamb)));
}

void SettleDecisiveTest::aPlaneOnBothSidesHasOddsOfAHundredToOne()
{
    const auto toldOf = [](bool groundGoesOn) {
        JambOnGround scene(0.0, groundGoesOn);
        const double own = devianceOf(scene.line, scene.plane(0), scene.scan);
        scene.settle();
        const std::vector<Decision> decisions = scene.scan.recorded.decisions(DecisionKind::Assign);
        return decisions.empty() ? std::nan("") : decisions.front().tests.front().value - own;
    };
    QVERIFY(std::abs(toldOf(true) + 2.0 * std::log(100.0)) < 1e-6);
    QVERIFY(std::abs(toldOf(false)) < 1e-6);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SettleDecisiveTest)
#include "settle_decisive_test.moc"
