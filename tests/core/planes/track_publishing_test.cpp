// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/track_publishing.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <QtTest>

#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A wall that leans and is turned out of all axes.
const Surface kPublished{Eigen::Vector3d{0.3, 0.9, -0.2}.normalized(), 3.0, 320, 400};

/// Ten slices of the leaning surface whose points stray from it by a centimetre, and these points in space.
struct Rough {
    NoddingScan scan;
    std::vector<std::vector<Eigen::Vector3d>> points;  // of each segment

    explicit Rough(std::uint64_t seed)
    {
        Random random(seed);
        for (int k = 0; k < 10; ++k) {
            const double tilt = degrees(85.0) + k * kTiltStep;
            std::vector<Eigen::Vector2d> slice = pointsOf(kPublished, tilt);
            points.emplace_back();
            for (Eigen::Vector2d& point : slice) {
                point *= 1.0 + 0.01 / point.norm() * random.normalPair().first;
                points.back().push_back(frameOf(tilt, kSensor).pointAt(point.x(), point.y()));
            }
            scan.add(tilt, {statisticsOf(slice, kPublished.firstBeam, scan.parameters.noise)});
        }
        scan.makePlane({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, kPublished);
    }
    PlaneTrack& plane() { return scan.map.plane(0); }
};

/// Ten slices of the wall with the noise that the scanner is told to have, times a factor, and their plane.
NoddingScan noisyWall(double factor, Random& random)
{
    NoddingScan scan;
    for (int k = 0; k < 10; ++k) {
        const double tilt = degrees(85.0) + k * kTiltStep;
        const double error = factor * scan.parameters.noise.pitch * random.normalPair().first;
        SegmentStatistics s = seen(kWall, tilt + error, scan.parameters.noise);
        const Random::Pair pair = random.normalPair();
        disturb(s, factor * pair.first / std::sqrt(s.offsetInformation),
                factor * pair.second / std::sqrt(s.slopeInformation));
        scan.add(tilt, {s});
    }
    scan.makePlane({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, kWall);
    return scan;
}

}  // namespace

class TrackPublishingTest : public QObject {
    Q_OBJECT

private slots:
    void segmentsAreCalledByStepAndPlace();
    void endPointsAreThoseOfTheirBeams();
    void directionOfASegmentIsTowardsItsStart();
    void momentsAreThoseOfAllPoints();
    void directionSigmaIsThatOfTheLine();
    void rmsIsThatOfAllPoints();
    void meanErrorIsOneWhereNoiseIsAsTold();
    void covarianceGrowsWithTheErrorAndNeverShrinks();
    void publishedPlaneTellsWhatItIsMadeOf();
    void normalIsPublishedWithAPositiveDistance();
    void covarianceFollowsTheNormalWhenItIsTurned();
    void tangentsAreThoseOfTheNormal();
    void publishesTheSameObjectUntilItChanges();
    void clustersAreTheSameObjectUntilTheyChange();
};

void TrackPublishingTest::segmentsAreCalledByStepAndPlace()
{
    // Steps 3 and 7: those between are missing from the recording.
    TrackMap map;
    for (const int step : {3, 7}) {
        const std::vector<SegmentStatistics> segments{seen({kWall.normal, 4.0, 300, 340}, degrees(80.0 + step), {}),
                                                      seen({kWall.normal, 4.0, 350, 390}, degrees(80.0 + step), {})};
        map.append(sliceAt(step, degrees(80.0 + step)), kSensor, segments);
    }

    QCOMPARE(idOf(0, map), (SegmentId{3, 0}));
    QCOMPARE(idOf(3, map), (SegmentId{7, 1}));
    const Segments segments = segmentsOf(1, map, kSensor, {});
    QCOMPARE(segments.size(), std::size_t{2});
    QCOMPARE(segments[0].id, (SegmentId{7, 0}));
    QCOMPARE(segments[1].id, (SegmentId{7, 1}));
    QCOMPARE(segments[1].firstBeam, 350);
    QCOMPARE(segments[1].lastBeam, 390);
    QCOMPARE(segments[1].points, 41);
}

void TrackPublishingTest::endPointsAreThoseOfTheirBeams()
{
    NoddingScan scan;
    const double tilt = degrees(70.0);
    scan.see(tilt, {kPublished});

    const LineSegment segment = segmentsOf(0, scan.map, kSensor, scan.parameters.noise).at(0);

    const std::vector<Eigen::Vector2d> points = pointsOf(kPublished, tilt);
    for (const bool last : {false, true}) {
        const double range = (last ? points.back() : points.front()).norm();
        const double bearing = kBearingStep * (last ? kPublished.lastBeam : kPublished.firstBeam);
        const Eigen::Vector3d expected = toCartesian(range, bearing, tilt, kSensor);
        QVERIFY(((last ? segment.end : segment.start) - expected).norm() < 1e-12);
        QVERIFY((last ? segment.endCovariance : segment.startCovariance)
                    .isApprox(cartesianCovariance(range, bearing, tilt, kSensor, scan.parameters.noise), 1e-9));
    }
    // The laser is 5 cm from the pitch axis, at right angles to where it looks.
    QVERIFY((segment.viewpoint - 0.05 * Eigen::Vector3d{0.0, std::cos(tilt), std::sin(tilt)}).norm() < 1e-15);
}

void TrackPublishingTest::directionOfASegmentIsTowardsItsStart()
{
    NoddingScan scan;
    scan.see(degrees(70.0), {kPublished});

    const LineSegment segment = segmentsOf(0, scan.map, kSensor, scan.parameters.noise).at(0);

    QVERIFY((segment.direction - (segment.start - segment.end).normalized()).norm() < 1e-12);
    QVERIFY((directionOf(0, scan.map) + segment.direction).norm() < 1e-12);
    QVERIFY(std::abs(segment.direction.dot(kPublished.normal)) < 1e-12);
}

void TrackPublishingTest::momentsAreThoseOfAllPoints()
{
    const Rough rough(41);

    for (int k = 0; k < 10; ++k) {
        const LineSegment segment = segmentsOf(k, rough.scan.map, kSensor, rough.scan.parameters.noise).at(0);

        PointMoments expected;
        for (const Eigen::Vector3d& point : rough.points[static_cast<std::size_t>(k)])
            expected += {1.0, point, Eigen::Matrix3d::Zero()};
        QCOMPARE(segment.moments.count, expected.count);
        QVERIFY((segment.moments.mean - expected.mean).norm() < 1e-12);
        QVERIFY((segment.moments.scatter - expected.scatter).norm() < 1e-9);
        // The sum of squares across the line is what the others leave of the trace.
        const double across = expected.scatter.trace() - segment.direction.dot(expected.scatter * segment.direction);
        QVERIFY(std::abs(segment.rms - std::sqrt(across / expected.count)) < 1e-9);
    }
}

void TrackPublishingTest::directionSigmaIsThatOfTheLine()
{
    NoddingScan scan;
    scan.see(degrees(80.0), {kWall, kWall});
    scan.map.segment(0).statistics.slopeInformation = 2500.0;
    scan.map.segment(1).statistics.slopeInformation = 0.0;

    const Segments segments = segmentsOf(0, scan.map, kSensor, scan.parameters.noise);

    QCOMPARE(segments[0].directionSigma, 0.02);
    QCOMPARE(segments[1].directionSigma, std::numbers::pi);
}

void TrackPublishingTest::rmsIsThatOfAllPoints()
{
    Rough rough(42);

    const auto published = publishedPlane(rough.plane(), rough.scan.map);

    double sum = 0.0;
    int count = 0;
    for (const auto& line : rough.points) {
        for (const Eigen::Vector3d& point : line) {
            sum += std::pow(published->normal.dot(point) - published->distance, 2);
            ++count;
        }
    }
    QCOMPARE(published->points, count);
    QVERIFY(std::abs(published->rms - std::sqrt(sum / count)) < 1e-12);
    QVERIFY(published->rms > 0.005);
}

void TrackPublishingTest::meanErrorIsOneWhereNoiseIsAsTold()
{
    for (const double factor : {1.0, 2.0}) {
        Random random(43);
        double sum = 0.0;
        constexpr int kTrials = 300;
        for (int trial = 0; trial < kTrials; ++trial) {
            const NoddingScan scan = noisyWall(factor, random);
            sum += meanErrorOf(scan.map.planes().front()) / kTrials;
        }

        // Of 17 degrees of freedom each: the mean of 300 has a standard deviation of 0.02 times the square of the
        // noise.
        QVERIFY2(std::abs(sum / (factor * factor) - 1.0) < 0.08, qPrintable(QString::number(sum)));
    }
}

void TrackPublishingTest::covarianceGrowsWithTheErrorAndNeverShrinks()
{
    for (const double factor : {0.1, 3.0}) {
        Random random(44);
        NoddingScan scan = noisyWall(factor, random);
        PlaneTrack& plane = scan.map.plane(0);

        const auto published = publishedPlane(plane, scan.map);

        QCOMPARE(published->fittingError, meanErrorOf(plane));
        QCOMPARE(published->fittingError > 1.0, factor > 1.0);
        const double growth = factor > 1.0 ? published->fittingError : 1.0;
        QVERIFY(published->covariance.isApprox(growth * plane.estimate.covariance(), 1e-12));
    }
}

void TrackPublishingTest::publishedPlaneTellsWhatItIsMadeOf()
{
    NoddingScan scan;
    scan.nod(6, {{kWall.normal, 4.0, 300, 340}, {kWall.normal, 4.0, 345, 385}});
    scan.makePlane({1, 2, 3, 6, 7, 8}, kWall);
    const SegmentNumber number = 11;
    scan.map.join(scan.map.plane(0), std::span{&number, 1}, 9, scan.parameters);
    scan.map.plane(0).lineage = {Lineage::Kind::Merged, {0, 4}};

    const auto published = publishedPlane(scan.map.plane(0), scan.map);

    QCOMPARE(published->id, 0);
    QCOMPARE(published->revision, scan.map.plane(0).revision);
    QVERIFY((published->segments == std::vector<SegmentId>{{0, 1}, {1, 0}, {1, 1}, {3, 0}, {3, 1}, {4, 0}, {5, 1}}));
    QCOMPARE(published->points, 7 * 41);
    QCOMPARE(published->bornStep, 5);
    QCOMPARE(published->changedStep, 9);
    QVERIFY(published->lineage.kind == Lineage::Kind::Merged);
    QVERIFY((published->lineage.parents == std::vector<PlaneId>{0, 4}));
    QVERIFY((published->normal - kWall.normal).norm() < 1e-9);
    QVERIFY(std::abs(published->distance - 4.0) < 1e-9);
    QVERIFY(published->rms < 1e-9);
    QVERIFY(published->fittingError < 1e-9);
}

void TrackPublishingTest::normalIsPublishedWithAPositiveDistance()
{
    NoddingScan scan;
    scan.nod(5, {kWall});
    scan.makePlane({0, 1, 2, 3, 4}, {-kWall.normal, -kWall.distance});

    const auto published = publishedPlane(scan.map.plane(0), scan.map);

    QVERIFY(scan.map.plane(0).estimate.distance() < 0.0);
    QVERIFY((published->normal - kWall.normal).norm() < 1e-9);
    QVERIFY(std::abs(published->distance - 4.0) < 1e-9);
}

void TrackPublishingTest::covarianceFollowsTheNormalWhenItIsTurned()
{
    Rough rough(45);
    rough.scan.map.dissolve(0);
    rough.scan.makePlane({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, {-kPublished.normal, -kPublished.distance});
    PlaneTrack& plane = rough.scan.map.plane(1);
    const PlaneEstimate& estimate = plane.estimate;

    const auto published = publishedPlane(plane, rough.scan.map);

    // From the estimate's angles and d to those of the published plane, by central differences through the plane.
    constexpr double kStep = 1e-6;
    const auto carried = [&](const Eigen::Vector3d& x) {
        Eigen::Vector3d there;
        there << published->tangents.transpose() *
                     -(estimate.normal() + estimate.tangents() * x.head<2>()).normalized(),
            -(estimate.distance() + x[2]);
        return there;
    };
    Eigen::Matrix3d jacobian;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
        jacobian.col(i) = (carried(step) - carried(-step)) / (2.0 * kStep);
    }
    QVERIFY(published->normal.dot(estimate.normal()) < -0.999);
    const Eigen::Matrix3d expected = jacobian * estimate.covariance() * jacobian.transpose();
    QVERIFY(published->covariance.isApprox(std::max(1.0, published->fittingError) * expected, 1e-4));
}

void TrackPublishingTest::tangentsAreThoseOfTheNormal()
{
    Rough rough(46);
    refineTracks(rough.scan.map, rough.scan.parameters);

    const auto published = publishedPlane(rough.plane(), rough.scan.map);

    Eigen::Matrix3d frame;
    frame << published->tangents, published->normal;
    QVERIFY((frame.transpose() * frame).isApprox(Eigen::Matrix3d::Identity(), 1e-6));
}

void TrackPublishingTest::publishesTheSameObjectUntilItChanges()
{
    NoddingScan scan;
    scan.nod(6, {kWall});
    scan.makePlane({0, 1, 2, 3, 4}, kWall);

    const auto first = publishedPlane(scan.map.plane(0), scan.map);
    const auto second = publishedPlane(scan.map.plane(0), scan.map);
    const SegmentNumber number = 5;
    scan.map.join(scan.map.plane(0), std::span{&number, 1}, 5, scan.parameters);
    const auto third = publishedPlane(scan.map.plane(0), scan.map);

    QVERIFY(first == second);
    QVERIFY(third != second);
    QVERIFY(third->revision > second->revision);
    QCOMPARE(second->segments.size(), std::size_t{5});
    QCOMPARE(third->segments.size(), std::size_t{6});
}

void TrackPublishingTest::clustersAreTheSameObjectUntilTheyChange()
{
    NoddingScan scan;
    scan.nod(3, {kWall, {kWall.normal, 4.0, 410, 450}});
    for (const SegmentNumber number : {0, 3})
        scan.map.clusters.add(number, directionOf(number, scan.map), scan.parameters.clusters);
    GrowingCluster& cluster = scan.map.clusters.all().front();

    const auto first = publishedCluster(cluster, scan.map);
    const auto second = publishedCluster(cluster, scan.map);
    scan.map.clusters.add(4, directionOf(4, scan.map), scan.parameters.clusters);
    const auto third = publishedCluster(cluster, scan.map);

    QVERIFY(first == second);
    QCOMPARE(first->id, cluster.id);
    // All segments run across, x from right to left.
    QVERIFY((first->direction + Eigen::Vector3d::UnitX()).norm() < 1e-9);
    QVERIFY((first->segments == std::vector<SegmentId>{{0, 0}, {1, 1}}));
    QVERIFY((third->segments == std::vector<SegmentId>{{0, 0}, {1, 1}, {2, 0}}));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::TrackPublishingTest)
#include "track_publishing_test.moc"
