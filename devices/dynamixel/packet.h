// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace planewright {

/// The two languages of Dynamixel servos. They share a bus and do not understand each other.
enum class DynamixelProtocol { One, Two };

/// What a request asks for. 0x55 marks an answer in protocol 2.0.
enum class DynamixelInstruction : std::uint8_t {
    Ping = 0x01,
    Read = 0x02,
    Write = 0x03,
    RegWrite = 0x04,
    Action = 0x05,
    Reboot = 0x08,  ///< 2.0 only
    Status = 0x55,
    SyncRead = 0x82,  ///< 2.0 only
    SyncWrite = 0x83,
};

/// Number that speaks to all servos of a bus; none of them answers (but a ping in 2.0).
inline constexpr std::uint8_t kBroadcastId = 0xFE;

/// What stands between the header and the check of a packet, in either direction.
struct DynamixelPacket {
    std::uint8_t id = 0;
    std::uint8_t code = 0;  ///< instruction; of an answer in 1.0 its error byte, in 2.0 0x55
    std::vector<std::uint8_t> parameters;

    bool operator==(const DynamixelPacket&) const = default;
};

/// What a servo answers.
struct DynamixelStatus {
    std::uint8_t id = 0;
    std::uint8_t error = 0;  ///< as decodeStatusError() reads it
    std::vector<std::uint8_t> data;

    bool operator==(const DynamixelStatus&) const = default;
};

/// Bytes of a packet: header, length, byte stuffing in 2.0, and check.
///
/// 1.0: FF FF ID LEN CODE parameters CHK; 2.0: FF FF FD 00 ID LENL LENH CODE parameters CRCL CRCH. At most 248
/// parameters in 1.0 and 380 in 2.0.
std::vector<std::uint8_t> encodePacket(DynamixelProtocol protocol, const DynamixelPacket& packet);

/// An answer as a packet, and back; empty where a packet of 2.0 is no answer. In 1.0 a request cannot be told from an
/// answer.
DynamixelPacket packetOf(DynamixelProtocol protocol, const DynamixelStatus& status);
std::optional<DynamixelStatus> statusOf(DynamixelProtocol protocol, const DynamixelPacket& packet);

/// CHK of 1.0: the complement of the low byte of the sum, from the ID on.
std::uint8_t checksum(std::span<const std::uint8_t> fromId);

/// CRC-16 of 2.0 over a packet from its first FF: polynomial 8005, initially 0, not reflected ("123456789" gives FEE8).
std::uint16_t crc16(std::span<const std::uint8_t> bytes);

/// "FF FF 01 02 01 FB".
std::string hexText(std::span<const std::uint8_t> bytes);

}  // namespace planewright
