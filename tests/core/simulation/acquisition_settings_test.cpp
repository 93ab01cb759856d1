// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/acquisition_settings.h"

#include <array>

#include <QtTest/QtTest>

#include "tests/test_program.h"

using namespace planewright;

class AcquisitionSettingsTest : public QObject {
    Q_OBJECT

private slots:
    void table8HasItsPointsTiltAndTime();
    void everyColumnOfTable10HasItsNumberOfPoints();
    void everyColumnOfTable10SpansItsTiltAndBearings();
    void theLargestLooksAllRound();
    void anUnknownNameListsTheKnownOnes();
};

void AcquisitionSettingsTest::table8HasItsPointsTiltAndTime()
{
    const AcquisitionSettings s = acquisitionSettings("table8").value();

    QCOMPARE(s.slices * s.beams, 98777);
    QCOMPARE(toDegrees(s.firstTilt), 10.0);
    QVERIFY(qAbs(toDegrees(s.tiltStep) - 1.16) < 1e-12);
    QVERIFY(qAbs(toDegrees(s.firstBearing + (s.beams - 1) * s.bearingStep) - 180.0) < 1e-9);
    QCOMPARE((s.slices * s.sliceTime).count(), 3'425'000);
    QCOMPARE(s.pitchAxisOffset, 0.05);
    QCOMPARE(s.rangeMin, 0.1);
    QCOMPARE(s.rangeMax, 30.0);
    QVERIFY(!s.continuous);
}

void AcquisitionSettingsTest::everyColumnOfTable10HasItsNumberOfPoints()
{
    // Column 7 prints 320,214, which no whole number of 721-beam slices gives: 444 of them make 320,124.
    const std::array points{20216, 40071, 86520, 120697, 205857, 241394, 320124, 410913};

    for (std::size_t i = 0; i < points.size(); ++i) {
        const AcquisitionSettings s = acquisitionSettings("table10-" + std::to_string(i + 1)).value();
        QCOMPARE(s.slices * s.beams, points[i]);
    }
}

void AcquisitionSettingsTest::everyColumnOfTable10SpansItsTiltAndBearings()
{
    const std::array tilt{130.0, 130.0, 140.0, 160.0, 150.0, 160.0, 130.0, 150.0};
    const std::array first{0.0, 0.0, 0.0, -20.0, -10.0, -20.0, 0.0, -10.0};

    for (std::size_t i = 0; i < tilt.size(); ++i) {
        const AcquisitionSettings s = acquisitionSettings("table10-" + std::to_string(i + 1)).value();
        // The number of slices follows from the number of points, which the paper counted, and not from the tilt.
        QVERIFY(qAbs(toDegrees(s.slices * s.tiltStep) - tilt[i]) < 1.5);
        QVERIFY(qAbs(toDegrees(s.firstBearing) - first[i]) < 1e-9);
        QVERIFY(qAbs(toDegrees(s.firstBearing + (s.beams - 1) * s.bearingStep) - (180.0 - first[i])) < 1e-9);
    }
}

void AcquisitionSettingsTest::theLargestLooksAllRound()
{
    const AcquisitionSettings s = acquisitionSettings("largest").value();

    QCOMPARE(s.slices, 1024);
    QCOMPARE(s.beams, 1081);
    QVERIFY(qAbs(toDegrees(s.firstBearing) + 45.0) < 1e-9);
    QVERIFY(qAbs(toDegrees(s.firstBearing + (s.beams - 1) * s.bearingStep) - 225.0) < 1e-9);
    QCOMPARE(s.firstTilt, 0.0);
    QVERIFY(qAbs(toDegrees(s.firstTilt + (s.slices - 1) * s.tiltStep) - 180.0) < 1e-9);
}

void AcquisitionSettingsTest::anUnknownNameListsTheKnownOnes()
{
    const auto result = acquisitionSettings("table9");

    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::Usage);
    QCOMPARE(acquisitionPresets().size(), std::size_t(10));
    for (const NamedSettings& preset : acquisitionPresets())
        QVERIFY(result.error().message.find(preset.name) != std::string::npos);
}

PLANEWRIGHT_TEST(AcquisitionSettingsTest)
#include "acquisition_settings_test.moc"
