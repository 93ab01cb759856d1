// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <QtTest>

#include "core/planes/split_and_merge.h"
#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Three short rows 0.1 m apart, 20 mm before a wall 4 m ahead, on it and 20 mm behind it: at 11° to the wall, and each
/// within 30 mm of it.
Sheet tilted(int firstStep = 3)
{
    return {{0.0, 3.98, 0.1 * firstStep}, {0.3, 0.0, 0.0}, {0.0, 0.02, 0.1}, 3, firstStep};
}

struct Absorbing {
    Parameters parameters = lenient();
    PlaneMap map;
    Recorded recorded;

    explicit Absorbing(const std::vector<Segments>& groups)
    {
        makePlanes(map, groups, parameters.planes);
        map.step = 20;
    }
    void absorb() { absorbPlanes(map, parameters, recorded.recorder); }
    std::vector<Decision> merges() const { return recorded.decisions(DecisionKind::Merge); }
};

/// A row on which no wall 4 m ahead lays a claim.
Segments rowFarBehind(int step)
{
    return {segmentBetween(step, {0.0, 4.05, 0.1 * step}, {0.3, 4.05, 0.1 * step})};
}

}  // namespace

class AbsorbPlanesTest : public QObject {
    Q_OBJECT

private slots:
    void aTiltedPlaneOnAWallGoesToTheWall();
    void theWallMayHaveTheLargerId();
    void theWallIsRefinedOverAll();
    void segmentsThatDoNotFitAreClusteredAgain();
    void aPlaneOfWhichLessIsSharedStays();
    void aPlaneWithAGapToTheWallStays();
    void aPlaneAsLargeAsTheOtherStays();
    void thePlaneThatCoversMostTakesIt();
    void planesAreAbsorbedUntilNoneIsCovered();
    void absorptionIsExplainedByTestsThatPass();
};

void AbsorbPlanesTest::aTiltedPlaneOnAWallGoesToTheWall()
{
    Absorbing absorbing({wall(10).segments(), tilted().segments()});
    mergePlanes(absorbing.map, absorbing.parameters, absorbing.recorded.recorder);
    QCOMPARE(absorbing.map.planes.size(), std::size_t{2});  // Eq. (21) does not let them merge

    absorbing.absorb();

    QVERIFY((planeIds(absorbing.map) == std::vector<PlaneId>{0}));
    QCOMPARE(absorbing.map.planes[0].members().size(), std::size_t{13});
    for (SegmentNumber number = 0; number < 13; ++number)
        QCOMPARE(absorbing.map.segments.owner(number), 0);
    QVERIFY(absorbing.map.clusters.all().empty());
    QCOMPARE(absorbing.recorded.report.counts.merges, 1);
}

void AbsorbPlanesTest::theWallMayHaveTheLargerId()
{
    Absorbing absorbing({tilted().segments(), wall(10).segments()});

    absorbing.absorb();

    QVERIFY((planeIds(absorbing.map) == std::vector<PlaneId>{1}));
    const auto plane = absorbing.map.planes[0].publish(absorbing.map.segments);
    QCOMPARE(plane->segments.size(), std::size_t{13});
    QVERIFY(plane->lineage.kind == Lineage::Kind::Merged);
    QVERIFY((plane->lineage.parents == std::vector<PlaneId>{0, 1}));
}

void AbsorbPlanesTest::theWallIsRefinedOverAll()
{
    Absorbing absorbing({wall(10).segments(), tilted().segments()});
    const auto before = absorbing.map.planes[0].publish(absorbing.map.segments);

    absorbing.absorb();

    const auto after = absorbing.map.planes[0].publish(absorbing.map.segments);
    const PlaneFit start = [] {
        PlaneFit fit;
        fit.normal = Eigen::Vector3d::UnitY();
        fit.distance = 4.0;
        return fit;
    }();
    const PlaneFit expected = refinePlane(start, endPointsOf(absorbing.map.planes[0].members(), absorbing.map.segments),
                                          absorbing.parameters.planes);
    QVERIFY(after->revision > before->revision);
    QCOMPARE(after->changedStep, 20);
    QVERIFY(angleBetween(after->normal, expected.normal) < 1e-7);
    QVERIFY(std::abs(after->distance - expected.distance) < 1e-7);
    QCOMPARE(after->points, 13 * 30);
}

void AbsorbPlanesTest::segmentsThatDoNotFitAreClusteredAgain()
{
    Absorbing absorbing({wall(10).segments(), tilted().segments() + rowFarBehind(6)});

    absorbing.absorb();

    QVERIFY((planeIds(absorbing.map) == std::vector<PlaneId>{0}));
    QCOMPARE(absorbing.map.planes[0].members().size(), std::size_t{13});
    const auto clustered = clusteredSegments(absorbing.map);
    QCOMPARE(clustered.size(), std::size_t{1});
    QCOMPARE(absorbing.map.segments[clustered[0]].start.y(), 4.05);
    QCOMPARE(absorbing.map.segments.owner(clustered[0]), kNoPlane);
}

