// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <QtTest>

#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Surfaces as a mirror shows them: x turns round, and with it the order of the beams.
std::vector<Surface> mirrored(std::vector<Surface> surfaces)
{
    std::reverse(surfaces.begin(), surfaces.end());
    for (Surface& surface : surfaces) {
        surface.normal.x() = -surface.normal.x();
        surface = {surface.normal, surface.distance, kBeams - 1 - surface.lastBeam, kBeams - 1 - surface.firstBeam};
    }
    return surfaces;
}

}  // namespace

class SeedTracksTest : public QObject {
    Q_OBJECT

private slots:
    void threeSlicesOfAPlaneMakeIt_data();
    void threeSlicesOfAPlaneMakeIt();
    void segmentsOnNoCommonPlaneMakeNone_data();
    void segmentsOnNoCommonPlaneMakeNone();
    void theGateIsTheOneOfTheParameters();
    void normalsThatAreNotKnownWellMakeNone();
    void twoSlicesMakeNone();
    void segmentsThatDoNotFaceEachOtherMakeNone();
    void segmentsOfPlanesMakeNoOther();
    void newestOfThreeIsOfTheSlicesAskedFor();
    void aPlaneMetAtAGrazingAngleIsNone_data();
    void aPlaneMetAtAGrazingAngleIsNone();
    void theBestSupportedPlaneComesFirst();
    void decisionsTellTheNumbersCompared();
    void aMirroredScanHasTheMirroredPlanes();
    void aTurnedScanHasTheTurnedPlanes();
    void youngPlanesThatTurnedIntoTheirSlicesAreDropped();
};

void SeedTracksTest::threeSlicesOfAPlaneMakeIt_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::addColumn<double>("distance");
    QTest::addColumn<double>("tilt");

    QTest::newRow("wall ahead") << 0.0 << 1.0 << 0.0 << 4.0 << 85.0;
    QTest::newRow("wall turned by 30 degrees") << 0.5 << std::sqrt(0.75) << 0.0 << 3.0 << 95.0;
    QTest::newRow("floor a metre below") << 0.0 << 0.0 << -1.0 << 1.0 << 40.0;
    QTest::newRow("ceiling") << 0.0 << 0.0 << 1.0 << 1.6 << 130.0;
    QTest::newRow("ramp") << 0.0 << std::sqrt(0.5) << -std::sqrt(0.5) << 2.0 << 70.0;
    QTest::newRow("leaning out of all axes") << 2.0 / 7.0 << 6.0 / 7.0 << -3.0 / 7.0 << 2.5 << 80.0;
}

void SeedTracksTest::threeSlicesOfAPlaneMakeIt()
{
    QFETCH(const double, x);
    QFETCH(const double, y);
    QFETCH(const double, z);
    QFETCH(const double, distance);
    QFETCH(const double, tilt);
    const Surface surface{{x, y, z}, distance, 320, 400};
    NoddingScan scan;
    scan.nod(3, {surface}, degrees(tilt));

    seed(scan);

    QCOMPARE(scan.map.planes().size(), std::size_t{1});
    QVERIFY((scan.map.plane(0).members == Numbers{0, 1, 2}));
    QVERIFY(apart(scan.map.plane(0).estimate, surface) < 1e-9);
    QVERIFY(scan.map.plane(0).estimate.chi() < 1e-9);
    QVERIFY(!scan.map.plane(0).ofPair);
    QVERIFY(disagreement(scan.map).empty());
}

void SeedTracksTest::segmentsOnNoCommonPlaneMakeNone_data()
{
    QTest::addColumn<double>("offset");
    QTest::addColumn<double>("turn");

    QTest::newRow("the middle one 10 cm off") << 0.1 << 0.0;
    QTest::newRow("the middle one 3 cm off") << 0.03 << 0.0;
    QTest::newRow("the middle one turned by 3 degrees") << 0.0 << degrees(3.0);
}

