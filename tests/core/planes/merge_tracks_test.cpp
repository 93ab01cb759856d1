// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <QtTest>

#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

using Ids = std::vector<PlaneId>;

/// Ten slices that see surfaces from right to left, and a plane of each in this order.
struct TrackMerging {
    NoddingScan scan;

    explicit TrackMerging(const std::vector<Surface>& surfaces, int slices = 10)
    {
        scan.nod(slices, surfaces);
        for (std::size_t i = 0; i < surfaces.size(); ++i)
            scan.makePlane(scan.column(static_cast<int>(i), 0, slices - 1), surfaces[i]);
    }

    void merge() { mergeTracks(scan.map, scan.parameters, scan.recorded.recorder); }
    PlaneTrack& plane(PlaneId id) { return scan.map.plane(id); }
    double mergeChi(PlaneId a, PlaneId b)
    {
        return plane(a).estimate.mergeChi(plane(b).estimate, 0.5 * scan.parameters.flatnessFloor(), 1.0);
    }
    std::vector<Decision> nears() const { return scan.recorded.decisions(DecisionKind::Near); }
    std::vector<Decision> merges() const { return scan.recorded.decisions(DecisionKind::Merge); }
};

/// Two walls side by side, one as far behind the other as gives this χ² of their being one.
TrackMerging apartBy(double chi)
{
    // The distance enters χ² squared: planes of the same beams have the same covariance wherever they are nearly.
    double shift = 0.01;
    for (int round = 0; round < 6; ++round) {
        TrackMerging merging({wallBy(300, 355), wallBy(360, 415, shift)});
        shift *= std::sqrt(chi / merging.mergeChi(0, 1));
    }
    return TrackMerging({wallBy(300, 355), wallBy(360, 415, shift)});
}

/// Two walls side by side of which every other slice is a centimetre to the front and to the back, with much less noise
/// than that; the second is so much farther [m].
TrackMerging uneven(double shift)
{
    TrackMerging merging({}, 0);
    merging.scan.parameters.noise.rangeConstant = 0.002;
    merging.scan.parameters.noise.pitch = degrees(0.01);
    constexpr int kSlices = 30;
    for (int k = 0; k < kSlices; ++k) {
        const double stray = k % 2 == 0 ? 0.01 : -0.01;
        merging.scan.see(degrees(75.0) + k * kTiltStep, {wallBy(300, 355, stray), wallBy(360, 415, stray + shift)});
    }
    for (const int column : {0, 1})
        merging.scan.makePlane(merging.scan.column(column, 0, kSlices - 1), wallBy(300, 415, column * shift));
    return merging;
}

}  // namespace

class MergeTracksTest : public QObject {
    Q_OBJECT

private slots:
    void halvesOfAWallBecomeOne();
    void ofEqualPlanesTheOlderLives();
    void theLargerPlaneLives();
    void parallelWallsTenCentimetresApartStayTwo();
    void wallsAtAnAngleStayTwo();
    void theGateIsTheOneOfTheParameters_data();
    void theGateIsTheOneOfTheParameters();
    void planesThatAreFarApartInChiAreNotEvenNear_data();
    void planesThatAreFarApartInChiAreNotEvenNear();
    void decisionsTellTheNumbersCompared();
    void normalsMayPointEitherWay();
    void halvesAcrossAGapMergeWhereBothAreKnown_data();
    void halvesAcrossAGapMergeWhereBothAreKnown();
    void twentyBeamsApartIsSideBySide();
    void piecesOfAWallBecomeOneInOneGo();
    void aMergedPlaneMeetsTheOnesBefore();
    void aMergedPlaneIsComparedAgainHoweverLittleItGrew();
    void aMergedPlaneIsThatOfAllItsSegments();
    void planesThatDidNotGrowAreNotComparedAgain();
    void planesAreSolvedBeforeTheyAreCompared();
    void oneLongPlaneIsLeftAlone();
    void mirroredScansMergeAlike();
    void halvesOfAnUnevenWallAreOne();
    void unevenWallsThatAreTwoStayTwo();
};

