// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/line_segment.h"

#include <random>
#include <span>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

namespace {

/// Points of a slanted, offset cloud: coordinates of the size of a room, from an engine with a written seed.
std::vector<Eigen::Vector3d> somePoints(std::size_t count, std::uint64_t seed)
{
    std::mt19937_64 engine(seed);
    const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double along = 6.0 * uniform();
        points.emplace_back(12.0 + along, -3.0 + 0.5 * along + 0.02 * uniform(), 1.0 + 0.1 * uniform());
    }
    return points;
}

/// Count, mean and scatter by their definitions, in two passes.
PointMoments momentsByDefinition(std::span<const Eigen::Vector3d> points)
{
    PointMoments moments;
    moments.count = static_cast<double>(points.size());
    for (const Eigen::Vector3d& point : points)
        moments.mean += point / moments.count;
    for (const Eigen::Vector3d& point : points)
        moments.scatter += (point - moments.mean) * (point - moments.mean).transpose();
    return moments;
}

}  // namespace

class LineSegmentTest : public QObject {
    Q_OBJECT

private slots:
    void momentsOfTwoSetsAddUpToThoseOfTheirUnion();
    void momentsOfSinglePointsAddUpToThoseOfAll();
    void addingNothingChangesNothing();
    void addingToNothingGivesTheOther();
    void squaredDistanceIsTheSumOverThePoints();
    void lengthAndMidpointAreThoseOfTheEndPoints();
    void idsAreOrderedByStepThenIndex();
};

void LineSegmentTest::momentsOfTwoSetsAddUpToThoseOfTheirUnion()
{
    const auto points = somePoints(500, 1);
    PointMoments sum = momentsByDefinition(std::span(points).first(137));

    sum += momentsByDefinition(std::span(points).subspan(137));

    const PointMoments all = momentsByDefinition(points);
    QCOMPARE(sum.count, 500.0);
    QVERIFY((sum.mean - all.mean).norm() < 1e-12);
    QVERIFY(sum.scatter.isApprox(all.scatter, 1e-12));
}

void LineSegmentTest::momentsOfSinglePointsAddUpToThoseOfAll()
{
    const auto points = somePoints(200, 2);

    PointMoments sum;
    for (const Eigen::Vector3d& point : points)
        sum += PointMoments{1.0, point, Eigen::Matrix3d::Zero()};

    const PointMoments all = momentsByDefinition(points);
    QCOMPARE(sum.count, 200.0);
    QVERIFY((sum.mean - all.mean).norm() < 1e-12);
    QVERIFY(sum.scatter.isApprox(all.scatter, 1e-11));
}

void LineSegmentTest::addingNothingChangesNothing()
{
    const PointMoments before = momentsByDefinition(somePoints(10, 3));
    PointMoments after = before;

    after += PointMoments{};

    QCOMPARE(after.count, before.count);
    QVERIFY(after.mean == before.mean);
    QVERIFY(after.scatter == before.scatter);
}

void LineSegmentTest::addingToNothingGivesTheOther()
{
    const PointMoments other = momentsByDefinition(somePoints(10, 4));
    PointMoments sum;

    sum += other;

    QCOMPARE(sum.count, other.count);
    QVERIFY(sum.mean == other.mean);
    QVERIFY(sum.scatter == other.scatter);
}

void LineSegmentTest::squaredDistanceIsTheSumOverThePoints()
{
    const auto points = somePoints(300, 5);
    const Eigen::Vector3d normal = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
    const double distance = 7.5;
    double expected = 0.0;
    for (const Eigen::Vector3d& point : points)
        expected += (normal.dot(point) - distance) * (normal.dot(point) - distance);

    const double actual = momentsByDefinition(points).squaredDistanceTo(normal, distance);

    QVERIFY(std::abs(actual - expected) < 1e-10 * expected);
}

void LineSegmentTest::lengthAndMidpointAreThoseOfTheEndPoints()
{
    LineSegment segment;
    segment.start = {1.0, 2.0, 3.0};
    segment.end = {4.0, 6.0, 3.0};

    QCOMPARE(segment.length(), 5.0);
    QVERIFY(segment.midpoint() == Eigen::Vector3d(2.5, 4.0, 3.0));
}

void LineSegmentTest::idsAreOrderedByStepThenIndex()
{
    QVERIFY((SegmentId{2, 9} < SegmentId{3, 0}));
    QVERIFY((SegmentId{3, 0} < SegmentId{3, 1}));
    QVERIFY((SegmentId{3, 1} == SegmentId{3, 1}));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::LineSegmentTest)
#include "line_segment_test.moc"
