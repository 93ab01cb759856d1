// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/preset_file.h"

#include <clocale>
#include <sstream>

#include <QtTest>

#include "core/params/registry.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

Result<void> readPresetText(const std::string& text, Parameters& parameters)
{
    std::istringstream in(text);
    return readPresetFile(in, "my.json", parameters);
}

std::string preset(const std::string& values)
{
    return R"({"format":"planewright-preset 1","parameters":{)" + values + "}}";
}

}  // namespace

class PresetFileTest : public QObject {
    Q_OBJECT

private slots:
    void setsNumbersTextsAndSwitches();
    void everyParameterSurvivesWritingAndReading();
    void readsTheSameInEveryLocale();
    void refusesAndChangesNothing_data();
    void refusesAndChangesNothing();
    void messagesNeverRepeatAWholeHostileText();
    void aFullDiskIsNotSilent();
};

void PresetFileTest::setsNumbersTextsAndSwitches()
{
    Parameters parameters;

    QVERIFY(readPresetText(preset(R"("segments.split-distance":0.05,"segments.min-points":12,"clusters.average":"sma",)"
                                  R"("segments.merge-angle":"3.5")"),
                           parameters)
                .has_value());

    QCOMPARE(parameters.segments.splitDistance, 0.05);
    QCOMPARE(parameters.segments.minPoints, 12);
    QCOMPARE(parameters.clusters.average, MovingAverage::Simple);
    QCOMPARE(parameters.segments.mergeAngle, degrees(3.5));
    for (const ParameterRow& row : parameterRows()) {
        if (row.unit != Unit::Switch)
            continue;
        for (const std::string value : {"true", "false"}) {
            QVERIFY(readPresetText(preset("\"" + std::string(row.key) + "\":" + value), parameters).has_value());
            QCOMPARE(printParameter(parameters, row.key), value);
        }
    }
}

void PresetFileTest::everyParameterSurvivesWritingAndReading()
{
    // Every parameter at its lowest, so that none is at its default.
    Parameters parameters;
    for (const ParameterRow& row : parameterRows()) {
        std::ostringstream value;
        value << row.lowest;
        const std::string text = row.choices.empty() ? value.str() : std::string(row.choices.back());
        QVERIFY2(setParameter(parameters, row.key, text).has_value(), row.key.data());
    }
    std::ostringstream out;
    Parameters again;

    QVERIFY(writePresetFile(out, parameters).has_value());
    QVERIFY(readPresetText(out.str(), again).has_value());

    for (const ParameterRow& row : parameterRows())
        QCOMPARE(printParameter(again, row.key), printParameter(parameters, row.key));
    std::ostringstream twice;
    QVERIFY(writePresetFile(twice, again).has_value());
    QCOMPARE(twice.str(), out.str());
}

void PresetFileTest::readsTheSameInEveryLocale()
{
    QVERIFY2(std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr,
             "the locale de_DE.UTF-8 is missing: install locales-all");
    Parameters parameters;

    const auto done = readPresetText(preset(R"("segments.split-distance":0.055)"), parameters);
    std::setlocale(LC_ALL, "C");

    QVERIFY(done.has_value());
    QCOMPARE(parameters.segments.splitDistance, 0.055);
}

void PresetFileTest::refusesAndChangesNothing_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("message");
    const int unreadable = static_cast<int>(ErrorCode::Unreadable);
    const int usage = static_cast<int>(ErrorCode::Usage);
    const auto values = [](const char* text) {
        return QByteArray::fromStdString(preset(R"("segments.min-points":12,)" + std::string(text)));
    };
    QTest::newRow("no JSON") << QByteArray("min-points=12") << unreadable
                             << "my.json: line 1, column 1: this is not JSON at 'm'; correct it there";
    QTest::newRow("NaN")
        << values(R"("segments.split-distance":NaN)") << unreadable
        << "my.json: line 1, column 99: this is not JSON at '\"segments.split-distance\":N'; correct it "
           "there";
    QTest::newRow("newer") << QByteArray(R"({"format":"planewright-preset 2","parameters":{}})") << unreadable
                           << "my.json: the file is of the newer format 'planewright-preset 2' and this program reads "
                              "'planewright-preset 1'; use a newer version of the program";
    QTest::newRow("no parameters") << QByteArray(R"({"format":"planewright-preset 1"})") << unreadable
                                   << "my.json: there is no object 'parameters'; add \"parameters\":{key:value}";
    QTest::newRow("list") << QByteArray(R"({"format":"planewright-preset 1","parameters":[]})") << unreadable
                          << "my.json: there is no object 'parameters'; add \"parameters\":{key:value}";
    QTest::newRow("unknown key outside") << QByteArray(R"({"format":"planewright-preset 1","parameters":{},"x":1})")
                                         << unreadable
                                         << "my.json: the key 'x' is not known; a preset has 'format' and 'parameters'";
    QTest::newRow("key twice") << values(R"("segments.min-points":13)") << unreadable
                               << "my.json: the key 'segments.min-points' is there twice; remove one of the two";
    QTest::newRow("unknown parameter") << values(R"("segments.min-pionts":13)") << usage
                                       << "my.json: there is no parameter 'segments.min-pionts'; did you mean "
                                          "segments.min-points? 'planewright-cli params' lists all";
    QTest::newRow("out of range")
        << values(R"("segments.split-distance":7)") << usage
        << "my.json: parameter segments.split-distance: '7' is not allowed; give a number from "
           "0 to 0.5 m";
    QTest::newRow("no whole number") << values(R"("assignment.refit-every":1.5)") << usage
                                     << "my.json: parameter assignment.refit-every: '1.5' is not allowed; give a whole "
                                        "number from 1 to 10000";
    QTest::newRow("null")
        << values(R"("segments.split-distance":null)") << usage
        << "my.json: parameter 'segments.split-distance': a value is a number, a text, true or false; "
           "correct it";
    QTest::newRow("switch for a number") << values(R"("segments.split-distance":true)") << usage
                                         << "my.json: parameter segments.split-distance: 'true' is not allowed; give a "
                                            "number from 0 to 0.5 m";
}

void PresetFileTest::refusesAndChangesNothing()
{
    QFETCH(QByteArray, text);
    QFETCH(int, code);
    QFETCH(QString, message);
    Parameters parameters;

    const auto done = readPresetText(text.toStdString(), parameters);

    QVERIFY(!done.has_value());
    QCOMPARE(QString::fromStdString(done.error().message), message);
    QCOMPARE(static_cast<int>(done.error().code), code);
    QCOMPARE(parameters.segments.minPoints, Parameters{}.segments.minPoints);
}

void PresetFileTest::messagesNeverRepeatAWholeHostileText()
{
    Parameters parameters;
    const std::string hostile = std::string(100000, 'x') + "\\u001b[2J";

    const auto key = readPresetText(preset("\"" + hostile + "\":1"), parameters);
    const auto value = readPresetText(preset("\"segments.min-points\":\"\\u001b" + hostile + "\""), parameters);

    for (const auto& done : {key, value}) {
        QVERIFY(!done.has_value());
        QVERIFY(done.error().message.size() < 300);
        QVERIFY(done.error().message.find('\x1b') == std::string::npos);
    }
}

void PresetFileTest::aFullDiskIsNotSilent()
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);

    QCOMPARE(writePresetFile(out, {}).error().code, ErrorCode::NotWritten);
}

PLANEWRIGHT_TEST(PresetFileTest)
#include "preset_file_test.moc"