void AbsorbPlanesTest::aPlaneOfWhichLessIsSharedStays()
{
    // Three of five rows are shared.
    const std::vector<Segments> groups{wall(10).segments(), tilted().segments() + rowFarBehind(6) + rowFarBehind(7)};
    Absorbing strict(groups);
    strict.parameters.planes.mergeShare = 0.61;
    Absorbing lax(groups);
    lax.parameters.planes.mergeShare = 0.59;

    strict.absorb();
    lax.absorb();

    QCOMPARE(strict.map.planes.size(), std::size_t{2});
    QVERIFY(strict.recorded.report.decisions.empty());
    QCOMPARE(lax.map.planes.size(), std::size_t{1});
    QVERIFY(std::abs(testOf(lax.merges()[0].tests, "shared_segments").value - 0.6) < 1e-12);
}

void AbsorbPlanesTest::aPlaneWithAGapToTheWallStays()
{
    Look beside;
    beside.firstBeam = 300;
    beside.lastBeam = 329;
    const auto rightOfTheWall = [&](double gap) {
        Sheet sheet = tilted();
        sheet.corner.x() = 1.0 + gap;
        return sheet.segments(beside);
    };
    Absorbing near({wall(10).segments(), rightOfTheWall(0.49)});
    Absorbing far({wall(10).segments(), rightOfTheWall(0.51)});

    near.absorb();
    far.absorb();

    QCOMPARE(near.map.planes.size(), std::size_t{1});
    QVERIFY(std::abs(testOf(near.merges()[0].tests, "in_plane_gap").value - 0.49) < 1e-9);
    QCOMPARE(far.map.planes.size(), std::size_t{2});
}

void AbsorbPlanesTest::aPlaneAsLargeAsTheOtherStays()
{
    Absorbing same({wall(3, 0.0, 3).segments(), tilted().segments()});
    Absorbing larger({wall(4, 0.0, 3).segments(), tilted().segments()});

    same.absorb();
    larger.absorb();

    QCOMPARE(same.map.planes.size(), std::size_t{2});
    QCOMPARE(larger.map.planes.size(), std::size_t{1});
}

void AbsorbPlanesTest::thePlaneThatCoversMostTakesIt()
{
    // Rows at 3.99 to 4.05 m: within 35.5 mm of the wall at 3.98 m are three of them, of that at 4.02 m all.
    Sheet rows = tilted();
    rows.corner.y() = 3.99;
    rows.up = {0.0, 0.01, 0.05};
    rows.rows = 7;
    Absorbing absorbing({wall(10, -0.02).segments(), wall(10, 0.02).segments(), rows.segments()});
    absorbing.parameters.planes.mergeShare = 0.1;
    absorbing.parameters.assignment.planeDistance = 0.0355;

    absorbing.absorb();

    QCOMPARE(planeOf(absorbing.merges()[0].result[0]), 1);
    QVERIFY(std::abs(testOf(absorbing.merges()[0].tests, "shared_segments").value - 1.0) < 1e-12);
}

void AbsorbPlanesTest::planesAreAbsorbedUntilNoneIsCovered()
{
    Sheet another = tilted(6);
    another.corner.y() = 4.02;
    another.up.y() = -0.02;
    Absorbing absorbing({tilted(0).segments(), wall(10).segments(), another.segments()});

    absorbing.absorb();

    QVERIFY((planeIds(absorbing.map) == std::vector<PlaneId>{1}));
    QCOMPARE(absorbing.map.planes[0].members().size(), std::size_t{16});
    QCOMPARE(absorbing.recorded.report.counts.merges, 2);
}

void AbsorbPlanesTest::absorptionIsExplainedByTestsThatPass()
{
    Absorbing absorbing({wall(10).segments(), tilted().segments() + rowFarBehind(6)});

    absorbing.absorb();

    QCOMPARE(absorbing.merges().size(), std::size_t{1});
    const Decision decision = absorbing.merges()[0];
    QVERIFY(allPass(decision.tests));
    QVERIFY(std::abs(testOf(decision.tests, "shared_segments").value - 0.75) < 1e-12);
    QCOMPARE(testOf(decision.tests, "in_plane_gap").value, 0.0);
    QCOMPARE(planeOf(decision.operands[0]), 0);
    QCOMPARE(planeOf(decision.operands[1]), 1);
    QCOMPARE(planeOf(decision.result[0]), 0);
    QCOMPARE(absorbing.recorded.decisions(DecisionKind::Cluster).size(), std::size_t{1});
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::AbsorbPlanesTest)
#include "absorb_planes_test.moc"
