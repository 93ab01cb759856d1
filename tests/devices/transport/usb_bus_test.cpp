// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_bus.h"

#include <libusb.h>
#include <set>

#include <QtTest>

#include "devices/transport/usb_error.h"
#include "tests/devices/transport/usb_rig.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class UsbBusTest : public QObject {
    Q_OBJECT

private slots:
    // What is listed.
    void aLaserIsListedWithAllThatItSays();
    void servoAdaptersAreListed();
    void whatTheSystemDoesNotTellTheDeviceIsAskedFor();
    void whatDoesNotPrintIsShownAsQuestionMarks();
    void oneThatMayNotBeOpenedIsListedAsDenied();
    void oneThatAnotherProgramHasIsListedAsBusy();
    void twoThatAreAlikeAreTwo();
    void interfacesAndEndpointsAreThoseOfTheDescriptors_data();
    void interfacesAndEndpointsAreThoseOfTheDescriptors();
    void descriptorsThatMakeNoSenseAreNotListed_data();
    void descriptorsThatMakeNoSenseAreNotListed();

    // What changes.
    void oneThatComesIsListedAndToldAndOneThatGoesToo_data();
    void oneThatComesIsListedAndToldAndOneThatGoesToo();
    void oneThatComesBackHasAnotherAddress();
    void oneThatIsAnnouncedTwiceIsOne();
    void oneWhoseGoingNobodyToldIsFoundOutByOpening();
    void aStormOfThirtyCyclesIsToldSeldomAndEndsRight();

    // Lending.
    void aDeviceIsLentOnce();
    void anAddressThatGoesToAnotherDeviceIsNotLent();
    void whoHasOneLentIsToldThatItIsGone();
    void waitingCostsNothing();
};

namespace {

/// What a transport would be opened on.
std::optional<UsbLayout> layoutOf(const UsbRig& rig, const UsbDevice& device)
{
    const auto loan = rig.bus->lend(device, {});
    if (!loan)
        return std::nullopt;
    rig.bus->giveBack(loan->device);
    libusb_unref_device(loan->device);
    return loan->layout;
}

}  // namespace

void UsbBusTest::aLaserIsListedWithAllThatItSays()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 4);

    const auto devices = rig.devices(1);

    QCOMPARE(devices.size(), std::size_t(1));
    QCOMPARE(devices[0].vendor, std::uint16_t(0x15D1));
    QCOMPARE(devices[0].product, std::uint16_t(0));
    QCOMPARE(int(devices[0].bus), 1);
    QCOMPARE(int(devices[0].address), rig.usb.address(laser));
    QCOMPARE(devices[0].port, std::string("1-4"));
    QCOMPARE(devices[0].name(), std::string("usb 1-4"));
    QCOMPARE(devices[0].manufacturer, std::string("Hokuyo Automatic Co, Ltd."));
    QCOMPARE(devices[0].productName, std::string("URG-Series USB Driver"));
    QCOMPARE(devices[0].serial, std::string());
    QCOMPARE(devices[0].kind, UsbKind::CdcAcm);
    QCOMPARE(devices[0].access, UsbAccess::Openable);
    QVERIFY(comesTrue([&] { return rig.bus->devices().at(0).driver == "cdc_acm"; }));
}

void UsbBusTest::servoAdaptersAreListed()
{
    UsbRig rig;
    rig.usb.plug(ft232rModel(), 1);
    rig.usb.plug(ft232hModel(), 2);

    const auto devices = rig.devices(2);

    QCOMPARE(devices.size(), std::size_t(2));
    QCOMPARE(devices[0].product, std::uint16_t(0x6001));
    QCOMPARE(devices[1].product, std::uint16_t(0x6014));
    QCOMPARE(devices[1].kind, UsbKind::Ftdi);
    QCOMPARE(devices[1].serial, std::string("A9005a9b"));
    QCOMPARE(layoutOf(rig, devices[0])->packetSize, std::size_t(64));
    QCOMPARE(layoutOf(rig, devices[1])->packetSize, std::size_t(512));
    QVERIFY(comesTrue([&] { return rig.bus->devices().at(1).driver == "ftdi_sio"; }));
}

