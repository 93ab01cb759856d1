// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/label_overlap.h"

#include <limits>
#include <map>
#include <random>

#include <QTest>

#include "tests/test_program.h"

using namespace planewright;

class LabelOverlapTest : public QObject {
    Q_OBJECT

private slots:
    void agreesWithCountingEveryPairByHand();
    void returnsThatAreNoPlaneAreLeftOutOfTheSizes();
    void idsMayBeAnyInt();
    void otherNumberOfLinesIsAnError();
    void otherLineLengthIsAnErrorThatNamesTheLine();
    void emptyGridsHaveNoRegions();
};

void LabelOverlapTest::agreesWithCountingEveryPairByHand()
{
    std::mt19937_64 random{20260101};
    const auto label = [&] { return static_cast<int>(random() % 7) - 2; };
    LabelGrid a(23, std::vector<int>(31));
    LabelGrid b = a;
    std::map<std::pair<int, int>, std::int64_t> counts;
    for (std::size_t row = 0; row < a.size(); ++row) {
        for (std::size_t beam = 0; beam < a[row].size(); ++beam) {
            a[row][beam] = label();
            b[row][beam] = label();
            ++counts[{a[row][beam], b[row][beam]}];
        }
    }

    const auto overlap = overlapOf(a, b);

    QVERIFY(overlap);
    QCOMPARE(overlap->regionsA.size(), std::size_t(5));
    QCOMPARE(overlap->regionsB.size(), std::size_t(5));
    QCOMPARE(overlap->common.size(), std::size_t(25));
    for (const LabelOverlap::Common& common : overlap->common) {
        const int idA = overlap->regionsA[common.a].id;
        const int idB = overlap->regionsB[common.b].id;
        QCOMPARE(common.returns, (counts[{idA, idB}]));
    }
    for (const LabelOverlap::Region& region : overlap->regionsA) {
        std::int64_t sum = 0;
        for (int other = -1; other <= 4; ++other)
            sum += counts[{region.id, other}];
        QCOMPARE(region.returns, sum);
        QCOMPARE(region.notPlane, (counts[{region.id, -2}]));
    }
    for (const LabelOverlap::Region& region : overlap->regionsB) {
        std::int64_t sum = 0;
        for (int other = -2; other <= 4; ++other)
            sum += counts[{other, region.id}];
        QCOMPARE(region.returns, sum);
    }
}

void LabelOverlapTest::returnsThatAreNoPlaneAreLeftOutOfTheSizes()
{
    const auto overlap = overlapOf({{3, 3, 3, 3}}, {{0, -1, -2, -2}});

    QVERIFY(overlap);
    QCOMPARE(overlap->regionsA[0].returns, std::int64_t(2));
    QCOMPARE(overlap->regionsA[0].notPlane, std::int64_t(2));
}

void LabelOverlapTest::idsMayBeAnyInt()
{
    constexpr int kLargest = std::numeric_limits<int>::max();
    constexpr int kSmallest = std::numeric_limits<int>::min();

    const auto overlap = overlapOf({{kLargest, kLargest, kSmallest}}, {{7, kSmallest, 7}});

    QVERIFY(overlap);
    QCOMPARE(overlap->regionsA.size(), std::size_t(1));
    QCOMPARE(overlap->regionsA[0].id, kLargest);
    QCOMPARE(overlap->regionsA[0].returns, std::int64_t(2));
    QCOMPARE(overlap->regionsB[0].returns, std::int64_t(2));
    QCOMPARE(overlap->common[0].returns, std::int64_t(1));
}

void LabelOverlapTest::otherNumberOfLinesIsAnError()
{
    const auto overlap = overlapOf({{1}}, {{1}, {1}});

    QVERIFY(!overlap);
    QCOMPARE(overlap.error().code, ErrorCode::Unreadable);
    QCOMPARE(overlap.error().message, std::string("1 lines against 2; both labellings must be of the same recording"));
}

void LabelOverlapTest::otherLineLengthIsAnErrorThatNamesTheLine()
{
    const auto overlap = overlapOf({{1}, {1, 1}}, {{1}, {1}});

    QVERIFY(!overlap);
    QCOMPARE(overlap.error().message,
             std::string("line 2: 2 labels against 1; both labellings must be of the same recording"));
}

void LabelOverlapTest::emptyGridsHaveNoRegions()
{
    const auto overlap = overlapOf({}, {});

    QVERIFY(overlap);
    QVERIFY(overlap->regionsA.empty());
    QVERIFY(overlap->common.empty());
}

PLANEWRIGHT_TEST(LabelOverlapTest)
#include "label_overlap_test.moc"
