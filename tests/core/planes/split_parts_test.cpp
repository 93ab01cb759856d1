// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <numbers>
#include <vector>

#include <QtTest>

#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Ten slices that see surfaces from right to left, and one plane of all that they saw.
struct OnePlane {
    NoddingScan scan;

    explicit OnePlane(const std::vector<Surface>& surfaces) { make(surfaces); }
    OnePlane() = default;

    void make(const std::vector<Surface>& surfaces, int slices = 10)
    {
        scan.nod(slices, surfaces);
        makeOfAll();
    }
    void makeOfAll()
    {
        Numbers all;
        for (SegmentNumber number = 0; number < scan.map.segments(); ++number)
            all.push_back(number);
        QCOMPARE(scan.makePlane(all, kWall), PlaneId{0});
    }
    void split() { splitParts(scan.map, scan.parameters, scan.recorded.recorder); }
    const std::vector<PlaneTrack>& planes() const { return scan.map.planes(); }
};

}  // namespace

class SplitPartsTest : public QObject {
    Q_OBJECT

private slots:
    void aWallSeenThroughTwoDoorsStaysOne();
    void aPartThatIsOffBecomesAPlaneOfItsOwn();
    void theRestFitsWhatIsLeftOfIt();
    void eachPartThatIsOffBecomesOne();
    void whatHangsTogetherStaysTogether();
    void aGapInWhatWasSeenMakesNoTwoParts();
    void twoSegmentsApartHaveNoSay();
    void whatWasDecidedIsTold();
    void aPartThatMayLieThereByChanceIsAskedForInMaps();
    void theLimitOfChanceIsThatOfBayes();
    void chanceLeavesTheNumbersOfOtherPlanes();
};

void SplitPartsTest::aWallSeenThroughTwoDoorsStaysOne()
{
    OnePlane one({wallBy(250, 290), wallBy(320, 400), wallBy(440, 480)});

    one.split();

    QCOMPARE(one.planes().size(), std::size_t{1});
    QVERIFY(one.scan.recorded.report.decisions.empty());
    QCOMPARE(disagreement(one.scan.map), std::string{});
}

void SplitPartsTest::aPartThatIsOffBecomesAPlaneOfItsOwn()
{
    const Surface near = wallBy(320, 400);
    const Surface far = wallBy(440, 480, 0.05);
    OnePlane one({near, far});

    one.split();

    QVERIFY((one.scan.planeIds() == std::vector<PlaneId>{0, 1}));
    // The larger part keeps the number.
    QVERIFY(one.planes()[0].members == one.scan.column(0, 0, 9));
    QVERIFY(one.planes()[1].members == one.scan.column(1, 0, 9));
    QVERIFY(apart(one.planes()[0].estimate, near) < 1e-6);
    QVERIFY(apart(one.planes()[1].estimate, far) < 1e-6);
    QVERIFY(one.planes()[1].lineage.kind == Lineage::Kind::Split);
    QVERIFY(one.planes()[1].lineage.parents == std::vector<PlaneId>{0});
    QCOMPARE(disagreement(one.scan.map), std::string{});
}

void SplitPartsTest::theRestFitsWhatIsLeftOfIt()
{
    OnePlane one({wallBy(320, 400), wallBy(440, 480, 0.05)});
    QVERIFY(apart(one.planes()[0].estimate, kWall) > 0.001);

    one.split();

    QVERIFY(apart(one.planes()[0].estimate, kWall) < 1e-6);
}

void SplitPartsTest::eachPartThatIsOffBecomesOne()
{
    OnePlane one({wallBy(200, 240, -0.08), wallBy(300, 400), wallBy(440, 470, 0.08)});

    one.split();

    QCOMPARE(one.planes().size(), std::size_t{3});
    QVERIFY(one.planes()[0].members == one.scan.column(1, 0, 9));
    QCOMPARE(one.scan.recorded.report.counts.splits, 2);
    QCOMPARE(disagreement(one.scan.map), std::string{});
}

/// Twenty beams between two segments are no gap.
void SplitPartsTest::whatHangsTogetherStaysTogether()
{
    OnePlane one({wallBy(320, 400), wallBy(420, 460, 0.05)});

    one.split();

    QCOMPARE(one.planes().size(), std::size_t{1});
}

/// Two slices count as next to a slice of this tilt step: up to four are looked back.
void SplitPartsTest::aGapInWhatWasSeenMakesNoTwoParts()
{
    const auto planesAfterGap = [](int gap) {
        OnePlane one;
        one.scan.nod(6, {wallBy(320, 360)}, degrees(80.0));
        one.scan.nod(gap, {}, degrees(80.0) + 6 * kTiltStep);
        one.scan.nod(6, {wallBy(320, 360, 0.05)}, degrees(80.0) + (6 + gap) * kTiltStep);
        one.makeOfAll();
        one.split();
        return one.planes().size();
    };
    QCOMPARE(planesAfterGap(3), std::size_t{1});
    QCOMPARE(planesAfterGap(4), std::size_t{2});
}

void SplitPartsTest::twoSegmentsApartHaveNoSay()
{
    for (const int slices : {2, 3}) {
        OnePlane one;
        one.scan.nod(slices, {wallBy(320, 400), wallBy(440, 480, 0.05)});
        one.scan.nod(8, {wallBy(320, 400)}, degrees(85.0) + slices * kTiltStep);
        one.makeOfAll();

        one.split();

        QCOMPARE(one.planes().size(), std::size_t(slices < 3 ? 1 : 2));
    }
}

