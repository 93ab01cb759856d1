// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/snap_height.h"

#include <cmath>
#include <vector>

#include <QTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

using Vector = Eigen::Vector3d;

constexpr double kRise = 0.2;   // [m]
constexpr double kGoing = 0.3;  // [m]
constexpr int kSteps = 15;      // 3 m from floor to floor

/// A rectangle between two corners whose edges are along the axes.
FacedPlane rectangle(const Vector& normal, const Vector& from, const Vector& to)
{
    const Vector across =
        std::abs(normal.z()) > 0.5 ? Vector(to.x(), from.y(), from.z()) : Vector(to.x(), to.y(), from.z());
    const Vector up = from + to - across;
    return {normal, normal.dot(from), {{{from, across, to, up}, {}}}};
}

FacedPlane level(double height, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    return rectangle(-Vector::UnitZ(), {from.x(), from.y(), height}, {to.x(), to.y(), height});
}

FacedPlane ground(double height = 0.0)
{
    return level(height, {-5.0, -5.0}, {5.0, 0.0});
}

/// Step n leads up to n · rise, 1 m wide from x = 0, along y.
FacedPlane tread(int step)
{
    return level(step * kRise, {0.0, (step - 1) * kGoing}, {1.0, step * kGoing});
}

/// `seen` of its height, from the top down.
FacedPlane riser(int step, double seen = kRise)
{
    const double y = (step - 1) * kGoing;
    return rectangle(Vector::UnitY(), {0.0, y, step * kRise - seen}, {1.0, y, step * kRise});
}

std::vector<FacedPlane> lifted(std::vector<FacedPlane> planes, double by)
{
    for (FacedPlane& plane : planes)
        plane = moved(std::move(plane), {Eigen::Quaterniond::Identity(), {0.0, 0.0, by}});
    return planes;
}

}  // namespace

class SnapHeightTest : public QObject {
    Q_OBJECT

private slots:
    void sharedTreadsTellTheHeight();
    void theLowerFloorComesToTheUpperOneToo();
    void topsOfRisersTellItWhereATreadHidesTheirFeet();
    void theFloorBelowSeenFromAboveTellsIt();
    void whereTheFloorLeansItsHeightIsThatAtTheStairs();
    void whatStandsOnAStoreyHasNoSay();
    void oneSurfaceThatIsOffHasNoSayAgainstMore();
    void treadsBesideEachOtherAreNoPartners();
    void risersOfOtherStepsAreNoPartners();
    void twoStoreysDoNotStandInEachOther();
    void moreThanAMetreAndAHalfIsTooFar();
    void withoutAnythingToStandOnThereIsNoHeight();
};

void SnapHeightTest::sharedTreadsTellTheHeight()
{
    const std::vector<FacedPlane> lower{ground(), tread(3), tread(8), tread(9), tread(10)};
    const std::vector<FacedPlane> upper{ground(3.0), tread(9), tread(10), tread(12)};

    for (const double off : {0.4, -0.4, 1.4, -1.4}) {
        const auto snap = snapHeight(lifted(upper, off), lower);

        QVERIFY(snap);
        QVERIFY(std::abs(snap->lift + off) < 1e-9);
        QCOMPARE(snap->surfaces, 2);
        QVERIFY(snap->rms < 1e-9);
    }
}

void SnapHeightTest::theLowerFloorComesToTheUpperOneToo()
{
    const std::vector<FacedPlane> lower{ground(), tread(9), tread(10)};
    const std::vector<FacedPlane> upper{ground(3.0), tread(9), tread(10)};

    const auto snap = snapHeight(lifted(lower, -0.7), upper);

    QVERIFY(snap);
    QVERIFY(std::abs(snap->lift - 0.7) < 1e-9);
    QCOMPARE(snap->surfaces, 2);
}

void SnapHeightTest::topsOfRisersTellItWhereATreadHidesTheirFeet()
{
    const std::vector<FacedPlane> lower{ground(), riser(9, 0.15), riser(10, 0.14), riser(11, 0.12)};
    const std::vector<FacedPlane> upper{ground(3.0), riser(9), riser(10), riser(11)};

    const auto snap = snapHeight(lifted(upper, 0.35), lower);

    QVERIFY(snap);
    QVERIFY(std::abs(snap->lift + 0.35) < 1e-9);
    QCOMPARE(snap->surfaces, 3);
}

void SnapHeightTest::theFloorBelowSeenFromAboveTellsIt()
{
    const std::vector<FacedPlane> upper{ground(3.0), level(0.0, {-2.0, -2.0}, {-1.0, -1.0})};

    const auto snap = snapHeight(lifted(upper, 0.8), std::vector{ground()});

    QVERIFY(snap);
    QVERIFY(std::abs(snap->lift + 0.8) < 1e-9);
    QCOMPARE(snap->surfaces, 1);
}

