// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/device_setup.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class DeviceSetupTest : public QObject {
    Q_OBJECT

private slots:
    void limitsGoIntoTheAddress_data();
    void limitsGoIntoTheAddress();
};

void DeviceSetupTest::limitsGoIntoTheAddress_data()
{
    QTest::addColumn<QByteArray>("typed");
    QTest::addColumn<double>("lowest");
    QTest::addColumn<double>("fastest");
    QTest::addColumn<QByteArray>("address");
    const auto row = [](const char* name, const char* typed, double lowest, double fastest, const char* address) {
        QTest::newRow(name) << QByteArray(typed) << lowest << fastest << QByteArray(address);
    };
    row("as they are without", "board:usb:", 0.0, 120.0, "board:usb:");
    row("behind nothing", "board:usb:", -12.5, 120.0, "board:usb:?lowest=-12.5");
    row("behind an option", "dynamixel:usb:?id=2", 0.0, 45.0, "dynamixel:usb:?id=2&fastest=45");
    row("both", "board:serial:/dev/what?", 10.0, 60.0, "board:serial:/dev/what?lowest=10&fastest=60");
    row("what was typed wins", "board:usb:?lowest=5", 10.0, 60.0, "board:usb:?lowest=5&fastest=60");
}

void DeviceSetupTest::limitsGoIntoTheAddress()
{
    QFETCH(QByteArray, typed);
    QFETCH(double, lowest);
    QFETCH(double, fastest);
    QFETCH(QByteArray, address);
    DeviceSetup setup;
    setup.tiltUnit = typed.toStdString();
    setup.lowest = lowest;
    setup.fastest = fastest;

    QCOMPARE(QByteArray::fromStdString(tiltUnitAddress(setup)), address);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DeviceSetupTest)
#include "device_setup_test.moc"