void SeedTracksTest::segmentsOnNoCommonPlaneMakeNone()
{
    QFETCH(const double, offset);
    QFETCH(const double, turn);
    NoddingScan scan;
    scan.nod(3, {kWall});
    disturb(scan.map.segment(1).statistics, offset, turn);

    seed(scan);

    QVERIFY(scan.map.planes().empty());
    QVERIFY(scan.recorded.report.decisions.empty());
    for (SegmentNumber number = 0; number < 3; ++number)
        QCOMPARE(scan.map.segment(number).owner, kNoPlane);
}

void SeedTracksTest::theGateIsTheOneOfTheParameters()
{
    NoddingScan scan;
    scan.nod(3, {kWall});
    disturb(scan.map.segment(1).statistics, 0.002, 0.0);
    const double chi =
        solvedFrom(PlaneEstimate(kWall.normal, kWall.distance), {0, 1, 2}, scan.map, scan.parameters.noise, 0.0).chi();
    NoddingScan tighter = scan;
    scan.parameters.likelihood.seedGate = 1.001 * chi;
    tighter.parameters.likelihood.seedGate = 0.999 * chi;

    seed(scan);
    seed(tighter);

    QCOMPARE(scan.map.planes().size(), std::size_t{1});
    QVERIFY(tighter.map.planes().empty());
}

void SeedTracksTest::normalsThatAreNotKnownWellMakeNone()
{
    NoddingScan scan;
    scan.nod(3, {kWall});
    const double sigma = std::sqrt(
        solvedFrom(PlaneEstimate(kWall.normal, kWall.distance), {0, 1, 2}, scan.map, scan.parameters.noise, 0.0)
            .normalVariance());
    NoddingScan tighter = scan;
    scan.parameters.likelihood.seedAngle = 1.001 * sigma;
    tighter.parameters.likelihood.seedAngle = 0.999 * sigma;

    seed(scan);
    seed(tighter);

    QCOMPARE(scan.map.planes().size(), std::size_t{1});
    QVERIFY(tighter.map.planes().empty());
}

void SeedTracksTest::twoSlicesMakeNone()
{
    NoddingScan scan;
    scan.nod(2, {kWall, wallBy(410, 470)});

    seed(scan);

    QVERIFY(scan.map.planes().empty());
}

void SeedTracksTest::segmentsThatDoNotFaceEachOtherMakeNone()
{
    for (const int gap : {3, 4}) {
        NoddingScan scan;
        scan.see(degrees(85.0), {wallBy(300, 330)});
        scan.see(degrees(86.2), {wallBy(330 + gap, 360 + gap)});
        scan.see(degrees(87.4), {wallBy(360 + 2 * gap, 390 + 2 * gap)});

        seed(scan);

        QCOMPARE(scan.map.planes().size(), gap <= 3 ? std::size_t{1} : std::size_t{0});
    }
}

void SeedTracksTest::segmentsOfPlanesMakeNoOther()
{
    NoddingScan scan;
    scan.nod(3, {kWall, wallBy(410, 470)});
    scan.makePlane({1, 2, 3, 5}, kWall);

    seed(scan);

    // Of the middle slice nothing is left to make a plane with.
    QCOMPARE(scan.map.planes().size(), std::size_t{1});
    QVERIFY((scan.map.plane(0).members == Numbers{1, 2, 3, 5}));
}

void SeedTracksTest::newestOfThreeIsOfTheSlicesAskedFor()
{
    NoddingScan scan;
    scan.nod(4, {kWall});
    scan.nod(2, {}, degrees(90.0));

    seed(scan, 4);
    QVERIFY(scan.map.planes().empty());
    seed(scan, 3);

    // Slice 3 is the newest of three, and slice 0 is grown into.
    QCOMPARE(scan.map.planes().size(), std::size_t{1});
    QCOMPARE(scan.map.plane(0).members.size(), std::size_t{4});
}

