// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/polygon_union.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QTest>

#include "tests/test_program.h"

using namespace planewright;

namespace {

/// Counter-clockwise.
PlanarRing square(double left, double bottom, double side)
{
    return {{left, bottom}, {left + side, bottom}, {left + side, bottom + side}, {left, bottom + side}};
}

PlanarRing reversed(PlanarRing ring)
{
    std::ranges::reverse(ring);
    return ring;
}

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-5 * std::max(1.0, std::abs(b));
}

}  // namespace

class PolygonUnionTest : public QObject {
    Q_OBJECT

private slots:
    void areaIsPositiveCounterClockwise();
    void squaresThatOverlapAreOnePolygon();
    void whatARingGoesRoundIsAHole();
    void sharedAreaIsThatOfBoth();
    void sharedAreaLeavesHolesOut();
    void sharedAreaIsTheSameClockwise();
    void sharedAreaHoldsFarFromTheOrigin();
};

void PolygonUnionTest::areaIsPositiveCounterClockwise()
{
    QCOMPARE(signedArea(square(3.0, -2.0, 1.5)), 2.25);
    QCOMPARE(signedArea(reversed(square(3.0, -2.0, 1.5))), -2.25);
    QCOMPARE(signedArea({}), 0.0);
}

void PolygonUnionTest::squaresThatOverlapAreOnePolygon()
{
    const auto joined = unionOf({square(0.0, 0.0, 2.0), square(1.0, 1.0, 2.0)});
    QCOMPARE(joined.size(), std::size_t(1));
    QVERIFY(isNear(signedArea(joined[0].ring), 7.0));
    QCOMPARE(joined[0].ring.size(), std::size_t(8));
    QCOMPARE(unionOf({square(0.0, 0.0, 1.0), square(1.1, 0.0, 1.0)}).size(), std::size_t(2));
}

void PolygonUnionTest::whatARingGoesRoundIsAHole()
{
    // Four strips around an empty square of 1 m.
    const auto frame = unionOf({{{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {0.0, 1.0}},
                                {{0.0, 2.0}, {3.0, 2.0}, {3.0, 3.0}, {0.0, 3.0}},
                                {{0.0, 0.0}, {1.0, 0.0}, {1.0, 3.0}, {0.0, 3.0}},
                                {{2.0, 0.0}, {3.0, 0.0}, {3.0, 3.0}, {2.0, 3.0}}});
    QCOMPARE(frame.size(), std::size_t(1));
    QCOMPARE(frame[0].holes.size(), std::size_t(1));
    QVERIFY(isNear(signedArea(frame[0].ring), 9.0));
    QVERIFY(isNear(signedArea(frame[0].holes[0]), -1.0));
}

void PolygonUnionTest::sharedAreaIsThatOfBoth()
{
    QVERIFY(isNear(sharedArea({square(0.0, 0.0, 2.0)}, {square(1.0, 1.5, 2.0)}), 0.5));
    QVERIFY(isNear(sharedArea({square(0.0, 0.0, 2.0)}, {square(0.5, 0.5, 1.0)}), 1.0));
    QCOMPARE(sharedArea({square(0.0, 0.0, 2.0)}, {square(2.5, 0.0, 1.0)}), 0.0);
    QCOMPARE(sharedArea({}, {square(2.5, 0.0, 1.0)}), 0.0);
    // Two parts, each half over the other.
    QVERIFY(isNear(sharedArea({square(0.0, 0.0, 1.0), square(3.0, 0.0, 1.0)}, {square(0.5, 0.0, 3.0)}), 1.0));
}

void PolygonUnionTest::sharedAreaLeavesHolesOut()
{
    const std::vector<PlanarRing> frame{square(0.0, 0.0, 3.0), reversed(square(1.0, 1.0, 1.0))};
    QVERIFY(isNear(sharedArea(frame, {square(0.0, 0.0, 3.0)}), 8.0));
    QCOMPARE(sharedArea(frame, {square(1.25, 1.25, 0.5)}), 0.0);
    QVERIFY(isNear(sharedArea({square(0.5, 0.5, 1.0)}, frame), 0.75));
}

void PolygonUnionTest::sharedAreaIsTheSameClockwise()
{
    const std::vector<PlanarRing> frame{reversed(square(0.0, 0.0, 3.0)), square(1.0, 1.0, 1.0)};
    QVERIFY(isNear(sharedArea(frame, {square(0.5, 0.5, 1.0)}), 0.75));
    QVERIFY(isNear(sharedArea(frame, {reversed(square(0.5, 0.5, 1.0))}), 0.75));
}

void PolygonUnionTest::sharedAreaHoldsFarFromTheOrigin()
{
    // The grid is of 0.02 mm there.
    QVERIFY(std::abs(sharedArea({square(1e4, -1e4, 2.0)}, {square(1e4 + 1.0, -1e4 + 1.5, 2.0)}) - 0.5) < 1e-3);
}

PLANEWRIGHT_TEST(PolygonUnionTest)
#include "polygon_union_test.moc"
