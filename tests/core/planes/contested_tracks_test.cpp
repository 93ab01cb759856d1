// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/contested_tracks.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <QtTest>

#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A stair straight ahead as wide as these beams: the first of its risers 4 m away and 0.6 m below the pitch axis. Of
/// the treads at eye level and above nothing is seen.
struct Stair {
    static constexpr double kRise = 0.17;
    static constexpr double kGoing = 0.30;
    static constexpr double kFirstRiser = 4.0;
    static constexpr double kFoot = -0.6;
    static constexpr int kSteps = 8;

    static Surface riser(int step) { return {Eigen::Vector3d::UnitY(), kFirstRiser + step * kGoing, 300, 420}; }
    static Surface tread(int step) { return {-Eigen::Vector3d::UnitZ(), -(kFoot + (step + 1) * kRise), 300, 420}; }

    /// The plane through the edges of all steps.
    static Surface slope()
    {
        const Eigen::Vector3d normal = Eigen::Vector3d{0.0, kRise, -kGoing}.normalized();
        return {normal, normal.dot(Eigen::Vector3d{0.0, kFirstRiser, kFoot + kRise}), 300, 420};
    }

    /// What of it a slice sees, the same for all beams; nothing beside it.
    static std::optional<Surface> seenAt(double tilt)
    {
        const SliceFrame frame = frameOf(tilt, kSensor);
        for (int step = 0; step < kSteps; ++step) {
            const double bottom = kFoot + step * kRise;
            const double height = heightAt(kFirstRiser + step * kGoing, frame);
            if (height < bottom)
                return step == 0 ? std::nullopt : std::optional{tread(step - 1)};
            if (height < bottom + kRise)
                return riser(step);
        }
        return std::nullopt;
    }
    static double heightAt(double y, const SliceFrame& frame)
    {
        return frame.origin.z() + (y - frame.origin.y()) * frame.ahead.z() / frame.ahead.y();
    }
};

/// A scanner with a fine tilt step and much noise of the pitch, as the one that recorded an entrance hall.
NoddingScan coarseScanner()
{
    NoddingScan scan;
    scan.parameters.noise.rangeConstant = 0.01;
    scan.parameters.noise.pitch = degrees(0.1);
    scan.parameters.noise.systematic = 0.0015;
    return scan;
}

constexpr double kFineStep = degrees(0.17);

/// A scan of the stair, from its top on, and the slope over it as the plane of all its segments.
struct SlopeOverStair {
    NoddingScan scan = coarseScanner();
    std::vector<Surface> seen;  ///< in each slice

    SlopeOverStair()
    {
        for (double tilt = degrees(105.0); tilt > degrees(75.0); tilt -= kFineStep) {
            const auto surface = Stair::seenAt(tilt);
            if (!surface)
                continue;
            scan.see(tilt, {*surface});
            seen.push_back(*surface);
        }
        scan.makePlane(scan.column(0, 0, scan.map.slices() - 1), Stair::slope());
    }
    PlaneTrack& slope() { return scan.map.planes().front(); }
    void split() { splitContested(scan.map, scan.parameters, scan.recorded.recorder); }
};

/// A wall 4 m ahead that waves to and fro with its height, seen from −0.5 m to 0.5 m, as one plane.
NoddingScan wavyWall(double amplitude, double length)
{
    NoddingScan scan = coarseScanner();
    scan.parameters.noise.rangeConstant = 0.002;
    scan.parameters.noise.systematic = 0.0;
    for (double tilt = degrees(83.0); tilt < degrees(97.0); tilt += kFineStep) {
        const double height = Stair::heightAt(4.0, frameOf(tilt, kSensor));
        const double shift = amplitude * std::sin(2.0 * std::numbers::pi * height / length);
        scan.see(tilt, {wallBy(300, 420, shift)});
    }
    scan.makePlane(scan.column(0, 0, scan.map.slices() - 1), kWall);
    return scan;
}

double tiltOf(const PlaneEstimate& estimate)
{
    return toDegrees(std::acos(std::min(1.0, std::abs(estimate.normal().z()))));
}

}  // namespace

class ContestedTracksTest : public QObject {
    Q_OBJECT

private slots:
    void mostOfASlopeOverAStairIsContested();
    void aWallIsNotContested();
    void aWavyWallIsNotContested();
    void aStairIsItsRisersAndNoSlope();
    void runsOfOtherPlanesContestTheirNeighbours();
    void whatIsLeftOfASlopeIsNoPlaneEither();
    void aPlaneThatDidNotChangeIsNotAskedAgain();
};

void ContestedTracksTest::mostOfASlopeOverAStairIsContested()
{
    SlopeOverStair stair;

    // The slope is 30° steep: the three slices in a row that see one riser lean out of it by 60°.
    QVERIFY(std::abs(tiltOf(stair.slope().estimate) - toDegrees(std::atan(Stair::kRise / Stair::kGoing))) < 5.0);
    QVERIFY(contestedShare(stair.slope(), stair.scan.map, stair.scan.parameters) > 0.5);
}

