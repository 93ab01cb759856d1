// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/compare_planes.h"

#include <cmath>

#include <QTest>

#include "tests/test_program.h"

using namespace planewright;

namespace {

/// A wall whose normal is turned by an angle from the y axis.
ComparedPlane wall(int id, double turn, double distance)
{
    return {id, {std::sin(degrees(turn)), std::cos(degrees(turn)), 0.0}, distance};
}

}  // namespace

class ComparePlanesTest : public QObject {
    Q_OBJECT

private slots:
    void matchesTheNearestInAngleFirst();
    void equalAnglesMatchTheNearestInDistance();
    void usesEachPlaneOnce();
    void leavesPlanesBeyondEitherLimit();
    void errorsAreThoseOfTheMatches();
    void nothingMatchesNothing();
    void tooManyPlanesAreRefused();
    void tooManyPairsAreRefused();
};

void ComparePlanesTest::matchesTheNearestInAngleFirst()
{
    const std::vector<ComparedPlane> a{wall(10, 3.0, 4.0), wall(11, 1.0, 4.05)};
    const std::vector<ComparedPlane> b{wall(20, 0.0, 4.0)};

    const auto comparison = comparePlanes(a, b, {});

    QVERIFY(comparison);
    QCOMPARE(comparison->matches.size(), std::size_t(1));
    QCOMPARE(comparison->matches[0].a, 11);
    QCOMPARE(comparison->matches[0].b, 20);
    QCOMPARE(comparison->unmatchedA, std::vector<int>{10});
    QVERIFY(comparison->unmatchedB.empty());
}

void ComparePlanesTest::equalAnglesMatchTheNearestInDistance()
{
    const std::vector<ComparedPlane> a{wall(0, 0.0, 4.0), wall(1, 0.0, 4.06)};
    const std::vector<ComparedPlane> b{wall(0, 0.0, 4.05)};

    const auto comparison = comparePlanes(a, b, {});

    QVERIFY(comparison);
    QCOMPARE(comparison->matches[0].a, 1);
}

void ComparePlanesTest::usesEachPlaneOnce()
{
    const std::vector<ComparedPlane> a{wall(0, 0.0, 4.0)};
    const std::vector<ComparedPlane> b{wall(5, 0.5, 4.0), wall(6, 1.0, 4.0)};

    const auto comparison = comparePlanes(a, b, {});

    QVERIFY(comparison);
    QCOMPARE(comparison->matches.size(), std::size_t(1));
    QCOMPARE(comparison->matches[0].b, 5);
    QCOMPARE(comparison->unmatchedB, std::vector<int>{6});
}

void ComparePlanesTest::leavesPlanesBeyondEitherLimit()
{
    const std::vector<ComparedPlane> a{wall(0, 0.0, 4.0), wall(1, 90.0, 2.0)};
    const std::vector<ComparedPlane> b{wall(0, 6.0, 4.0), wall(1, 90.0, 2.2)};

    const auto comparison = comparePlanes(a, b, {degrees(5.0), 0.1});

    QVERIFY(comparison);
    QVERIFY(comparison->matches.empty());
    QCOMPARE(comparison->unmatchedA, (std::vector<int>{0, 1}));
    QCOMPARE(comparison->unmatchedB, (std::vector<int>{0, 1}));
}

void ComparePlanesTest::errorsAreThoseOfTheMatches()
{
    const std::vector<ComparedPlane> a{wall(0, 1.0, 4.01), wall(1, 92.0, 2.03)};
    const std::vector<ComparedPlane> b{wall(0, 90.0, 2.0), wall(1, 0.0, 4.0)};

    const auto comparison = comparePlanes(a, b, {});

    QVERIFY(comparison);
    QCOMPARE(comparison->matches[0].b, 0);
    QCOMPARE(comparison->matches[0].a, 1);
    QVERIFY(std::abs(comparison->errors.angle.mean - degrees(1.5)) < 1e-12);
    QVERIFY(std::abs(comparison->errors.angle.max - degrees(2.0)) < 1e-12);
    QVERIFY(std::abs(comparison->errors.distance.median - 0.02) < 1e-12);
}

void ComparePlanesTest::nothingMatchesNothing()
{
    const auto comparison = comparePlanes({}, {}, {});

    QVERIFY(comparison);
    QVERIFY(comparison->matches.empty());
    QCOMPARE(comparison->errors.count, std::size_t(0));
}

void ComparePlanesTest::tooManyPlanesAreRefused()
{
    const std::vector<ComparedPlane> many(kMaxComparedPlanes + 1);

    const auto comparison = comparePlanes(many, {}, {});

    QVERIFY(!comparison);
    QCOMPARE(comparison.error().code, ErrorCode::Usage);
}

void ComparePlanesTest::tooManyPairsAreRefused()
{
    const std::vector<ComparedPlane> same(4097);

    const auto comparison = comparePlanes(same, same, {});

    QVERIFY(!comparison);
    QCOMPARE(comparison.error().code, ErrorCode::Usage);
}

PLANEWRIGHT_TEST(ComparePlanesTest)
#include "compare_planes_test.moc"
