// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace planewright::board {

/// Most bytes of a message's payload.
inline constexpr std::size_t kMaxPayload = 64;
/// Most bytes of a frame on the wire, its 0x00 not counted: header, payload, checksum, and the byte that COBS adds.
inline constexpr std::size_t kMaxFrame = 5 + kMaxPayload + 2 + 1;
/// The version of the protocol that this is.
inline constexpr std::uint8_t kVersion = 1;
/// Sequence numbers of events begin here; those of requests and replies end before.
inline constexpr std::uint16_t kFirstEvent = 0x8000;

/// What one frame of NTB/1 carries (resources/manual/board-protocol.md): any message, known or not.
struct Frame {
    std::uint16_t seq = 0;
    std::uint8_t type = 0;
    std::vector<std::uint8_t> payload;

    bool isEvent() const { return seq >= kFirstEvent; }
    bool operator==(const Frame&) const = default;
};

/// Why bytes are no frame.
enum class Damage {
    Cobs,     ///< not what COBS gives
    Length,   ///< more or fewer bytes than the frame says
    Crc,      ///< wrong checksum
    Version,  ///< undamaged, of a version that this is not
};

/// The bytes of a frame on the wire, with the 0x00 that ends it. The payload has at most kMaxPayload bytes.
std::vector<std::uint8_t> encodeFrame(const Frame& frame);

/// The frame that the bytes between two 0x00 make.
tl::expected<Frame, Damage> decodeFrame(std::span<const std::uint8_t> bytes);

/// CRC-16/CCITT-FALSE: polynomial 0x1021, begins with 0xFFFF, nothing reflected, nothing inverted.
std::uint16_t crc16(std::span<const std::uint8_t> bytes);

/// Bytes as people read them: "02 01 00".
std::string toHex(std::span<const std::uint8_t> bytes);

}  // namespace planewright::board
