// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>

#include <QtTest>

#include "core/planes/neighbourhood.h"
#include "core/planes/split_and_merge.h"
#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Parameters of rough walls: planes some centimetres apart still fit together.
Parameters rough()
{
    Parameters parameters = lenient();
    parameters.planes.flatness = 0.03;
    return parameters;
}

/// A map with a plane of each of these groups, and what merging them decided.
struct Merging {
    Parameters parameters;
    PlaneMap map;
    Recorded recorded;

    Merging(const std::vector<Segments>& groups, const Parameters& given) : parameters(given)
    {
        makePlanes(map, groups, parameters.planes);
        map.step = 20;
    }
    void merge() { mergePlanes(map, parameters, recorded.recorder); }
    std::vector<Decision> merges() const { return recorded.decisions(DecisionKind::Merge); }
    std::vector<Decision> nears() const { return recorded.decisions(DecisionKind::Near); }
};

/// A wall 4 m ahead from x on, 1 m wide, seen by beams from 100 per metre on.
Segments wallFrom(double x, int rows = 6)
{
    Look look;
    look.firstBeam = static_cast<int>(std::lround(1000.0 + 100.0 * x));
    look.lastBeam = look.firstBeam + 100;
    return Sheet{{x, 4.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.1}, rows, 0}.segments(look);
}

/// A wall over the height from 0 on, turned about its lower edge.
Sheet leaning(double angle, int rows = 6)
{
    return {{-1.0, 4.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.1 * std::sin(angle), 0.1 * std::cos(angle)}, rows, 0};
}

/// Segments that stray in all directions, on some plane.
Segments anySheet(Random& random, int rows)
{
    Segments segments;
    for (int row = 0; row < rows; ++row) {
        LineSegment segment = segmentBetween(row, Eigen::Vector3d(-1.0, 4.0, 0.1 * row) + 0.03 * anyVector(random),
                                             Eigen::Vector3d(1.0, 4.0, 0.1 * row) + 0.03 * anyVector(random));
        segment.startCovariance = anyCovariance(random, 0.02);
        segment.endCovariance = anyCovariance(random, 0.02);
        segments.push_back(segment);
    }
    return segments;
}

}  // namespace

class MergePlanesTest : public QObject {
    Q_OBJECT

private slots:
    void pairDistanceIsEq22WithoutNoise();
    void pairDistanceIsThatOfTheEndPointThatExceedsItsLimitMost();
    void pairDistanceOfOnePlaneSeenTwiceHasTheLimitInForce();
    void pairDistanceDoesNotDependOnTheOrder();
    void gapIsTheSmallestBetweenSegments();
    void gapBeyondWhatMattersIsOnlyKnownToBeBeyond();
    void facingPlanesHaveNoGap();
    void halvesOfAWallBecomeOne();
    void theLargerKeepsItsId();
    void ofEqualPlanesTheFirstKeepsItsId();
    void aMergedPlaneLiesBetweenTheTwo();
    void mergedPlanesKnowTheirParents();
    void normalsMayPointEitherWay();
    void planesFartherApartThanTheDistanceStayTwo();
    void planesAtALargerAngleStayTwo();
    void planesWithAGapBetweenThemStayTwo();
    void planesThatDoNotFitTogetherStayTwo();
    void planesFarApartAreNotEvenNear();
    void theNearestPairMergesFirst();
    void aMergedPlaneIsComparedAgain();
    void mergesAreExplainedByTestsThatPass();
    void nothingHappensToOnePlaneAlone();
};

void MergePlanesTest::pairDistanceIsEq22WithoutNoise()
{
    // Both planes are 0.6 m high and wide as each other; the upper edge leans 0.5·sin(2°) out of the wall, and the
    // wall's upper edge is as far from the leaning plane.
    const Merging merging({wall(6).segments(), leaning(degrees(2.0)).segments()}, lenient());
    const GrowingPlane& a = merging.map.planes[0];
    const GrowingPlane& b = merging.map.planes[1];

    const PairDistance distance = planePairDistance(a, b, merging.map.segments, merging.parameters);

    double largest = 0.0;
    for (const EndPoint& point : endPointsOf(b.members(), merging.map.segments))
        largest = std::max(largest, a.distanceTo(point.position));
    for (const EndPoint& point : endPointsOf(a.members(), merging.map.segments))
        largest = std::max(largest, b.distanceTo(point.position));
    QVERIFY(std::abs(distance.value - 0.5 * std::sin(degrees(2.0))) < 1e-8);
    QVERIFY(std::abs(distance.value - largest) < 1e-12);
    QVERIFY(std::abs(distance.limit - (0.03 + 0.025)) < 1e-12);
}

