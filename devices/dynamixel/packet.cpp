// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/packet.h"

#include <array>
#include <cassert>

#include "devices/dynamixel/byte_stuffing.h"

namespace planewright {

namespace {

constexpr std::size_t kMostParametersOne = 248;
constexpr std::size_t kMostParametersTwo = 380;

constexpr std::array<std::uint16_t, 256> makeCrcTable()
{
    std::array<std::uint16_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t crc = byte << 8;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 0x8000) != 0 ? (crc << 1) ^ 0x8005 : crc << 1;
        table[byte] = static_cast<std::uint16_t>(crc);
    }
    return table;
}

constexpr std::array<std::uint16_t, 256> kCrcTable = makeCrcTable();

std::uint8_t lowByte(std::size_t value)
{
    return static_cast<std::uint8_t>(value & 0xFF);
}

std::vector<std::uint8_t> encodeOne(const DynamixelPacket& packet)
{
    const std::vector<std::uint8_t>& parameters = packet.parameters;
    assert(parameters.size() <= kMostParametersOne);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(parameters.size() + 6);
    for (const std::uint8_t byte :
         {std::uint8_t{0xFF}, std::uint8_t{0xFF}, packet.id, lowByte(parameters.size() + 2), packet.code})
        bytes.push_back(byte);
    bytes.insert(bytes.end(), parameters.begin(), parameters.end());
    bytes.push_back(checksum(std::span{bytes}.subspan(2)));
    return bytes;
}

std::vector<std::uint8_t> encodeTwo(const DynamixelPacket& packet)
{
    assert(packet.parameters.size() <= kMostParametersTwo);
    std::vector<std::uint8_t> plain;
    plain.reserve(packet.parameters.size() + 1);
    plain.push_back(packet.code);
    plain.insert(plain.end(), packet.parameters.begin(), packet.parameters.end());
    const std::vector<std::uint8_t> content = stuffed(plain);
    const std::size_t length = content.size() + 2;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(length + 7);
    for (const std::uint8_t byte : {std::uint8_t{0xFF}, std::uint8_t{0xFF}, std::uint8_t{0xFD}, std::uint8_t{0x00},
                                    packet.id, lowByte(length), lowByte(length >> 8)})
        bytes.push_back(byte);
    bytes.insert(bytes.end(), content.begin(), content.end());
    const std::uint16_t crc = crc16(bytes);
    bytes.push_back(lowByte(crc));
    bytes.push_back(lowByte(crc >> 8));
    return bytes;
}

}  // namespace

std::vector<std::uint8_t> encodePacket(DynamixelProtocol protocol, const DynamixelPacket& packet)
{
    return protocol == DynamixelProtocol::One ? encodeOne(packet) : encodeTwo(packet);
}

DynamixelPacket packetOf(DynamixelProtocol protocol, const DynamixelStatus& status)
{
    if (protocol == DynamixelProtocol::One)
        return {status.id, status.error, status.data};
    DynamixelPacket packet{status.id, static_cast<std::uint8_t>(DynamixelInstruction::Status), {}};
    packet.parameters.reserve(status.data.size() + 1);
    packet.parameters.push_back(status.error);
    packet.parameters.insert(packet.parameters.end(), status.data.begin(), status.data.end());
    return packet;
}

std::optional<DynamixelStatus> statusOf(DynamixelProtocol protocol, const DynamixelPacket& packet)
{
    if (protocol == DynamixelProtocol::One)
        return DynamixelStatus{packet.id, packet.code, packet.parameters};
    if (packet.code != static_cast<std::uint8_t>(DynamixelInstruction::Status) || packet.parameters.empty())
        return std::nullopt;
    return DynamixelStatus{
        packet.id, packet.parameters.front(), {packet.parameters.begin() + 1, packet.parameters.end()}};
}

std::uint8_t checksum(std::span<const std::uint8_t> fromId)
{
    std::uint32_t sum = 0;
    for (const std::uint8_t byte : fromId)
        sum += byte;
    return static_cast<std::uint8_t>(~sum & 0xFF);
}

std::uint16_t crc16(std::span<const std::uint8_t> bytes)
{
    std::uint32_t crc = 0;
    for (const std::uint8_t byte : bytes)
        crc = ((crc << 8) & 0xFFFF) ^ kCrcTable[((crc >> 8) ^ byte) & 0xFF];
    return static_cast<std::uint16_t>(crc);
}

std::string hexText(std::span<const std::uint8_t> bytes)
{
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string text;
    for (const std::uint8_t byte : bytes) {
        if (!text.empty())
            text += ' ';
        text += kDigits[byte >> 4];
        text += kDigits[byte & 0x0F];
    }
    return text;
}

}  // namespace planewright
