// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_encoding.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class ScipEncodingTest : public QObject {
    Q_OBJECT

private slots:
    void sumsAreThoseOfTheSpecificationAndOfRealSessions_data();
    void sumsAreThoseOfTheSpecificationAndOfRealSessions();
    void numbersAreThoseOfTheSpecification_data();
    void numbersAreThoseOfTheSpecification();
    void everyNumberOfTwoCharactersComesBack();
    void aCharacterOutsideTheAlphabetIsNoNumber();
    void aLineEndsWithItsSumOrItDoesNot();
    void aBlockIsCutIntoLinesOf64();
};

void ScipEncodingTest::sumsAreThoseOfTheSpecificationAndOfRealSessions_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<char>("sum");
    const auto row = [](const char* text, char sum) { QTest::newRow(text) << QString{text} << sum; };
    row("Hokuyo", 'o');
    row("00", 'P');
    row("99", 'b');
    row("02", 'R');
    row("10", 'Q');
    row("0E", 'e');
    row("0L", 'l');
    row("BI9Y", 'M');
    row("<Sfk", 'P');
    row("<Sfl", 'Q');
    row("00]0LA00`0Kd00a0L000b0KB00a0Kc00b0K@00h0KR00h0K^00h0Jm00h0KG00g0", '7');
}

void ScipEncodingTest::sumsAreThoseOfTheSpecificationAndOfRealSessions()
{
    QFETCH(QString, text);
    QFETCH(char, sum);

    QCOMPARE(scipSum(text.toStdString()), sum);
    QVERIFY(endsWithScipSum(text.toStdString() + sum));
}

void ScipEncodingTest::numbersAreThoseOfTheSpecification_data()
{
    QTest::addColumn<QString>("characters");
    QTest::addColumn<quint32>("value");
    const auto row = [](const char* characters, quint32 value) {
        QTest::newRow(characters) << QString{characters} << value;
    };
    row("CB", 1234);
    row("1Dh", 5432);
    row("m2@0", 16'000'000);
    row("oooo", (1U << 24U) - 1);
    row(">YP", 60'000);
    row("?om", 65'533);
    row("7D`", 30'000);
    row("BI9Y", 4'821'609);
    row("00]", 45);
    row("0LA", 1809);
    row("0", 0);
}

void ScipEncodingTest::numbersAreThoseOfTheSpecification()
{
    QFETCH(QString, characters);
    QFETCH(quint32, value);

    QVERIFY(fromScip(characters.toStdString()) == value);
    QCOMPARE(toScip(value, static_cast<int>(characters.size())), characters.toStdString());
}

void ScipEncodingTest::everyNumberOfTwoCharactersComesBack()
{
    for (std::uint32_t value = 0; value < 4096; ++value) {
        const std::string text = toScip(value, 2);

        QCOMPARE(static_cast<std::uint32_t>((text[0] - '0') * 64 + (text[1] - '0')), value);
        QVERIFY(fromScip(text) == value);
    }
}

void ScipEncodingTest::aCharacterOutsideTheAlphabetIsNoNumber()
{
    for (int c = 0; c < 256; ++c) {
        const std::string text{'0', static_cast<char>(c), '0'};

        QCOMPARE(fromScip(text).has_value(), c >= 0x30 && c <= 0x6F);
    }
    QVERIFY(!fromScip(""));
    QVERIFY(!fromScip("000000"));
}

void ScipEncodingTest::aLineEndsWithItsSumOrItDoesNot()
{
    QVERIFY(endsWithScipSum("00P"));
    QVERIFY(!endsWithScipSum("00Q"));
    QVERIFY(!endsWithScipSum("P"));
    QVERIFY(!endsWithScipSum(""));
}

void ScipEncodingTest::aBlockIsCutIntoLinesOf64()
{
    const std::string full(64, '0');  // its sum: 64 times 0x30 is a multiple of 64

    QCOMPARE(toScipBlock(""), std::string{});
    QCOMPARE(toScipBlock("00"), std::string{"00P\n"});
    QCOMPARE(toScipBlock(full), full + "0\n");
    QCOMPARE(toScipBlock(full + "99"), full + "0\n99b\n");
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScipEncodingTest)
#include "scip_encoding_test.moc"
