// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <vector>

#include <QtTest>

#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"
#include "tests/core/planes/one_wall.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A floor 1 m below that these beams meet, or one so much lower [m].
Surface floorBy(int firstBeam, int lastBeam, double lower = 0.0)
{
    return {-Eigen::Vector3d::UnitZ(), 1.0 + lower, firstBeam, lastBeam};
}

/// Slices of the floor from 1.3 to 5.6 m away, and two segments of it side by side in one slice more, 6 m away, the
/// second lower [m] and seen by the scanner at another pitch [rad] than is told.
struct FarFloor {
    static constexpr double kFarTilt = degrees(80.5);
    NoddingScan scan;
    PlaneId id = kNoPlane;

    FarFloor(double lower, double pitchError)
    {
        scan.nod(28, {floorBy(280, 440)}, degrees(48.0));
        std::vector<SegmentStatistics> far;
        for (const Surface& surface : {floorBy(300, 350), floorBy(351, 356, lower)})
            far.push_back(seen(surface, kFarTilt + pitchError, scan.parameters.noise));
        scan.add(kFarTilt, far);
        Numbers members;
        for (SegmentNumber number = 0; number < scan.map.segments(); ++number)
            members.push_back(number);
        id = scan.makePlane(members, floorBy(0, 0));
    }

    double joinChi(SegmentNumber number)
    {
        return scan.map.joinChi(scan.map.plane(id), number, scan.parameters.noise, scan.parameters.flatnessFloor());
    }
    PlaneTrack& refined()
    {
        refineTracks(scan.map, scan.parameters);
        return scan.map.plane(id);
    }
};

/// Covariance of normal and distance in space, whatever the tangents.
Eigen::Matrix4d inSpace(const PlaneEstimate& estimate)
{
    Eigen::Matrix<double, 4, 3> frame = Eigen::Matrix<double, 4, 3>::Zero();
    frame.topLeftCorner<3, 2>() = estimate.tangents();
    frame(3, 2) = 1.0;
    return frame * estimate.covariance() * frame.transpose();
}

}  // namespace

class RefineTracksTest : public QObject {
    Q_OBJECT

private slots:
    void lastFitIsWithoutSegmentsBeyondTheGate();
    void lastFitHasNoFloor();
    void lastFitIsPublished();
    void segmentsOfASliceThatContradictEachOtherDoNotBothCount();
    void segmentsOfASliceThatAreOffAlikeAllCount();
    void whatAllBordersMayBeOffIsInTheCovariance();
};

void RefineTracksTest::lastFitIsWithoutSegmentsBeyondTheGate()
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

void RefineTracksTest::lastFitHasNoFloor()
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

void RefineTracksTest::lastFitIsPublished()
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

void RefineTracksTest::segmentsOfASliceThatContradictEachOtherDoNotBothCount()
{
    FarFloor floor(0.03, 0.0);
    const double gate = floor.scan.parameters.likelihood.finalGate;
    QVERIFY(floor.joinChi(28) < gate);
    QVERIFY(floor.joinChi(29) < gate);

    const PlaneTrack& plane = floor.refined();

    QCOMPARE(plane.fitted, 29);
    QCOMPARE(plane.members.size(), std::size_t{30});
    QVERIFY(apart(plane.estimate, floorBy(0, 0)) < 1e-6);
}

void RefineTracksTest::segmentsOfASliceThatAreOffAlikeAllCount()
{
    FarFloor floor(0.0, degrees(0.1));
    const PlaneTrack& plane = floor.refined();
    QCOMPARE(plane.fitted, 30);
    QCOMPARE(plane.members.size(), std::size_t{30});
}

void RefineTracksTest::whatAllBordersMayBeOffIsInTheCovariance()
{
    // A jamb of six beams, and what its plane moves by where each slice's last, or first, point is off by a third of
    // its standard deviation.
    const Surface jamb{kWall.normal, kWall.distance, 357, 362};
    constexpr double kOff = 2.0 / 6.0;
    NoddingScan scan;
    scan.parameters.noise.rangeConstant = 0.001;
    scan.parameters.noise.rangeProportional = 0.0;
    scan.nod(12, {jamb});
    const PlaneEstimate start(jamb.normal, jamb.distance);
    const Numbers members = scan.column(0, 0, 11);
    const auto movedWith = [&](bool last) {
        NoddingScan off;
        off.parameters = scan.parameters;
        for (int place = 0; place < 12; ++place) {
            const double tilt = degrees(85.0) + place * kTiltStep;
            std::vector<Eigen::Vector2d> points = pointsOf(jamb, tilt);
            const Eigen::Vector2d along = traceOf(jamb.normal, jamb.distance, frameOf(tilt, kSensor)).direction();
            const double sigma = std::sqrt(6.0 / scan.map.segment(place).statistics.offsetInformation);
            (last ? points.back() : points.front()) += kOff * sigma * Eigen::Vector2d{-along.y(), along.x()};
            off.add(tilt, {statisticsOf(points, jamb.firstBeam, scan.parameters.noise)});
        }
        const PlaneEstimate moved = solvedFrom(start, members, off.map, scan.parameters.noise, 0.0);
        Eigen::Vector4d change;
        change << moved.normal() - jamb.normal, moved.distance() - jamb.distance;
        return change;
    };

    const PlaneId id = scan.makePlane(members, jamb);
    const Eigen::Matrix4d ofNoise = inSpace(solvedFrom(start, members, scan.map, scan.parameters.noise, 0.0));
    refineTracks(scan.map, scan.parameters);
    const Eigen::Matrix4d told = inSpace(scan.map.plane(id).estimate);

    const Eigen::Vector4d byLast = movedWith(true);
    const Eigen::Vector4d byFirst = movedWith(false);
    const Eigen::Matrix4d expected = ofNoise + byLast * byLast.transpose() + byFirst * byFirst.transpose();
    QVERIFY((told - expected).norm() < 0.06 * (expected - ofNoise).norm());

    // Ends beyond which something clearly farther follows are no borders.
    for (const SegmentNumber number : members) {
        scan.map.segment(number).statistics.startsFree = true;
        scan.map.segment(number).statistics.endsFree = true;
    }
    refineTracks(scan.map, scan.parameters);
    QVERIFY((inSpace(scan.map.plane(id).estimate) - ofNoise).norm() < 1e-6 * ofNoise.norm());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::RefineTracksTest)
#include "refine_tracks_test.moc"