void MergePlanesTest::pairDistanceIsThatOfTheEndPointThatExceedsItsLimitMost()
{
    Parameters parameters = lenient();
    parameters.assignment.planeDistanceSigmas = 3.0;
    parameters.planes.mergeSigmas = 4.0;
    Random random(61);
    for (int trial = 0; trial < 30; ++trial) {
        const Merging merging({anySheet(random, 5), anySheet(random, 8)}, parameters);
        const SegmentTable& table = merging.map.segments;

        const PairDistance distance =
            planePairDistance(merging.map.planes[0], merging.map.planes[1], table, parameters);

        PairDistance worst;
        double worstShare = -1.0;
        for (const auto& [from, to] : {std::pair{0, 1}, std::pair{1, 0}}) {
            const GrowingPlane& other = merging.map.planes[static_cast<std::size_t>(to)];
            for (const EndPoint& point :
                 endPointsOf(merging.map.planes[static_cast<std::size_t>(from)].members(), table)) {
                const double value = std::abs(other.normal().dot(point.position) - other.distance());
                const double sigma = std::sqrt(other.normal().dot(point.covariance * other.normal()));
                const double limit =
                    std::max(0.03, 3.0 * sigma) + std::max(0.025, 4.0 * std::sqrt(other.varianceAt(point.position)));
                if (value / limit > worstShare) {
                    worstShare = value / limit;
                    worst = {value, limit};
                }
            }
        }
        QVERIFY(std::abs(distance.value - worst.value) < 1e-12);
        QVERIFY(std::abs(distance.limit - worst.limit) < 1e-12);
    }
}

void MergePlanesTest::pairDistanceOfOnePlaneSeenTwiceHasTheLimitInForce()
{
    const Parameters parameters = lenient();
    PlaneMap map;
    const auto numbers = append(map.segments, wall(6).segments());
    PlaneFit exact;
    exact.normal = Eigen::Vector3d::UnitY();
    exact.distance = 4.0;
    exact.tangents = tangentsOf(exact.normal);
    exact.information = Eigen::Matrix3d::Identity();
    map.makePlane(exact, {0, 1, 2}, parameters.planes);
    map.makePlane(exact, {3, 4, 5}, parameters.planes);

    const PairDistance distance = planePairDistance(map.planes[0], map.planes[1], map.segments, parameters);

    QCOMPARE(distance.value, 0.0);
    QVERIFY(std::abs(distance.limit - (0.03 + 0.025)) < 1e-12);
}

void MergePlanesTest::pairDistanceDoesNotDependOnTheOrder()
{
    Parameters parameters = lenient();
    parameters.planes.mergeSigmas = 3.0;
    Random random(62);
    const Merging merging({anySheet(random, 5), anySheet(random, 8)}, parameters);
    const auto& planes = merging.map.planes;

    const PairDistance there = planePairDistance(planes[0], planes[1], merging.map.segments, parameters);
    const PairDistance back = planePairDistance(planes[1], planes[0], merging.map.segments, parameters);

    QCOMPARE(there.value, back.value);
    QCOMPARE(there.limit, back.limit);
}

void MergePlanesTest::gapIsTheSmallestBetweenSegments()
{
    Random random(63);
    for (int trial = 0; trial < 50; ++trial) {
        const auto blob = [&](int firstBeam) {
            Look look;
            look.firstBeam = firstBeam;
            look.lastBeam = firstBeam + 10;
            Segments segments;
            for (int i = 0; i < 5; ++i)
                segments.push_back(segmentBetween(i, anyVector(random), anyVector(random), look));
            return segments;
        };
        const Merging merging({blob(100), blob(200)}, lenient());
        const auto& planes = merging.map.planes;

        const double gap = inPlaneGap(planes[0], planes[1], merging.map.segments, 100.0);

        double smallest = std::numeric_limits<double>::infinity();
        for (const SegmentNumber i : planes[0].members()) {
            for (const SegmentNumber j : planes[1].members())
                smallest = std::min(smallest, segmentDistance(merging.map.segments[i], merging.map.segments[j]));
        }
        QVERIFY(std::abs(gap - smallest) < 1e-12);
    }
}

