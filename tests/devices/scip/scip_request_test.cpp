// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_request.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class ScipRequestTest : public QObject {
    Q_OBJECT

private slots:
    void measurementsAreWrittenAsInRealSessions();
    void whatIsWrittenIsReadBack();
    void settingsHaveTheirDigits();
    void aTagStandsBehindASemicolon();
    void onlySixteenPlainLettersAreATag();
    void valuesAreBeamsOrGroupsOfThem();
    void anEchoMayHaveTooFewDigitsButNothingElse_data();
    void anEchoMayHaveTooFewDigitsButNothingElse();
    void aMeasurementHasAllItsDigitsAndItsStepsInOrder();
};

void ScipRequestTest::measurementsAreWrittenAsInRealSessions()
{
    QCOMPARE(scipRequest({"MD", 0, 1080, 0, 0, 0}), std::string{"MD0000108000000"});
    QCOMPARE(scipRequest({"ME", 0, 1080, 1, 1, 1}), std::string{"ME0000108001101"});
    QCOMPARE(scipRequest({"GD", 44, 725, 1, 0, 0}), std::string{"GD0044072501"});
}

void ScipRequestTest::whatIsWrittenIsReadBack()
{
    for (const char* const command : {"MD", "MS", "ME", "ND", "NE", "GD", "GS", "GE", "HD", "HE"}) {
        ScipMeasurement asked{command, 12, 3456, 78, 0, 0};
        if (asked.isStream()) {
            asked.interval = 9;
            asked.count = 42;
        }
        const std::string text = scipRequest(asked);

        const auto echo = readScipEcho(text);
        QVERIFY(echo);
        const auto read = readScipMeasurement(*echo);

        QVERIFY(read);
        QCOMPARE(read->command, asked.command);
        QCOMPARE(read->first, 12);
        QCOMPARE(read->last, 3456);
        QCOMPARE(read->cluster, 78);
        QCOMPARE(read->interval, asked.interval);
        QCOMPARE(read->count, asked.count);
        QCOMPARE(read->isStream(), text[0] == 'M' || text[0] == 'N');
        QCOMPARE(read->isMultiEcho(), text[0] == 'N' || text[0] == 'H');
        QCOMPARE(read->hasIntensity(), text[1] == 'E');
        QCOMPARE(read->charactersPerRange(), text[1] == 'S' ? 2 : 3);
    }
}

void ScipRequestTest::settingsHaveTheirDigits()
{
    QCOMPARE(scipLineSpeed(19'200), std::string{"SS019200"});
    QCOMPARE(scipMotorSpeed(0), std::string{"CR00"});
    QCOMPARE(scipSensitivity(true), std::string{"HS1"});
    QCOMPARE(scipSensitivity(false), std::string{"HS0"});
    QCOMPARE(scipSimulatedFault(10), std::string{"DB10"});
}

void ScipRequestTest::aTagStandsBehindASemicolon()
{
    const std::string request = withScipTag("TM1", "a1");
    QCOMPARE(request, std::string{"TM1;a1"});

    const auto echo = readScipEcho(request);

    QVERIFY(echo);
    QVERIFY(echo->command == "TM");
    QVERIFY(echo->parameters == "1");
    QVERIFY(echo->tag == "a1");
}

void ScipRequestTest::onlySixteenPlainLettersAreATag()
{
    QVERIFY(isScipTag("a"));
    QVERIFY(isScipTag("Az 9._+@12345678"));
    QVERIFY(!isScipTag(""));
    QVERIFY(!isScipTag("12345678901234567"));
    QVERIFY(!isScipTag("a;b"));
    QVERIFY(!isScipTag("a\tb"));
}

void ScipRequestTest::valuesAreBeamsOrGroupsOfThem()
{
    QCOMPARE((ScipMeasurement{"MD", 0, 1080, 0, 0, 0}.values()), 1081);
    QCOMPARE((ScipMeasurement{"MD", 0, 1080, 1, 0, 0}.values()), 1081);
    QCOMPARE((ScipMeasurement{"MD", 180, 900, 0, 0, 0}.values()), 721);
    QCOMPARE((ScipMeasurement{"MD", 0, 1080, 2, 0, 0}.values()), 541);  // 540 pairs and the last alone
    QCOMPARE((ScipMeasurement{"MD", 0, 1079, 2, 0, 0}.values()), 540);
    QCOMPARE((ScipMeasurement{"MD", 0, 0, 99, 0, 0}.values()), 1);
}

void ScipRequestTest::anEchoMayHaveTooFewDigitsButNothingElse_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<bool>("isEcho");
    const auto row = [](const char* line, bool isEcho) { QTest::newRow(line) << QString{line} << isEcho; };
    row("VV", true);
    row("VV;a1", true);
    row("SCIP2.0", true);
    row("%ST", true);
    row("MD00001080", true);
    row("MD0000108000000123", true);
    row("MD00001080000001234", false);
    row("MD000O108000000", false);
    row("FOO", false);
    row("", false);
    row("Q", false);
    row("qt", false);
    row("VV;", false);
    row("VV;a;b", false);
    row("RSabc", false);
}

void ScipRequestTest::anEchoMayHaveTooFewDigitsButNothingElse()
{
    QFETCH(QString, line);
    QFETCH(bool, isEcho);
    const std::string text = line.toStdString();

    QCOMPARE(readScipEcho(text).has_value(), isEcho);
}

void ScipRequestTest::aMeasurementHasAllItsDigitsAndItsStepsInOrder()
{
    const auto reads = [](const char* text) { return readScipMeasurement(*readScipEcho(text)).has_value(); };

    QVERIFY(reads("MD0000108000000"));
    QVERIFY(reads("MD0010001000000"));
    QVERIFY(!reads("MD00001080"));
    QVERIFY(!reads("GD0000108000000"));
    QVERIFY(!reads("MD0011001000000"));
    QVERIFY(!reads("VV"));
    QVERIFY(!reads("SS019200"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScipRequestTest)
#include "scip_request_test.moc"
