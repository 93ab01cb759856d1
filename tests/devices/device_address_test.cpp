// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/device_address.h"

#include <cmath>
#include <numbers>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class DeviceAddressTest : public QObject {
    Q_OBJECT

private slots:
    void anAddressSaysUnitLinkAndPlace_data();
    void anAddressSaysUnitLinkAndPlace();
    void optionsHaveDefaults();
    void aServoHasANumberAndASpeed();
    void howATiltUnitIsMountedIsSaid();
    void aTiltUnitHasLimits();
    void whatHasNoNumberIsNamedByItsPlug_data();
    void whatHasNoNumberIsNamedByItsPlug();
    void aDialogueHasAPace();
    void otherTextsAreNoDevices_data();
    void otherTextsAreNoDevices();
    void whatIsWrongIsNamed_data();
    void whatIsWrongIsNamed();
};

namespace {

using Unit = DeviceAddress::Unit;
using Link = DeviceAddress::Link;

}  // namespace

void DeviceAddressTest::anAddressSaysUnitLinkAndPlace_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<Unit>("unit");
    QTest::addColumn<Link>("link");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<int>("port");
    const auto row = [](const char* text, Unit unit, Link link, const char* name, int port) {
        QTest::newRow(text) << QByteArray(text) << unit << link << QByteArray(name) << port;
    };
    row("usb:H0906091", Unit::Laser, Link::Usb, "H0906091", 0);
    row("usb:", Unit::Laser, Link::Usb, "", 0);
    row("usb:?", Unit::Laser, Link::Usb, "", 0);
    row("tcp:192.168.0.10:10940", Unit::Laser, Link::Tcp, "192.168.0.10", 10940);
    row("tcp:laser.lab:1", Unit::Laser, Link::Tcp, "laser.lab", 1);
    row("tcp:[fe80::1%eth0]:65535", Unit::Laser, Link::Tcp, "fe80::1%eth0", 65535);
    row("serial:/dev/ttyACM0", Unit::Laser, Link::Serial, "/dev/ttyACM0", 0);
    row("serial:/dev/what?", Unit::Laser, Link::Serial, "/dev/what", 0);
    row("serial:/dev/what??baud=19200", Unit::Laser, Link::Serial, "/dev/what?", 0);
    row("serial:/dev/serial/by-id/usb-FTDI:0", Unit::Laser, Link::Serial, "/dev/serial/by-id/usb-FTDI:0", 0);
    row("dialogue:session.txt", Unit::Laser, Link::Dialogue, "session.txt", 0);
    row("dynamixel:usb:AI02QIYN", Unit::Dynamixel, Link::Usb, "AI02QIYN", 0);
    row("dynamixel:usb:", Unit::Dynamixel, Link::Usb, "", 0);
    row("dynamixel:serial:/dev/ttyUSB0", Unit::Dynamixel, Link::Serial, "/dev/ttyUSB0", 0);
    row("dynamixel:tcp:127.0.0.1:4001?id=3", Unit::Dynamixel, Link::Tcp, "127.0.0.1", 4001);
    row("dynamixel:dialogue:servo.txt", Unit::Dynamixel, Link::Dialogue, "servo.txt", 0);
    row("board:usb:0001", Unit::Board, Link::Usb, "0001", 0);
    row("board:serial:/dev/ttyACM1", Unit::Board, Link::Serial, "/dev/ttyACM1", 0);
    row("board:tcp:[::1]:4002", Unit::Board, Link::Tcp, "::1", 4002);
}

void DeviceAddressTest::anAddressSaysUnitLinkAndPlace()
{
    QFETCH(QByteArray, text);
    QFETCH(Unit, unit);
    QFETCH(Link, link);
    QFETCH(QByteArray, name);
    QFETCH(int, port);

    const auto address = parseDeviceAddress(text.toStdString());

    QVERIFY2(address, address ? "" : address.error().message.c_str());
    QVERIFY(isDeviceAddress(text.toStdString()));
    QCOMPARE(address->unit, unit);
    QCOMPARE(address->link, link);
    QCOMPARE(address->name, name.toStdString());
    QCOMPARE(int{address->port}, port);
}

void DeviceAddressTest::optionsHaveDefaults()
{
    QCOMPARE(parseDeviceAddress("serial:/dev/ttyACM0")->baud, 115200);
    QCOMPARE(parseDeviceAddress("board:usb:")->baud, 115200);
    const auto servo = parseDeviceAddress("dynamixel:usb:");
    QCOMPARE(servo->baud, 57142);
    QCOMPARE(servo->id, 1);
    QVERIFY(!servo->hasEcho);
    QVERIFY(parseDeviceAddress("dynamixel:usb:?echo=yes")->hasEcho);
    QVERIFY(!parseDeviceAddress("dynamixel:usb:?echo=no")->hasEcho);
    QVERIFY(!servo->zeroPitch);
    QCOMPARE(servo->sign, 1.0);
    QCOMPARE(servo->scale, 1.0);
    QVERIFY(parseDeviceAddress("dialogue:a")->isInTime);
}