void SeedTracksTest::aPlaneMetAtAGrazingAngleIsNone_data()
{
    QTest::addColumn<double>("angle");
    QTest::addColumn<bool>("made");

    QTest::newRow("2.9 degrees") << 2.9 << false;
    // The three slices meet the floor from 3.1 to 3.7 m on, 0.7 m apart in all; 0.01 degrees of pitch are 0.6 mm of
    // height there, so that its normal is known to 0.07 degrees, and 3 degrees must be exceeded by twice that.
    QTest::newRow("3.1 degrees") << 3.1 << false;
    QTest::newRow("3.4 degrees") << 3.4 << true;
}

void SeedTracksTest::aPlaneMetAtAGrazingAngleIsNone()
{
    QFETCH(const double, angle);
    QFETCH(const bool, made);
    // Below a laser on the pitch axis a floor is met at the angle of the tilt below level.
    const SensorModel centred{0.0, 0.1, 30.0};
    NoddingScan scan;
    scan.parameters.noise.pitch = degrees(0.01);
    for (const double below : {angle + 0.6, angle + 0.3, angle}) {
        const double tilt = degrees(90.0 - below);
        const Trace trace = traceOf(-Eigen::Vector3d::UnitZ(), 0.2, frameOf(tilt, centred));
        std::vector<Eigen::Vector2d> points;
        for (int beam = 355; beam <= 365; ++beam)
            points.push_back(trace.pointAt(kBearingStep * beam));
        scan.map.append(sliceAt(scan.map.slices(), tilt), centred,
                        std::vector{statisticsOf(points, 355, scan.parameters.noise)});
    }

    seed(scan);

    QCOMPARE(scan.map.planes().size(), made ? std::size_t{1} : std::size_t{0});
}

void SeedTracksTest::youngPlanesThatTurnedIntoTheirSlicesAreDropped()
{
    for (const int slices : {5, 20, 21}) {
        NoddingScan scan;
        scan.nod(slices, {kWall, kSideWall}, degrees(80.0));
        scan.makePlane(scan.column(0, 0, slices - 1), kWall);
        scan.makePlane(scan.column(1, 0, slices - 1), kSideWall);
        // A plane that holds the middle slice is met at half a nod at most by those at the ends.
        const SliceFrame& middle = scan.map.slice(slices / 2).frame;
        const Eigen::Vector3d normal = Eigen::Vector3d::UnitX().cross(middle.ahead);
        scan.map.plane(0).estimate = PlaneEstimate(normal, normal.dot(middle.origin));
        scan.parameters.planes.minIncidence = degrees(13.0);

        dropYoungGrazing(scan.map, scan.parameters, scan.recorded.recorder);

        const bool young = slices <= 20;
        QVERIFY((scan.planeIds() == (young ? std::vector<PlaneId>{1} : std::vector<PlaneId>{0, 1})));
        QCOMPARE(scan.map.segment(0).owner, young ? kNoPlane : 0);
        const auto decisions = scan.recorded.decisions(DecisionKind::NoFit);
        QCOMPARE(decisions.size(), young ? std::size_t{1} : std::size_t{0});
        if (young)
            QVERIFY(failed(decisions[0].tests) == std::vector<std::string_view>{"incidence"});
    }
}

void SeedTracksTest::theBestSupportedPlaneComesFirst()
{
    NoddingScan scan;
    scan.nod(3, {{Eigen::Vector3d::UnitX(), 2.0, 100, 120}, wallBy(300, 420), kSideWall});

    seed(scan);

    // 121, 61 and 21 beams.
    QCOMPARE(scan.map.planes().size(), std::size_t{3});
    QVERIFY(apart(scan.map.plane(0).estimate, kWall) < 1e-9);
    QVERIFY(apart(scan.map.plane(1).estimate, kSideWall) < 1e-9);
    QVERIFY(apart(scan.map.plane(2).estimate, {Eigen::Vector3d::UnitX(), 2.0}) < 1e-9);
}

