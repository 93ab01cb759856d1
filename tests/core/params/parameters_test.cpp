// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/params/parameters.h"

#include <tuple>
#include <vector>

#include <QtTest>

#include "core/params/parameter_rows.h"
#include "tests/test_program.h"

namespace planewright {

namespace {

/// A part of one row, whose default the row's range may or may not hold.
template <int kLowest>
struct OneRow {
    int value = 5;

    friend constexpr auto rowsOf(const OneRow& /*part*/)
    {
        return std::tuple{Parameter{"part.value", &OneRow::value, Unit::Count, Range{kLowest, 10.0}, "", "A number."}};
    }
};

/// Steps from 0 at which a question is answered with yes.
template <class Question>
std::vector<int> stepsBelow(int end, Question question)
{
    std::vector<int> steps;
    for (int step = 0; step < end; ++step) {
        if (question(step))
            steps.push_back(step);
    }
    return steps;
}

}  // namespace

class ParametersTest : public QObject {
    Q_OBJECT

private slots:
    void rangeVarianceAddsTheSquaresOfBothParts();
    void thePhasesRunEveryFiveSevenAndFiveSteps();
    void aDefaultOutOfItsRangeIsNoticed();
};

void ParametersTest::rangeVarianceAddsTheSquaresOfBothParts()
{
    NoiseParameters noise;
    noise.rangeConstant = 0.03;
    noise.rangeProportional = 0.004;

    // 30 mm and 10 m · 4 mm/m = 40 mm: a right triangle with the hypotenuse 50 mm.
    QVERIFY(std::abs(noise.rangeVariance(10.0) - 0.05 * 0.05) < 1e-15);
    QCOMPARE(noise.rangeVariance(0.0), 0.03 * 0.03);
}

void ParametersTest::thePhasesRunEveryFiveSevenAndFiveSteps()
{
    const ScheduleParameters schedule;

    QCOMPARE(stepsBelow(20, [&](int step) { return schedule.fitsPlanesAt(step); }), (std::vector{4, 9, 14, 19}));
    QCOMPARE(stepsBelow(21, [&](int step) { return schedule.splitsAndMergesAt(step); }), (std::vector{6, 13, 20}));
    QCOMPARE(stepsBelow(20, [&](int step) { return schedule.fitsRemainingAt(step); }), (std::vector{4, 9, 14, 19}));
}

void ParametersTest::aDefaultOutOfItsRangeIsNoticed()
{
    QVERIFY(defaultsAreInRange<OneRow<5>>());
    QVERIFY(!defaultsAreInRange<OneRow<6>>());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ParametersTest)
#include "parameters_test.moc"
