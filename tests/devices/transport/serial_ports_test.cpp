// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/serial_ports.h"

#include <algorithm>

#include <QtTest>

#include "tests/devices/transport/emulated_ports.h"
#include "tests/test_program.h"

namespace planewright {

class SerialPortsTest : public QObject {
    Q_OBJECT

private slots:
    void aPortSaysWhoIsBehindIt();
    void portsAreListedByPath();
    void aPortThatIsPulledOutIsNotListed();

private:
    EmulatedPorts machine_;
};

void SerialPortsTest::aPortSaysWhoIsBehindIt()
{
    machine_.add("ttyACM0", "15d1", "0000", "Hokuyo_Automatic_Co__Ltd.", "URG-Series_USB_Driver", "");
    machine_.add("ttyUSB0", "0403", "6001", "FTDI", "USB__-__Serial", "AI02QIYN");

    const std::vector<SerialPort> ports = serialPorts();

    QCOMPARE(ports.size(), std::size_t{2});
    QCOMPARE(ports[0].path, std::string("/dev/ttyACM0"));
    QCOMPARE(ports[0].usbVendor, std::uint16_t{0x15d1});
    QCOMPARE(ports[0].usbProduct, std::uint16_t{0});
    QCOMPARE(ports[0].product, std::string("URG-Series USB Driver"));
    QCOMPARE(ports[0].serial, std::string());
    QCOMPARE(ports[1].path, std::string("/dev/ttyUSB0"));
    QCOMPARE(ports[1].usbVendor, std::uint16_t{0x0403});
    QCOMPARE(ports[1].usbProduct, std::uint16_t{0x6001});
    QCOMPARE(ports[1].vendor, std::string("FTDI"));
    QCOMPARE(ports[1].serial, std::string("AI02QIYN"));
    machine_.remove("ttyACM0");
    machine_.remove("ttyUSB0");
}

void SerialPortsTest::portsAreListedByPath()
{
    for (const char* port : {"ttyUSB3", "ttyACM3", "ttyUSB2"})
        machine_.add(port, "0403", "6001", "FTDI", "FT232R", port);

    const std::vector<SerialPort> ports = serialPorts();

    QCOMPARE(ports.size(), std::size_t{3});
    QCOMPARE(ports[0].path, std::string("/dev/ttyACM3"));
    QCOMPARE(ports[1].path, std::string("/dev/ttyUSB2"));
    QCOMPARE(ports[2].path, std::string("/dev/ttyUSB3"));
    for (const SerialPort& port : ports)
        machine_.remove(port.path.substr(5));
}

void SerialPortsTest::aPortThatIsPulledOutIsNotListed()
{
    machine_.add("ttyACM5", "15d1", "0000", "Hokuyo", "URG", "");
    QCOMPARE(serialPorts().size(), std::size_t{1});

    machine_.remove("ttyACM5");

    QVERIFY(serialPorts().empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SerialPortsTest)
#include "serial_ports_test.moc"