void SeedTracksTest::decisionsTellTheNumbersCompared()
{
    NoddingScan scan;
    scan.nod(3, {kWall});
    disturb(scan.map.segment(1).statistics, 0.001, 0.0005);
    const PlaneEstimate expected =
        solvedFrom(PlaneEstimate(kWall.normal, kWall.distance), {0, 1, 2}, scan.map, scan.parameters.noise, 0.0);

    seed(scan);

    const auto fits = scan.recorded.decisions(DecisionKind::Fit);
    QCOMPARE(fits.size(), std::size_t{1});
    QCOMPARE(planeOf(fits[0].result.at(0)), 0);
    QVERIFY((stepsOf(fits[0]) == std::vector<int>{0, 1, 2}));
    QVERIFY(allPass(fits[0].tests));
    const Test chi = testOf(fits[0].tests, "seed_chi2");
    const Test sigma = testOf(fits[0].tests, "normal_sigma");
    QVERIFY(std::abs(chi.value / expected.chi() - 1.0) < 1e-3);
    QVERIFY(std::abs(sigma.value / std::sqrt(expected.normalVariance()) - 1.0) < 1e-3);
    QCOMPARE(chi.limit, scan.parameters.likelihood.seedGate);
    QCOMPARE(sigma.limit, scan.parameters.likelihood.seedAngle);
}

void SeedTracksTest::aMirroredScanHasTheMirroredPlanes()
{
    const std::vector<Surface> surfaces{{Eigen::Vector3d{0.8, 0.6, 0.0}, 2.0, 100, 180},
                                        {Eigen::Vector3d{0.1, 0.9, 0.2}.normalized(), 3.0, 250, 400},
                                        {Eigen::Vector3d{-0.7, 0.7, -0.1}.normalized(), 2.5, 500, 550}};
    NoddingScan scan;
    NoddingScan mirror;
    Random random(8);
    for (int k = 0; k < 10; ++k) {
        const double tilt = degrees(80.0) + k * kTiltStep;
        const SegmentNumber first = scan.see(tilt, surfaces);
        mirror.see(tilt, mirrored(surfaces));
        for (int i = 0; i < 3; ++i) {
            const double offset = 0.001 * random.normalPair().first;
            disturb(scan.map.segment(first + i).statistics, offset, 0.0);
            disturb(mirror.map.segment(first + 2 - i).statistics, offset, 0.0);
        }
    }

    seed(scan);
    seed(mirror);

    QCOMPARE(scan.map.planes().size(), std::size_t{3});
    QCOMPARE(mirror.map.planes().size(), std::size_t{3});
    for (const PlaneId id : {0, 1, 2}) {
        const PlaneEstimate& a = scan.map.plane(id).estimate;
        Eigen::Vector3d normal = mirror.map.plane(id).estimate.normal();
        normal.x() = -normal.x();
        const Surface expected{normal, mirror.map.plane(id).estimate.distance()};
        QVERIFY(apart(a, expected) < 1e-9);
        QCOMPARE(scan.map.plane(id).members.size(), std::size_t{10});
    }
}

void SeedTracksTest::aTurnedScanHasTheTurnedPlanes()
{
    // The head and the room turned together about the pitch axis: the scan is the same but for its tilts.
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(degrees(-25.0), Eigen::Vector3d::UnitX()).toRotationMatrix();
    NoddingScan scan;
    NoddingScan turned;
    Random random(9);
    for (int k = 0; k < 10; ++k) {
        SegmentStatistics s = seen(kWall, degrees(85.0) + k * kTiltStep, scan.parameters.noise);
        disturb(s, random);
        scan.add(degrees(85.0) + k * kTiltStep, {s});
        turned.add(degrees(60.0) + k * kTiltStep, {s});
    }

    seed(scan);
    seed(turned);

    QCOMPARE(scan.map.planes().size(), std::size_t{1});
    QCOMPARE(turned.map.planes().size(), std::size_t{1});
    const PlaneEstimate& plane = scan.map.plane(0).estimate;
    QVERIFY(apart(turned.map.plane(0).estimate, {turn * plane.normal(), plane.distance()}) < 1e-9);
    QVERIFY(turned.map.plane(0).members == scan.map.plane(0).members);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SeedTracksTest)
#include "seed_tracks_test.moc"