void MergeTracksTest::halvesOfAWallBecomeOne()
{
    TrackMerging merging({wallBy(300, 355), wallBy(360, 415)});
    const std::uint64_t revision = merging.plane(0).revision;
    merging.plane(0).published = std::make_shared<const Plane>();

    merging.merge();

    QVERIFY((merging.scan.planeIds() == Ids{0}));
    QCOMPARE(merging.plane(0).members.size(), std::size_t{20});
    QCOMPARE(merging.plane(0).fitted, 20);
    QVERIFY2(disagreement(merging.scan.map).empty(), disagreement(merging.scan.map).c_str());
    QVERIFY(apart(merging.plane(0).estimate, kWall) < 1e-9);
    QVERIFY(merging.plane(0).revision > revision);
    QVERIFY(merging.plane(0).published == nullptr);
    QVERIFY(merging.plane(0).lineage.kind == Lineage::Kind::Merged);
    QVERIFY((merging.plane(0).lineage.parents == Ids{0, 1}));
    QCOMPARE(merging.scan.recorded.report.counts.merges, 1);
}

void MergeTracksTest::ofEqualPlanesTheOlderLives()
{
    // The older one is the one on the left.
    NoddingScan scan;
    scan.nod(10, {wallBy(300, 355), wallBy(360, 415)});
    scan.makePlane(scan.column(1, 0, 9), kWall);
    scan.makePlane(scan.column(0, 0, 9), kWall);

    mergeTracks(scan.map, scan.parameters, scan.recorded.recorder);

    QVERIFY((scan.planeIds() == Ids{0}));
    QCOMPARE(planeOf(scan.recorded.decisions(DecisionKind::Merge).at(0).result.at(0)), 0);
}

void MergeTracksTest::theLargerPlaneLives()
{
    TrackMerging merging({wallBy(300, 340), wallBy(345, 415)});

    merging.merge();

    QVERIFY((merging.scan.planeIds() == Ids{1}));
    QCOMPARE(merging.plane(1).members.size(), std::size_t{20});
    QVERIFY(disagreement(merging.scan.map).empty());
    QCOMPARE(planeOf(merging.merges().at(0).result.at(0)), 1);
    // Numbers of planes are not used twice.
    merging.scan.map.dissolve(1);
    QCOMPARE(merging.scan.makePlane({0, 2, 4}, kWall), 2);
}

void MergeTracksTest::parallelWallsTenCentimetresApartStayTwo()
{
    TrackMerging merging({wallBy(300, 355), wallBy(360, 415, 0.1)});

    merging.merge();

    QVERIFY((merging.scan.planeIds() == Ids{0, 1}));
    QVERIFY(merging.plane(0).lineage.kind == Lineage::Kind::Fitted);
    QCOMPARE(merging.scan.recorded.report.counts.merges, 0);
    QVERIFY(disagreement(merging.scan.map).empty());
}

void MergeTracksTest::wallsAtAnAngleStayTwo()
{
    // Both go through the same line between beams 355 and 360: x = 0.1, y = 4.
    const double angle = degrees(5.0);
    const Eigen::Vector3d normal{std::sin(angle), std::cos(angle), 0.0};
    TrackMerging merging({wallBy(300, 355), {normal, normal.dot(Eigen::Vector3d{0.1, 4.0, 0.0}), 360, 415}});

    merging.merge();

    QVERIFY((merging.scan.planeIds() == Ids{0, 1}));
}

void MergeTracksTest::theGateIsTheOneOfTheParameters_data()
{
    QTest::addColumn<double>("factor");

    QTest::newRow("above") << 1.01;
    QTest::newRow("below") << 0.99;
}

void MergeTracksTest::theGateIsTheOneOfTheParameters()
{
    QFETCH(const double, factor);
    TrackMerging merging = apartBy(factor * 25.0);
    QCOMPARE(merging.scan.parameters.likelihood.mergeGate, 25.0);

    merging.merge();

    QCOMPARE(merging.scan.map.planes().size(), factor < 1.0 ? std::size_t{1} : std::size_t{2});
}

