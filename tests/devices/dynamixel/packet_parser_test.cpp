// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/packet_parser.h"

#include <random>

#include <QtTest>

#include "devices/dynamixel/byte_stuffing.h"
#include "devices/dynamixel/echo_filter.h"
#include "devices/dynamixel/requests.h"
#include "tests/devices/dynamixel/hex_bytes.h"
#include "tests/test_program.h"

namespace planewright {

class PacketParserTest : public QObject {
    Q_OBJECT

private slots:
    void bytesMayComeOneByOne();
    void aDamagedPacketTakesNoSoundOneWithIt();
    void aFlippedBitIsNeverAnotherAnswer();
    void headersInARowAreSlidOver();
    void lengthsThatCannotBeAreSlidOver();
    void aLengthThatIsALieEndsWhereTheNextPacketBegins();
    void neverMoreThanAPacketIsHeld();
    void stuffingGoesThereAndBack();
    void anEchoIsTakenOut();
    void whatIsNoEchoIsPassedOn();
};

namespace {

constexpr DynamixelProtocol kBoth[] = {DynamixelProtocol::One, DynamixelProtocol::Two};

std::vector<std::uint8_t> operator+(std::vector<std::uint8_t> left, const std::vector<std::uint8_t>& right)
{
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

DynamixelPacket state(std::uint8_t id)
{
    return {id, 0x55, {0, 0, 2, 0, 0, 64, 0, 148, 38, 0, 0, 0}};
}

}  // namespace

void PacketParserTest::bytesMayComeOneByOne()
{
    for (const DynamixelProtocol protocol : kBoth) {
        const std::vector<std::uint8_t> bytes = encodePacket(protocol, state(1)) + encodePacket(protocol, state(2));
        PacketParser parser{protocol};
        std::vector<DynamixelPacket> packets;

        for (const std::uint8_t byte : bytes) {
            for (const DynamixelPacket& packet : parser.push({&byte, 1}))
                packets.push_back(packet);
        }

        QVERIFY(packets == (std::vector{state(1), state(2)}));
        QCOMPARE(parser.held(), std::size_t(0));
    }
}

void PacketParserTest::aDamagedPacketTakesNoSoundOneWithIt()
{
    for (const DynamixelProtocol protocol : kBoth) {
        std::vector<std::uint8_t> damaged = encodePacket(protocol, state(1));
        damaged.pop_back();  // a byte got lost, so that the next packet's first one stands in its place
        PacketParser parser{protocol};

        const auto packets = parser.push(damaged + encodePacket(protocol, state(2)));

        QVERIFY(packets == std::vector{state(2)});
        QCOMPARE(parser.damaged(), std::size_t(1));
    }
}

void PacketParserTest::aFlippedBitIsNeverAnotherAnswer()
{
    for (const DynamixelProtocol protocol : kBoth) {
        const std::vector<std::uint8_t> sound = encodePacket(protocol, state(1));
        for (std::size_t bit = 0; bit < 8 * sound.size(); ++bit) {
            std::vector<std::uint8_t> damaged = sound;
            damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << bit % 8));

            QVERIFY(PacketParser{protocol}.push(damaged).empty());
        }
    }
}

void PacketParserTest::headersInARowAreSlidOver()
{
    PacketParser parser{DynamixelProtocol::One};

    const auto packets = parser.push(hexBytes("FF FF FF FF FF 01 02 00 FC"));

    QVERIFY(packets == (std::vector{DynamixelPacket{1, 0, {}}}));
}

void PacketParserTest::lengthsThatCannotBeAreSlidOver()
{
    for (const char* length : {"00", "01", "FB", "FF"}) {
        PacketParser parser{DynamixelProtocol::One};
        const auto packets = parser.push(hexBytes(std::string{"FF FF 01 "} + length) + hexBytes("FF FF 01 02 00 FC"));
        QCOMPARE(packets.size(), std::size_t(1));
    }
    for (const char* length : {"00 00", "02 00", "02 02", "FF FF"}) {
        PacketParser parser{DynamixelProtocol::Two};
        const auto packets =
            parser.push(hexBytes(std::string{"FF FF FD 00 01 "} + length) + hexBytes("FF FF FD 00 01 03 00 01 19 4E"));
        QCOMPARE(packets.size(), std::size_t(1));
    }
}

