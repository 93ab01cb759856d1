// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <QtTest>

#include "core/planes/split_and_merge.h"
#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A slope of 30° that rises from an edge over a wall of so many rows; no row lies on the edge.
Sheet slopeOver(int wallRows, int rows)
{
    const Eigen::Vector3d up = 0.1 * Eigen::Vector3d(0.0, std::sin(degrees(30.0)), std::cos(degrees(30.0)));
    const double edge = 0.1 * wallRows;
    return {Eigen::Vector3d(-1.0, 4.0, edge) + up, {2.0, 0.0, 0.0}, up, rows, wallRows};
}

const Eigen::Vector3d kSlopeNormal{0.0, std::cos(degrees(30.0)), -std::sin(degrees(30.0))};

/// A map with one plane, made of segments of whatever planes.
struct Crooked {
    Parameters parameters = lenient();
    PlaneMap map;
    Recorded recorded;

    explicit Crooked(const Segments& segments)
    {
        makePlanes(map, {segments}, parameters.planes);
        map.step = 20;
    }
    void split() { splitPlanes(map, parameters, recorder()); }
    StepRecorder& recorder() { return recorded.recorder; }
    std::shared_ptr<const Plane> plane(PlaneId id) { return map.plane(id).publish(map.segments); }
};

bool isThere(const Plane& plane, const Eigen::Vector3d& normal, double distance)
{
    return angleBetween(plane.normal, normal) < 1e-8 && std::abs(plane.distance - distance) < 1e-8;
}

const double kSlopeDistance = kSlopeNormal.dot(Eigen::Vector3d(0.0, 4.0, 0.7));  // over a wall of seven rows

}  // namespace

class SplitPlanesTest : public QObject {
    Q_OBJECT

private slots:
    void aPlaneOverAnEdgeBecomesTwo();
    void theLargestPartKeepsTheId();
    void theLargestPartKeepsTheIdThoughAnotherFitsBetter();
    void partsKnowWhereTheyCameFrom();
    void theKeptPlaneGoesOnFromItsRevision();
    void segmentsInNoPartAreClusteredAgain();
    void aPlaneWithoutAnyPartDisappears();
    void aPlaneWithinTheErrorLimitStaysUntouched();
    void otherPlanesStayUntouched();
    void severalPlanesAreSplitAtOnce();
    void aSplitIsExplainedByItsError();
};

void SplitPlanesTest::aPlaneOverAnEdgeBecomesTwo()
{
    Crooked crooked(wall(7).segments() + slopeOver(7, 5).segments());
    QVERIFY(crooked.map.planes[0].error() > crooked.parameters.planes.errorLimit);

    crooked.split();

    QVERIFY((planeIds(crooked.map) == std::vector<PlaneId>{0, 1}));
    QVERIFY(isThere(*crooked.plane(0), Eigen::Vector3d::UnitY(), 4.0));
    QVERIFY(isThere(*crooked.plane(1), kSlopeNormal, kSlopeDistance));
    QCOMPARE(crooked.plane(0)->segments.size(), std::size_t{7});
    QCOMPARE(crooked.plane(1)->segments.size(), std::size_t{5});
    for (SegmentNumber number = 0; number < 12; ++number)
        QCOMPARE(crooked.map.segments.owner(number), number < 7 ? 0 : 1);
    QVERIFY(crooked.map.clusters.all().empty());
}

void SplitPlanesTest::theLargestPartKeepsTheId()
{
    Crooked crooked(wall(7).segments() + slopeOver(7, 9).segments());

    crooked.split();

    QVERIFY((planeIds(crooked.map) == std::vector<PlaneId>{0, 1}));
    QVERIFY(isThere(*crooked.plane(0), kSlopeNormal, kSlopeDistance));
    QVERIFY(isThere(*crooked.plane(1), Eigen::Vector3d::UnitY(), 4.0));
}

void SplitPlanesTest::theLargestPartKeepsTheIdThoughAnotherFitsBetter()
{
    // The wall's rows are turned by turns, 20 mm to either side: by Eq. (14) the slope is the better plane.
    Segments rows;
    for (int i = 0; i < 7; ++i) {
        const double off = i % 2 == 0 ? 0.02 : -0.02;
        rows.push_back(segmentBetween(i, {-1.0, 4.0 + off, 0.1 * i}, {1.0, 4.0 - off, 0.1 * i}));
    }
    Crooked crooked(rows + slopeOver(7, 5).segments());

    crooked.split();

    QCOMPARE(crooked.plane(0)->segments.size(), std::size_t{7});
    QCOMPARE(crooked.plane(1)->segments.size(), std::size_t{5});
}

void SplitPlanesTest::partsKnowWhereTheyCameFrom()
{
    Crooked crooked(wall(7).segments() + slopeOver(7, 5).segments());

    crooked.split();

    for (const PlaneId id : {0, 1}) {
        QVERIFY(crooked.plane(id)->lineage.kind == Lineage::Kind::Split);
        QVERIFY(crooked.plane(id)->lineage.parents == std::vector<PlaneId>{0});
    }
}