void ContestedTracksTest::aWallIsNotContested()
{
    NoddingScan scan = coarseScanner();
    scan.nod(60, {wallBy(300, 420)}, degrees(85.0), kFineStep);
    scan.makePlane(scan.column(0, 0, 59), kWall);

    QCOMPARE(contestedShare(scan.map.planes().front(), scan.map, scan.parameters), 0.0);
}

void ContestedTracksTest::aWavyWallIsNotContested()
{
    // 5 mm to and fro over 1 m: it turns by 1.8° at most, though its segments are off by more than their noise.
    NoddingScan scan = wavyWall(0.005, 1.0);
    PlaneTrack& wall = scan.map.planes().front();
    QVERIFY(wall.estimate.chi() > 2.0 * (2.0 * static_cast<double>(wall.members.size()) - 3.0));

    splitContested(scan.map, scan.parameters, scan.recorded.recorder);

    QCOMPARE(contestedShare(scan.map.planes().front(), scan.map, scan.parameters), 0.0);
    QCOMPARE(scan.map.planes().size(), std::size_t{1});
    QCOMPARE(static_cast<SegmentNumber>(scan.map.planes().front().members.size()), scan.map.segments());
}

void ContestedTracksTest::aStairIsItsRisersAndNoSlope()
{
    SlopeOverStair stair;

    stair.split();

    int risers = 0;
    for (const PlaneTrack& plane : stair.scan.map.planes()) {
        const double tilt = tiltOf(plane.estimate);
        QVERIFY2(tilt < 10.0 || tilt > 60.0, qPrintable(QString::number(tilt)));
        if (tilt < 60.0)
            continue;
        ++risers;
        const Surface& of = stair.seen[static_cast<std::size_t>(stair.scan.map.segment(plane.members[1]).slice)];
        QVERIFY(apart(plane.estimate, of) < 0.2);
    }
    QVERIFY2(risers >= 6, qPrintable(QString::number(risers)));
    QVERIFY2(disagreement(stair.scan.map).empty(), disagreement(stair.scan.map).c_str());
    QCOMPARE(stair.scan.recorded.report.counts.splits, 1);
    const auto split = stair.scan.recorded.decisions(DecisionKind::Split);
    QCOMPARE(split.size(), std::size_t{1});
    QVERIFY(testOf(split[0].tests, "contested_share").pass());
}

void ContestedTracksTest::runsOfOtherPlanesContestTheirNeighbours()
{
    // The last two slices of each riser and the first of the next one but one are a slope as well: of three slices in a
    // row, two are its own.
    SlopeOverStair stair;
    stair.scan.map.dissolve(stair.slope().id);
    Numbers last;
    for (SegmentNumber number = 2; number + 1 < stair.scan.map.segments(); ++number) {
        const auto at = [&](SegmentNumber n) { return stair.seen[static_cast<std::size_t>(n)].distance; };
        if (at(number) == at(number - 2) && at(number + 1) != at(number)) {
            last.push_back(number - 1);
            last.push_back(number);
        }
    }
    stair.scan.makePlane(last, Stair::slope());

    QVERIFY(contestedShare(stair.slope(), stair.scan.map, stair.scan.parameters) > 0.5);
}

void ContestedTracksTest::whatIsLeftOfASlopeIsNoPlaneEither()
{
    SlopeOverStair stair;
    stair.split();
    Numbers edges;  // the first segment of each riser is on the slope
    for (SegmentNumber number = 1; number < stair.scan.map.segments(); ++number) {
        const auto place = static_cast<std::size_t>(number);
        if (stair.seen[place].distance != stair.seen[place - 1].distance)
            edges.push_back(number);
    }
    for (const PlaneId id : stair.scan.planeIds())
        stair.scan.map.dissolve(id);
    stair.scan.makePlane(edges, Stair::slope());
    QVERIFY(std::abs(tiltOf(stair.slope().estimate) - toDegrees(std::atan(Stair::kRise / Stair::kGoing))) < 10.0);
    stair.scan.parameters.planes.maxContested = 1.0;  // no runs speak against it: its segments' past does

    stair.split();

    QVERIFY(stair.scan.planeIds().empty());
    QVERIFY(testOf(stair.scan.recorded.decisions(DecisionKind::Split).back().tests, "contested_remains").pass());
}

void ContestedTracksTest::aPlaneThatDidNotChangeIsNotAskedAgain()
{
    SlopeOverStair stair;
    stair.slope().contestedAt = stair.slope().points;

    stair.split();

    QCOMPARE(stair.scan.map.planes().size(), std::size_t{1});
    QCOMPARE(stair.scan.recorded.report.counts.splits, 0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ContestedTracksTest)
#include "contested_tracks_test.moc"