void MergePlanesTest::gapBeyondWhatMattersIsOnlyKnownToBeBeyond()
{
    const Merging merging({wallFrom(-3.0), wallFrom(1.0)}, lenient());
    const auto& planes = merging.map.planes;

    QVERIFY(std::abs(inPlaneGap(planes[0], planes[1], merging.map.segments, 3.5) - 3.0) < 1e-9);
    const double beyond = inPlaneGap(planes[0], planes[1], merging.map.segments, 0.5);
    QVERIFY(beyond > 0.5);
    QVERIFY(beyond <= 3.0 + 1e-9);
}

void MergePlanesTest::facingPlanesHaveNoGap()
{
    // The same beams in slices 0 to 2 and from 7 on: five slices on they still face each other, six on no more.
    const Merging near({wall(3).segments(), wall(3, 0.0, 7).segments()}, lenient());
    const Merging far({wall(3).segments(), wall(3, 0.0, 8).segments()}, lenient());

    QCOMPARE(inPlaneGap(near.map.planes[0], near.map.planes[1], near.map.segments, 0.1), 0.0);
    QCOMPARE(inPlaneGap(near.map.planes[1], near.map.planes[0], near.map.segments, 0.1), 0.0);
    QVERIFY(std::abs(inPlaneGap(far.map.planes[0], far.map.planes[1], far.map.segments, 10.0) - 0.6) < 1e-9);
}

void MergePlanesTest::halvesOfAWallBecomeOne()
{
    Merging merging({wallFrom(-1.2), wallFrom(0.2)}, lenient());

    merging.merge();

    QVERIFY((planeIds(merging.map) == std::vector<PlaneId>{0}));
    QCOMPARE(merging.map.planes[0].members().size(), std::size_t{12});
    for (SegmentNumber number = 0; number < 12; ++number)
        QCOMPARE(merging.map.segments.owner(number), 0);
    QCOMPARE(merging.recorded.report.counts.merges, 1);
    QVERIFY(merging.nears().empty());
}

void MergePlanesTest::theLargerKeepsItsId()
{
    Merging merging({wallFrom(-1.2, 4), wallFrom(0.2, 6)}, lenient());

    merging.merge();

    QVERIFY((planeIds(merging.map) == std::vector<PlaneId>{1}));
    QCOMPARE(merging.map.planes[0].members().size(), std::size_t{10});
    for (SegmentNumber number = 0; number < 10; ++number)
        QCOMPARE(merging.map.segments.owner(number), 1);
    QCOMPARE(planeOf(merging.merges()[0].result[0]), 1);
}

void MergePlanesTest::ofEqualPlanesTheFirstKeepsItsId()
{
    Merging merging({wallFrom(-1.2), wallFrom(0.2)}, lenient());

    merging.merge();

    QCOMPARE(planeOf(merging.merges()[0].result[0]), 0);
}

void MergePlanesTest::aMergedPlaneLiesBetweenTheTwo()
{
    Merging merging({wall(6).segments(), wall(6, 0.02).segments()}, rough());

    merging.merge();

    const auto plane = merging.map.planes[0].publish(merging.map.segments);
    QVERIFY(angleBetween(plane->normal, Eigen::Vector3d::UnitY()) < 1e-8);
    QVERIFY(std::abs(plane->distance - 4.01) < 1e-8);
    QVERIFY(std::abs(plane->rms - 0.01) < 1e-8);
    QCOMPARE(plane->changedStep, 20);
}

void MergePlanesTest::mergedPlanesKnowTheirParents()
{
    Merging merging({wallFrom(-1.2, 4), wallFrom(0.2, 6)}, lenient());

    merging.merge();

    const auto plane = merging.map.planes[0].publish(merging.map.segments);
    QVERIFY(plane->lineage.kind == Lineage::Kind::Merged);
    QVERIFY((plane->lineage.parents == std::vector<PlaneId>{0, 1}));
}

