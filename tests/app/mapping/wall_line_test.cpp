// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/wall_line.h"

#include <cmath>

#include <QTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

using Vector = Eigen::Vector3d;

/// A wall 2 m ahead, from x = −1 to 3 and 2 m high, turned about the x axis at its foot.
FacedPlane wallAhead(double lean = 0.0)
{
    const Vector foot{-1.0, 2.0, 0.0};
    const Vector up{0.0, 2.0 * std::sin(lean), 2.0 * std::cos(lean)};
    const Vector right{4.0, 0.0, 0.0};
    FacedPlane plane;
    plane.normal = {0.0, std::cos(lean), -std::sin(lean)};
    plane.distance = plane.normal.dot(foot);
    plane.parts = {{{foot, foot + right, foot + right + up, foot + up}, {}}};
    return plane;
}

}  // namespace

class WallLineTest : public QObject {
    Q_OBJECT

private slots:
    void aWallIsALineBetweenItsEnds();
    void oneThatLeansIsTakenAtHalfItsHeight();
    void whatIsNotUprightOrNotSeenIsNone();
    void wallsOverlapAlongTheSecond();
};

void WallLineTest::aWallIsALineBetweenItsEnds()
{
    const auto line = wallLine(wallAhead());

    QVERIFY(line);
    QVERIFY((line->normal - Eigen::Vector2d(0.0, 1.0)).norm() < 1e-12);
    QVERIFY((line->middle() - Eigen::Vector2d(1.0, 2.0)).norm() < 1e-12);
    QVERIFY(std::abs(line->length() - 4.0) < 1e-12);
    QVERIFY(std::abs(line->offset({7.0, 2.5}) - 0.5) < 1e-12);
}

void WallLineTest::oneThatLeansIsTakenAtHalfItsHeight()
{
    const double lean = degrees(9.0);
    const auto line = wallLine(wallAhead(lean));
    QVERIFY(line);
    QVERIFY(std::abs(line->distance - (2.0 + std::sin(lean))) < 1e-12);
}

void WallLineTest::whatIsNotUprightOrNotSeenIsNone()
{
    QVERIFY(!wallLine(wallAhead(degrees(11.0))));
    FacedPlane unseen = wallAhead();
    unseen.parts.clear();
    QVERIFY(!wallLine(unseen));
}

void WallLineTest::wallsOverlapAlongTheSecond()
{
    const auto line = wallLine(wallAhead());
    const auto overlapAt = [&](double along) {
        return overlapOf(*wallLine(moved(wallAhead(), {Eigen::Quaterniond::Identity(), {along, 0.7, 0.0}})), *line);
    };
    QVERIFY(std::abs(overlapAt(0.0) - 4.0) < 1e-12);
    QVERIFY(std::abs(overlapAt(-2.5) - 1.5) < 1e-12);
    QVERIFY(std::abs(overlapAt(4.5) + 0.5) < 1e-12);
}

PLANEWRIGHT_TEST(WallLineTest)
#include "wall_line_test.moc"