void DeviceAddressTest::aServoHasANumberAndASpeed()
{
    for (const char* text :
         {"dynamixel:usb:AI02?id=253&baud=1000000", "dynamixel:serial:/dev/ttyUSB0?baud=1000000&id=253",
          "dynamixel:tcp:127.0.0.1:4001?id=253&baud=1000000"}) {
        const auto address = parseDeviceAddress(text);

        QVERIFY2(address, address ? "" : address.error().message.c_str());
        QCOMPARE(address->id, 253);
        QCOMPARE(address->baud, 1000000);
    }
}

void DeviceAddressTest::howATiltUnitIsMountedIsSaid()
{
    const auto address = parseDeviceAddress("board:usb:?zero=90.5&sign=-&scale=0.998");

    QVERIFY2(address, address ? "" : address.error().message.c_str());
    QVERIFY(address->zeroPitch);
    QVERIFY(std::abs(*address->zeroPitch - 90.5 / 180.0 * std::numbers::pi) < 1e-12);
    QCOMPARE(address->sign, -1.0);
    QCOMPARE(address->scale, 0.998);
    QCOMPARE(parseDeviceAddress("board:usb:?sign=+")->sign, 1.0);
    QVERIFY(parseDeviceAddress("dynamixel:usb:?zero=-12")->zeroPitch.value() < 0.0);
}

void DeviceAddressTest::aTiltUnitHasLimits()
{
    const auto limited = parseDeviceAddress("dynamixel:usb:?lowest=-20&highest=110.5&fastest=45");
    const auto free = parseDeviceAddress("dynamixel:usb:");

    QVERIFY2(limited, limited ? "" : limited.error().message.c_str());
    QCOMPARE(limited->lowest.value(), -20.0 / 180.0 * std::numbers::pi);
    QCOMPARE(limited->highest.value(), 110.5 / 180.0 * std::numbers::pi);
    QCOMPARE(limited->fastest.value(), 0.25 * std::numbers::pi);
    QVERIFY(!free->lowest && !free->highest && !free->fastest);
}

void DeviceAddressTest::whatHasNoNumberIsNamedByItsPlug_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("plug");
    const auto row = [](const char* text, const char* name, const char* plug) {
        QTest::newRow(text) << QByteArray(text) << QByteArray(name) << QByteArray(plug);
    };
    row("usb:@1-4", "", "1-4");
    row("usb:00903971@1-4", "00903971", "1-4");
    row("dynamixel:usb:@2-1.4.3?id=2", "", "2-1.4.3");
    row("dynamixel:usb:FT1@lab@1-12", "FT1@lab", "1-12");
    row("board:usb:FT1@lab", "FT1@lab", "");
    row("board:usb:FT1@1-", "FT1@1-", "");
    row("board:usb:FT1@1-4..2", "FT1@1-4..2", "");
}

void DeviceAddressTest::whatHasNoNumberIsNamedByItsPlug()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, plug);

    const auto address = parseDeviceAddress(text.toStdString());

    QVERIFY2(address, address ? "" : address.error().message.c_str());
    QCOMPARE(address->name, name.toStdString());
    QCOMPARE(address->usbPort, plug.toStdString());
}

void DeviceAddressTest::aDialogueHasAPace()
{
    QVERIFY(!parseDeviceAddress("dialogue:a.txt?speed=0")->isInTime);
    QVERIFY(parseDeviceAddress("dialogue:a.txt?speed=1")->isInTime);
    QVERIFY(!parseDeviceAddress("dynamixel:dialogue:a.txt?id=2&speed=0")->isInTime);
}

void DeviceAddressTest::otherTextsAreNoDevices_data()
{
    QTest::addColumn<QByteArray>("text");
    for (const char* text : {"lobby.csv", "sim:hall", "replay:a.csv", "usb", "usbstick/lobby.csv", "TCP:a:1"})
        QTest::newRow(text) << QByteArray(text);
}

void DeviceAddressTest::otherTextsAreNoDevices()
{
    QFETCH(QByteArray, text);

    QVERIFY(!isDeviceAddress(text.toStdString()));
    QVERIFY(!parseDeviceAddress(text.toStdString()));
}

