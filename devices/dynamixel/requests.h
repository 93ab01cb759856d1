// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "devices/dynamixel/packet.h"

namespace planewright {

/// Requests to servos, as packets for encodePacket(). Addresses and counts have one byte in protocol 1.0 and two
/// in 2.0; values are little-endian.

/// Is there a servo of this number? Always answered.
DynamixelPacket pingRequest(std::uint8_t id);

/// `count` bytes of the control table from an address on.
DynamixelPacket readRequest(DynamixelProtocol protocol, std::uint8_t id, std::uint16_t address, std::uint16_t count);

/// New bytes of the control table from an address on, at once.
DynamixelPacket writeRequest(DynamixelProtocol protocol, std::uint8_t id, std::uint16_t address,
                             std::span<const std::uint8_t> data);

/// The same, kept by the servo until an action request.
DynamixelPacket regWriteRequest(DynamixelProtocol protocol, std::uint8_t id, std::uint16_t address,
                                std::span<const std::uint8_t> data);
DynamixelPacket actionRequest(std::uint8_t id);

/// Restarts a servo of protocol 2.0, the only way out of its shutdown.
DynamixelPacket rebootRequest(std::uint8_t id);

/// New bytes for one servo of several.
struct SyncWriteData {
    std::uint8_t id = 0;
    std::vector<std::uint8_t> data;  ///< as many as for every other
};

/// New bytes at the same addresses for several servos. Nobody answers.
DynamixelPacket syncWriteRequest(DynamixelProtocol protocol, std::uint16_t address, std::uint16_t count,
                                 std::span<const SyncWriteData> servos);

/// The same bytes of several servos of protocol 2.0, which answer one after the other.
DynamixelPacket syncReadRequest(std::uint16_t address, std::uint16_t count, std::span<const std::uint8_t> ids);

/// The low `size` bytes of a value, lowest first.
std::vector<std::uint8_t> littleEndian(std::uint32_t value, int size);

/// The value of bytes, lowest first; at most four.
std::uint32_t fromLittleEndian(std::span<const std::uint8_t> bytes);

}  // namespace planewright
