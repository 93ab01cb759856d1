// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/growing_plane.h"

#include <cmath>

#include <Eigen/LU>
#include <QtTest>

#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Segments on a tilted plane whose points stray from it, with all their points.
struct NoisySheet {
    Segments segments;
    std::vector<std::vector<Eigen::Vector3d>> points;  ///< of each segment
    Eigen::Vector3d normal = Eigen::Vector3d(0.2, 0.9, -0.3).normalized();
    double distance = 3.0;

    explicit NoisySheet(int rows, std::uint64_t seed = 41)
    {
        Random random(seed);
        const auto tangents = tangentsOf(normal);
        for (int row = 0; row < rows; ++row) {
            std::vector<Eigen::Vector3d> line;
            for (int i = 0; i < 25; ++i) {
                const Eigen::Vector2d place{0.08 * i, 0.1 * row};
                line.emplace_back((distance + 0.01 * random.normalPair().first) * normal + tangents * place);
            }
            LineSegment segment = segmentThrough(row, line);
            segment.startCovariance = anyCovariance(random, 0.01);
            segment.endCovariance = anyCovariance(random, 0.01);
            segments.push_back(segment);
            points.push_back(line);
        }
    }

    Segments rows(int first, int last) const { return {segments.begin() + first, segments.begin() + last + 1}; }
};

const PlaneParameters kParameters = lenient().planes;

WeightedSums sumsAt(const Eigen::Vector3d& normal, const std::vector<EndPoint>& points)
{
    WeightedSums sums;
    for (const EndPoint& point : points)
        sums.add(point.position, endPointWeight(normal, point, kParameters));
    return sums;
}

/// The variance of a plane's place at a point: the numeric derivative of n·p − d carries the covariance there.
double slowVarianceAt(const Eigen::Vector3d& point, const Plane& plane)
{
    constexpr double kStep = 1e-6;
    const auto place = [&](const Eigen::Vector3d& x) {
        return (plane.normal + plane.tangents * x.head<2>()).normalized().dot(point) - (plane.distance + x[2]);
    };
    Eigen::Vector3d row;
    for (Eigen::Index i = 0; i < 3; ++i)
        row[i] = (place(kStep * Eigen::Vector3d::Unit(i)) - place(-kStep * Eigen::Vector3d::Unit(i))) / (2.0 * kStep);
    return row.dot(plane.covariance * row);
}

}  // namespace

class GrowingPlaneTest : public QObject {
    Q_OBJECT

private slots:
    void publishesTheSameObjectUntilItChanges();
    void everyChangeRaisesTheRevision();
    void publishedPlaneListsItsSegmentsInOrder();
    void pointsAndRmsAreThoseOfAllScanPoints();
    void fittingErrorIsTheMeanOverTheEndPoints();
    void normalIsPublishedWithAPositiveDistance();
    void covarianceFollowsTheNormalWhenItIsTurned();
    void tangentsAreOrthonormalWithTheNormal();
    void varianceAtAPointIsThatOfTheCovariance();
    void normalVarianceIsTheWorstOfAllDirections();
    void addingLeavesThePlaneWhereItIs();
    void refitIsLeastSquaresOverAllEndPoints();
    void refitOfAPlaneGrownByHalfIsARefinement();
    void absorbingTakesAllSegmentsAndRefines();
    void absorbedPlaneMayFaceTheOtherWay();
    void extremesAreTheFarthestEndPoints();
    void planeThatReplacesAnotherGoesOnFromItsRevision();
};

void GrowingPlaneTest::publishesTheSameObjectUntilItChanges()
{
    PlaneMap map;
    const NoisySheet sheet(6);
    const auto numbers = append(map.segments, sheet.segments);
    GrowingPlane& plane = makePlane(map, {0, 1, 2, 3}, kParameters);

    const auto first = plane.publish(map.segments);
    const auto second = plane.publish(map.segments);
    plane.add(numbers[4], map.segments, kParameters, 4);
    const auto third = plane.publish(map.segments);

    QVERIFY(first == second);
    QVERIFY(third != second);
    QCOMPARE(first->segments.size(), std::size_t{4});
    QCOMPARE(third->segments.size(), std::size_t{5});
}

void GrowingPlaneTest::everyChangeRaisesTheRevision()
{
    PlaneMap map;
    append(map.segments, NoisySheet(9).segments);
    GrowingPlane other = makePlane(map, {6, 7, 8}, kParameters);
    GrowingPlane& plane = makePlane(map, {0, 1, 2, 3}, kParameters);
    std::vector<std::shared_ptr<const Plane>> published{plane.publish(map.segments)};

    plane.add(4, map.segments, kParameters, 4);
    published.push_back(plane.publish(map.segments));
    plane.refit(map.segments, kParameters, 5);
    published.push_back(plane.publish(map.segments));
    plane.refine(map.segments, kParameters, 6);
    published.push_back(plane.publish(map.segments));
    plane.absorb(other, map.segments, kParameters, 7);
    published.push_back(plane.publish(map.segments));

    for (std::size_t i = 1; i < published.size(); ++i) {
        QVERIFY(published[i]->revision > published[i - 1]->revision);
        QCOMPARE(published[i]->changedStep, 3 + static_cast<int>(i));
        QCOMPARE(published[i]->bornStep, 0);
        QCOMPARE(published[i]->id, plane.id());
    }
}