void UsbBusTest::whatTheSystemDoesNotTellTheDeviceIsAskedFor()
{
    UsbRig rig;
    UsbModel model = ft232rModel();
    model.stringsInSysfs = false;
    rig.usb.plug(model, 1);

    const auto devices = rig.devices(1);

    QCOMPARE(devices.at(0).manufacturer, std::string("FTDI"));
    QCOMPARE(devices.at(0).productName, std::string("USB Serial Converter"));
    QCOMPARE(devices.at(0).serial, std::string("A9005a9b"));
}

void UsbBusTest::whatDoesNotPrintIsShownAsQuestionMarks()
{
    UsbRig rig;
    UsbModel model = cdcModel();
    model.stringsInSysfs = false;
    model.strings = {{1, "\x1b[2JMaker"}, {2, std::string(126, 'x')}};
    rig.usb.plug(model, 1);

    const auto devices = rig.devices(1);

    QCOMPARE(devices.at(0).manufacturer, std::string("?[2JMaker"));
    QCOMPARE(devices.at(0).productName, std::string(126, 'x'));
}

void UsbBusTest::oneThatMayNotBeOpenedIsListedAsDenied()
{
    UsbRig rig;
    UsbModel model = cdcModel();
    model.mayOpen = false;
    rig.usb.plug(model, 1);

    const auto devices = rig.devices(1);

    QCOMPARE(devices.at(0).access, UsbAccess::Denied);
    QCOMPARE(devices.at(0).productName, std::string("URG-Series USB Driver"));
}

void UsbBusTest::oneThatAnotherProgramHasIsListedAsBusy()
{
    UsbRig rig;
    UsbModel model = cdcModel();
    model.drivers = {"usbfs", "usbfs"};
    rig.usb.plug(model, 1);
    rig.devices(1);

    QVERIFY(comesTrue([&] { return rig.bus->devices().at(0).access == UsbAccess::Busy; }));
    QCOMPARE(rig.bus->devices().at(0).driver, std::string("usbfs"));
}

void UsbBusTest::twoThatAreAlikeAreTwo()
{
    UsbRig rig;
    rig.usb.plug(cdcModel(), 1);
    rig.usb.plug(cdcModel(), 2);

    const auto devices = rig.devices(2);

    QCOMPARE(devices.size(), std::size_t(2));
    QCOMPARE(devices[0].port, std::string("1-1"));
    QCOMPARE(devices[1].port, std::string("1-2"));
    QVERIFY(devices[0].address != devices[1].address);
}

void UsbBusTest::interfacesAndEndpointsAreThoseOfTheDescriptors_data()
{
    QTest::addColumn<int>("control");
    QTest::addColumn<int>("data");
    QTest::addColumn<int>("unitedWith");  // below zero: no union descriptor
    QTest::addColumn<int>("subclass");
    QTest::addColumn<int>("in");
    QTest::addColumn<int>("out");
    QTest::newRow("as a laser is") << 0 << 1 << 1 << 2 << 0x81 << 0x02;
    QTest::newRow("other endpoints") << 0 << 1 << 1 << 2 << 0x84 << 0x05;
    QTest::newRow("the union names an interface that is not the next") << 0 << 2 << 2 << 2 << 0x81 << 0x02;
    QTest::newRow("interfaces that begin elsewhere") << 3 << 4 << 4 << 2 << 0x82 << 0x03;
    QTest::newRow("no union: the next interface") << 0 << 1 << -1 << 2 << 0x81 << 0x02;
    QTest::newRow("a laser of another subclass") << 0 << 1 << 1 << 0 << 0x81 << 0x02;
}

void UsbBusTest::interfacesAndEndpointsAreThoseOfTheDescriptors()
{
    QFETCH(int, control);
    QFETCH(int, data);
    QFETCH(int, unitedWith);
    QFETCH(int, subclass);
    QFETCH(int, in);
    QFETCH(int, out);
    CdcVariant variant;
    variant.controlInterface = static_cast<std::uint8_t>(control);
    variant.dataInterface = static_cast<std::uint8_t>(data);
    variant.unitedWith.reset();
    if (unitedWith >= 0)
        variant.unitedWith = static_cast<std::uint8_t>(unitedWith);
    variant.subclass = static_cast<std::uint8_t>(subclass);
    variant.in = static_cast<std::uint8_t>(in);
    variant.out = static_cast<std::uint8_t>(out);
    UsbRig rig;
    rig.usb.plug(cdcModel(variant), 1);

    const auto devices = rig.devices(1);

    QCOMPARE(devices.size(), std::size_t(1));
    const auto layout = layoutOf(rig, devices[0]);
    QVERIFY(layout);
    QCOMPARE(int(layout->controlInterface), control);
    QCOMPARE(int(layout->dataInterface), data);
    QCOMPARE(int(layout->in), in);
    QCOMPARE(int(layout->out), out);
    QCOMPARE(layout->packetSize, std::size_t(64));
}

