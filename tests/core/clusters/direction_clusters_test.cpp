// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/clusters/direction_clusters.h"

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <Eigen/Core>
#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

double uniform(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Unit vectors within some 25° of straight ahead.
std::vector<Eigen::Vector3d> directionsAhead(int count, std::mt19937_64& random)
{
    std::vector<Eigen::Vector3d> directions;
    for (int i = 0; i < count; ++i)
        directions.push_back(Eigen::Vector3d(uniform(random) - 0.5, 1.5, uniform(random) - 0.5).normalized());
    return directions;
}

/// Moves the average along all directions, each turned round at random first.
Eigen::Vector3d movedAlong(const std::vector<Eigen::Vector3d>& directions, const ClusterParameters& parameters,
                           std::mt19937_64& random)
{
    Eigen::Vector3d mean = directions.front();
    for (std::size_t i = 1; i < directions.size(); ++i) {
        const double side = uniform(random) < 0.5 ? -1.0 : 1.0;
        mean = movedAverage(mean, static_cast<int>(i), side * directions[i], parameters);
    }
    return mean;
}

/// A level direction at an angle from the x-axis.
Eigen::Vector3d level(double angle)
{
    return {std::cos(angle), std::sin(angle), 0.0};
}

bool isNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return (a - b).norm() < 1e-12;
}

ClusterParameters within(double limit, MovingAverage average = MovingAverage::ExponentiallyWeighted, double decay = 0.5)
{
    ClusterParameters parameters;
    parameters.average = average;
    parameters.directionLimit = limit;
    parameters.decay = decay;
    return parameters;
}

ClusterParameters tenDegrees(MovingAverage average = MovingAverage::ExponentiallyWeighted, double decay = 0.5)
{
    return within(degrees(10.0), average, decay);
}

}  // namespace

class DirectionClustersTest : public QObject {
    Q_OBJECT

private slots:
    void theSimpleAverageIsEq10OverAllDirections();
    void theLinearlyWeightedAverageIsEq11OverAllDirections();
    void theExponentiallyWeightedAverageIsEq12OverAllDirections();
    void aDecayOfOneFollowsTheNewestAndOfNoneTheFirst();
    void anOppositeDirectionCountsAsTheSame();
    void theFirstSegmentFoundsAClusterOfItsDirection();
    void aDirectionWithinTheLimitJoins();
    void aDirectionBeyondTheLimitFoundsANewCluster();
    void theNearestClusterWins();
    void theDirectionFollowsItsSegmentsAndIsOfUnitLength();
    void aSlowlyTurningDirectionStaysInOneCluster();
    void aCrossingDirectionHasNoSimilarity();
    void removedMembersLeaveAndEmptyClustersDisappear();
    void idsAreNeverUsedAgain();
    void aChangedClusterIsNoLongerAsPublished();
};

void DirectionClustersTest::theSimpleAverageIsEq10OverAllDirections()
{
    std::mt19937_64 random(31);
    for (const int count : {2, 3, 10, 100}) {
        const auto directions = directionsAhead(count, random);

        const Eigen::Vector3d mean = movedAlong(directions, tenDegrees(MovingAverage::Simple), random);

        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& direction : directions)
            sum += direction;
        QVERIFY(isNear(mean, sum / count));
    }
}

void DirectionClustersTest::theLinearlyWeightedAverageIsEq11OverAllDirections()
{
    std::mt19937_64 random(32);
    for (const int count : {2, 3, 10, 100}) {
        const auto directions = directionsAhead(count, random);

        const Eigen::Vector3d mean = movedAlong(directions, tenDegrees(MovingAverage::LinearlyWeighted), random);

        // The first has weight 1, the newest weight N.
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double weights = 0.0;
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const auto weight = static_cast<double>(i + 1);
            sum += weight * directions[i];
            weights += weight;
        }
        QVERIFY(isNear(mean, sum / weights));
    }
}