void MergeTracksTest::planesThatAreFarApartInChiAreNotEvenNear_data()
{
    QTest::addColumn<double>("chi");
    QTest::addColumn<bool>("near");

    QTest::newRow("three gates") << 75.0 << true;
    QTest::newRow("five gates") << 125.0 << false;
}

void MergeTracksTest::planesThatAreFarApartInChiAreNotEvenNear()
{
    QFETCH(const double, chi);
    QFETCH(const bool, near);
    TrackMerging merging = apartBy(chi);

    merging.merge();

    QCOMPARE(merging.nears().size(), near ? std::size_t{1} : std::size_t{0});
    QVERIFY(merging.merges().empty());
}

void MergeTracksTest::decisionsTellTheNumbersCompared()
{
    for (const double chi : {10.0, 50.0}) {
        TrackMerging merging = apartBy(chi);

        merging.merge();

        const auto decided = chi < 25.0 ? merging.merges() : merging.nears();
        QCOMPARE(decided.size(), std::size_t{1});
        QCOMPARE(planeOf(decided[0].operands.at(0)), 0);
        QCOMPARE(planeOf(decided[0].operands.at(1)), 1);
        QCOMPARE(decided[0].result.empty(), chi > 25.0);
        QCOMPARE(allPass(decided[0].tests), chi < 25.0);
        const Test gate = testOf(decided[0].tests, "merge_chi2");
        QVERIFY(std::abs(gate.value / chi - 1.0) < 1e-3);
        QCOMPARE(gate.limit, 25.0);
        QVERIFY(std::abs(testOf(decided[0].tests, "normal_alignment").value - 1.0) < 1e-9);
        QCOMPARE(testOf(decided[0].tests, "adjacent").value, 1.0);
    }
}

void MergeTracksTest::normalsMayPointEitherWay()
{
    NoddingScan scan;
    scan.nod(10, {wallBy(300, 355), wallBy(360, 415)});
    scan.makePlane(scan.column(0, 0, 9), kWall);
    scan.makePlane(scan.column(1, 0, 9), {-kWall.normal, -kWall.distance});

    mergeTracks(scan.map, scan.parameters, scan.recorded.recorder);

    QVERIFY((scan.planeIds() == Ids{0}));
    QVERIFY(apart(scan.map.plane(0).estimate, kWall) < 1e-9);
}

void MergeTracksTest::halvesAcrossAGapMergeWhereBothAreKnown_data()
{
    QTest::addColumn<double>("factor");

    QTest::newRow("both known") << 1.01;
    QTest::newRow("one not known well enough") << 0.99;
}

void MergeTracksTest::halvesAcrossAGapMergeWhereBothAreKnown()
{
    QFETCH(const double, factor);
    TrackMerging merging({wallBy(300, 330), wallBy(370, 415)});
    merging.scan.parameters.likelihood.mergeAngle =
        factor *
        std::sqrt(std::max(merging.plane(0).estimate.normalVariance(), merging.plane(1).estimate.normalVariance()));

    merging.merge();

    QCOMPARE(merging.scan.map.planes().size(), factor > 1.0 ? std::size_t{1} : std::size_t{2});
    if (factor < 1.0) {
        QCOMPARE(merging.nears().size(), std::size_t{1});
        QVERIFY((failed(merging.nears()[0].tests) == std::vector<std::string_view>{"adjacent"}));
    }
}

void MergeTracksTest::twentyBeamsApartIsSideBySide()
{
    for (const int gap : {20, 21}) {
        TrackMerging merging({wallBy(300, 340), wallBy(340 + gap, 415)});
        merging.scan.parameters.likelihood.mergeAngle = 0.0;

        merging.merge();

        QCOMPARE(merging.scan.map.planes().size(), gap == 20 ? std::size_t{1} : std::size_t{2});
    }
}

void MergeTracksTest::piecesOfAWallBecomeOneInOneGo()
{
    TrackMerging merging(
        {wallBy(250, 290), wallBy(295, 360, 0.1), wallBy(365, 390), wallBy(395, 470), wallBy(475, 500)});

    merging.merge();

    // All but the second are one wall; the largest of them is the fourth.
    QVERIFY((merging.scan.planeIds() == Ids{1, 3}));
    QCOMPARE(merging.plane(3).members.size(), std::size_t{40});
    QCOMPARE(merging.scan.recorded.report.counts.merges, 3);
    QVERIFY2(disagreement(merging.scan.map).empty(), disagreement(merging.scan.map).c_str());
    QVERIFY(apart(merging.plane(3).estimate, kWall) < 1e-9);
}