void GrowingPlaneTest::publishedPlaneListsItsSegmentsInOrder()
{
    PlaneMap map;
    append(map.segments, NoisySheet(6).segments);
    GrowingPlane& plane = makePlane(map, {1, 3, 5}, kParameters);

    plane.add(4, map.segments, kParameters, 6);
    plane.add(0, map.segments, kParameters, 6);
    plane.add(2, map.segments, kParameters, 6);

    std::vector<SegmentId> expected;
    for (int step = 0; step < 6; ++step)
        expected.push_back({step, 0});
    QVERIFY(plane.publish(map.segments)->segments == expected);
    QVERIFY((plane.members() == std::vector<SegmentNumber>{0, 1, 2, 3, 4, 5}));
}

void GrowingPlaneTest::pointsAndRmsAreThoseOfAllScanPoints()
{
    PlaneMap map;
    const NoisySheet sheet(7);
    append(map.segments, sheet.segments);
    GrowingPlane other = makePlane(map, {5, 6}, kParameters);
    GrowingPlane& plane = makePlane(map, {0, 1, 2}, kParameters);

    plane.add(3, map.segments, kParameters, 7);
    plane.add(4, map.segments, kParameters, 7);
    plane.absorb(other, map.segments, kParameters, 7);

    const auto published = plane.publish(map.segments);
    double sum = 0.0;
    int count = 0;
    for (const auto& line : sheet.points) {
        for (const Eigen::Vector3d& point : line) {
            sum += std::pow(published->normal.dot(point) - published->distance, 2);
            ++count;
        }
    }
    QCOMPARE(published->points, count);
    QVERIFY(std::abs(published->rms - std::sqrt(sum / count)) < 1e-12);
}

void GrowingPlaneTest::fittingErrorIsTheMeanOverTheEndPoints()
{
    PlaneMap map;
    const auto numbers = append(map.segments, NoisySheet(6).segments);
    GrowingPlane& plane = makePlane(map, {0, 1, 2, 3}, kParameters);
    const auto meanError = [&] {
        double sum = 0.0;
        for (const EndPoint& point : endPointsOf(plane.members(), map.segments))
            sum += std::pow(plane.distanceTo(point.position), 2) * endPointWeight(plane.normal(), point, kParameters);
        return sum / (2.0 * static_cast<double>(plane.members().size()));
    };

    QVERIFY(std::abs(plane.error() / meanError() - 1.0) < 1e-9);
    plane.add(numbers[4], map.segments, kParameters, 4);
    QVERIFY(std::abs(plane.error() / meanError() - 1.0) < 1e-6);
    plane.add(numbers[5], map.segments, kParameters, 5);
    plane.refine(map.segments, kParameters, 5);
    QVERIFY(std::abs(plane.error() / meanError() - 1.0) < 1e-9);
    QCOMPARE(plane.publish(map.segments)->fittingError, plane.error());
}

void GrowingPlaneTest::normalIsPublishedWithAPositiveDistance()
{
    PlaneMap map;
    const auto numbers = append(map.segments, wall(4).segments());
    const std::vector<EndPoint> points = endPointsOf(numbers, map.segments);
    PlaneFit backwards;
    backwards.normal = -Eigen::Vector3d::UnitY();
    backwards.distance = -4.0;
    GrowingPlane& plane = map.makePlane(refinePlane(backwards, points, kParameters), numbers, kParameters);

    const auto published = plane.publish(map.segments);

    QVERIFY(plane.distance() < 0.0);
    QVERIFY(angleBetween(published->normal, Eigen::Vector3d::UnitY()) < 1e-10);
    QVERIFY(std::abs(published->distance - 4.0) < 1e-10);
}

