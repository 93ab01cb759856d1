// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/found_devices.h"

#include <QtTest>

#include "tests/app/sources/fake_devices.h"
#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {

/// What is connected by USB, and the address that opens each. Serial ports are those of the machine.
class FoundDevicesTest : public QObject {
    Q_OBJECT

private slots:
    void lasersThatAreAskedAreNamedByTheirNumber();
    void lasersThatAreNotAskedAreThoseThatWereAtTheirPorts();
    void ofOneThatIsThereNoNameIsNeeded();
    void whatHasNoNumberIsNamedByItsPort();
    void whatMayNotBeOpenedHasACure();
    void usbThatCannotBeUsedIsSaid();
    void whoWasAskedIsRememberedAtOnePort();
};

namespace {

struct Machine {
    FakeClock clock;
    FakeAccess access{std::make_shared<FakeHead>(), clock};

    std::vector<FoundDevice> find(bool asks, const KnownLasers& known = {})
    {
        std::vector<FoundDevice> found = findDevices(access, asks, known, {}).devices;
        std::erase_if(found, [](const FoundDevice& f) { return f.kind == FoundDevice::Kind::SerialPort; });
        return found;
    }
};

UsbDevice device(std::uint16_t vendor, UsbKind kind, const std::string& port, const std::string& serial)
{
    UsbDevice device;
    device.vendor = vendor;
    device.kind = kind;
    device.port = port;
    device.serial = serial;
    return device;
}

UsbDevice laser(const std::string& port)
{
    return device(0x15d1, UsbKind::CdcAcm, port, "");
}

UsbDevice adapter(const std::string& port, const std::string& serial)
{
    return device(0x0403, UsbKind::Ftdi, port, serial);
}

}  // namespace

void FoundDevicesTest::lasersThatAreAskedAreNamedByTheirNumber()
{
    Machine machine;
    machine.access.usb = {laser("1-1"), laser("1-2")};
    machine.access.serials = {{"1-1", "00903971"}};

    const auto found = machine.find(true);

    QCOMPARE(found.size(), std::size_t(2));
    QCOMPARE(found[0].address, std::string("usb:00903971"));
    QCOMPARE(found[0].serial, std::string("00903971"));
    QVERIFY(found[0].problem.empty());
    QCOMPARE(found[1].address, std::string("usb:@1-2"));
    QCOMPARE(found[1].problem, std::string("usb 1-2: does not answer"));
    QCOMPARE(machine.access.asked, 2);
}

void FoundDevicesTest::lasersThatAreNotAskedAreThoseThatWereAtTheirPorts()
{
    Machine machine;
    machine.access.usb = {laser("1-1"), laser("1-2")};

    const auto found = machine.find(false, {{"1-1", "00903971"}});

    QCOMPARE(found[0].address, std::string("usb:00903971"));
    QVERIFY(found[0].name.find("number 00903971") != std::string::npos);
    QVERIFY(found[0].serial.empty());  // nobody has asked it now
    QCOMPARE(found[1].address, std::string("usb:@1-2"));
    QCOMPARE(machine.access.asked, 0);
}

void FoundDevicesTest::ofOneThatIsThereNoNameIsNeeded()
{
    Machine machine;
    machine.access.usb = {laser("1-1"), adapter("1-2", ""), device(0x1209, UsbKind::CdcAcm, "1-3", "0001")};

    const auto found = machine.find(false);

    QCOMPARE(found.size(), std::size_t(3));
    QCOMPARE(found[0].address, std::string("usb:"));
    QCOMPARE(found[1].address, std::string("dynamixel:usb:"));
    QCOMPARE(found[2].address, std::string("board:usb:0001"));
}

void FoundDevicesTest::whatHasNoNumberIsNamedByItsPort()
{
    Machine machine;
    machine.access.usb = {adapter("1-2.3", ""), adapter("1-2.4", ""), adapter("1-3", "FT1"), adapter("1-4", "FT1"),
                          adapter("1-5", "FT2")};

    const auto found = machine.find(false);

    std::vector<std::string> addresses;
    for (const FoundDevice& f : found)
        addresses.push_back(f.address);
    const std::vector<std::string> expected{"dynamixel:usb:@1-2.3", "dynamixel:usb:@1-2.4", "dynamixel:usb:FT1@1-3",
                                            "dynamixel:usb:FT1@1-4", "dynamixel:usb:FT2"};
    QCOMPARE(addresses, expected);
    // Each of these means that device alone.
    for (std::size_t i = 0; i < addresses.size(); ++i) {
        const auto meant = usbDevicesOf(parseDeviceAddress(addresses[i]).value(), machine.access.usb);
        QCOMPARE(meant.size(), std::size_t(1));
        QCOMPARE(meant[0].port, machine.access.usb[i].port);
    }
}

void FoundDevicesTest::whatMayNotBeOpenedHasACure()
{
    Machine machine;
    machine.access.usb = {laser("1-1"), laser("1-2")};
    machine.access.usb[0].access = UsbAccess::Denied;
    machine.access.usb[1].access = UsbAccess::Busy;

    const auto found = machine.find(true);

    QVERIFY(found[0].cure.starts_with("sudo "));
    QVERIFY(found[0].problem.ends_with(found[0].cure));
    QVERIFY(found[1].cure.empty());
    QVERIFY(found[1].problem.find("another program") != std::string::npos);
    QCOMPARE(machine.access.asked, 0);
}

void FoundDevicesTest::usbThatCannotBeUsedIsSaid()
{
    Machine machine;
    machine.access.usbProblem = Error{ErrorCode::NoDevice, "USB cannot be used here"};

    QCOMPARE(findDevices(machine.access, true, {}, {}).usbProblem, std::string("USB cannot be used here"));
    QVERIFY(machine.find(true).empty());
}

void FoundDevicesTest::whoWasAskedIsRememberedAtOnePort()
{
    FoundDevice moved;
    moved.port = "1-2";
    moved.serial = "00903971";
    FoundDevice unasked;
    unasked.port = "1-3";

    const KnownLasers known = withAsked({{"1-1", "00903971"}, {"1-3", "00905555"}}, FoundDevices{{moved, unasked}, {}});

    QCOMPARE(known, (KnownLasers{{"1-2", "00903971"}, {"1-3", "00905555"}}));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::FoundDevicesTest)
#include "found_devices_test.moc"