void MergeTracksTest::aMergedPlaneMeetsTheOnesBefore()
{
    // Two pieces side by side that are known well enough only together, and before them one far off that is known.
    TrackMerging merging({wallBy(250, 330), wallBy(400, 425), wallBy(430, 455)});
    const double known = std::sqrt(merging.plane(0).estimate.normalVariance());
    TrackMerging pieces({wallBy(400, 425), wallBy(430, 455)});
    const double piece =
        std::sqrt(std::min(pieces.plane(0).estimate.normalVariance(), pieces.plane(1).estimate.normalVariance()));
    pieces.merge();
    const double both = std::sqrt(pieces.plane(0).estimate.normalVariance());
    QVERIFY(known < both && both < piece);
    merging.scan.parameters.likelihood.mergeAngle = 0.5 * (both + piece);

    merging.merge();

    QVERIFY((merging.scan.planeIds() == Ids{0}));
    QCOMPARE(merging.scan.recorded.report.counts.merges, 2);
}

void MergeTracksTest::aMergedPlaneIsComparedAgainHoweverLittleItGrew()
{
    // A piece that is not known well enough for one across a gap, until a fifth more is beside it.
    TrackMerging merging({wallBy(250, 330), wallBy(400, 455), wallBy(457, 467)});
    merging.scan.map.dissolve(2);
    const double piece = std::sqrt(merging.plane(1).estimate.normalVariance());
    TrackMerging more({wallBy(400, 467)});
    const double both = std::sqrt(more.plane(0).estimate.normalVariance());
    QVERIFY(both < piece);
    merging.scan.parameters.likelihood.mergeAngle = 0.5 * (both + piece);
    merging.merge();
    QCOMPARE(merging.scan.map.planes().size(), std::size_t{2});

    merging.scan.makePlane(merging.scan.column(2, 0, 9), kWall);
    merging.merge();

    QVERIFY((merging.scan.planeIds() == Ids{0}));
    QCOMPARE(merging.plane(0).members.size(), std::size_t{30});
}

void MergeTracksTest::aMergedPlaneIsThatOfAllItsSegments()
{
    NoddingScan scan;
    Random random(31);
    for (int k = 0; k < 10; ++k) {
        const double tilt = degrees(85.0) + k * kTiltStep;
        std::vector<SegmentStatistics> segments;
        for (const Surface& surface : {wallBy(300, 355), wallBy(360, 415)}) {
            segments.push_back(seen(surface, tilt, scan.parameters.noise));
            disturb(segments.back(), random);
        }
        scan.add(tilt, segments);
    }
    scan.makePlane(scan.column(0, 0, 9), kWall);
    scan.makePlane(scan.column(1, 0, 9), kWall);
    const PlaneEstimate before = scan.map.plane(0).estimate;

    mergeTracks(scan.map, scan.parameters, scan.recorded.recorder);

    QVERIFY((scan.planeIds() == Ids{0}));
    // Linearised where the larger was.
    const PlaneEstimate whole = solvedFrom(before, scan.map.plane(0).members, scan.map, scan.parameters.noise, 0.0);
    QVERIFY(nearlyEqual(scan.map.plane(0).estimate, whole, 1e-12));
    QCOMPARE(scan.map.plane(0).slices, 10);
}

void MergeTracksTest::planesThatDidNotGrowAreNotComparedAgain()
{
    TrackMerging merging = apartBy(50.0);
    merging.merge();
    QCOMPARE(merging.nears().size(), std::size_t{1});

    merging.merge();
    QCOMPARE(merging.nears().size(), std::size_t{1});

    // One of them grows, by a fifth first and then by three tenths of what it was.
    for (int k = 10; k < 13; ++k) {
        const SegmentNumber number = merging.scan.see(degrees(85.0) + k * kTiltStep, {wallBy(300, 355)});
        merging.scan.map.join(merging.plane(0), std::span{&number, 1}, k, merging.scan.parameters);
        merging.merge();
        QCOMPARE(merging.nears().size(), k < 12 ? std::size_t{1} : std::size_t{2});
    }
}