void GrowingPlaneTest::covarianceFollowsTheNormalWhenItIsTurned()
{
    PlaneMap map;
    const NoisySheet sheet(6);
    const auto numbers = append(map.segments, sheet.segments);
    const std::vector<EndPoint> points = endPointsOf(numbers, map.segments);
    PlaneFit backwards;
    backwards.normal = -sheet.normal;
    backwards.distance = -sheet.distance;
    const PlaneFit fit = refinePlane(backwards, points, kParameters);
    GrowingPlane& plane = map.makePlane(fit, numbers, kParameters);

    const auto published = plane.publish(map.segments);

    // From the fit's angles and d to those of the published plane, by central differences through the plane itself.
    constexpr double kStep = 1e-6;
    const auto carried = [&](const Eigen::Vector3d& x) {
        const Eigen::Vector3d normal = -(fit.normal + fit.tangents * x.head<2>()).normalized();
        Eigen::Vector3d there;
        there << published->tangents.transpose() * normal, -(fit.distance + x[2]);
        return there;
    };
    Eigen::Matrix3d jacobian;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
        jacobian.col(i) = (carried(step) - carried(-step)) / (2.0 * kStep);
    }
    QVERIFY(published->distance > 0.0);
    QVERIFY(published->normal.dot(fit.normal) < -0.999);
    QVERIFY(published->covariance.isApprox(jacobian * covarianceOf(fit) * jacobian.transpose(), 1e-7));
}

void GrowingPlaneTest::tangentsAreOrthonormalWithTheNormal()
{
    PlaneMap map;
    append(map.segments, NoisySheet(6).segments);
    GrowingPlane& plane = makePlane(map, {0, 1, 2, 3}, kParameters);
    plane.add(4, map.segments, kParameters, 4);
    plane.refit(map.segments, kParameters, 4);

    const auto published = plane.publish(map.segments);

    Eigen::Matrix3d frame;
    frame << published->tangents, published->normal;
    QVERIFY((frame.transpose() * frame).isApprox(Eigen::Matrix3d::Identity(), 1e-13));
}

void GrowingPlaneTest::varianceAtAPointIsThatOfTheCovariance()
{
    PlaneMap map;
    append(map.segments, NoisySheet(6).segments);
    GrowingPlane& plane = makePlane(map, {0, 1, 2, 3, 4, 5}, kParameters);
    const auto published = plane.publish(map.segments);
    Random random(42);
    for (int i = 0; i < 20; ++i) {
        const Eigen::Vector3d point = published->distance * published->normal +
                                      published->tangents * Eigen::Vector2d(random.uniform(-3.0, 3.0), 1.0);

        QVERIFY(std::abs(plane.varianceAt(point) / slowVarianceAt(point, *published) - 1.0) < 1e-5);
    }
}

void GrowingPlaneTest::normalVarianceIsTheWorstOfAllDirections()
{
    PlaneMap map;
    append(map.segments, NoisySheet(6).segments);
    GrowingPlane& plane = makePlane(map, {0, 1, 2, 3, 4, 5}, kParameters);
    const Eigen::Matrix2d angles = plane.publish(map.segments)->covariance.topLeftCorner<2, 2>();
    double worst = 0.0;
    for (int i = 0; i < 3600; ++i) {
        const Eigen::Vector2d way{std::cos(degrees(0.1 * i)), std::sin(degrees(0.1 * i))};
        worst = std::max(worst, way.dot(angles * way));
    }

    QVERIFY(std::abs(plane.normalVariance() / worst - 1.0) < 1e-5);
}

void GrowingPlaneTest::addingLeavesThePlaneWhereItIs()
{
    PlaneMap map;
    append(map.segments, NoisySheet(6).segments);
    GrowingPlane& plane = makePlane(map, {0, 1, 2, 3}, kParameters);
    const Eigen::Vector3d normal = plane.normal();
    const double distance = plane.distance();

    plane.add(4, map.segments, kParameters, 4);
    plane.add(5, map.segments, kParameters, 5);

    QVERIFY(plane.normal() == normal);
    QCOMPARE(plane.distance(), distance);
    QCOMPARE(plane.addedSinceRefit(), 2);
}

void GrowingPlaneTest::refitIsLeastSquaresOverAllEndPoints()
{
    PlaneMap map;
    append(map.segments, NoisySheet(9).segments);
    GrowingPlane& plane = makePlane(map, {0, 1, 2, 3, 4, 5}, kParameters);
    const Eigen::Vector3d normal = plane.normal();

    plane.add(6, map.segments, kParameters, 6);
    plane.refit(map.segments, kParameters, 6);

    const PlaneFit expected = fitPlane(sumsAt(normal, endPointsOf(plane.members(), map.segments)), normal);
    QVERIFY(angleBetween(plane.normal(), expected.normal) < 1e-12);
    QVERIFY(std::abs(plane.distance() - expected.distance) < 1e-12);
    QVERIFY(plane.publish(map.segments)->covariance.isApprox(covarianceOf(expected), 1e-9));
    QCOMPARE(plane.addedSinceRefit(), 0);
}