void PacketParserTest::aLengthThatIsALieEndsWhereTheNextPacketBegins()
{
    PacketParser parser{DynamixelProtocol::One};

    // LEN says 8 and two bytes come; then sound answers.
    std::vector<DynamixelPacket> packets = parser.push(hexBytes("FF FF 01 08 00 AA"));
    QVERIFY(packets.empty());
    for (int i = 0; i < 2; ++i) {
        for (const DynamixelPacket& packet : parser.push(hexBytes("FF FF 01 02 00 FC")))
            packets.push_back(packet);
    }

    QCOMPARE(packets.size(), std::size_t(2));
}

void PacketParserTest::neverMoreThanAPacketIsHeld()
{
    std::mt19937 random{7};  // NOLINT: the same bytes every time
    for (const DynamixelProtocol protocol : kBoth) {
        PacketParser parser{protocol};
        for (int i = 0; i < 2000; ++i) {
            std::vector<std::uint8_t> bytes;
            for (auto n = random() % 300; n > 0; --n)
                bytes.push_back(
                    static_cast<std::uint8_t>(random() % 3 == 0 ? random() : 0xFFFDU >> (8 * (random() % 2))));
            parser.push(bytes);
            QVERIFY(parser.held() <= PacketParser::kMostPacketBytes);
        }
        parser.reset();
        QCOMPARE(parser.push(encodePacket(protocol, state(1))).size(), std::size_t(1));
    }
}

void PacketParserTest::stuffingGoesThereAndBack()
{
    std::mt19937 random{11};  // NOLINT: the same bytes every time
    constexpr std::uint8_t kLikely[] = {0xFF, 0xFF, 0xFD, 0x00};
    for (int i = 0; i < 3000; ++i) {
        std::vector<std::uint8_t> content;
        for (auto n = random() % 12; n > 0; --n)
            content.push_back(kLikely[random() % 4]);

        const std::vector<std::uint8_t> bytes = stuffed(content);

        QVERIFY(unstuffed(bytes) == content);
        const std::vector<std::uint8_t> header{0xFF, 0xFF, 0xFD, 0x00};
        QVERIFY(std::search(bytes.begin(), bytes.end(), header.begin(), header.end()) == bytes.end());
    }
}

void PacketParserTest::anEchoIsTakenOut()
{
    const std::vector<std::uint8_t> sent = encodePacket(DynamixelProtocol::One, pingRequest(1));
    const std::vector<std::uint8_t> answer = hexBytes("FF FF 01 02 00 FC");
    for (std::size_t cut = 0; cut <= sent.size(); ++cut) {
        const std::vector<std::uint8_t> all = sent + answer;
        EchoFilter filter{sent};

        const auto first = filter.push(std::span{all}.first(cut));
        const auto second = filter.push(std::span{all}.subspan(cut));

        QVERIFY(first + second == answer);
        QVERIFY(filter.heardEcho());
    }
}

void PacketParserTest::whatIsNoEchoIsPassedOn()
{
    const std::vector<std::uint8_t> sent = encodePacket(DynamixelProtocol::One, pingRequest(1));
    const std::vector<std::uint8_t> answer = hexBytes("FF FF 01 02 00 FC");
    EchoFilter filter{sent};

    std::vector<std::uint8_t> passed;
    for (const std::uint8_t byte : answer + sent)
        passed = passed + filter.push({&byte, 1});

    QVERIFY(passed == answer + sent);
    QVERIFY(!filter.heardEcho());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PacketParserTest)
#include "packet_parser_test.moc"