void DirectionClustersTest::theExponentiallyWeightedAverageIsEq12OverAllDirections()
{
    std::mt19937_64 random(33);
    for (const double decay : {0.2, 0.5, 0.9}) {
        const auto directions = directionsAhead(20, random);

        const Eigen::Vector3d mean =
            movedAlong(directions, tenDegrees(MovingAverage::ExponentiallyWeighted, decay), random);

        // Eq. (12) unrolled: (1 − τ)^(N−1) δ₁ + Σ τ (1 − τ)^(N−i) δ_i over i from 2.
        Eigen::Vector3d sum = std::pow(1.0 - decay, 19) * directions[0];
        for (int i = 1; i < 20; ++i)
            sum += decay * std::pow(1.0 - decay, 19 - i) * directions[static_cast<std::size_t>(i)];
        QVERIFY(isNear(mean, sum));
    }
}

void DirectionClustersTest::aDecayOfOneFollowsTheNewestAndOfNoneTheFirst()
{
    const Eigen::Vector3d first = level(0.0);
    const Eigen::Vector3d newest = level(degrees(8.0));

    QVERIFY(isNear(movedAverage(first, 5, newest, tenDegrees(MovingAverage::ExponentiallyWeighted, 1.0)), newest));
    QVERIFY(isNear(movedAverage(first, 5, newest, tenDegrees(MovingAverage::ExponentiallyWeighted, 0.0)), first));
}

void DirectionClustersTest::anOppositeDirectionCountsAsTheSame()
{
    for (const MovingAverage average :
         {MovingAverage::Simple, MovingAverage::LinearlyWeighted, MovingAverage::ExponentiallyWeighted}) {
        const Eigen::Vector3d direction = level(degrees(30.0));

        QVERIFY(isNear(movedAverage(direction, 3, -direction, tenDegrees(average)), direction));
    }
}

void DirectionClustersTest::theFirstSegmentFoundsAClusterOfItsDirection()
{
    DirectionClusters clusters;

    const auto joined = clusters.add(7, level(0.3), tenDegrees());

    QVERIFY(joined.founded);
    QCOMPARE(joined.similarity, 0.0);
    QCOMPARE(clusters.all().size(), std::size_t(1));
    QCOMPARE(clusters.all()[0].id, joined.cluster);
    QVERIFY(isNear(clusters.all()[0].direction, level(0.3)));
    QCOMPARE(clusters.all()[0].members.size(), std::size_t(1));
    QCOMPARE(clusters.all()[0].members[0].segment, 7);
    QVERIFY(!clusters.all()[0].members[0].searched);
}

void DirectionClustersTest::aDirectionWithinTheLimitJoins()
{
    for (const double side : {1.0, -1.0}) {
        DirectionClusters clusters;
        const auto first = clusters.add(0, level(0.0), tenDegrees());

        const auto joined = clusters.add(1, side * level(degrees(9.9)), tenDegrees());

        QVERIFY(!joined.founded);
        QCOMPARE(joined.cluster, first.cluster);
        QVERIFY(std::abs(joined.similarity - std::cos(degrees(9.9))) < 1e-14);
        QCOMPARE(clusters.all().size(), std::size_t(1));
        QCOMPARE(clusters.all()[0].members[1].segment, 1);
    }
}

void DirectionClustersTest::aDirectionBeyondTheLimitFoundsANewCluster()
{
    for (const double side : {1.0, -1.0}) {
        DirectionClusters clusters;
        const auto first = clusters.add(0, level(0.0), tenDegrees());

        const auto joined = clusters.add(1, side * level(degrees(10.1)), tenDegrees());

        QVERIFY(joined.founded);
        QVERIFY(joined.cluster != first.cluster);
        QVERIFY(std::abs(joined.similarity - std::cos(degrees(10.1))) < 1e-14);
        QCOMPARE(clusters.all().size(), std::size_t(2));
    }
}

void DirectionClustersTest::theNearestClusterWins()
{
    // At 12° both clusters at 0° and at 15° are within 13°; the order in which they were founded does not matter.
    const ClusterParameters parameters = within(degrees(13.0));
    for (const bool swapped : {false, true}) {
        DirectionClusters clusters;
        const auto a = clusters.add(0, level(swapped ? degrees(15.0) : 0.0), parameters);
        const auto b = clusters.add(1, level(swapped ? 0.0 : degrees(15.0)), parameters);
        QVERIFY(b.founded);

        const auto joined = clusters.add(2, -level(degrees(12.0)), parameters);

        QCOMPARE(joined.cluster, swapped ? a.cluster : b.cluster);
        QVERIFY(std::abs(joined.similarity - std::cos(degrees(3.0))) < 1e-14);
    }
}

