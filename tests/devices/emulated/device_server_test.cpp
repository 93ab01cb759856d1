// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/device_server.h"

#include <thread>

#include <QtTest>

#include "devices/transport/serial_line.h"
#include "devices/transport/tcp_link.h"
#include "tests/devices/echo_device.h"
#include "tests/devices/transport/test_pty.h"
#include "tests/devices/transport/test_socket.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

/// Emulated devices behind real sockets and pseudo terminals, in real time.
class DeviceServerTest : public QObject {
    Q_OBJECT

private slots:
    void aDeviceIsServedOverTcp();
    void aDeviceIsServedOnAPseudoTerminal();
    void theDevicesOfARigAreServedTogether();
    void itListensOnThisMachineOnly();
    void aHostMayBeNamed();
    void onlyOneClientAtATimeIsServed_data();
    void onlyOneClientAtATimeIsServed();
    void aClientMayComeAgain_data();
    void aClientMayComeAgain();
    void whatWasLeftUnreadIsNotForTheNextClient();
    void anAnswerIsNeverEarly_data();
    void anAnswerIsNeverEarly();
    void aClientThatReadsNothingHoldsUpNobody_data();
    void aClientThatReadsNothingHoldsUpNobody();
    void aPulledPlugIsALossAndHoldsUpNobody_data();
    void aPulledPlugIsALossAndHoldsUpNobody();
    void aPluggedInAgainDeviceIsServedAtTheSamePort();
    void manyBytesComeThroughWhole_data();
    void manyBytesComeThroughWhole();
    void aPortInUseIsExplained();
    void whatIsNoPlaceIsRefused_data();
    void whatIsNoPlaceIsRefused();
};

namespace {

/// A server that runs on a thread of its own until it goes.
class Running {
public:
    explicit Running(DeviceServer& server)
        : thread_([&server](const std::stop_token& stop) { QVERIFY(server.run(stop)); })
    {
    }

private:
    std::jthread thread_;
};

std::uint16_t portOf(const std::string& address)
{
    return static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
}

/// Opens what a server has said.
Result<std::unique_ptr<Transport>> openLink(const std::string& address)
{
    constexpr std::string_view kSerial = "serial:";
    if (address.starts_with(kSerial))
        return openSerialLine(address.substr(kSerial.size()), 115200, steadyClock());
    return openTcpLink("127.0.0.1", portOf(address), steadyClock(), steadyClock().now() + kPatience, {});
}

bool write(Transport& link, std::string_view text)
{
    return link.write(asBytes(text), steadyClock().now() + kPatience).has_value();
}

void addPlaces()
{
    QTest::addColumn<QByteArray>("place");
    QTest::newRow("tcp") << QByteArray("tcp:0");
    QTest::newRow("pty") << QByteArray("pty");
}

}  // namespace

void DeviceServerTest::aDeviceIsServedOverTcp()
{
    EchoDevice device;
    DeviceServer server;
    const auto address = server.add(device, "tcp:0");
    QVERIFY2(address, address ? "" : address.error().message.c_str());
    QVERIFY2(address->starts_with("tcp:127.0.0.1:"), address->c_str());
    QVERIFY(portOf(*address) > 0);
    const Running running{server};

    const auto link = openLink(*address);
    QVERIFY2(link, link ? "" : link.error().message.c_str());
    QVERIFY(write(**link, "hello"));

    QCOMPARE(readText(**link, 5), std::string("hello"));
}

void DeviceServerTest::aDeviceIsServedOnAPseudoTerminal()
{
    EchoDevice device;
    DeviceServer server;
    const auto address = server.add(device, "pty");
    QVERIFY2(address, address ? "" : address.error().message.c_str());
    QVERIFY2(address->starts_with("serial:/dev/pts/"), address->c_str());
    const Running running{server};

    // A program that opens it as it is, without setting it up, must find it raw.
    const Descriptor plain = openPlainly(address->substr(7));
    QVERIFY(plain.isOpen());
    QVERIFY(sendText(plain, "a\r\n\x03\x04\x11\x13\x7F"));

    QCOMPARE(receiveText(plain, 8), std::string("a\r\n\x03\x04\x11\x13\x7F"));
}

void DeviceServerTest::theDevicesOfARigAreServedTogether()
{
    EchoDevice laser;
    EchoDevice servo;
    DeviceServer server;
    const auto laserAddress = server.add(laser, "tcp:0");
    const auto servoAddress = server.add(servo, "pty");
    QVERIFY(laserAddress && servoAddress);
    const Running running{server};
    const auto laserLink = openLink(*laserAddress);
    const auto servoLink = openLink(*servoAddress);
    QVERIFY(laserLink && servoLink);

    QVERIFY(write(**laserLink, "laser"));
    QVERIFY(write(**servoLink, "servo"));

    QCOMPARE(readText(**servoLink, 5), std::string("servo"));
    QCOMPARE(readText(**laserLink, 5), std::string("laser"));
}

