// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/device_opener.h"

#include <filesystem>

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "app/sources/device_permission.h"
#include "app/sources/found_devices.h"
#include "core/simulation/scenes.h"
#include "devices/emulated/emulated_rig.h"
#include "tests/devices/holds.h"
#include "tests/devices/transport/far_end.h"
#include "tests/devices/transport/test_socket.h"
#include "tests/devices/transport/usb_rig.h"
#include "tests/test_program.h"

namespace planewright {

/// Devices at an emulated USB, opened by what people call them.
class DeviceOpenerTest : public QObject {
    Q_OBJECT

private slots:
    void lasersAreToldApartByTheirNumber();
    void aLaserIsFoundAgainWhereverItIsPluggedIn();
    void aLaserIsNamedByItsPortAsWell();
    void adaptersWithoutANumberAreNamedByTheirPort();
    void everyDialogueHasAFileOfItsOwn();
    void aHostThatWasThereIsNotTakenByAnotherProgram();
    void aSerialPortThatMayNotBeOpenedHasACure();
};

namespace {

/// A laser of a number at a port, which answers.
struct PluggedLaser {
    PluggedLaser(EmulatedUsb& usb, int port, const std::string& serial)
        : device(usb.plug(cdcModel(), port)),
          rig(EmulatedRig::make(setupOf(serial)).value()),
          farEnd(device, rig->laser(), steadyClock())
    {
    }

    static EmulatedRigSetup setupOf(const std::string& serial)
    {
        EmulatedRigSetup setup;
        setup.scene = makeScene("empty", 1).value();
        setup.laserSerial = serial;
        setup.tilt = EmulatedRigSetup::Tilt::None;
        return setup;
    }

