// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/coplanar_groups.h"

#include <cmath>
#include <vector>

#include <QTest>

#include "tests/test_program.h"

using namespace planewright;

namespace {

ComparedPlane wall(double tilt, double distance)
{
    return {0, {std::sin(tilt), std::cos(tilt), 0.0}, distance};
}

}  // namespace

class CoplanarGroupsTest : public QObject {
    Q_OBJECT

private slots:
    void planesWithinBothLimitsAreOne();
    void planesThreeMillimetresApartAreTwo();
    void planesATwelfthOfADegreeApartNearTheOriginAreOneAndAnEighthTwo();
    void theSamePlaneSeenFromBehindIsOne();
    void groupsNameTheirFirstPlane();
    void chainsAreOneGroup();
    void noPlanesGiveNoGroups();
};

void CoplanarGroupsTest::planesWithinBothLimitsAreOne()
{
    QVERIFY(areCoplanar(wall(0.0, 4.0), wall(0.0, 4.0019)));
}

void CoplanarGroupsTest::planesThreeMillimetresApartAreTwo()
{
    QVERIFY(!areCoplanar(wall(0.0, 4.0), wall(0.0, 4.003)));
}

void CoplanarGroupsTest::planesATwelfthOfADegreeApartNearTheOriginAreOneAndAnEighthTwo()
{
    QVERIFY(areCoplanar(wall(0.0, 0.1), wall(degrees(1.0 / 12.0), 0.1)));
    QVERIFY(!areCoplanar(wall(0.0, 0.1), wall(degrees(1.0 / 8.0), 0.1)));
}

void CoplanarGroupsTest::theSamePlaneSeenFromBehindIsOne()
{
    const ComparedPlane front{0, {0.0, 0.0, 1.0}, 0.0005};
    const ComparedPlane back{1, {0.0, 0.0, -1.0}, 0.0005};

    QVERIFY(areCoplanar(front, back));
}

void CoplanarGroupsTest::groupsNameTheirFirstPlane()
{
    const std::vector<ComparedPlane> planes{wall(0.0, 4.0), wall(0.0, 5.0), wall(0.0, 4.001), wall(0.5, 5.0),
                                            wall(0.0, 5.001)};

    const std::vector<std::size_t> groups = coplanarGroups(planes);

    QCOMPARE(groups, (std::vector<std::size_t>{0, 1, 0, 3, 1}));
}

void CoplanarGroupsTest::chainsAreOneGroup()
{
    const std::vector<ComparedPlane> planes{wall(0.0, 4.0), wall(0.0, 4.003), wall(0.0, 4.0015)};

    const std::vector<std::size_t> groups = coplanarGroups(planes);

    QCOMPARE(groups, (std::vector<std::size_t>{0, 0, 0}));
}

void CoplanarGroupsTest::noPlanesGiveNoGroups()
{
    QVERIFY(coplanarGroups({}).empty());
}

PLANEWRIGHT_TEST(CoplanarGroupsTest)
#include "coplanar_groups_test.moc"
