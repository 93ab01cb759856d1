// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string_view>
#include <vector>

#include <QtTest>

#include "tests/core/planes/one_wall.h"
#include "tests/test_program.h"

namespace planewright {

class DropUnfoundedTest : public QObject {
    Q_OBJECT

private slots:
    void aFoundedPlaneStays();
    void aPlaneFillsItsSolidAngle();
    void aPlaneIsNoPatchNextToThePitchAxis();
    void aPlaneHasItsSegmentsAndSlices();
    void aPairNeedsTwoSlicesOnly();
    void aNarrowPlaneThatStandsFreeIsAPole_data();
    void aNarrowPlaneThatStandsFreeIsAPole();
    void aPlaneExplainsItsSegments();
    void aPlaneOfManySegmentsNeedNotExplainThem();
    void aPlaneKnowsItsNormal();
    void aPlaneIsOfStraightSegments_data();
    void aPlaneIsOfStraightSegments();
    void aPlaneIsMetAtMoreThanAGrazingAngle_data();
    void aPlaneIsMetAtMoreThanAGrazingAngle();
    void droppedPlanesFreeTheirSegments();
};

void DropUnfoundedTest::aFoundedPlaneStays()
{
    OneWall wall(10);

    QVERIFY(wall.droppedFor().empty());

    QCOMPARE(wall.scan.map.planes().size(), std::size_t{1});
    QVERIFY(wall.scan.recorded.report.decisions.empty());
}

void DropUnfoundedTest::aPlaneFillsItsSolidAngle()
{
    // 0.0106 sr of 0.25° × 1.16° each are 120 points.
    QVERIFY(OneWall(3, wallBy(320, 359)).droppedFor().empty());
    QVERIFY((OneWall(3, wallBy(320, 358)).droppedFor() == Names{"points"}));

    // Twelve points are the least.
    OneWall few(3, wallBy(320, 323));
    OneWall fewer(3, wallBy(320, 322));
    few.scan.parameters.likelihood.minSolidAngle = 0.0;
    fewer.scan.parameters.likelihood.minSolidAngle = 0.0;
    few.scan.parameters.planes.maxNormalSigma = fewer.scan.parameters.planes.maxNormalSigma = degrees(45.0);
    QVERIFY(few.droppedFor().empty());
    QVERIFY((fewer.droppedFor() == Names{"points", "spread_points"}));
}

void DropUnfoundedTest::aPlaneIsNoPatchNextToThePitchAxis()
{
    // Beams 709 to 719 are those at 177.25° to 179.75°, at 1.5° from the pitch axis on average: eleven points of a
    // slice count as 0.29, and ten are those of 35 slices.
    const auto patch = [](int slices) {
        OneWall wall(slices, {Eigen::Vector3d{-1.0, 0.0, 0.0}, 1.2, 709, 719}, degrees(60.0));
        wall.scan.parameters.planes.maxNormalSigma = degrees(45.0);
        wall.scan.parameters.planes.minIncidence = 0.0;
        wall.scan.parameters.likelihood.stripWidth = 0.0;
        return wall.droppedFor();
    };
    QVERIFY((patch(32) == Names{"spread_points"}));
    QVERIFY(patch(38).empty());
}

void DropUnfoundedTest::aPlaneHasItsSegmentsAndSlices()
{
    OneWall segments(4);
    segments.scan.parameters.planes.minSegments = 5;
    QVERIFY((segments.droppedFor() == Names{"segments"}));

    OneWall slices(4);
    slices.scan.parameters.planes.minSlices = 5;
    QVERIFY((slices.droppedFor() == Names{"slices"}));

    OneWall enough(5);
    enough.scan.parameters.planes.minSegments = 5;
    enough.scan.parameters.planes.minSlices = 5;
    QVERIFY(enough.droppedFor().empty());
}

void DropUnfoundedTest::aPairNeedsTwoSlicesOnly()
{
    OneWall wall(2);
    OneWall pair(2);
    pair.plane().ofPair = true;

    QVERIFY((wall.droppedFor() == Names{"segments", "slices"}));
    QVERIFY(pair.droppedFor().empty());
}

void DropUnfoundedTest::aNarrowPlaneThatStandsFreeIsAPole_data()
{
    QTest::addColumn<int>("beams");
    QTest::addColumn<int>("freeSlices");
    QTest::addColumn<bool>("pole");

    // A beam is 4 m · 0.25° = 17.5 mm wide, or a little more where the wall is met obliquely: 12 cm are six of them.
    QTest::newRow("narrow and free in 13 of 20 slices") << 7 << 13 << true;
    QTest::newRow("narrow and free in 12 of 20 slices") << 7 << 12 << false;
    QTest::newRow("nine beams wide and free in all slices") << 9 << 20 << false;
}

void DropUnfoundedTest::aNarrowPlaneThatStandsFreeIsAPole()
{
    QFETCH(const int, beams);
    QFETCH(const int, freeSlices);
    QFETCH(const bool, pole);
    OneWall wall(20, wallBy(360, 359 + beams), degrees(80.0));
    for (SegmentNumber number = 0; number < 20; ++number) {
        wall.segment(number).startsFree = number < freeSlices;
        wall.segment(number).endsFree = true;
    }

    QVERIFY(wall.droppedFor() == (pole ? Names{"free_strip_share"} : Names{}));

    if (pole)
        QCOMPARE(testOf(wall.scan.recorded.report.decisions[0].tests, "free_strip_share").value, freeSlices / 20.0);
}

void DropUnfoundedTest::aPlaneExplainsItsSegments()
{
    // Three segments have three degrees of freedom: 1 + 3·√(2/3) is the limit.
    OneWall wall(3);
    const double limit = 1.0 + 3.0 * std::sqrt(2.0 / 3.0);
    disturb(wall.segment(1), 0.0, 0.004);
    wall.make(kWall);
    const double part = wall.reducedChi() / limit;
    QVERIFY(part > 0.0);

    for (const double factor : {0.95, 1.05}) {
        // χ² goes with the square of what a segment is turned by.
        OneWall turned(3);
        disturb(turned.segment(1), 0.0, std::atan(0.004 * std::sqrt(factor / part)));
        turned.make(kWall);
        const double reduced = turned.reducedChi();
        QVERIFY(std::abs(reduced / (factor * limit) - 1.0) < 0.02);

        QVERIFY(turned.droppedFor() == (factor > 1.0 ? Names{"reduced_chi2"} : Names{}));

        if (factor > 1.0) {
            const Test test = testOf(turned.scan.recorded.report.decisions[0].tests, "reduced_chi2");
            QVERIFY(std::abs(test.value / reduced - 1.0) < 1e-12);
            QVERIFY(std::abs(test.limit - limit) < 1e-12);
        }
    }
}

void DropUnfoundedTest::aPlaneOfManySegmentsNeedNotExplainThem()
{
    for (const int slices : {60, 61}) {
        OneWall wall(slices, kWall, degrees(60.0), degrees(1.0));
        for (SegmentNumber number = 0; number < slices; ++number)
            disturb(wall.segment(number), number % 2 == 0 ? 0.02 : -0.02, 0.0);
        wall.make(kWall);

        QVERIFY(wall.droppedFor() == (slices == 60 ? Names{"reduced_chi2"} : Names{}));
    }
}

void DropUnfoundedTest::aPlaneKnowsItsNormal()
{
    OneWall wall(4);
    OneWall strict(4);
    const double sigma = std::sqrt(wall.plane().estimate.normalVariance());
    wall.scan.parameters.planes.maxNormalSigma = 1.01 * sigma;
    strict.scan.parameters.planes.maxNormalSigma = 0.99 * sigma;

    QVERIFY(wall.droppedFor().empty());
    QVERIFY((strict.droppedFor() == Names{"normal_sigma"}));
    OneWall together(4);
    together.scan.parameters.planes.maxNormalSigma = 0.99 * sigma;
    together.scan.parameters.noise.systematic = 0.0015;
    QVERIFY(together.droppedFor().empty());
}

void DropUnfoundedTest::aPlaneIsOfStraightSegments_data()
{
    QTest::addColumn<double>("chi");
    QTest::addColumn<int>("segments");
    QTest::addColumn<bool>("dropped");

    // 81 points have 79 degrees of freedom: they are straight up to 2·(79 + 4·√158) = 258.6.
    QTest::newRow("six of ten bent") << 259.0 << 6 << true;
    QTest::newRow("half of them bent") << 259.0 << 5 << false;
    QTest::newRow("all of them nearly bent") << 258.0 << 10 << false;
}

void DropUnfoundedTest::aPlaneIsOfStraightSegments()
{
    QFETCH(const double, chi);
    QFETCH(const int, segments);
    QFETCH(const bool, dropped);
    OneWall wall(10);
    for (SegmentNumber number = 0; number < segments; ++number)
        wall.segment(number).chi = chi;

    QVERIFY(wall.droppedFor() == (dropped ? Names{"bent_share"} : Names{}));
}

void DropUnfoundedTest::aPlaneIsMetAtMoreThanAGrazingAngle_data()
{
    QTest::addColumn<double>("below");
    QTest::addColumn<bool>("dropped");

    // Straight ahead a floor is met at the angle by which the slice looks down: 0.1° less and more than this. At less
    // than 3° no segment can be told to belong, either.
    QTest::newRow("2.9 degrees") << 2.9 << true;
    QTest::newRow("3.1 degrees") << 3.1 << false;
}

void DropUnfoundedTest::aPlaneIsMetAtMoreThanAGrazingAngle()
{
    QFETCH(const double, below);
    QFETCH(const bool, dropped);
    OneWall floor(3, {-Eigen::Vector3d::UnitZ(), 0.2, 355, 365}, degrees(90.0 - below - 0.1), degrees(0.1));
    floor.scan.parameters.likelihood.minSolidAngle = 0.0;

    QVERIFY(floor.droppedFor() == (dropped ? Names{"reduced_chi2", "incidence"} : Names{}));
}

void DropUnfoundedTest::droppedPlanesFreeTheirSegments()
{
    NoddingScan scan;
    scan.nod(5, {wallBy(300, 303), wallBy(320, 400), wallBy(410, 413)});
    for (int i = 0; i < 3; ++i)
        scan.makePlane(scan.column(i, 0, 4), kWall);

    dropUnfounded(scan.map, scan.parameters, scan.recorded.recorder);

    QVERIFY((scan.planeIds() == std::vector<PlaneId>{1}));
    QVERIFY(disagreement(scan.map).empty());
    const auto decisions = scan.recorded.decisions(DecisionKind::NoFit);
    QCOMPARE(decisions.size(), std::size_t{2});
    QCOMPARE(planeOf(decisions[0].operands.at(0)), 0);
    QCOMPARE(planeOf(decisions[1].operands.at(0)), 2);
    QCOMPARE(testOf(decisions[0].tests, "points").value, 20.0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DropUnfoundedTest)
#include "drop_unfounded_test.moc"
