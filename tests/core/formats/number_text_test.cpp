// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/number_text.h"

#include <charconv>
#include <clocale>
#include <cmath>
#include <limits>
#include <random>

#include <QtTest>

#include "tests/test_program.h"

using namespace planewright;

class NumberTextTest : public QObject {
    Q_OBJECT

private slots:
    void shortestFormOfNineSignificantDigits_data();
    void shortestFormOfNineSignificantDigits();
    void whatIsUnknownIsEmpty();
    void readsBackToNineDigits();
    void doesNotFollowTheLocale();
};

void NumberTextTest::shortestFormOfNineSignificantDigits_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("zero") << 0.0 << "0";
    QTest::newRow("no negative zero") << -0.0 << "0";
    QTest::newRow("whole") << 12.0 << "12";
    QTest::newRow("a tenth") << 0.1 << "0.1";
    QTest::newRow("noise behind the ninth digit is gone") << 0.1 + 0.2 << "0.3";
    QTest::newRow("a third") << 1.0 / 3.0 << "0.333333333";
    QTest::newRow("two thirds are rounded up") << -2.0 / 3.0 << "-0.666666667";
    QTest::newRow("nine digits before the point") << 123456789.4 << "123456789";
    QTest::newRow("carry through all digits") << 0.9999999999 << "1";
    QTest::newRow("small") << 1e-7 << "1e-07";
    QTest::newRow("longest") << -1.23456789e-300 << "-1.23456789e-300";
    QTest::newRow("largest") << std::numeric_limits<double>::max() << "1.79769313e+308";
}

void NumberTextTest::shortestFormOfNineSignificantDigits()
{
    QFETCH(double, value);
    QFETCH(QString, text);

    QCOMPARE(QString::fromStdString(formatNumber(value)), text);
}

void NumberTextTest::whatIsUnknownIsEmpty()
{
    QVERIFY(formatNumber(std::numeric_limits<double>::quiet_NaN()).empty());
    QVERIFY(formatNumber(std::numeric_limits<double>::infinity()).empty());

    std::string text = "d=";
    appendNumber(text, 2.5);
    QCOMPARE(text, std::string("d=2.5"));
}

void NumberTextTest::readsBackToNineDigits()
{
    std::mt19937_64 random{11};
    for (int i = 0; i < 10000; ++i) {
        const int exponent = static_cast<int>(random() % 40) - 20;
        const double value = std::ldexp(static_cast<double>(random() >> 11), exponent - 53);

        const std::string text = formatNumber(value);

        double read = -1.0;
        std::from_chars(text.data(), text.data() + text.size(), read);
        QVERIFY2(std::abs(read - value) <= 0.5e-8 * value, text.c_str());
        QCOMPARE(formatNumber(read), text);
    }
}

void NumberTextTest::doesNotFollowTheLocale()
{
    QVERIFY2(std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr,
             "the locale de_DE.UTF-8 is missing: install locales-all");

    const std::string text = formatNumber(1234.5);
    std::setlocale(LC_ALL, "C");

    QCOMPARE(text, std::string("1234.5"));
}

PLANEWRIGHT_TEST(NumberTextTest)
#include "number_text_test.moc"