void SplitPartsTest::whatWasDecidedIsTold()
{
    OnePlane one({wallBy(320, 400), wallBy(440, 480, 0.05)});

    one.split();

    QCOMPARE(one.scan.recorded.report.decisions.size(), std::size_t{1});
    const Decision& decision = one.scan.recorded.report.decisions.front();
    QCOMPARE(decision.kind, DecisionKind::Split);
    QCOMPARE(planeOf(decision.operands.at(0)), PlaneId{0});
    QCOMPARE(planeOf(decision.result.at(0)), PlaneId{0});
    QCOMPARE(planeOf(decision.result.at(1)), PlaneId{1});
    const Test& told = decision.tests.front();
    QCOMPARE(told.name, std::string_view{"parts_chi2"});
    QCOMPARE(told.limit, one.scan.parameters.likelihood.mergeGate);
    // Neither part scatters: χ² is that of the two planes as they are now, but for where they were linearised, which
    // was the plane of both.
    const double chi =
        one.planes()[1].estimate.mergeChi(one.planes()[0].estimate, 0.5 * one.scan.parameters.flatnessFloor(), 1.0);
    QVERIFY(chi > told.limit);
    QVERIFY2(std::abs(told.value - chi) < 0.1 * chi, qPrintable(QString("%1 %2").arg(told.value).arg(chi)));
}

/// Three slices tell a narrow surface's normal to degrees: many another one would lie there as well.
void SplitPartsTest::aPartThatMayLieThereByChanceIsAskedForInMaps()
{
    for (const double chancePlanes : {0.0, 10.0}) {
        OnePlane one;
        one.scan.parameters.likelihood.chancePlanes = chancePlanes;
        one.scan.nod(3, {wallBy(320, 400), wallBy(440, 446)});
        one.scan.nod(8, {wallBy(320, 400)}, degrees(85.0) + 3 * kTiltStep);
        one.makeOfAll();

        one.split();

        QCOMPARE(one.planes().size(), std::size_t(chancePlanes > 0.0 ? 2 : 1));
    }
    // Two that are known well are one.
    OnePlane known;
    known.scan.parameters.likelihood.chancePlanes = 10.0;
    known.make({wallBy(250, 290), wallBy(320, 400), wallBy(440, 480)});

    known.split();

    QCOMPARE(known.planes().size(), std::size_t{1});
}

/// exp(-χ² / 2) / ((2π)^1.5 √|S|) is as much as ten planes on each square degree and metre.
void SplitPartsTest::theLimitOfChanceIsThatOfBayes()
{
    OnePlane one;
    one.scan.parameters.likelihood.chancePlanes = 10.0;
    one.make({wallBy(320, 400), wallBy(440, 480, 0.008)});

    one.split();

    QCOMPARE(one.planes().size(), std::size_t{2});
    const Test& told = one.scan.recorded.report.decisions.front().tests.front();
    QVERIFY(told.limit < one.scan.parameters.likelihood.mergeGate);
    const PlaneDisparity now =
        one.planes()[1].estimate.disparity(one.planes()[0].estimate, 0.5 * one.scan.parameters.flatnessFloor(), 1.0);
    const double likelihood =
        std::exp(-0.5 * told.limit) / std::sqrt(std::pow(2.0 * std::numbers::pi, 3) * now.determinant);
    const double density = 10.0 * std::pow(180.0 / std::numbers::pi, 2);
    QVERIFY2(std::abs(likelihood - density) < 0.1 * density, qPrintable(QString::number(likelihood / density)));
}

void SplitPartsTest::chanceLeavesTheNumbersOfOtherPlanes()
{
    const auto lineages = [](double chancePlanes) {
        NoddingScan scan;
        scan.parameters.likelihood.chancePlanes = chancePlanes;
        const Surface side{kSideWall.normal, kSideWall.distance, 530, 570};
        const Surface offSide{kSideWall.normal, kSideWall.distance + 0.05, 610, 650};
        scan.nod(3, {wallBy(320, 400), wallBy(440, 446), side, offSide});
        scan.nod(8, {wallBy(320, 400), side, offSide}, degrees(85.0) + 3 * kTiltStep);
        Numbers ahead;
        Numbers left;
        for (SegmentNumber number = 0; number < scan.map.segments(); ++number)
            (scan.map.beams(number).first < 500 ? ahead : left).push_back(number);
        scan.makePlane(ahead, kWall);
        scan.makePlane(left, kSideWall);

        splitParts(scan.map, scan.parameters, scan.recorded.recorder);

        std::vector<PlaneId> parents;
        for (const PlaneTrack& plane : scan.map.planes())
            parents.push_back(plane.lineage.parents.empty() ? kNoPlane : plane.lineage.parents.front());
        return parents;
    };
    QVERIFY((lineages(0.0) == std::vector<PlaneId>{kNoPlane, kNoPlane, 1}));
    QVERIFY((lineages(10.0) == std::vector<PlaneId>{kNoPlane, kNoPlane, 1, 0}));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SplitPartsTest)
#include "split_parts_test.moc"
