// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_bus.h"

#include <QtTest>

#include "tests/devices/transport/usb_rig.h"

namespace planewright {

class UsbBusTest : public QObject {
    Q_OBJECT

private slots:
    void aLaserIsListedWithAllThatItSays();
};

void UsbBusTest::aLaserIsListedWithAllThatItSays()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 4);

    const auto devices = rig.devices(1);

    QCOMPARE(devices.size(), std::size_t(1));
    QCOMPARE(devices[0].vendor, std::uint16_t(0x15D1));
    QCOMPARE(devices[0].product, std::uint16_t(0));
    QCOMPARE(devices[0].port, std::string("1-4"));
    QCOMPARE(devices[0].manufacturer, std::string("Hokuyo Automatic Co, Ltd."));
    QCOMPARE(devices[0].productName, std::string("URG-Series USB Driver"));
}

}  // namespace planewright

QTEST_GUILESS_MAIN(planewright::UsbBusTest)
#include "usb_bus_test.moc"
