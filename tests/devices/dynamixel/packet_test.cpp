// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/packet.h"

#include <QtTest>

#include "devices/dynamixel/packet_parser.h"
#include "devices/dynamixel/requests.h"
#include "tests/devices/dynamixel/hex_bytes.h"
#include "tests/test_program.h"

namespace planewright {

class PacketTest : public QObject {
    Q_OBJECT

private slots:
    void requestsAreTheBytesOfTheManual_data();
    void requestsAreTheBytesOfTheManual();
    void answersAreReadAsTheManualSays_data();
    void answersAreReadAsTheManualSays();
    void crcIsThatOfTheKnownCheckString();
    void aHeaderInsideAPacketIsStuffed();
    void aRequestOfTwoIsNoAnswer();
    void valuesAreLittleEndian();
};

namespace {

constexpr DynamixelProtocol kProtocolOne = DynamixelProtocol::One;
constexpr DynamixelProtocol kTwo = DynamixelProtocol::Two;

void request(const char* name, DynamixelProtocol protocol, const DynamixelPacket& packet, const char* hex)
{
    QTest::newRow(name) << protocol << packet << QString{hex};
}

void answer(const char* name, DynamixelProtocol protocol, const char* hex, const DynamixelStatus& status)
{
    QTest::newRow(name) << protocol << QString{hex} << status;
}

DynamixelPacket write(DynamixelProtocol protocol, std::uint16_t address, std::vector<std::uint8_t> data)
{
    return writeRequest(protocol, 1, address, data);
}

}  // namespace

}  // namespace planewright

Q_DECLARE_METATYPE(planewright::DynamixelProtocol)
Q_DECLARE_METATYPE(planewright::DynamixelPacket)
Q_DECLARE_METATYPE(planewright::DynamixelStatus)