void GrowingPlaneTest::refitOfAPlaneGrownByHalfIsARefinement()
{
    PlaneMap map;
    append(map.segments, NoisySheet(9).segments);
    GrowingPlane& plane = makePlane(map, {0, 1, 2, 3, 4, 5}, kParameters);

    for (const SegmentNumber number : {6, 7, 8})
        plane.add(number, map.segments, kParameters, 8);
    plane.refit(map.segments, kParameters, 8);

    PlaneFit start;
    start.normal = NoisySheet(0).normal;
    start.distance = 3.0;
    const PlaneFit expected = refinePlane(start, endPointsOf(plane.members(), map.segments), kParameters);
    QVERIFY(angleBetween(plane.normal(), expected.normal) < 1e-7);
    QVERIFY(std::abs(plane.distance() - expected.distance) < 1e-7);
    QVERIFY(std::abs(plane.error() / expected.error - 1.0) < 1e-9);
    QCOMPARE(plane.addedSinceRefit(), 0);
}

void GrowingPlaneTest::absorbingTakesAllSegmentsAndRefines()
{
    PlaneMap map;
    append(map.segments, NoisySheet(8).segments);
    GrowingPlane other = makePlane(map, {1, 3, 5, 7}, kParameters);
    GrowingPlane& plane = makePlane(map, {0, 2, 4, 6}, kParameters);

    plane.absorb(other, map.segments, kParameters, 8);

    PlaneFit start;
    start.normal = NoisySheet(0).normal;
    start.distance = 3.0;
    const PlaneFit expected = refinePlane(start, endPointsOf({0, 1, 2, 3, 4, 5, 6, 7}, map.segments), kParameters);
    QVERIFY((plane.members() == std::vector<SegmentNumber>{0, 1, 2, 3, 4, 5, 6, 7}));
    QVERIFY(angleBetween(plane.normal(), expected.normal) < 1e-7);
    QVERIFY(std::abs(plane.distance() - expected.distance) < 1e-7);
    QCOMPARE(plane.sums().points, 16);
    QCOMPARE(plane.publish(map.segments)->points, 200);
}

void GrowingPlaneTest::absorbedPlaneMayFaceTheOtherWay()
{
    PlaneMap map;
    append(map.segments, wall(6).segments());
    PlaneFit backwards;
    backwards.normal = -Eigen::Vector3d::UnitY();
    backwards.distance = -4.0;
    const GrowingPlane other(7, refinePlane(backwards, endPointsOf({3, 4, 5}, map.segments), kParameters), {3, 4, 5},
                             map.segments, kParameters, 5);
    GrowingPlane& plane = makePlane(map, {0, 1, 2}, kParameters);

    plane.absorb(other, map.segments, kParameters, 6);

    QVERIFY(angleBetween(plane.normal(), Eigen::Vector3d::UnitY()) < 1e-10);
    QVERIFY(std::abs(plane.distance() - 4.0) < 1e-10);
    QVERIFY(plane.error() < 1e-10);
}

void GrowingPlaneTest::extremesAreTheFarthestEndPoints()
{
    Random random(43);
    PlaneMap map;
    Segments segments;
    for (int step = 0; step < 12; ++step)
        segments.push_back(segmentBetween(step, anyVector(random), anyVector(random)));
    append(map.segments, segments);
    GrowingPlane other = makePlane(map, {8, 9, 10, 11}, kParameters);
    GrowingPlane& plane = makePlane(map, {0, 1, 2, 3}, kParameters);

    for (const SegmentNumber number : {4, 5, 6, 7})
        plane.add(number, map.segments, kParameters, 12);
    plane.absorb(other, map.segments, kParameters, 12);

    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        double lowest = segments[0].start[axis];
        double highest = lowest;
        for (const LineSegment& segment : segments) {
            lowest = std::min({lowest, segment.start[axis], segment.end[axis]});
            highest = std::max({highest, segment.start[axis], segment.end[axis]});
        }
        QCOMPARE(plane.extremes()[static_cast<std::size_t>(2 * axis)][axis], lowest);
        QCOMPARE(plane.extremes()[static_cast<std::size_t>(2 * axis + 1)][axis], highest);
    }
}

void GrowingPlaneTest::planeThatReplacesAnotherGoesOnFromItsRevision()
{
    PlaneMap map;
    append(map.segments, NoisySheet(6).segments);
    GrowingPlane before = makePlane(map, {0, 1, 2, 3, 4}, kParameters);
    before.refit(map.segments, kParameters, 5);
    before.setLineage({Lineage::Kind::Merged, {0, 1}});
    before.refit(map.segments, kParameters, 6);
    GrowingPlane& after = makePlane(map, {0, 1, 2}, kParameters);

    after.continueFrom(before, 9);

    const auto published = after.publish(map.segments);
    QVERIFY(published->revision > before.publish(map.segments)->revision);
    QCOMPARE(published->changedStep, 9);
    QVERIFY(published->lineage.kind == Lineage::Kind::Merged);
    QVERIFY((published->lineage.parents == std::vector<PlaneId>{0, 1}));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::GrowingPlaneTest)
#include "growing_plane_test.moc"