void UsbBusTest::descriptorsThatMakeNoSenseAreNotListed_data()
{
    QTest::addColumn<QByteArray>("configuration");
    const auto bytesOf = [](const UsbModel& model) {
        return QByteArray(reinterpret_cast<const char*>(model.configuration.data()),
                          static_cast<qsizetype>(model.configuration.size()));
    };
    const auto variant = [&](auto change) {
        CdcVariant changed;
        change(changed);
        return bytesOf(cdcModel(changed));
    };
    const QByteArray whole = bytesOf(cdcModel());
    const auto patched = [&](qsizetype at, int value) {
        QByteArray bytes = whole;
        bytes[at] = static_cast<char>(value);
        return bytes;
    };
    QTest::newRow("packets of no size") << variant([](CdcVariant& v) { v.packetSize = 0; });
    QTest::newRow("packets of a size that USB does not have") << variant([](CdcVariant& v) { v.packetSize = 100; });
    QTest::newRow("a union with an interface that is not there") << variant([](CdcVariant& v) { v.unitedWith = 9; });
    QTest::newRow("a union with itself") << variant([](CdcVariant& v) { v.unitedWith = 0; });
    QTest::newRow("no endpoint from the host") << variant([](CdcVariant& v) { v.out = 0x82; });
    QTest::newRow("endpoints that are not for bulk") << patched(9 + 9 + 19 + 7 + 9 + 3, 3);
    QTest::newRow("no class of modems") << patched(9 + 5, 3);
    QTest::newRow("no class of data") << patched(9 + 9 + 19 + 7 + 5, 3);
    QTest::newRow("cut off in the union") << whole.left(9 + 9 + 17);
    QTest::newRow("cut off before the data interface") << whole.left(9 + 9 + 19 + 7);
    QTest::newRow("a class descriptor of no length") << patched(9 + 9, 0);
    QTest::newRow("a class descriptor that is longer than all") << patched(9 + 9, 255);
    QTest::newRow("more interfaces than there are") << patched(4, 32).left(9 + 9 + 19 + 7);
    QTest::newRow("nothing but a head") << whole.left(9);
    QTest::newRow("nothing") << QByteArray();
}

void UsbBusTest::descriptorsThatMakeNoSenseAreNotListed()
{
    QFETCH(QByteArray, configuration);
    UsbRig rig;
    UsbModel model = cdcModel();
    model.configuration.assign(configuration.begin(), configuration.end());

    rig.usb.plug(model, 1);
    rig.usb.plug(ft232rModel(), 2);  // the system tells of them in order

    const auto devices = rig.devices(1);
    QCOMPARE(devices.size(), std::size_t(1));
    QCOMPARE(devices[0].kind, UsbKind::Ftdi);
}

void UsbBusTest::oneThatComesIsListedAndToldAndOneThatGoesToo_data()
{
    QTest::addColumn<bool>("isPolling");
    QTest::newRow("the system tells") << false;
    QTest::newRow("the bus asks") << true;
}

void UsbBusTest::oneThatComesIsListedAndToldAndOneThatGoesToo()
{
    QFETCH(bool, isPolling);
    UsbRig rig(isPolling ? UsbWatch::Polling : UsbWatch::Hotplug);
    QVERIFY(rig.bus->devices().empty());
    QCOMPARE(rig.changes.load(), 0);

    const auto laser = rig.usb.plug(cdcModel(), 1);
    rig.usb.plug(ft232rModel(), 2);

    QCOMPARE(rig.devices(2).size(), std::size_t(2));
    QVERIFY(comesTrue([&] { return rig.changes > 0; }));
    const int before = rig.changes;

    rig.usb.unplug(laser);

    const auto devices = rig.devices(1);
    QCOMPARE(devices.size(), std::size_t(1));
    QCOMPARE(devices[0].kind, UsbKind::Ftdi);
    QVERIFY(comesTrue([&] { return rig.changes > before; }));
}