namespace planewright {

void PacketTest::requestsAreTheBytesOfTheManual_data()
{
    QTest::addColumn<DynamixelProtocol>("protocol");
    QTest::addColumn<DynamixelPacket>("packet");
    QTest::addColumn<QString>("hex");
    const std::vector<std::uint8_t> goal500{0xF4, 0x01};
    const std::vector<SyncWriteData> two{{0, {0x10, 0x00, 0x50, 0x01}}, {1, {0x20, 0x02, 0x60, 0x03}}};

    request("ping", kProtocolOne, pingRequest(1), "FF FF 01 02 01 FB");
    request("read temperature", kProtocolOne, readRequest(kProtocolOne, 1, 43, 1), "FF FF 01 04 02 2B 01 CC");
    request("read model and firmware", kProtocolOne, readRequest(kProtocolOne, 1, 0, 3), "FF FF 01 04 02 00 03 F5");
    request("read the state", kProtocolOne, readRequest(kProtocolOne, 1, 36, 11), "FF FF 01 04 02 24 0B C9");
    request("torque on", kProtocolOne, write(kProtocolOne, 24, {1}), "FF FF 01 04 03 18 01 DE");
    request("torque off", kProtocolOne, write(kProtocolOne, 24, {0}), "FF FF 01 04 03 18 00 DF");
    request("goal 512", kProtocolOne, write(kProtocolOne, 30, {0x00, 0x02}), "FF FF 01 05 03 1E 00 02 D6");
    request("goal 512 at speed 100", kProtocolOne, write(kProtocolOne, 30, {0x00, 0x02, 0x64, 0x00}),
            "FF FF 01 07 03 1E 00 02 64 00 70");
    request("reg-write goal 500", kProtocolOne, regWriteRequest(kProtocolOne, 1, 30, goal500),
            "FF FF 01 05 04 1E F4 01 E2");
    request("action", kProtocolOne, actionRequest(kBroadcastId), "FF FF FE 02 05 FA");
    request("torque limit 1023", kProtocolOne, write(kProtocolOne, 34, {0xFF, 0x03}), "FF FF 01 05 03 22 FF 03 D2");
    request("return delay 0", kProtocolOne, write(kProtocolOne, 5, {0}), "FF FF 01 04 03 05 00 F2");
    request("sync write", kProtocolOne, syncWriteRequest(kProtocolOne, 30, 4, two),
            "FF FF FE 0E 83 1E 04 00 10 00 50 01 01 20 02 60 03 67");
    request("2.0: ping", kTwo, pingRequest(1), "FF FF FD 00 01 03 00 01 19 4E");
    request("2.0: ping to all", kTwo, pingRequest(kBroadcastId), "FF FF FD 00 FE 03 00 01 31 42");
    request("2.0: read position", kTwo, readRequest(kTwo, 1, 132, 4), "FF FF FD 00 01 07 00 02 84 00 04 00 1D 15");
    request("2.0: goal 512", kTwo, write(kTwo, 116, {0x00, 0x02, 0x00, 0x00}),
            "FF FF FD 00 01 09 00 03 74 00 00 02 00 00 CA 89");
    request("2.0: torque on", kTwo, write(kTwo, 64, {1}), "FF FF FD 00 01 06 00 03 40 00 01 DB 66");
}

void PacketTest::requestsAreTheBytesOfTheManual()
{
    QFETCH(DynamixelProtocol, protocol);
    QFETCH(DynamixelPacket, packet);
    QFETCH(QString, hex);

    QCOMPARE(hexText(encodePacket(protocol, packet)), hex.toStdString());
    QVERIFY(PacketParser{protocol}.push(hexBytes(hex.toStdString())) == std::vector{packet});
}

void PacketTest::answersAreReadAsTheManualSays_data()
{
    QTest::addColumn<DynamixelProtocol>("protocol");
    QTest::addColumn<QString>("hex");
    QTest::addColumn<DynamixelStatus>("status");

    answer("ok", kProtocolOne, "FF FF 01 02 00 FC", {1, 0x00, {}});
    answer("overload and overheating", kProtocolOne, "FF FF 01 02 24 D8", {1, 0x24, {}});
    answer("32 °C", kProtocolOne, "FF FF 01 03 00 20 DB", {1, 0x00, {32}});
    answer("the state", kProtocolOne, "FF FF 01 0D 00 00 02 00 00 40 00 94 26 00 00 00 F5",
           {1, 0x00, {0x00, 0x02, 0x00, 0x00, 0x40, 0x00, 0x94, 0x26, 0x00, 0x00, 0x00}});
    answer("2.0: model 1030, firmware 38", kTwo, "FF FF FD 00 01 07 00 55 00 06 04 26 65 5D",
           {1, 0x00, {0x06, 0x04, 38}});
    answer("2.0: the same of number 2", kTwo, "FF FF FD 00 02 07 00 55 00 06 04 26 6F 6D", {2, 0x00, {0x06, 0x04, 38}});
    answer("2.0: position 166", kTwo, "FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0", {1, 0x00, {166, 0, 0, 0}});
}

void PacketTest::answersAreReadAsTheManualSays()
{
    QFETCH(DynamixelProtocol, protocol);
    QFETCH(QString, hex);
    QFETCH(DynamixelStatus, status);

    const std::vector<DynamixelPacket> packets = PacketParser{protocol}.push(hexBytes(hex.toStdString()));

    QCOMPARE(packets.size(), std::size_t(1));
    QVERIFY(statusOf(protocol, packets[0]) == status);
    QCOMPARE(hexText(encodePacket(protocol, packetOf(protocol, status))), hex.toStdString());
}

void PacketTest::crcIsThatOfTheKnownCheckString()
{
    const std::string digits = "123456789";
    const std::vector<std::uint8_t> bytes{digits.begin(), digits.end()};

    QCOMPARE(crc16(bytes), std::uint16_t(0xFEE8));
    QCOMPARE(crc16({}), std::uint16_t(0));
}

void PacketTest::aHeaderInsideAPacketIsStuffed()
{
    const DynamixelPacket packet = write(kTwo, 116, {0xFF, 0xFF, 0xFD, 0xFD});

    const std::vector<std::uint8_t> bytes = encodePacket(kTwo, packet);

    // LEN 10: instruction, address, five bytes for four, CRC.
    QCOMPARE(hexText(std::span{bytes}.first(15)), std::string{"FF FF FD 00 01 0A 00 03 74 00 FF FF FD FD FD"});
    QVERIFY(PacketParser{kTwo}.push(bytes) == std::vector{packet});
}

void PacketTest::aRequestOfTwoIsNoAnswer()
{
    QVERIFY(!statusOf(kTwo, pingRequest(1)));
    QVERIFY(!statusOf(kTwo, {1, 0x55, {}}));
    QVERIFY(statusOf(kProtocolOne, pingRequest(1)));
}

void PacketTest::valuesAreLittleEndian()
{
    QVERIFY(littleEndian(0x12345678, 4) == hexBytes("78 56 34 12"));
    QVERIFY(littleEndian(512, 2) == hexBytes("00 02"));
    QCOMPARE(fromLittleEndian(hexBytes("78 56 34 12")), std::uint32_t(0x12345678));
    QCOMPARE(fromLittleEndian({}), std::uint32_t(0));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PacketTest)
#include "packet_test.moc"
