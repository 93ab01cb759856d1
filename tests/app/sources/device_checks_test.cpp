// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/device_checks.h"

#include <QtTest>

#include "devices/transport/usb_error.h"
#include "tests/app/sources/fake_devices.h"
#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {

class DeviceChecksTest : public QObject {
    Q_OBJECT

private slots:
    void sixChecksPassAndTheHeadIsBackAndHeld();
    void nothingMovesBeforeTheLastCheck();
    void devicesThatWereNotChosenAreNobodysTrouble();
    void aChosenDeviceThatMayNotBeOpenedIsNamedWithTheCure();
    void ofSeveralLasersOneThatMayBeOpenedIsEnough();
    void usbThatCannotBeUsedIsSaid();
    void aStopFailsTheCheckThatRuns();
};

namespace {

struct Bench {
    FakeClock clock;
    std::shared_ptr<FakeHead> head = std::make_shared<FakeHead>();
    FakeAccess access{head, clock};
    std::stop_source stop;
    std::vector<std::optional<Result<std::string>>> results = std::vector<std::optional<Result<std::string>>>(6);
    std::function<void(std::size_t)> onBegin;

    void run(const std::string& laser = "usb:", const std::string& unit = "dynamixel:usb:")
    {
        NoddingSetup setup;
        setup.tiltUnit = unit;
        checkDevices(
            access, laser, setup, clock,
            [&](std::size_t check, const std::optional<Result<std::string>>& result) {
                results.at(check) = result;
                if (!result && onBegin)
                    onBegin(check);
            },
            stop.get_token());
    }
    bool passed(std::size_t check) const { return results.at(check) && results.at(check)->has_value(); }
    std::string trouble(std::size_t check) const
    {
        return results.at(check) && !*results.at(check) ? results.at(check)->error().message : "";
    }
};

UsbDevice usbDevice(UsbKind kind, const std::string& port, const std::string& serial, UsbAccess access)
{
    UsbDevice device;
    device.vendor = kind == UsbKind::CdcAcm ? 0x15d1 : 0x0403;
    device.kind = kind;
    device.port = port;
    device.serial = serial;
    device.access = access;
    return device;
}

}  // namespace

void DeviceChecksTest::sixChecksPassAndTheHeadIsBackAndHeld()
{
    Bench bench;

    bench.run();

    for (std::size_t check = 0; check < 6; ++check)
        QVERIFY2(bench.passed(check), bench.trouble(check).c_str());
    QCOMPARE(bench.results[3]->value(), std::string("137 slices of 721 beams"));
    QCOMPARE(bench.head->moves, 2);
    QVERIFY(std::abs(bench.head->pitch - degrees(90.0)) < degrees(0.7));
    QVERIFY(bench.head->isHeld);
}

void DeviceChecksTest::nothingMovesBeforeTheLastCheck()
{
    Bench bench;
    int movesBefore = -1;
    bool armedBefore = true;
    bench.onBegin = [&](std::size_t check) {
        if (check == 5) {
            movesBefore = bench.head->moves;
            armedBefore = bench.head->isArmed;
        }
    };

    bench.run();

    QCOMPARE(movesBefore, 0);
    QVERIFY(!armedBefore);
}

void DeviceChecksTest::devicesThatWereNotChosenAreNobodysTrouble()
{
    Bench bench;
    bench.access.usb = {usbDevice(UsbKind::CdcAcm, "1-1", "", UsbAccess::Openable),
                        usbDevice(UsbKind::Ftdi, "1-2", "AB12", UsbAccess::Openable),
                        usbDevice(UsbKind::Ftdi, "1-3", "console", UsbAccess::Denied)};

    bench.run("usb:", "dynamixel:usb:AB12");

    QVERIFY2(bench.passed(0), bench.trouble(0).c_str());
}

void DeviceChecksTest::aChosenDeviceThatMayNotBeOpenedIsNamedWithTheCure()
{
    Bench bench;
    bench.access.usb = {usbDevice(UsbKind::CdcAcm, "1-1", "", UsbAccess::Openable),
                        usbDevice(UsbKind::Ftdi, "1-3", "AB12", UsbAccess::Denied)};

    bench.run("usb:", "dynamixel:usb:AB12");

    QVERIFY(!bench.passed(0));
    QVERIFY2(bench.trouble(0).starts_with("usb 1-3: you may not use it yet"), bench.trouble(0).c_str());
    QVERIFY(bench.trouble(0).find("serial port") != std::string::npos);
    QVERIFY(bench.trouble(0).ends_with(usbPermissionCommand()));
    QVERIFY(!bench.results[1]);
}

void DeviceChecksTest::ofSeveralLasersOneThatMayBeOpenedIsEnough()
{
    Bench bench;
    bench.access.usb = {usbDevice(UsbKind::CdcAcm, "1-1", "", UsbAccess::Denied),
                        usbDevice(UsbKind::CdcAcm, "1-2", "", UsbAccess::Openable)};

    bench.run("usb:00903971", "board:serial:/dev/no-such-port");
    Bench denied;
    denied.access.usb = bench.access.usb;
    denied.run("usb:@1-1", "board:serial:/dev/no-such-port");

    QVERIFY2(bench.passed(0), bench.trouble(0).c_str());
    QVERIFY(!denied.passed(0));
}

void DeviceChecksTest::usbThatCannotBeUsedIsSaid()
{
    Bench bench;
    bench.access.usbProblem = Error{ErrorCode::NoDevice, "USB cannot be used here"};

    bench.run("tcp:127.0.0.1:1", "dynamixel:usb:");
    Bench network;
    network.access.usbProblem = bench.access.usbProblem;
    network.run("tcp:127.0.0.1:1", "dynamixel:tcp:127.0.0.1:2");

    QCOMPARE(bench.trouble(0), std::string("USB cannot be used here"));
    QVERIFY(network.passed(0));
}

void DeviceChecksTest::aStopFailsTheCheckThatRuns()
{
    Bench bench;
    bench.head->onSample = [&] {
        if (bench.head->moves == 1 && bench.head->pitch > degrees(92.0))
            bench.stop.request_stop();
    };

    bench.run();

    QVERIFY2(bench.trouble(5).find("motion was stopped") != std::string::npos, bench.trouble(5).c_str());
    QCOMPARE(bench.head->moves, 1);
    QVERIFY(bench.head->isHeld);
    QVERIFY(bench.head->pitch < degrees(93.0));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DeviceChecksTest)
#include "device_checks_test.moc"
