// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/packet_parser.h"

#include <algorithm>
#include <optional>

#include "devices/dynamixel/byte_stuffing.h"

namespace planewright {

namespace {

/// What the bytes from one place on are.
struct Finding {
    enum class Kind { Incomplete, NoPacket, Damaged, Packet };
    Kind kind = Kind::Incomplete;
    std::size_t size = 0;  ///< bytes of the packet
    DynamixelPacket packet;
};

/// True where the bytes that are there are those of the header.
template <std::size_t N>
bool beginsLike(std::span<const std::uint8_t> bytes, const std::uint8_t (&header)[N])
{
    const std::size_t n = std::min(bytes.size(), N);
    return std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n), header);
}

Finding findOne(std::span<const std::uint8_t> bytes)
{
    constexpr std::uint8_t kHeader[] = {0xFF, 0xFF};
    constexpr std::size_t kLeast = 2;
    constexpr std::size_t kMost = 250;
    if (!beginsLike(bytes, kHeader) || (bytes.size() > 2 && bytes[2] == 0xFF))
        return {Finding::Kind::NoPacket, 0, {}};
    if (bytes.size() < 4)
        return {};
    const std::size_t length = bytes[3];
    if (length < kLeast || length > kMost)
        return {Finding::Kind::NoPacket, 0, {}};
    const std::size_t size = length + 4;
    if (bytes.size() < size)
        return {};
    if (checksum(bytes.subspan(2, size - 3)) != bytes[size - 1])
        return {Finding::Kind::Damaged, 0, {}};
    const auto parameters = bytes.subspan(5, length - 2);
    return {Finding::Kind::Packet, size, {bytes[2], bytes[4], {parameters.begin(), parameters.end()}}};
}

Finding findTwo(std::span<const std::uint8_t> bytes)
{
    constexpr std::uint8_t kHeader[] = {0xFF, 0xFF, 0xFD, 0x00};
    constexpr std::size_t kLeast = 3;
    constexpr std::size_t kMost = PacketParser::kMostPacketBytes - 7;
    if (!beginsLike(bytes, kHeader) || (bytes.size() > 4 && (bytes[4] == 0xFF || bytes[4] == 0xFD)))
        return {Finding::Kind::NoPacket, 0, {}};
    if (bytes.size() < 7)
        return {};
    const std::size_t length = bytes[5] | static_cast<std::size_t>(bytes[6]) << 8;
    if (length < kLeast || length > kMost)
        return {Finding::Kind::NoPacket, 0, {}};
    const std::size_t size = length + 7;
    if (bytes.size() < size)
        return {};
    if (crc16(bytes.first(size - 2)) != (bytes[size - 2] | bytes[size - 1] << 8))
        return {Finding::Kind::Damaged, 0, {}};
    const std::vector<std::uint8_t> content = unstuffed(bytes.subspan(7, length - 2));
    return {Finding::Kind::Packet, size, {bytes[4], content.front(), {content.begin() + 1, content.end()}}};
}

}  // namespace

std::vector<DynamixelPacket> PacketParser::push(std::span<const std::uint8_t> bytes)
{
    std::vector<DynamixelPacket> packets;
    // In pieces, so that what is held stays short however much comes at once.
    while (!bytes.empty()) {
        const std::size_t n = std::min(bytes.size(), kMostPacketBytes - buffer_.size());
        buffer_.insert(buffer_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n));
        bytes = bytes.subspan(n);
        takePackets(packets);
    }
    return packets;
}

void PacketParser::reset()
{
    buffer_.clear();
}

void PacketParser::takePackets(std::vector<DynamixelPacket>& packets)
{
    std::span<const std::uint8_t> rest{buffer_};
    while (!rest.empty()) {
        Finding found = protocol_ == DynamixelProtocol::One ? findOne(rest) : findTwo(rest);
        if (found.kind == Finding::Kind::Incomplete)
            break;
        if (found.kind == Finding::Kind::Packet)
            packets.push_back(std::move(found.packet));
        if (found.kind == Finding::Kind::Damaged)
            ++damaged_;
        rest = rest.subspan(std::max<std::size_t>(found.size, 1));
    }
    buffer_.erase(buffer_.begin(), buffer_.end() - static_cast<std::ptrdiff_t>(rest.size()));
}

}  // namespace planewright