    std::shared_ptr<EmulatedUsbDevice> device;
    std::unique_ptr<EmulatedRig> rig;
    FarEnd farEnd;
};

DeviceAddress addressOf(const std::string& text)
{
    return parseDeviceAddress(text).value();
}

std::string serialOf(const Result<std::unique_ptr<Laser>>& laser)
{
    return laser ? (*laser)->identity().serial : laser.error().message;
}

UsbModel adapterWithoutANumber()
{
    constexpr std::size_t kSerialNumber = 16;  // place in the device descriptor
    UsbModel model = ft232rModel();
    model.device[kSerialNumber] = 0;
    model.strings.erase(3);
    return model;
}

}  // namespace

void DeviceOpenerTest::lasersAreToldApartByTheirNumber()
{
    EmulatedUsb usb;
    const PluggedLaser left(usb, 1, "00903971");
    const PluggedLaser right(usb, 2, "00905555");
    DeviceOpener opener(steadyClock());

    QCOMPARE(serialOf(opener.openLaser(addressOf("usb:00905555"), {})), std::string("00905555"));
    QCOMPARE(serialOf(opener.openLaser(addressOf("usb:00903971"), {})), std::string("00903971"));
    const auto any = opener.openLaser(addressOf("usb:"), {});
    const auto other = opener.openLaser(addressOf("usb:00900000"), {});

    QVERIFY(!any);
    QCOMPARE(any.error().code, ErrorCode::NoDevice);
    QVERIFY2(holds(any.error().message, "2 lasers are connected by USB"), any.error().message.c_str());
    QVERIFY(!other);
    QVERIFY2(holds(other.error().message, "00903971, 00905555"), other.error().message.c_str());
    const FoundDevices found = findDevices(opener, true, {}, {});
    QCOMPARE(found.devices.at(0).address, std::string("usb:00903971"));
    QCOMPARE(found.devices.at(1).address, std::string("usb:00905555"));
}

void DeviceOpenerTest::aLaserIsFoundAgainWhereverItIsPluggedIn()
{
    EmulatedUsb usb;
    const PluggedLaser other(usb, 1, "00903971");
    const PluggedLaser wanted(usb, 2, "00905555");
    DeviceOpener opener(steadyClock());
    const auto count = [&](std::size_t devices) {
        return comesTrue([&] { return opener.usbDevices().value().size() == devices; });
    };
    QCOMPARE(serialOf(opener.openLaser(addressOf("usb:00905555"), {})), std::string("00905555"));

    usb.unplug(wanted.device);
    QVERIFY(count(1));
    const auto gone = opener.openLaser(addressOf("usb:00905555"), {});
    usb.plugAgain(wanted.device, 5);
    QVERIFY(count(2));
    QCOMPARE(serialOf(opener.openLaser(addressOf("usb:00905555"), {})), std::string("00905555"));

    QVERIFY(!gone);
    QVERIFY2(holds(gone.error().message, "there are: 00903971"), gone.error().message.c_str());
    // From now on it is looked for where it was, and the other one is left alone.
    const std::vector<int> before = other.device->released();
    QCOMPARE(serialOf(opener.openLaser(addressOf("usb:00905555"), {})), std::string("00905555"));
    QCOMPARE(other.device->released(), before);
}

void DeviceOpenerTest::aLaserIsNamedByItsPortAsWell()
{
    EmulatedUsb usb;
    const PluggedLaser left(usb, 1, "00903971");
    const PluggedLaser right(usb, 2, "00905555");
    DeviceOpener opener(steadyClock());

    QCOMPARE(serialOf(opener.openLaser(addressOf("usb:@1-2"), {})), std::string("00905555"));
    // Of a number the port is where it is looked for first; it may be elsewhere.
    QCOMPARE(serialOf(opener.openLaser(addressOf("usb:00903971@1-2"), {})), std::string("00903971"));
    const auto none = opener.openLaser(addressOf("usb:@1-3"), {});

    QVERIFY(!none);
    QVERIFY2(holds(none.error().message, "no laser is plugged in at usb 1-3"), none.error().message.c_str());
}

void DeviceOpenerTest::adaptersWithoutANumberAreNamedByTheirPort()
{
    EmulatedUsb usb;
    const auto left = usb.plug(adapterWithoutANumber(), 1);
    const auto right = usb.plug(adapterWithoutANumber(), 2);
    DeviceOpener opener(steadyClock());

    const auto any = opener.openTiltUnit(addressOf("dynamixel:usb:"), {});
    const auto none = opener.openTiltUnit(addressOf("dynamixel:usb:@1-3"), {});
    const auto silent = opener.openTiltUnit(addressOf("dynamixel:usb:@1-2"), {});

    QVERIFY(!any);
    QVERIFY2(holds(any.error().message, "@1-1, @1-2"), any.error().message.c_str());
    QVERIFY(!none);
    QVERIFY2(holds(none.error().message, "no servo adapter at usb 1-3"), none.error().message.c_str());
    QVERIFY(!silent);  // there is no servo behind it, but it was the one that was opened
    QCOMPARE(right->released(), std::vector<int>{0});
    QVERIFY(left->released().empty());
}

void DeviceOpenerTest::everyDialogueHasAFileOfItsOwn()
{
    EmulatedUsb usb;
    const PluggedLaser laser(usb, 1, "00903971");
    const QTemporaryDir folder;
    const std::string dialogues = folder.filePath("kept/dialogues").toStdString();

    for (int run = 0; run < 2; ++run) {
        DeviceOpener opener(steadyClock(), {dialogues, {}});
        QCOMPARE(serialOf(opener.openLaser(addressOf("usb:"), {})), std::string("00903971"));
        QCOMPARE(serialOf(opener.openLaser(addressOf("usb:"), {})), std::string("00903971"));
    }

    for (const char* name : {"laser-1", "laser-2", "laser-3", "laser-4"}) {
        const std::string path = dialogues + "/" + name + ".dialogue";
        QVERIFY2(std::filesystem::exists(path) && std::filesystem::file_size(path) > 100, path.c_str());
    }
    QVERIFY(!std::filesystem::exists(dialogues + "/laser-5.dialogue"));
}

void DeviceOpenerTest::aHostThatWasThereIsNotTakenByAnotherProgram()
{
    auto device = std::make_unique<TestListener>();
    const DeviceAddress address = addressOf("dynamixel:tcp:127.0.0.1:" + std::to_string(device->port()) + "?id=1");
    DeviceOpener opener(steadyClock());
    DeviceOpener newcomer(steadyClock());
    QVERIFY(!opener.openTiltUnit(address, {}));  // it was connected, and nothing answered

    device.reset();
    const auto again = opener.openTiltUnit(address, {});
    const auto first = newcomer.openTiltUnit(address, {});

    QVERIFY(!again && !first);
    QVERIFY2(holds(again.error().message, "nothing answers there yet"), again.error().message.c_str());
    QVERIFY2(holds(first.error().message, "it serves one client at a time"), first.error().message.c_str());
}

void DeviceOpenerTest::aSerialPortThatMayNotBeOpenedHasACure()
{
    // This test runs as a user without rights.
    const QTemporaryDir folder;
    QFile port(folder.filePath("ttyUSB0"));
    QVERIFY(port.open(QIODevice::WriteOnly));
    port.close();
    const std::string path = port.fileName().toStdString();
    const DeviceAddress address = addressOf("dynamixel:serial:" + path);
    EmulatedUsb usb;
    DeviceOpener opener(steadyClock());
    QVERIFY(!hindranceOf(path));

    QVERIFY(port.setPermissions({}));

    QVERIFY(hindranceOf(path));
    QVERIFY(hindranceOf(path)->cure.starts_with("sudo usermod -aG "));
    QVERIFY(holds(hindranceOf(path)->problem, hindranceOf(path)->cure.c_str()));
    QVERIFY(hindranceOf(address, opener));
    QVERIFY(!hindranceOf(folder.filePath("ttyUSB1").toStdString()));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DeviceOpenerTest)
#include "device_opener_test.moc"