void MergePlanesTest::normalsMayPointEitherWay()
{
    const Parameters parameters = lenient();
    PlaneMap map;
    Recorded recorded;
    const auto numbers = append(map.segments, wallFrom(-1.2) + wallFrom(0.2));
    const std::vector<SegmentNumber> left(numbers.begin(), numbers.begin() + 6);
    const std::vector<SegmentNumber> right(numbers.begin() + 6, numbers.end());
    makePlane(map, left, parameters.planes);
    PlaneFit backwards;
    backwards.normal = -Eigen::Vector3d::UnitY();
    backwards.distance = -4.0;
    map.makePlane(refinePlane(backwards, endPointsOf(right, map.segments), parameters.planes), right,
                  parameters.planes);

    mergePlanes(map, parameters, recorded.recorder);

    QCOMPARE(map.planes.size(), std::size_t{1});
    QVERIFY(std::abs(map.planes[0].publish(map.segments)->distance - 4.0) < 1e-9);
}

void MergePlanesTest::planesFartherApartThanTheDistanceStayTwo()
{
    // D_m of 30 mm and 25 mm on top of it.
    Merging within({wall(6).segments(), wall(6, 0.054).segments()}, rough());
    Merging beyond({wall(6).segments(), wall(6, 0.056).segments()}, rough());

    within.merge();
    beyond.merge();

    QCOMPARE(within.map.planes.size(), std::size_t{1});
    QCOMPARE(beyond.map.planes.size(), std::size_t{2});
    QVERIFY(beyond.merges().empty());
    QCOMPARE(beyond.nears().size(), std::size_t{1});
    const Decision near = beyond.nears()[0];
    QCOMPARE(planeOf(near.operands[0]), 0);
    QCOMPARE(planeOf(near.operands[1]), 1);
    QVERIFY(near.result.empty());
    QVERIFY(failed(near.tests) == std::vector<std::string_view>{"plane_distance"});
    QVERIFY(std::abs(testOf(near.tests, "plane_distance").value - 0.056) < 1e-8);
}

void MergePlanesTest::planesAtALargerAngleStayTwo()
{
    Parameters parameters = rough();
    parameters.planes.mergeDistance = 1.0;
    Merging within({wall(6).segments(), leaning(degrees(4.9)).segments()}, parameters);
    Merging beyond({wall(6).segments(), leaning(degrees(5.1)).segments()}, parameters);

    within.merge();
    beyond.merge();

    QCOMPARE(within.map.planes.size(), std::size_t{1});
    const Test alignment = testOf(within.merges()[0].tests, "normal_alignment");
    QVERIFY(std::abs(alignment.value - std::cos(degrees(4.9))) < 1e-8);
    QVERIFY(std::abs(alignment.limit - std::cos(degrees(5.0))) < 1e-12);
    QCOMPARE(beyond.map.planes.size(), std::size_t{2});
    QVERIFY(beyond.recorded.report.decisions.empty());
}

void MergePlanesTest::planesWithAGapBetweenThemStayTwo()
{
    Merging within({wallFrom(-1.0), wallFrom(0.49)}, lenient());
    Merging beyond({wallFrom(-1.0), wallFrom(0.51)}, lenient());

    within.merge();
    beyond.merge();

    QCOMPARE(within.map.planes.size(), std::size_t{1});
    QVERIFY(std::abs(testOf(within.merges()[0].tests, "in_plane_gap").value - 0.49) < 1e-9);
    QCOMPARE(beyond.map.planes.size(), std::size_t{2});
    QCOMPARE(beyond.nears().size(), std::size_t{1});
    QVERIFY(failed(beyond.nears()[0].tests) == std::vector<std::string_view>{"in_plane_gap"});
}

