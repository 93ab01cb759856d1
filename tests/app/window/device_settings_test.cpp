// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/device_settings.h"

#include <QTemporaryDir>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class DeviceSettingsTest : public QObject {
    Q_OBJECT

private slots:
    void whatWasSetUpIsThereTheNextTime();
    void whatMakesNoSenseIsAsWithoutSettings();
    void lasersStayKnown();
};

void DeviceSettingsTest::whatWasSetUpIsThereTheNextTime()
{
    const QTemporaryDir folder;
    DeviceSetup setup;
    setup.laser = "usb:00903971";
    setup.tiltUnit = "dynamixel:usb:@1-2.3?id=2";
    setup.stepAndStare = true;
    setup.firstTilt = 20.0;
    setup.lastTilt = 120.0;
    setup.tiltStep = 0.3;
    setup.firstBearing = 10.0;
    setup.lastBearing = 170.0;
    setup.cluster = 4;
    setup.settle = 30.0;
    setup.travelSpeed = 45.0;
    setup.lowest = -10.0;
    setup.highest = 130.5;
    setup.fastest = 60.0;
    setup.axisOffset = 0.0815;
    setup.dialogueFolder = "/tmp/a folder, with a comma";
    {
        QSettings settings(folder.filePath("window.ini"), QSettings::IniFormat);
        saveDeviceSetup(setup, settings);
    }

    const QSettings settings(folder.filePath("window.ini"), QSettings::IniFormat);

    QVERIFY(loadDeviceSetup(settings) == setup);
}

void DeviceSettingsTest::whatMakesNoSenseIsAsWithoutSettings()
{
    const QTemporaryDir folder;
    QSettings settings(folder.filePath("window.ini"), QSettings::IniFormat);
    QVERIFY(loadDeviceSetup(settings) == DeviceSetup{});
    settings.setValue("devices/fastest", "nan");
    settings.setValue("devices/tilt-step", "wide");
    settings.setValue("devices/first-tilt", QStringList{"1", "2"});
    settings.setValue("devices/known-lasers", QStringList{"1-4", "=5", "1-5=", "1-6=00903971"});

    QVERIFY(loadDeviceSetup(settings) == DeviceSetup{});
    QCOMPARE(loadKnownLasers(settings), (KnownLasers{{"1-6", "00903971"}}));
}

void DeviceSettingsTest::lasersStayKnown()
{
    const QTemporaryDir folder;
    const KnownLasers known{{"1-4", "00903971"}, {"1-5.2", "00905555"}};
    {
        QSettings settings(folder.filePath("window.ini"), QSettings::IniFormat);
        saveKnownLasers(known, settings);
    }

    const QSettings settings(folder.filePath("window.ini"), QSettings::IniFormat);

    QCOMPARE(loadKnownLasers(settings), known);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DeviceSettingsTest)
#include "device_settings_test.moc"