void MergeTracksTest::planesAreSolvedBeforeTheyAreCompared()
{
    // Plane 0 was made of the wall behind and has taken in one segment too many to be solved.
    TrackMerging merging({kWall}, 12);
    for (SegmentNumber number = 12; number < 14; ++number) {
        merging.scan.see(degrees(85.0) + number * kTiltStep, {wallBy(320, 400, 0.01)});
        merging.scan.map.join(merging.plane(0), std::span{&number, 1}, number, merging.scan.parameters);
    }
    QVERIFY(merging.plane(0).slicesUnsolved > 0);
    const Numbers members = merging.plane(0).members;
    const auto before = publishedPlane(merging.plane(0), merging.scan.map);

    merging.merge();

    QCOMPARE(merging.plane(0).slicesUnsolved, 0);
    const PlaneEstimate whole = solvedFrom(PlaneEstimate(kWall.normal, kWall.distance), members, merging.scan.map,
                                           merging.scan.parameters.noise, 0.0);
    QVERIFY(nearlyEqual(merging.plane(0).estimate, whole, 1e-9));
    const auto after = publishedPlane(merging.plane(0), merging.scan.map);
    QVERIFY(after->normal == merging.plane(0).estimate.normal());
    QVERIFY(after->normal != before->normal);
    QVERIFY(after->revision > before->revision);
}

void MergeTracksTest::oneLongPlaneIsLeftAlone()
{
    TrackMerging merging({kWall});
    const std::uint64_t revision = merging.plane(0).revision;

    merging.merge();

    QCOMPARE(merging.plane(0).revision, revision);
    QVERIFY(merging.scan.recorded.report.decisions.empty());
}

void MergeTracksTest::mirroredScansMergeAlike()
{
    const std::vector<Surface> surfaces{wallBy(250, 300), wallBy(305, 345, 0.002), wallBy(350, 420, 0.05)};
    std::vector<Surface> mirrored;
    for (auto surface = surfaces.rbegin(); surface != surfaces.rend(); ++surface)
        mirrored.push_back(
            {surface->normal, surface->distance, kBeams - 1 - surface->lastBeam, kBeams - 1 - surface->firstBeam});
    TrackMerging merging(surfaces);
    TrackMerging mirror(mirrored);

    merging.merge();
    mirror.merge();

    QVERIFY((merging.scan.planeIds() == Ids{0, 2}));
    QVERIFY((mirror.scan.planeIds() == Ids{0, 2}));
    for (const PlaneId id : {0, 2}) {
        const PlaneEstimate& a = merging.plane(id).estimate;
        const PlaneEstimate& b = mirror.plane(2 - id).estimate;
        QVERIFY(apart(a, {{-b.normal().x(), b.normal().y(), b.normal().z()}, b.distance()}) < 1e-12);
    }
}

void MergeTracksTest::halvesOfAnUnevenWallAreOne()
{
    // 8 mm apart: many times what the noise tells, and less than each strays itself. One plane between them would
    // explain both (10² + 4²)/10² = 1.16 times as badly, and one that turns towards both less than that.
    TrackMerging merging = uneven(0.008);
    QVERIFY(merging.mergeChi(0, 1) > merging.scan.parameters.likelihood.mergeGate);

    merging.merge();

    QCOMPARE(merging.scan.map.planes().size(), std::size_t{1});
    const Test worse = testOf(merging.merges().at(0).tests, "worse_together");
    QVERIFY2(worse.pass() && worse.value < 1.16, qPrintable(QString::number(worse.value)));
}

void MergeTracksTest::unevenWallsThatAreTwoStayTwo()
{
    TrackMerging merging = uneven(0.1);

    merging.merge();

    QCOMPARE(merging.scan.map.planes().size(), std::size_t{2});
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MergeTracksTest)
#include "merge_tracks_test.moc"
