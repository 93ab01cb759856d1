// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <string_view>
#include <vector>

#include <QtTest>

#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

void pair(NoddingScan& scan)
{
    seedPairs(scan.map, scan.parameters, scan.recorded.recorder);
}

}  // namespace

class SeedPairsTest : public QObject {
    Q_OBJECT

private slots:
    void twoFacingSegmentsMakeAPlaneOfAPair();
    void aPairNeedsFortyPoints();
    void aPairSharesHalfOfTheShorter();
    void segmentsThatAreNotParallelAreNoPair();
    void theBestPartnerMakesThePair();
    void aPairParallelToAKnownPlaneComesFirst();
};

void SeedPairsTest::twoFacingSegmentsMakeAPlaneOfAPair()
{
    NoddingScan scan;
    scan.nod(2, {kWall});

    pair(scan);

    QCOMPARE(scan.map.planes().size(), std::size_t{1});
    QVERIFY(scan.map.plane(0).ofPair);
    QVERIFY(apart(scan.map.plane(0).estimate, kWall) < 1e-9);
    QVERIFY(disagreement(scan.map).empty());
    const auto fits = scan.recorded.decisions(DecisionKind::Fit);
    QCOMPARE(fits.size(), std::size_t{1});
    QVERIFY((stepsOf(fits[0]) == std::vector<int>{0, 1}));
    QVERIFY(allPass(fits[0].tests));
    QVERIFY(testOf(fits[0].tests, "pair_chi2").value < 1e-9);
    QCOMPARE(testOf(fits[0].tests, "pair_chi2").limit, scan.parameters.likelihood.joinGate);
}

void SeedPairsTest::aPairNeedsFortyPoints()
{
    for (const int lastBeam : {318, 319}) {
        NoddingScan scan;
        scan.nod(2, {wallBy(300, lastBeam)});

        pair(scan);

        QCOMPARE(scan.map.planes().size(), lastBeam == 319 ? std::size_t{1} : std::size_t{0});
    }
}

void SeedPairsTest::aPairSharesHalfOfTheShorter()
{
    for (const int shared : {19, 20}) {
        NoddingScan scan;
        scan.see(degrees(85.0), {wallBy(300, 399)});
        scan.see(degrees(86.2), {wallBy(400 - shared, 439 - shared)});

        pair(scan);

        QCOMPARE(scan.map.planes().size(), shared == 20 ? std::size_t{1} : std::size_t{0});
    }
}

void SeedPairsTest::segmentsThatAreNotParallelAreNoPair()
{
    NoddingScan scan;
    scan.nod(2, {kWall});
    disturb(scan.map.segment(1).statistics, 0.0, degrees(3.0));

    pair(scan);

    QVERIFY(scan.map.planes().empty());
}

void SeedPairsTest::theBestPartnerMakesThePair()
{
    // Two pieces of a wall faced by one, of which one is turned by a tenth of a degree.
    for (const int turned : {0, 1}) {
        NoddingScan scan;
        scan.see(degrees(85.0), {wallBy(300, 345), wallBy(350, 395)});
        disturb(scan.map.segment(turned).statistics, 0.0, degrees(0.1));
        scan.see(degrees(86.2), {wallBy(315, 385)});

        pair(scan);

        const auto fits = scan.recorded.decisions(DecisionKind::Fit);
        QCOMPARE(fits.size(), std::size_t{1});
        QCOMPARE(segmentOf(fits[0].operands.at(0)), (SegmentId{0, 1 - turned}));
    }
}

void SeedPairsTest::aPairParallelToAKnownPlaneComesFirst()
{
    // A tread and a riser seen in three slices: all three lines are parallel, and any two of them make a plane. Of the
    // two ways to pair them the one is right that makes a plane parallel to a wall, or to a floor, that is known.
    const Surface riser{Eigen::Vector3d::UnitY(), 2.0, 320, 400};
    const Surface tread{-Eigen::Vector3d::UnitZ(), 0.6, 320, 400};
    const Surface wall{Eigen::Vector3d::UnitY(), 4.0, 560, 640};
    const Surface floor{-Eigen::Vector3d::UnitZ(), 1.2, 560, 640};
    struct Way {
        std::vector<Surface> seen;
        Surface known;
        Numbers expected;
    };
    for (const Way& way : {Way{{tread, riser, riser}, wall, {2, 4}}, Way{{tread, tread, riser}, floor, {0, 2}}}) {
        NoddingScan scan;
        Numbers known;
        for (int k = 0; k < 12; ++k) {
            const double tilt = degrees(60.0) + k * kTiltStep;
            const bool pairable = k < 3;
            const SegmentNumber first =
                scan.see(tilt, pairable ? std::vector{way.seen[static_cast<std::size_t>(k)], way.known}
                                        : std::vector{way.known});
            known.push_back(pairable ? first + 1 : first);
        }
        scan.makePlane(known, way.known);

        pair(scan);

        QCOMPARE(scan.map.planes().size(), std::size_t{2});
        QVERIFY(scan.map.plane(1).members == way.expected);
        QVERIFY(scan.map.plane(1).ofPair);
        const auto fits = scan.recorded.decisions(DecisionKind::Fit);
        QCOMPARE(fits.size(), std::size_t{1});
        QVERIFY(testOf(fits[0].tests, "parallel_chi2").value < 1e-6);
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SeedPairsTest)
#include "seed_pairs_test.moc"