void DirectionClustersTest::theDirectionFollowsItsSegmentsAndIsOfUnitLength()
{
    // Half the way each time with τ = 0.5: two unit vectors 8° apart meet at 4°, shortened to cos 4°.
    DirectionClusters clusters;
    clusters.add(0, level(0.0), tenDegrees());

    clusters.add(1, level(degrees(8.0)), tenDegrees());

    const GrowingCluster& cluster = clusters.all()[0];
    QVERIFY(isNear(cluster.direction, level(degrees(4.0))));
    QVERIFY(isNear(cluster.mean, std::cos(degrees(4.0)) * level(degrees(4.0))));
}

void DirectionClustersTest::aSlowlyTurningDirectionStaysInOneCluster()
{
    // Fig. 5: segments of a side wall turn with the tilt. The exponential average keeps up; the simple one falls back.
    DirectionClusters exponential;
    DirectionClusters simple;
    for (int i = 0; i < 60; ++i) {
        exponential.add(i, level(degrees(1.16 * i)), tenDegrees());
        simple.add(i, level(degrees(1.16 * i)), tenDegrees(MovingAverage::Simple));
    }

    QCOMPARE(exponential.all().size(), std::size_t(1));
    QVERIFY(simple.all().size() > 1);
}

void DirectionClustersTest::aCrossingDirectionHasNoSimilarity()
{
    DirectionClusters clusters;
    clusters.add(0, Eigen::Vector3d::UnitX(), tenDegrees());

    const auto joined = clusters.add(1, Eigen::Vector3d::UnitY(), within(degrees(90.0)));

    QVERIFY(joined.founded);
    QCOMPARE(joined.similarity, 0.0);
}

void DirectionClustersTest::removedMembersLeaveAndEmptyClustersDisappear()
{
    DirectionClusters clusters;
    const ClusterId level0 = clusters.add(0, level(0.0), tenDegrees()).cluster;
    clusters.add(1, level(degrees(60.0)), tenDegrees());
    clusters.add(2, level(degrees(1.0)), tenDegrees());
    clusters.add(3, level(degrees(61.0)), tenDegrees());
    clusters.add(4, level(degrees(2.0)), tenDegrees());

    clusters.remove([](SegmentNumber segment) { return segment == 2 || segment % 2 == 1; });

    QCOMPARE(clusters.all().size(), std::size_t(1));
    QCOMPARE(clusters.all()[0].id, level0);
    QCOMPARE(clusters.all()[0].members.size(), std::size_t(2));
    QCOMPARE(clusters.all()[0].members[0].segment, 0);
    QCOMPARE(clusters.all()[0].members[1].segment, 4);
}

void DirectionClustersTest::idsAreNeverUsedAgain()
{
    DirectionClusters clusters;
    const ClusterId first = clusters.add(0, level(0.0), tenDegrees()).cluster;
    const ClusterId second = clusters.add(1, level(degrees(90.0)), tenDegrees()).cluster;
    clusters.remove([](SegmentNumber) { return true; });
    QVERIFY(clusters.all().empty());

    const auto again = clusters.add(2, level(0.0), tenDegrees());

    QVERIFY(again.founded);
    QCOMPARE(again.similarity, 0.0);
    QVERIFY(again.cluster != first && again.cluster != second);
}

void DirectionClustersTest::aChangedClusterIsNoLongerAsPublished()
{
    DirectionClusters clusters;
    clusters.add(0, level(0.0), tenDegrees());
    clusters.add(1, level(degrees(90.0)), tenDegrees());
    clusters.add(2, level(degrees(90.0)), tenDegrees());
    const auto publish = [&] {
        for (GrowingCluster& cluster : clusters.all())
            cluster.published = std::make_shared<const DirectionCluster>();
    };

    publish();
    clusters.add(3, level(degrees(1.0)), tenDegrees());
    QVERIFY(clusters.all()[0].published == nullptr);
    QVERIFY(clusters.all()[1].published != nullptr);

    publish();
    clusters.remove([](SegmentNumber segment) { return segment == 2; });
    QVERIFY(clusters.all()[0].published != nullptr);
    QVERIFY(clusters.all()[1].published == nullptr);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DirectionClustersTest)
#include "direction_clusters_test.moc"