void UsbBusTest::oneThatComesBackHasAnotherAddress()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 1);
    const auto before = rig.devices(1);

    rig.usb.unplug(laser);
    QVERIFY(rig.devices(0).empty());
    rig.usb.plugAgain(laser, 1);

    const auto after = rig.devices(1);
    QCOMPARE(after.at(0).port, before.at(0).port);
    QVERIFY(after.at(0).address != before.at(0).address);
}

void UsbBusTest::oneThatIsAnnouncedTwiceIsOne()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 1);
    QVERIFY(comesTrue([&] { return rig.changes == 1; }));

    rig.usb.announceAgain(laser);
    rig.usb.plug(ft232rModel(), 2);  // comes after that

    QCOMPARE(rig.devices(2).size(), std::size_t(2));
    QVERIFY(comesTrue([&] { return rig.changes == 2; }));
}

void UsbBusTest::oneWhoseGoingNobodyToldIsFoundOutByOpening()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 1);
    QVERIFY(comesTrue([&] { return rig.changes == 1; }));

    rig.usb.unplug(laser, EmulatedUsb::Unplugging::TransfersOnly);

    QVERIFY(rig.bus->devices().empty());
    QVERIFY(comesTrue([&] { return rig.changes == 2; }));
}

void UsbBusTest::aStormOfThirtyCyclesIsToldSeldomAndEndsRight()
{
    UsbRig rig;
    UsbModel model = cdcModel();
    model.driversInSysfs = false;
    const auto began = steadyClock().now();
    const auto laser = rig.usb.plug(model, 1);
    for (int cycle = 0; cycle < 30; ++cycle) {
        rig.usb.unplug(laser);
        rig.usb.plugAgain(laser, 1);
    }

    const int address = rig.usb.address(laser);
    QVERIFY(comesTrue([&] {
        const auto devices = rig.bus->devices();
        return devices.size() == 1 && devices[0].address == address;
    }));
    QVERIFY(comesTrue([&] { return rig.changes > 0; }));
    const double seconds = std::chrono::duration<double>(steadyClock().now() - began).count();
    // Five at once and two a second of a storm; how many of 61 that are, the machine's load decides.
    QVERIFY2(rig.changes <= (5 + 2) * (seconds + 1.0), qPrintable(QString::number(rig.changes.load())));
}

void UsbBusTest::aDeviceIsLentOnce()
{
    UsbRig rig;
    rig.usb.plug(cdcModel(), 1);
    const auto device = rig.devices(1).at(0);

    const auto loan = rig.bus->lend(device, {});
    const auto second = rig.bus->lend(device, {});

    QVERIFY(loan);
    QVERIFY(!second);
    QCOMPARE(second.error().code, ErrorCode::NoDevice);
    QCOMPARE(rig.bus->devices().at(0).access, UsbAccess::Busy);
    rig.bus->giveBack(loan->device);
    libusb_unref_device(loan->device);
    QCOMPARE(rig.bus->devices().at(0).access, UsbAccess::Openable);
    QVERIFY(layoutOf(rig, device));
}

void UsbBusTest::anAddressThatGoesToAnotherDeviceIsNotLent()
{
    UsbRig rig;
    rig.usb.plug(cdcModel(), 1);
    UsbDevice device = rig.devices(1).at(0);

    device.product = 0x6001;
    const auto other = rig.bus->lend(device, {});
    device.address = 99;
    const auto nobody = rig.bus->lend(device, {});

    QVERIFY(!other);
    QCOMPARE(other.error().code, ErrorCode::NoDevice);
    QVERIFY(!nobody);
    QVERIFY(nobody.error().message.starts_with("usb 1-1 (15d1:6001"));
}

void UsbBusTest::whoHasOneLentIsToldThatItIsGone()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 1);
    const auto device = rig.devices(1).at(0);
    std::atomic<int> told{0};
    const auto loan = rig.bus->lend(device, [&] { ++told; });
    QVERIFY(loan);

    rig.usb.unplug(laser);

    QVERIFY(rig.devices(0).empty());
    QCOMPARE(told.load(), 1);
    rig.bus->giveBack(loan->device);
    libusb_unref_device(loan->device);
}

void UsbBusTest::waitingCostsNothing()
{
    UsbRig rig;
    rig.usb.plug(cdcModel(), 1);
    rig.devices(1);
    const long before = rig.usb.requests();

    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    const auto until = in(300ms);
    while (steadyClock().now() < until)
        steadyClock().wait(lock, never, {}, until);

    QCOMPARE(rig.usb.requests(), before);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::UsbBusTest)
#include "usb_bus_test.moc"