void SplitPlanesTest::theKeptPlaneGoesOnFromItsRevision()
{
    Crooked crooked(wall(7).segments() + slopeOver(7, 5).segments());
    crooked.map.planes[0].refine(crooked.map.segments, crooked.parameters.planes, 15);
    const auto before = crooked.plane(0);

    crooked.split();

    QVERIFY(crooked.plane(0)->revision > before->revision);
    QCOMPARE(crooked.plane(0)->bornStep, before->bornStep);
    QCOMPARE(crooked.plane(0)->changedStep, 20);
    QCOMPARE(crooked.plane(1)->bornStep, 20);
    QCOMPARE(before->segments.size(), std::size_t{12});
}

void SplitPlanesTest::segmentsInNoPartAreClusteredAgain()
{
    Crooked crooked(wall(7).segments() + slopeOver(7, 5).segments() +
                    Segments{segmentBetween(12, {-1.0, 4.5, 0.2}, {1.0, 4.5, 0.2})});

    crooked.split();

    QCOMPARE(crooked.map.planes.size(), std::size_t{2});
    QVERIFY((clusteredSegments(crooked.map) == std::vector<SegmentNumber>{12}));
    QCOMPARE(crooked.map.segments.owner(12), kNoPlane);
    QCOMPARE(crooked.recorded.decisions(DecisionKind::Cluster).size(), std::size_t{1});
}

void SplitPlanesTest::aPlaneWithoutAnyPartDisappears()
{
    Crooked crooked(wall(4).segments() + slopeOver(4, 4).segments());
    crooked.parameters.planes.minSegments = 5;

    crooked.split();

    QVERIFY(crooked.map.planes.empty());
    QCOMPARE(clusteredSegments(crooked.map).size(), std::size_t{8});
    for (SegmentNumber number = 0; number < 8; ++number)
        QCOMPARE(crooked.map.segments.owner(number), kNoPlane);
    const auto decisions = crooked.recorded.decisions(DecisionKind::Split);
    QCOMPARE(decisions.size(), std::size_t{1});
    QVERIFY(decisions[0].result.empty());
}

void SplitPlanesTest::aPlaneWithinTheErrorLimitStaysUntouched()
{
    Crooked crooked(wall(7).segments() + slopeOver(7, 5).segments());
    crooked.parameters.planes.errorLimit = crooked.map.planes[0].error();
    const auto before = crooked.plane(0);

    crooked.split();

    QVERIFY(crooked.plane(0) == before);
    QCOMPARE(crooked.recorded.report.counts.splits, 0);
    QVERIFY(crooked.recorded.report.decisions.empty());
}

void SplitPlanesTest::otherPlanesStayUntouched()
{
    const Parameters parameters = lenient();
    Recorded recorded;
    PlaneMap map;
    makePlanes(map,
               {wall(6, -2.0).segments(), wall(7).segments() + slopeOver(7, 5).segments(), wall(6, 2.0).segments()},
               parameters.planes);
    const auto first = map.plane(0).publish(map.segments);
    const auto last = map.plane(2).publish(map.segments);

    splitPlanes(map, parameters, recorded.recorder);

    QVERIFY((planeIds(map) == std::vector<PlaneId>{0, 1, 2, 3}));
    QVERIFY(map.plane(0).publish(map.segments) == first);
    QVERIFY(map.plane(2).publish(map.segments) == last);
}

void SplitPlanesTest::severalPlanesAreSplitAtOnce()
{
    const Parameters parameters = lenient();
    Recorded recorded;
    PlaneMap map;
    Sheet above = slopeOver(7, 5);
    above.corner.y() += 2.0;
    makePlanes(map, {wall(7).segments() + slopeOver(7, 5).segments(), wall(7, 2.0).segments() + above.segments()},
               parameters.planes);

    splitPlanes(map, parameters, recorded.recorder);

    QVERIFY((planeIds(map) == std::vector<PlaneId>{0, 1, 2, 3}));
    QCOMPARE(recorded.report.counts.splits, 2);
    QVERIFY(map.plane(2).publish(map.segments)->lineage.parents == std::vector<PlaneId>{0});
    QVERIFY(map.plane(3).publish(map.segments)->lineage.parents == std::vector<PlaneId>{1});
}

void SplitPlanesTest::aSplitIsExplainedByItsError()
{
    Crooked crooked(wall(7).segments() + slopeOver(7, 5).segments());
    const double error = crooked.map.planes[0].error();

    crooked.split();

    QCOMPARE(crooked.recorded.report.counts.splits, 1);
    const auto decisions = crooked.recorded.decisions(DecisionKind::Split);
    QCOMPARE(decisions.size(), std::size_t{1});
    QCOMPARE(planeOf(decisions[0].operands[0]), 0);
    QCOMPARE(decisions[0].result.size(), std::size_t{2});
    QCOMPARE(planeOf(decisions[0].result[0]), 0);
    QCOMPARE(planeOf(decisions[0].result[1]), 1);
    QVERIFY(allPass(decisions[0].tests));
    QCOMPARE(testOf(decisions[0].tests, "fitting_error").value, error);
    QCOMPARE(testOf(decisions[0].tests, "fitting_error").limit, 4.0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SplitPlanesTest)
#include "split_planes_test.moc"