/// 1° over 100 m would be 1.7 m.
void SnapHeightTest::whereTheFloorLeansItsHeightIsThatAtTheStairs()
{
    const Vector stairs{100.0, 0.0, 0.0};
    const std::vector<FacedPlane> lower{ground(), tread(9), tread(10)};
    std::vector<FacedPlane> there = lower;
    std::vector<FacedPlane> leaning{ground(3.0), tread(9), tread(10)};
    for (FacedPlane& plane : there)
        plane = moved(std::move(plane), {Eigen::Quaterniond::Identity(), stairs});
    for (FacedPlane& plane : leaning) {
        plane = moved(std::move(plane), {rotationAbout({0.0, degrees(1.0), 0.0}), Vector::Zero()});
        plane = moved(std::move(plane), {Eigen::Quaterniond::Identity(), stairs + Vector(0.0, 0.0, 0.5)});
    }

    const auto snap = snapHeight(leaning, there);

    QVERIFY(snap);
    // Half a metre from the axis that it leans about.
    QVERIFY(std::abs(snap->lift + 0.5 - 0.5 * std::sin(degrees(1.0))) < 1e-3);
    QCOMPARE(snap->surfaces, 2);
}

/// The same tables on both floors, half a metre too high: who takes them for stairs lowers the floor.
void SnapHeightTest::whatStandsOnAStoreyHasNoSay()
{
    std::vector<FacedPlane> lower{ground(), tread(10), tread(11)};
    std::vector<FacedPlane> upper{ground(3.0), tread(10), tread(11)};
    for (int i = 0; i < 6; ++i) {
        const Eigen::Vector2d corner(i - 4.0, -3.0);
        lower.push_back(level(2.6, corner, corner + Eigen::Vector2d(0.8, 0.8)));
        upper.push_back(level(3.7, corner, corner + Eigen::Vector2d(0.8, 0.8)));
    }

    const auto snap = snapHeight(lifted(upper, 0.2), lower);

    QVERIFY(snap);
    QVERIFY(std::abs(snap->lift + 0.2) < 1e-9);
    QCOMPARE(snap->surfaces, 2);
}

void SnapHeightTest::oneSurfaceThatIsOffHasNoSayAgainstMore()
{
    const std::vector<FacedPlane> lower{ground(), tread(9), tread(10), level(2.5, {-3.0, 1.0}, {-2.0, 2.0})};
    const std::vector<FacedPlane> upper{ground(3.0), tread(9), tread(10), level(2.3, {-3.0, 1.0}, {-2.0, 2.0})};

    const auto snap = snapHeight(lifted(upper, 0.3), lower);

    QVERIFY(snap);
    QVERIFY(std::abs(snap->lift + 0.3) < 1e-9);
    QCOMPARE(snap->surfaces, 2);
}

void SnapHeightTest::treadsBesideEachOtherAreNoPartners()
{
    const std::vector<FacedPlane> lower{ground(), tread(8), tread(9)};
    QVERIFY(!snapHeight(std::vector{ground(3.0), tread(10), tread(11)}, lower));
    // Two fifths of a tread over another one are not enough, three fifths are.
    const auto beside = [&](double along) {
        const FacedPlane shifted = moved(tread(9), {Eigen::Quaterniond::Identity(), {0.0, along * kGoing, 0.0}});
        return snapHeight(std::vector{ground(3.0), shifted}, std::vector{ground(), tread(9)});
    };
    QVERIFY(!beside(0.6));
    QVERIFY(beside(0.4));
}

void SnapHeightTest::risersOfOtherStepsAreNoPartners()
{
    QVERIFY(!snapHeight(std::vector{ground(3.0), riser(10), riser(12)}, std::vector{ground(), riser(9), riser(11)}));
    // Nor are those of a flight beside it, nor the other sides of the same ones.
    const Pose besideIt{Eigen::Quaterniond::Identity(), {1.1, 0.0, 0.0}};
    QVERIFY(!snapHeight(std::vector{ground(3.0), riser(10)}, std::vector{ground(), moved(riser(10), besideIt)}));
    FacedPlane back = riser(10);
    back.normal = -back.normal;
    back.distance = -back.distance;
    QVERIFY(!snapHeight(std::vector{ground(3.0), riser(10)}, std::vector{ground(), back}));
    QVERIFY(snapHeight(std::vector{ground(3.0), riser(10)}, std::vector{ground(), riser(10)}));
}

/// The flights that lead up from either floor look the same.
void SnapHeightTest::twoStoreysDoNotStandInEachOther()
{
    const std::vector<FacedPlane> lower{ground(), tread(1), tread(2), tread(3)};

    QVERIFY(!snapHeight(lower, lower));
    QVERIFY(!snapHeight(lifted(lower, 0.9), lower));
    // Below what it is walked on the upper one sees nothing.
    QVERIFY(!snapHeight(lifted(lower, 1.1), lower));
}

void SnapHeightTest::moreThanAMetreAndAHalfIsTooFar()
{
    const std::vector<FacedPlane> lower{ground(), tread(9), tread(10)};
    const std::vector<FacedPlane> upper{ground(3.0), tread(9), tread(10)};
    QVERIFY(!snapHeight(lifted(upper, 1.6), lower));
    QVERIFY(!snapHeight(lifted(upper, -1.6), lower));
}

void SnapHeightTest::withoutAnythingToStandOnThereIsNoHeight()
{
    QVERIFY(!snapHeight({}, std::vector{ground()}));
    QVERIFY(!snapHeight(std::vector{ground()}, {}));
    QVERIFY(!snapHeight(std::vector{riser(9)}, std::vector{riser(9)}));
}

PLANEWRIGHT_TEST(SnapHeightTest)
#include "snap_height_test.moc"
