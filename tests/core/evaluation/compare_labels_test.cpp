// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/compare_labels.h"

#include <cmath>

#include <QTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

/// A row of beams: runs of (label, beams).
std::vector<int> row(std::initializer_list<std::pair<int, int>> runs)
{
    std::vector<int> labels;
    for (const auto& [label, beams] : runs)
        labels.insert(labels.end(), static_cast<std::size_t>(beams), label);
    return labels;
}

/// Planes 0 to count − 1, parallel and a metre apart, so that none are coplanar.
std::vector<ComparedPlane> stack(int count)
{
    std::vector<ComparedPlane> planes;
    for (int id = 0; id < count; ++id)
        planes.push_back({id, Eigen::Vector3d::UnitZ(), 1.0 + id});
    return planes;
}

LabelComparison compare(const LabelGrid& a, const LabelGrid& b, const LabelMatchSettings& settings = {})
{
    return *compareLabels(a, b, stack(6), stack(6), settings);
}

}  // namespace

class CompareLabelsTest : public QObject {
    Q_OBJECT

private slots:
    void regionsThatShareHalfOfBothAreCorrect();
    void aRegionThatSharesLessThanHalfIsNoiseAndItsGroupMissed();
    void aGroupInPiecesIsOverSegmented();
    void aRegionOverSeveralGroupsIsUnderSegmented();
    void leftoversOfACorrectRegionAreNotOverSegmented();
    void theLargerShareWinsWhereTwoCouldMatch();
    void aRegionIsInOneSetOnly();
    void coplanarPlanesOfBAreOneGroup();
    void coplanarPlanesOfAStaySeparate();
    void smallGroupsAreNobodysBusiness();
    void surfacesThatAreNoPlaneCountNeitherForNorAgainst();
    void overlapIsASetting();
    void errorsAreAgainstThePlaneSharedMost();
    void planesThatNobodySawTakeNoPart();
    void emptyScansCompareAsPerfect();
    void findingNothingHasNoRecall();
    void findingWhereNothingIsHasNoPrecision();
    void labelsWithoutPlanesAreAnError();
    void differentShapesAreAnError();
    void tooManyPlanesAreRefused();
};

void CompareLabelsTest::regionsThatShareHalfOfBothAreCorrect()
{
    const LabelGrid a{row({{3, 10}, {-1, 10}, {5, 20}})};
    const LabelGrid b{row({{0, 20}, {1, 10}, {-1, 10}})};

    const LabelComparison comparison = compare(a, b);

    QCOMPARE(comparison.correct.size(), std::size_t(2));
    QCOMPARE(comparison.correct[0].a, 3);
    QCOMPARE(comparison.correct[0].b, PlaneGroup{0});
    QCOMPARE(comparison.correct[0].common, std::int64_t(10));
    QCOMPARE(comparison.correct[1].a, 5);
    QCOMPARE(comparison.recall, 1.0);
    QCOMPARE(comparison.precision, 1.0);
    QCOMPARE(comparison.f1, 1.0);
}

void CompareLabelsTest::aRegionThatSharesLessThanHalfIsNoiseAndItsGroupMissed()
{
    const LabelGrid a{row({{0, 9}, {-1, 11}}), row({{1, 20}})};
    const LabelGrid b{row({{2, 20}}), row({{3, 20}})};

    const LabelComparison comparison = compare(a, b);

    QCOMPARE(comparison.noise, std::vector<int>{0});
    QCOMPARE(comparison.missed, std::vector<PlaneGroup>{{2}});
    QCOMPARE(comparison.correct.size(), std::size_t(1));
    QCOMPARE(comparison.recall, 0.5);
    QCOMPARE(comparison.precision, 0.5);
    QCOMPARE(comparison.f1, 0.5);
}

void CompareLabelsTest::aGroupInPiecesIsOverSegmented()
{
    const LabelGrid a{row({{0, 4}, {1, 4}, {2, 4}, {-1, 8}})};
    const LabelGrid b{row({{5, 20}})};

    const LabelComparison comparison = compare(a, b);

    QVERIFY(comparison.correct.empty());
    QCOMPARE(comparison.overSegmented.size(), std::size_t(1));
    QCOMPARE(comparison.overSegmented[0].b, PlaneGroup{5});
    QCOMPARE(comparison.overSegmented[0].a, (std::vector<int>{0, 1, 2}));
    QVERIFY(comparison.missed.empty());
    QVERIFY(comparison.noise.empty());
    QCOMPARE(comparison.recall, 0.0);
    QCOMPARE(comparison.precision, 0.0);
    QCOMPARE(comparison.f1, 0.0);
}