void DeviceAddressTest::whatIsWrongIsNamed_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* text, const char* says) {
        QTest::newRow(*text == '\0' ? "nothing" : text) << QByteArray(text) << QByteArray(says);
    };
    row("", "give usb:SERIAL, tcp:HOST:PORT, serial:PATH or dialogue:FILE, and for a tilt unit dynamixel: or board:");
    row("/dev/ttyACM0", "give usb:SERIAL, tcp:HOST:PORT, serial:PATH");
    row("dynamixel:", "give usb:SERIAL, tcp:HOST:PORT, serial:PATH or dialogue:FILE behind dynamixel:");
    row("board:/dev/ttyACM0", "behind board:");
    row("board:dynamixel:usb:", "behind board:");
    row("serial:", "give a port, as in serial:/dev/ttyUSB0");
    row("serial:?baud=9600", "give a port, as in serial:/dev/ttyUSB0");
    row("dialogue:", "give the name of a file");
    row("tcp:", "give a host and a port, as in 192.168.0.10:10940");
    row("tcp::10940", "give a host and a port");
    row("tcp:192.168.0.10", "give a port, too, as in 192.168.0.10:10940");
    row("tcp:192.168.0.10:", "port '' is not a whole number from 1 to 65535");
    row("tcp:192.168.0.10:0", "port '0' is not a whole number from 1 to 65535");
    row("tcp:192.168.0.10:65536", "port '65536' is not");
    row("tcp:192.168.0.10:-1", "port '-1' is not");
    row("tcp:192.168.0.10:10940x", "port '10940x' is not");
    row("tcp:192.168.0.10: 1", "port ' 1' is not");
    row("tcp:fe80::1:10940", "put a host with colons into brackets");
    row("tcp:[fe80::1", "bracket of the host is not closed");
    row("tcp:[fe80::1]", "give a port, too, as in [fe80::1]:10940");
    row("tcp:[fe80::1]10940", "give a port, too");
    row("tcp:[]:10940", "in brackets stands a number with colons");
    row("tcp:[laser]:10940", "in brackets stands a number with colons");
    row("tcp:laser:10940?baud=9600", "no option 'baud'; such an address has none");
    row("usb:?id=1", "no option 'id'; such an address has none");
    row("serial:/dev/ttyS0?id=1", "no option 'id'; known: baud");
    row("serial:/dev/ttyS0?baud=fast", "baud 'fast' is not a whole number of bit/s from 300 to 4500000");
    row("serial:/dev/ttyS0?baud=299", "baud '299' is not");
    row("serial:/dev/ttyS0?baud=4500001", "baud '4500001' is not");
    row("serial:/dev/ttyS0?baud", "baud '' is not");
    row("serial:/dev/ttyS0?baud=9600&baud=9600", "'baud' is given twice");
    row("dynamixel:usb:?speed=0", "no option 'speed'; known: id, echo, baud, zero, sign, scale");
    row("dynamixel:usb:?id=254", "id '254' is not a whole number from 0 to 253");
    row("dynamixel:usb:?id=-1", "id '-1' is not");
    row("dynamixel:usb:?id=1.5", "id '1.5' is not");
    row("dynamixel:usb:?echo=1", "echo '1' is not yes");
    row("board:usb:?id=1", "no option 'id'; known: zero, sign, scale");
    row("board:serial:/dev/ttyACM0?Baud=1", "no option 'Baud'; known: baud, zero, sign, scale");
    row("board:usb:?zero=level", "zero 'level' is not a number of degrees from -360 to 360");
    row("board:usb:?zero=nan", "zero 'nan' is not");
    row("board:usb:?zero=361", "zero '361' is not");
    row("board:usb:?sign=1", "sign '1' is not + or -");
    row("board:usb:?scale=0", "scale '0' is not a number from 0.01 to 100");
    row("board:usb:?scale=inf", "scale 'inf' is not");
    row("board:usb:?lowest=down", "lowest 'down' is not a number of degrees from -360 to 360");
    row("board:usb:?highest=360.1", "highest '360.1' is not");
    row("board:usb:?lowest=90&highest=90", "lowest is not below highest");
    row("board:usb:?highest=-1", "lowest is not below highest");  // lowest is 0 where nobody says otherwise
    row("board:usb:?fastest=0", "fastest '0' is not a number of degrees a second from 1 to 720");
    row("usb:?lowest=1", "no option 'lowest'; such an address has none");
    row("usb:@", "'' is no place where something is plugged in; give usb:@1-4 or, behind a hub, usb:@1-4.2");
    row("dynamixel:usb:@left", "'left' is no place");
    row("dialogue:a?speed=2", "speed '2' is not 0, as fast as possible, or 1, real time");
    row("dialogue:a?zero=1", "no option 'zero'; known: speed");
}

void DeviceAddressTest::whatIsWrongIsNamed()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, says);

    const auto address = parseDeviceAddress(text.toStdString());

    QVERIFY(!address);
    QCOMPARE(address.error().code, ErrorCode::Usage);
    QVERIFY2(address.error().message.starts_with("'" + text.toStdString() + "': "), address.error().message.c_str());
    QVERIFY2(address.error().message.find(says.toStdString()) != std::string::npos, address.error().message.c_str());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DeviceAddressTest)
#include "device_address_test.moc"
