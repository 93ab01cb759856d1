// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/angle_text.h"

#include <limits>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

class AngleTextTest : public QObject {
    Q_OBJECT

private slots:
    void anglesAreReadInDegrees();
    void numbersHaveTheDecimalsThatAreAskedFor();
};

void AngleTextTest::anglesAreReadInDegrees()
{
    QCOMPARE(degreesText(degrees(11.734), 2), std::string("11.73°"));
    QCOMPARE(degreesText(degrees(-0.29), 2), std::string("-0.29°"));
    QCOMPARE(degreesText(degrees(5.006), 2), std::string("5.01°"));
    QCOMPARE(degreesText(degrees(90.0), 1), std::string("90°"));
    QCOMPARE(degreesText(degrees(12.5), 2), std::string("12.5°"));
    QCOMPARE(degreesText(degrees(100.4), 0), std::string("100°"));
    QCOMPARE(degreesText(degrees(-0.001), 1), std::string("0°"));
    QCOMPARE(degreesText(std::numeric_limits<double>::quiet_NaN(), 1), std::string("no angle"));
    QCOMPARE(degreesText(std::numeric_limits<double>::infinity(), 1), std::string("no angle"));
}

void AngleTextTest::numbersHaveTheDecimalsThatAreAskedFor()
{
    QCOMPARE(fixedText(14.8, 2), std::string("14.80"));
    QCOMPARE(fixedText(-2.5, 1), std::string("-2.5"));
    QCOMPARE(fixedText(81.6, 0), std::string("82"));
    QCOMPARE(fixedText(-0.001, 2), std::string("0.00"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::AngleTextTest)
#include "angle_text_test.moc"
