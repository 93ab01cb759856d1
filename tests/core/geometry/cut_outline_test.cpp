// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/cut_outline.h"

#include <QTest>

#include "tests/test_program.h"

using namespace planewright;

class CutOutlineTest : public QObject {
    Q_OBJECT

private slots:
    void aWallIsCutFromSideToSide();
    void aDoorIsLeftOut();
    void aLeaningWallIsCutWhereItIsAtThatHeight();
    void partsAreCutEachForItself();
    void aboveAndBelowThereIsNothing();
    void aLevelPlaneIsNotCut();
    void aCornerThatTouchesTheHeightIsNoPiece();
    void anEdgeAtTheHeightIsCutAsWhatIsBelowIt();
};

namespace {

const Eigen::Vector3d kForward{0.0, 1.0, 0.0};

using Ring = std::vector<Eigen::Vector3d>;

/// A rectangle in the plane y = 2, from x0 to x1 and z0 to z1.
Ring rectangle(double x0, double x1, double z0, double z1)
{
    return {{x0, 2.0, z0}, {x1, 2.0, z0}, {x1, 2.0, z1}, {x0, 2.0, z1}};
}

Outline outlineOfParts(std::vector<Outline::Polygon> parts)
{
    Outline outline;
    outline.parts = std::move(parts);
    return outline;
}

}  // namespace

void CutOutlineTest::aWallIsCutFromSideToSide()
{
    const auto lines = cutAtHeight(outlineOfParts({{rectangle(-1.0, 3.0, -0.9, 2.0), {}}}), kForward, 0.1);

    QCOMPARE(lines.size(), std::size_t(1));
    QVERIFY(lines[0].from.isApprox(Eigen::Vector2d(3.0, 2.0)));  // along n × z: to the left of who looks along n
    QVERIFY(lines[0].to.isApprox(Eigen::Vector2d(-1.0, 2.0)));
}

void CutOutlineTest::aDoorIsLeftOut()
{
    const auto lines = cutAtHeight(
        outlineOfParts({{rectangle(-1.0, 3.0, -0.9, 2.0), {rectangle(0.0, 0.8, -0.8, 1.1)}}}), kForward, 0.1);

    QCOMPARE(lines.size(), std::size_t(2));
    QVERIFY(lines[0].from.isApprox(Eigen::Vector2d(3.0, 2.0)));
    QVERIFY(lines[0].to.isApprox(Eigen::Vector2d(0.8, 2.0)));
    QVERIFY(lines[1].from.isApprox(Eigen::Vector2d(0.0, 2.0)));
    QVERIFY(lines[1].to.isApprox(Eigen::Vector2d(-1.0, 2.0)));
}

void CutOutlineTest::aLeaningWallIsCutWhereItIsAtThatHeight()
{
    // It leans back by one in two: y = 2 + z / 2.
    const Ring ring{{0.0, 2.0, 0.0}, {1.0, 2.0, 0.0}, {1.0, 3.0, 2.0}, {0.0, 3.0, 2.0}};

    const auto lines = cutAtHeight(outlineOfParts({{ring, {}}}), Eigen::Vector3d(0.0, 2.0, -1.0).normalized(), 0.5);

    QCOMPARE(lines.size(), std::size_t(1));
    QVERIFY(lines[0].from.isApprox(Eigen::Vector2d(1.0, 2.25)));
    QVERIFY(lines[0].to.isApprox(Eigen::Vector2d(0.0, 2.25)));
}

void CutOutlineTest::partsAreCutEachForItself()
{
    const auto lines = cutAtHeight(
        outlineOfParts({{rectangle(0.0, 1.0, 0.0, 2.0), {}}, {rectangle(2.0, 3.0, 0.0, 2.0), {}}}), kForward, 1.0);

    QCOMPARE(lines.size(), std::size_t(2));
    QCOMPARE((lines[0].to - lines[0].from).norm(), 1.0);
    QCOMPARE((lines[1].to - lines[1].from).norm(), 1.0);
}

void CutOutlineTest::aboveAndBelowThereIsNothing()
{
    const Outline wall = outlineOfParts({{rectangle(0.0, 1.0, 0.0, 2.0), {}}});

    QVERIFY(cutAtHeight(wall, kForward, -0.1).empty());
    QVERIFY(cutAtHeight(wall, kForward, 2.1).empty());
    QVERIFY(cutAtHeight({}, kForward, 1.0).empty());
}

void CutOutlineTest::aLevelPlaneIsNotCut()
{
    const Ring ring{{0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, {1.0, 1.0, 1.0}};

    QVERIFY(cutAtHeight(outlineOfParts({{ring, {}}}), Eigen::Vector3d::UnitZ(), 1.0).empty());
}

void CutOutlineTest::aCornerThatTouchesTheHeightIsNoPiece()
{
    const Ring roof{{0.0, 2.0, 0.0}, {2.0, 2.0, 0.0}, {1.0, 2.0, 1.0}};

    QVERIFY(cutAtHeight(outlineOfParts({{roof, {}}}), kForward, 1.0).empty());
}

void CutOutlineTest::anEdgeAtTheHeightIsCutAsWhatIsBelowIt()
{
    const Ring step{{0.0, 2.0, 0.0}, {2.0, 2.0, 0.0}, {2.0, 2.0, 2.0},
                    {1.0, 2.0, 2.0}, {1.0, 2.0, 1.0}, {0.0, 2.0, 1.0}};

    const auto lines = cutAtHeight(outlineOfParts({{step, {}}}), kForward, 1.0);

    QCOMPARE(lines.size(), std::size_t(1));
    QVERIFY(lines[0].from.isApprox(Eigen::Vector2d(2.0, 2.0)));
    QVERIFY(lines[0].to.isApprox(Eigen::Vector2d(0.0, 2.0)));
}

PLANEWRIGHT_TEST(CutOutlineTest)
#include "cut_outline_test.moc"
