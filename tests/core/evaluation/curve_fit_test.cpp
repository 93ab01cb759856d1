// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/curve_fit.h"

#include <cmath>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class CurveFitTest : public QObject {
    Q_OBJECT

private slots:
    void aStraightLineIsFoundExactly();
    void scatterLowersWhatIsExplained();
    void pointsAboveEachOtherGiveALevelLine();
    void aPowerIsFoundExactly();
};

void CurveFitTest::aStraightLineIsFoundExactly()
{
    const LineFit line = lineThrough({1.0, 2.0, 4.0}, {5.0, 7.0, 11.0});

    QCOMPARE(line.slope, 2.0);
    QCOMPARE(line.intercept, 3.0);
    QVERIFY(std::abs(line.explained - 1.0) < 1e-12);
}

void CurveFitTest::scatterLowersWhatIsExplained()
{
    // Means 1 and 1; sums of squares 2 and 2, of products 1.
    const LineFit line = lineThrough({0.0, 1.0, 2.0}, {0.0, 2.0, 1.0});

    QCOMPARE(line.slope, 0.5);
    QCOMPARE(line.intercept, 0.5);
    QCOMPARE(line.explained, 0.25);
}

void CurveFitTest::pointsAboveEachOtherGiveALevelLine()
{
    const LineFit line = lineThrough({3.0, 3.0}, {1.0, 2.0});

    QCOMPARE(line.slope, 0.0);
    QCOMPARE(line.intercept, 1.5);
    QCOMPARE(line.explained, 0.0);
    QCOMPARE(lineThrough({}, {}).intercept, 0.0);
}

void CurveFitTest::aPowerIsFoundExactly()
{
    const PowerFit power = powerThrough({1.0, 2.0, 4.0}, {3.0, 12.0, 48.0});

    QVERIFY(std::abs(power.exponent - 2.0) < 1e-12);
    QVERIFY(std::abs(power.factor - 3.0) < 1e-12);
    QVERIFY(std::abs(power.explained - 1.0) < 1e-12);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::CurveFitTest)
#include "curve_fit_test.moc"