void CompareLabelsTest::aRegionOverSeveralGroupsIsUnderSegmented()
{
    const LabelGrid a{row({{4, 30}})};
    const LabelGrid b{row({{0, 10}, {1, 10}, {2, 10}})};

    const LabelComparison comparison = compare(a, b);

    QCOMPARE(comparison.underSegmented.size(), std::size_t(1));
    QCOMPARE(comparison.underSegmented[0].a, 4);
    QCOMPARE(comparison.underSegmented[0].b, (std::vector<PlaneGroup>{{0}, {1}, {2}}));
    QVERIFY(comparison.missed.empty());
    QVERIFY(comparison.noise.empty());
}

void CompareLabelsTest::leftoversOfACorrectRegionAreNotOverSegmented()
{
    const LabelGrid a{row({{0, 12}, {1, 4}, {2, 4}})};
    const LabelGrid b{row({{0, 20}})};

    const LabelComparison comparison = compare(a, b);

    QCOMPARE(comparison.correct.size(), std::size_t(1));
    QVERIFY(comparison.overSegmented.empty());
    QCOMPARE(comparison.noise, (std::vector<int>{1, 2}));
    QCOMPARE(comparison.precision, 1.0 / 3.0);
}

void CompareLabelsTest::theLargerShareWinsWhereTwoCouldMatch()
{
    const LabelGrid a{row({{0, 10}, {1, 10}}), row({{0, 2}, {-1, 18}})};
    const LabelGrid b{row({{3, 20}}), row({{-1, 20}})};

    const LabelComparison comparison = compare(a, b);

    QCOMPARE(comparison.correct.size(), std::size_t(1));
    QCOMPARE(comparison.correct[0].a, 1);
    QCOMPARE(comparison.noise, std::vector<int>{0});
}

void CompareLabelsTest::aRegionIsInOneSetOnly()
{
    // Half of region 0 lies in group 0, which region 1 shares; the other half covers groups 1 and 2.
    const LabelGrid a{row({{0, 8}, {1, 8}, {-1, 4}}), row({{0, 8}, {-1, 12}})};
    const LabelGrid b{row({{0, 20}}), row({{1, 4}, {2, 4}, {-1, 12}})};

    const LabelComparison comparison = compare(a, b);

    QCOMPARE(comparison.overSegmented.size(), std::size_t(1));
    QVERIFY(comparison.underSegmented.empty());
    QCOMPARE(comparison.missed, (std::vector<PlaneGroup>{{1}, {2}}));
}

void CompareLabelsTest::coplanarPlanesOfBAreOneGroup()
{
    std::vector<ComparedPlane> planesB = stack(3);
    planesB[2].distance = planesB[0].distance + 0.001;
    const LabelGrid a{row({{0, 10}, {1, 10}, {0, 10}})};
    const LabelGrid b{row({{0, 10}, {1, 10}, {2, 10}})};

    const auto comparison = compareLabels(a, b, stack(2), planesB, {});

    QVERIFY(comparison);
    QCOMPARE(comparison->groups, std::size_t(2));
    QCOMPARE(comparison->correct.size(), std::size_t(2));
    QCOMPARE(comparison->correct[0].b, (PlaneGroup{0, 2}));
    QCOMPARE(comparison->correct[0].common, std::int64_t(20));
}

void CompareLabelsTest::coplanarPlanesOfAStaySeparate()
{
    std::vector<ComparedPlane> planesA = stack(2);
    planesA[1].distance = planesA[0].distance;
    const LabelGrid a{row({{0, 10}, {1, 10}})};
    const LabelGrid b{row({{0, 20}})};

    const auto comparison = compareLabels(a, b, planesA, stack(1), {0.6, 0});

    QVERIFY(comparison);
    QCOMPARE(comparison->overSegmented.size(), std::size_t(1));
}

void CompareLabelsTest::smallGroupsAreNobodysBusiness()
{
    const LabelGrid a{row({{0, 20}}), row({{1, 5}, {2, 5}, {-1, 10}}), row({{3, 8}, {-1, 12}})};
    const LabelGrid b{row({{0, 20}}), row({{1, 5}, {-1, 2}, {2, 8}, {-1, 5}}), row({{-1, 20}})};

    const LabelComparison comparison = compare(a, b, {0.5, 10});

    QCOMPARE(comparison.groups, std::size_t(1));
    QCOMPARE(comparison.regions, std::size_t(2));
    QVERIFY(comparison.missed.empty());
    QCOMPARE(comparison.ignored, (std::vector<int>{1, 2}));
    QCOMPARE(comparison.noise, std::vector<int>{3});
    QCOMPARE(comparison.recall, 1.0);
    QCOMPARE(comparison.precision, 0.5);
}

