// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

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

}  // namespace

class RefineTracksTest : public QObject {
    Q_OBJECT

private slots:
    void lastFitIsWithoutSegmentsBeyondTheGate();
    void lastFitHasNoFloor();
    void lastFitIsPublished();
    void segmentsOfASliceThatContradictEachOtherDoNotBothCount();
    void segmentsOfASliceThatAreOffAlikeAllCount();
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

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::RefineTracksTest)
#include "refine_tracks_test.moc"