void MergePlanesTest::planesThatDoNotFitTogetherStayTwo()
{
    // Two like walls 50 mm apart: from the one between them each is off by 25 mm, E = 0.025²/(0.01² + flatness²).
    Parameters parameters = lenient();
    parameters.planes.flatness = 0.007;
    const double error = 0.025 * 0.025 / (0.01 * 0.01 + 0.007 * 0.007);
    parameters.planes.errorLimit = 1.001 * error;
    Merging within({wall(6).segments(), wall(6, 0.05).segments()}, parameters);
    parameters.planes.errorLimit = 0.999 * error;
    Merging beyond({wall(6).segments(), wall(6, 0.05).segments()}, parameters);

    within.merge();
    beyond.merge();

    QCOMPARE(within.map.planes.size(), std::size_t{1});
    QCOMPARE(beyond.map.planes.size(), std::size_t{2});
    QCOMPARE(beyond.nears().size(), std::size_t{1});
    QVERIFY(failed(beyond.nears()[0].tests) == std::vector<std::string_view>{"fitting_error"});
    QVERIFY(std::abs(testOf(beyond.nears()[0].tests, "fitting_error").value / error - 1.0) < 1e-6);
}

void MergePlanesTest::planesFarApartAreNotEvenNear()
{
    Merging merging({wall(6).segments(), wall(6, 1.0).segments()}, lenient());

    merging.merge();

    QCOMPARE(merging.map.planes.size(), std::size_t{2});
    QVERIFY(merging.recorded.report.decisions.empty());
    QCOMPARE(merging.recorded.report.counts.merges, 0);
}

void MergePlanesTest::theNearestPairMergesFirst()
{
    // The second and third wall are 10 mm apart, the first 20 mm before them. Merged first they lie at 4.025, and the
    // first wall's farther neighbour stays 30 mm away.
    Merging merging({wall(6).segments(), wall(6, 0.02).segments(), wall(6, 0.03).segments()}, rough());

    merging.merge();

    const auto merges = merging.merges();
    QCOMPARE(merges.size(), std::size_t{2});
    QCOMPARE(planeOf(merges[0].operands[0]), 1);
    QCOMPARE(planeOf(merges[0].operands[1]), 2);
    QVERIFY(std::abs(testOf(merges[0].tests, "plane_distance").value - 0.01) < 1e-8);
    QCOMPARE(planeOf(merges[1].operands[0]), 0);
    QCOMPARE(planeOf(merges[1].operands[1]), 1);
    QVERIFY(std::abs(testOf(merges[1].tests, "plane_distance").value - 0.03) < 1e-8);
    QVERIFY((planeIds(merging.map) == std::vector<PlaneId>{1}));
    QCOMPARE(merging.recorded.report.counts.merges, 2);
}

void MergePlanesTest::aMergedPlaneIsComparedAgain()
{
    // The outer walls are 60 mm apart and were no pair. With the middle one at 10 mm the first becomes one at 4.005,
    // from which the last is 55 mm off, while the first wall's own end points are still 60 mm from the last.
    Merging merging({wall(6).segments(), wall(6, 0.06).segments(), wall(6, 0.01).segments()}, rough());

    merging.merge();

    QCOMPARE(merging.merges().size(), std::size_t{1});
    QCOMPARE(planeOf(merging.merges()[0].operands[0]), 0);
    QCOMPARE(planeOf(merging.merges()[0].operands[1]), 2);
    QCOMPARE(merging.nears().size(), std::size_t{1});
    QVERIFY(std::abs(testOf(merging.nears()[0].tests, "plane_distance").value - 0.06) < 1e-8);
    QVERIFY((planeIds(merging.map) == std::vector<PlaneId>{0, 1}));
}

void MergePlanesTest::mergesAreExplainedByTestsThatPass()
{
    Merging merging({wallFrom(-1.2), wallFrom(0.2)}, lenient());

    merging.merge();

    QCOMPARE(merging.recorded.report.decisions.size(), std::size_t{1});
    const Decision merge = merging.merges()[0];
    QVERIFY(allPass(merge.tests));
    for (const std::string_view name : {"normal_alignment", "plane_distance", "in_plane_gap", "fitting_error"})
        QCOMPARE(testOf(merge.tests, name).name, name);
    QVERIFY(std::abs(testOf(merge.tests, "in_plane_gap").value - 0.4) < 1e-9);
}

void MergePlanesTest::nothingHappensToOnePlaneAlone()
{
    Merging merging({wall(6).segments()}, lenient());
    const auto before = merging.map.planes[0].publish(merging.map.segments);

    merging.merge();

    QVERIFY(merging.map.planes[0].publish(merging.map.segments) == before);
    QVERIFY(merging.recorded.report.decisions.empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MergePlanesTest)
#include "merge_planes_test.moc"