void CompareLabelsTest::surfacesThatAreNoPlaneCountNeitherForNorAgainst()
{
    // Region 0 is a wall that runs on over a pillar; region 1 lies on the pillar alone.
    const LabelGrid a{row({{0, 30}}), row({{1, 30}})};
    const LabelGrid b{row({{0, 10}, {-2, 20}}), row({{-2, 30}})};

    const LabelComparison comparison = compare(a, b, {0.8, 0});

    QCOMPARE(comparison.correct.size(), std::size_t(1));
    QCOMPARE(comparison.correct[0].a, 0);
    QCOMPARE(comparison.ignored, std::vector<int>{1});
    QVERIFY(comparison.noise.empty());
    QCOMPARE(comparison.precision, 1.0);
}

void CompareLabelsTest::overlapIsASetting()
{
    const LabelGrid a{row({{0, 15}, {-1, 5}})};
    const LabelGrid b{row({{0, 20}})};

    QCOMPARE(compare(a, b, {0.75, 0}).correct.size(), std::size_t(1));
    QCOMPARE(compare(a, b, {0.8, 0}).correct.size(), std::size_t(0));
}

void CompareLabelsTest::errorsAreAgainstThePlaneSharedMost()
{
    const double turn = degrees(0.05);
    const std::vector<ComparedPlane> planesB{{0, Eigen::Vector3d::UnitZ(), 1.0},
                                             {1, {std::sin(turn), 0.0, std::cos(turn)}, 1.001}};
    const std::vector<ComparedPlane> planesA{{7, Eigen::Vector3d::UnitZ(), 1.011}};
    const LabelGrid a{row({{7, 30}})};
    const LabelGrid b{row({{0, 10}, {1, 20}})};

    const auto comparison = compareLabels(a, b, planesA, planesB, {});

    QVERIFY(comparison);
    QCOMPARE(comparison->errors.count, std::size_t(1));
    QVERIFY(std::abs(comparison->errors.angle.max - turn) < 1e-12);
    QVERIFY(std::abs(comparison->errors.distance.max - 0.010) < 1e-12);
}

void CompareLabelsTest::planesThatNobodySawTakeNoPart()
{
    const LabelComparison comparison = compare({row({{0, 5}})}, {row({{0, 5}})});

    QCOMPARE(comparison.groups, std::size_t(1));
    QCOMPARE(comparison.regions, std::size_t(1));
}

void CompareLabelsTest::emptyScansCompareAsPerfect()
{
    const LabelComparison comparison = compare({row({{-1, 5}})}, {row({{-1, 5}})});

    QCOMPARE(comparison.recall, 1.0);
    QCOMPARE(comparison.precision, 1.0);
    QCOMPARE(comparison.f1, 1.0);
    QCOMPARE(comparison.errors.count, std::size_t(0));
}

void CompareLabelsTest::findingNothingHasNoRecall()
{
    const LabelComparison comparison = compare({row({{-1, 5}})}, {row({{2, 5}})});

    QCOMPARE(comparison.recall, 0.0);
    QCOMPARE(comparison.precision, 1.0);
    QCOMPARE(comparison.f1, 0.0);
    QCOMPARE(comparison.missed, std::vector<PlaneGroup>{{2}});
}

void CompareLabelsTest::findingWhereNothingIsHasNoPrecision()
{
    const LabelComparison comparison = compare({row({{2, 5}})}, {row({{-1, 5}})});

    QCOMPARE(comparison.recall, 1.0);
    QCOMPARE(comparison.precision, 0.0);
    QCOMPARE(comparison.noise, std::vector<int>{2});
}

void CompareLabelsTest::labelsWithoutPlanesAreAnError()
{
    const auto missingA = compareLabels({{9}}, {{0}}, stack(2), stack(2), {});
    const auto missingB = compareLabels({{0}}, {{9}}, stack(2), stack(2), {});

    QVERIFY(!missingA);
    QCOMPARE(missingA.error().code, ErrorCode::Unreadable);
    QVERIFY(missingA.error().message.starts_with("the labels of A name plane 9"));
    QVERIFY(!missingB);
    QVERIFY(missingB.error().message.starts_with("the labels of B name plane 9"));
}

void CompareLabelsTest::differentShapesAreAnError()
{
    QVERIFY(!compareLabels({{0}}, {{0, 0}}, stack(1), stack(1), {}));
}

void CompareLabelsTest::tooManyPlanesAreRefused()
{
    const std::vector<ComparedPlane> many(kMaxComparedPlanes + 1);

    const auto comparison = compareLabels({}, {}, {}, many, {});

    QVERIFY(!comparison);
    QCOMPARE(comparison.error().code, ErrorCode::Usage);
}

PLANEWRIGHT_TEST(CompareLabelsTest)
#include "compare_labels_test.moc"