void DeviceServerTest::itListensOnThisMachineOnly()
{
    EchoDevice device;
    DeviceServer server;
    const auto address = server.add(device, "tcp:0");
    QVERIFY(address);

    // The number behind the usual one of this machine is this machine as well: nobody listens there.
    const Descriptor socket{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
    sockaddr_in neighbour{};
    neighbour.sin_family = AF_INET;
    neighbour.sin_addr.s_addr = htonl(INADDR_LOOPBACK + 1);
    neighbour.sin_port = htons(portOf(*address));

    QCOMPARE(::connect(socket.number(), reinterpret_cast<const sockaddr*>(&neighbour), sizeof neighbour), -1);
}

void DeviceServerTest::aHostMayBeNamed()
{
    EchoDevice device;
    DeviceServer server;

    const auto address = server.add(device, "tcp:0.0.0.0:0");
    QVERIFY2(address, address ? "" : address.error().message.c_str());
    const Running running{server};

    QVERIFY(address->starts_with("tcp:0.0.0.0:"));
    const auto link = openTcpLink("127.0.0.2", portOf(*address), steadyClock(), steadyClock().now() + kPatience, {});
    QVERIFY2(link, link ? "" : link.error().message.c_str());
    QVERIFY(write(**link, "hello"));
    QCOMPARE(readText(**link, 5), std::string("hello"));
}

void DeviceServerTest::onlyOneClientAtATimeIsServed_data()
{
    addPlaces();
}

void DeviceServerTest::onlyOneClientAtATimeIsServed()
{
    QFETCH(QByteArray, place);
    EchoDevice device;
    DeviceServer server;
    const auto address = server.add(device, place.toStdString());
    QVERIFY(address);
    const Running running{server};
    const auto first = openLink(*address);
    QVERIFY(first);
    QVERIFY(write(**first, "one"));
    QCOMPARE(readText(**first, 3), std::string("one"));

    const auto second = openLink(*address);

    const std::string said = second ? readText(**second, 1) : second.error().message;
    QVERIFY2(said.find("other program") != std::string::npos || said.find("another program") != std::string::npos,
             said.c_str());
    QVERIFY(write(**first, "more"));
    QCOMPARE(readText(**first, 4), std::string("more"));
}

void DeviceServerTest::aClientMayComeAgain_data()
{
    addPlaces();
}

void DeviceServerTest::aClientMayComeAgain()
{
    QFETCH(QByteArray, place);
    EchoDevice device;
    DeviceServer server;
    const auto address = server.add(device, place.toStdString());
    QVERIFY(address);
    const Running running{server};

    for (int i = 0; i < 5; ++i) {
        const auto link = openLink(*address);
        QVERIFY2(link, link ? "" : link.error().message.c_str());
        QVERIFY(write(**link, "hello"));
        QCOMPARE(readText(**link, 5), std::string("hello"));
    }
}

void DeviceServerTest::whatWasLeftUnreadIsNotForTheNextClient()
{
    EchoDevice device;
    DeviceServer server;
    const auto address = server.add(device, "pty");
    QVERIFY(address);
    const Running running{server};
    {
        const Descriptor plain = openPlainly(address->substr(7));
        QVERIFY(sendText(plain, "left unread"));
        pollfd waiting{plain.number(), POLLIN, 0};
        QCOMPARE(::poll(&waiting, 1, 30'000), 1);
    }
    // The server sees the first client go within no time, but not in none.
    const auto isClean = [&] {
        const Descriptor plain = openPlainly(address->substr(7));
        pollfd waiting{plain.number(), POLLIN, 0};
        return ::poll(&waiting, 1, 0) == 0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isClean(), 30'000);

    const auto link = openLink(*address);
    QVERIFY(link);
    QVERIFY(write(**link, "new"));

    QCOMPARE(readText(**link, 3), std::string("new"));
}

void DeviceServerTest::anAnswerIsNeverEarly_data()
{
    addPlaces();
}

void DeviceServerTest::anAnswerIsNeverEarly()
{
    QFETCH(QByteArray, place);
    EchoDevice device;
    device.delay = 30ms;
    DeviceServer server;
    const auto address = server.add(device, place.toStdString());
    QVERIFY(address);
    const Running running{server};
    const auto link = openLink(*address);
    QVERIFY(link);

    const auto asked = steadyClock().now();
    QVERIFY(write(**link, "a"));
    QCOMPARE(readText(**link, 1), std::string("a"));

    QVERIFY(steadyClock().now() - asked >= 30ms);
}

void DeviceServerTest::aClientThatReadsNothingHoldsUpNobody_data()
{
    addPlaces();
}

void DeviceServerTest::aClientThatReadsNothingHoldsUpNobody()
{
    QFETCH(QByteArray, place);
    EchoDevice chatty;
    // More than any buffer between them holds, and no more than a machine that is busy can say in time.
    chatty.period = 1ms;
    chatty.frame = std::size_t{1} << 17;
    chatty.frames = 200;
    EchoDevice other;
    DeviceServer server;
    const auto chattyAddress = server.add(chatty, place.toStdString());
    const auto otherAddress = server.add(other, "tcp:0");
    QVERIFY(chattyAddress && otherAddress);
    const Running running{server};
    const Descriptor deaf =
        place == "pty" ? openPlainly(chattyAddress->substr(7)) : connectPlainly(portOf(*chattyAddress));
    QVERIFY(sendText(deaf, "S"));
    const auto link = openLink(*otherAddress);
    QVERIFY(link);

    for (int i = 0; i < 120; ++i) {
        QVERIFY(write(**link, "still there?"));
        QCOMPARE(readText(**link, 12), std::string("still there?"));
    }
}

void DeviceServerTest::aPulledPlugIsALossAndHoldsUpNobody_data()
{
    addPlaces();
}

void DeviceServerTest::aPulledPlugIsALossAndHoldsUpNobody()
{
    QFETCH(QByteArray, place);
    EchoDevice device;
    EchoDevice other;
    DeviceServer server;
    const auto address = server.add(device, place.toStdString());
    const auto otherAddress = server.add(other, "tcp:0");
    QVERIFY(address && otherAddress);
    const Running running{server};
    const auto link = openLink(*address);
    const auto otherLink = openLink(*otherAddress);
    QVERIFY(link && otherLink);
    QVERIFY(write(**link, "a"));
    QCOMPARE(readText(**link, 1), std::string("a"));

    QVERIFY(write(**link, "X"));

    const std::string end = readText(**link, 100);
    QVERIFY2(end.find("closed the connection") != std::string::npos || end.find("device is gone") != std::string::npos,
             end.c_str());
    QVERIFY(write(**otherLink, "still there?"));
    QCOMPARE(readText(**otherLink, 12), std::string("still there?"));
}

void DeviceServerTest::aPluggedInAgainDeviceIsServedAtTheSamePort()
{
    EchoDevice device;
    device.isPluggedIn = false;
    DeviceServer server;
    const auto address = server.add(device, "tcp:0");
    QVERIFY(address);
    {
        const Running running{server};
        const auto link = openLink(*address);
        QVERIFY(!link || readText(**link, 1).find("closed the connection") != std::string::npos);
    }

    device.isPluggedIn = true;
    const Running running{server};

    const auto link = openLink(*address);
    QVERIFY2(link, link ? "" : link.error().message.c_str());
    QVERIFY(write(**link, "hello"));
    QCOMPARE(readText(**link, 5), std::string("hello"));
}

void DeviceServerTest::manyBytesComeThroughWhole_data()
{
    addPlaces();
}

void DeviceServerTest::manyBytesComeThroughWhole()
{
    QFETCH(QByteArray, place);
    EchoDevice device;
    device.delay = 0ms;
    DeviceServer server;
    const auto address = server.add(device, place.toStdString());
    QVERIFY(address);
    const Running running{server};
    const auto link = openLink(*address);
    QVERIFY(link);
    std::string sent(100'000, '\0');
    for (std::size_t i = 0; i < sent.size(); ++i)
        sent[i] = static_cast<char>('a' + i * i % 23);
    std::jthread writer{[&] { write(**link, sent); }};

    const std::string received = readText(**link, sent.size());

    QVERIFY(received == sent);
}

void DeviceServerTest::aPortInUseIsExplained()
{
    const TestListener taken;
    EchoDevice device;
    DeviceServer server;

    const auto address = server.add(device, "tcp:" + std::to_string(taken.port()));

    QVERIFY(!address);
    QCOMPARE(address.error().code, ErrorCode::NoDevice);
    QCOMPARE(address.error().message, "tcp:" + std::to_string(taken.port()) +
                                          ": another program listens at this port; give another one, or 0 for any that "
                                          "is free");
}

void DeviceServerTest::whatIsNoPlaceIsRefused_data()
{
    QTest::addColumn<QByteArray>("place");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* place, const char* says) {
        QTest::newRow(*place == '\0' ? "nothing" : place) << QByteArray(place) << QByteArray(says);
    };
    row("", "give tcp:PORT, with 0 for any, or pty");
    row("udp:1", "give tcp:PORT");
    row("pty:1", "give tcp:PORT");
    row("10940", "give tcp:PORT");
    row("tcp:", "port '' is not a whole number from 0 to 65535");
    row("tcp:65536", "port '65536' is not");
    row("tcp:0.0.0.0", "port '0.0.0.0' is not");
    row("tcp::1", "give a host and a port");
    row("tcp:::1:0", "put a host with colons into brackets");
}

void DeviceServerTest::whatIsNoPlaceIsRefused()
{
    QFETCH(QByteArray, place);
    QFETCH(QByteArray, says);
    EchoDevice device;
    DeviceServer server;

    const auto address = server.add(device, place.toStdString());

    QVERIFY(!address);
    QCOMPARE(address.error().code, ErrorCode::Usage);
    QVERIFY2(address.error().message.starts_with("'" + place.toStdString() + "': "), address.error().message.c_str());
    QVERIFY2(address.error().message.find(says.toStdString()) != std::string::npos, address.error().message.c_str());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DeviceServerTest)
#include "device_server_test.moc"
