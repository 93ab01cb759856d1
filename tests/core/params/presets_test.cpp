// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/params/presets.h"

#include <limits>
#include <set>

#include <QtTest>

#include "core/params/registry.h"
#include "tests/test_program.h"

namespace planewright {

namespace {

/// The number that a text spells; 0.0005 and 5e-04 are the same.
double numberOf(std::string_view text)
{
    bool read = false;
    const double number = QByteArray(text.data(), static_cast<qsizetype>(text.size())).toDouble(&read);
    return read ? number : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

class PresetsTest : public QObject {
    Q_OBJECT

private slots:
    void theFirstMethodIsTheMoreAccurateOne();
    void thePublishedMethodIsThatOfPlainParameters();
    void everyPresetSetsParametersThatExistToAllowedValues();
    void namesAreUnique();
    void aPresetIsFoundByItsName();
    void aScannerIsKnownByTheNamesItGives_data();
    void aScannerIsKnownByTheNamesItGives();
    void applyingASensorSetsItsNoiseAndNothingElse();
};

void PresetsTest::theFirstMethodIsTheMoreAccurateOne()
{
    QCOMPARE(methodPresets().front().name, std::string_view("precise"));
}

void PresetsTest::thePublishedMethodIsThatOfPlainParameters()
{
    QVERIFY(findPreset(methodPresets(), "paper")->values.empty());
}

void PresetsTest::everyPresetSetsParametersThatExistToAllowedValues()
{
    for (const auto* presets : {&methodPresets(), &sensorPresets()}) {
        for (const Preset& preset : *presets) {
            Parameters parameters;
            for (const auto& [key, value] : preset.values) {
                const auto done = setParameter(parameters, key, value);
                QVERIFY2(done, done ? "" : done.error().message.c_str());
                QCOMPARE(numberOf(printParameter(parameters, key)), numberOf(value));
            }
        }
    }
}

void PresetsTest::namesAreUnique()
{
    std::set<std::string_view> names;
    for (const auto* presets : {&methodPresets(), &sensorPresets()}) {
        for (const Preset& preset : *presets)
            QVERIFY(names.insert(preset.name).second);
    }
}

void PresetsTest::aPresetIsFoundByItsName()
{
    const Preset* found = findPreset(sensorPresets(), "ust-20lx");
    QVERIFY(found != nullptr);
    QCOMPARE(found->name, std::string_view("ust-20lx"));
    QVERIFY(findPreset(sensorPresets(), "ust-20l") == nullptr);
    QVERIFY(findPreset(sensorPresets(), "") == nullptr);
    QVERIFY(findPreset(methodPresets(), "ust-20lx") == nullptr);
}

void PresetsTest::aScannerIsKnownByTheNamesItGives_data()
{
    QTest::addColumn<QString>("sensor");
    QTest::newRow("SICK LMS") << "sick-lms200";
    QTest::newRow("SICK LMS 200") << "sick-lms200";
    QTest::newRow("LMS200-30106") << "sick-lms200";
    QTest::newRow("UTM-30LX") << "utm-30lx";
    QTest::newRow("UTM-30LX-EW") << "utm-30lx";
    QTest::newRow("utm_30lx") << "utm-30lx";
    QTest::newRow("URG-04LX") << "urg-04lx";
    QTest::newRow("Hokuyo URG-04LX") << "urg-04lx";
    QTest::newRow("Hokuyo URG-04LX-UG01") << "urg-04lx";
    QTest::newRow("UST-20LX") << "ust-20lx";
    QTest::newRow("Hokuyo UST-20LX") << "ust-20lx";
    QTest::newRow("depth camera, PCD cloud") << "depth-camera";
    QTest::newRow("RPLIDAR A1") << "";
    QTest::newRow("30LX") << "";
    QTest::newRow("not a UTM-30LX") << "";
    QTest::newRow("- -") << "";
    QTest::newRow("") << "";
}

void PresetsTest::aScannerIsKnownByTheNamesItGives()
{
    QFETCH(QString, sensor);

    const Preset* preset = sensorOfScanner(QTest::currentDataTag());

    QCOMPARE(std::string(preset ? preset->name : ""), sensor.toStdString());
}

void PresetsTest::applyingASensorSetsItsNoiseAndNothingElse()
{
    const Parameters defaults;
    for (const Preset& sensor : sensorPresets()) {
        Parameters parameters;

        apply(sensor, parameters);

        for (const ParameterRow& row : parameterRows()) {
            std::string expected = printParameter(defaults, row.key);
            for (const auto& [key, value] : sensor.values) {
                if (key == row.key)
                    expected = value;
            }
            const std::string printed = printParameter(parameters, row.key);
            QVERIFY2(printed == expected || numberOf(printed) == numberOf(expected), printed.c_str());
        }
        for (const auto& [key, value] : sensor.values)
            QVERIFY(key.starts_with("noise."));
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PresetsTest)
#include "presets_test.moc"
