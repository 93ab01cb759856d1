// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/requests.h"

#include <cassert>

namespace planewright {

namespace {

using Bytes = std::vector<std::uint8_t>;

DynamixelPacket request(std::uint8_t id, DynamixelInstruction instruction, Bytes parameters = {})
{
    return {id, static_cast<std::uint8_t>(instruction), std::move(parameters)};
}

void append(Bytes& bytes, std::span<const std::uint8_t> more)
{
    bytes.insert(bytes.end(), more.begin(), more.end());
}

/// An address or a count, in the width of the protocol.
Bytes number(DynamixelProtocol protocol, std::uint16_t value)
{
    assert(protocol == DynamixelProtocol::Two || value < 256);
    return littleEndian(value, protocol == DynamixelProtocol::One ? 1 : 2);
}

Bytes addressed(DynamixelProtocol protocol, std::uint16_t address, std::span<const std::uint8_t> data)
{
    Bytes bytes = number(protocol, address);
    append(bytes, data);
    return bytes;
}

}  // namespace

DynamixelPacket pingRequest(std::uint8_t id)
{
    return request(id, DynamixelInstruction::Ping);
}

DynamixelPacket readRequest(DynamixelProtocol protocol, std::uint8_t id, std::uint16_t address, std::uint16_t count)
{
    return request(id, DynamixelInstruction::Read, addressed(protocol, address, number(protocol, count)));
}

DynamixelPacket writeRequest(DynamixelProtocol protocol, std::uint8_t id, std::uint16_t address,
                             std::span<const std::uint8_t> data)
{
    return request(id, DynamixelInstruction::Write, addressed(protocol, address, data));
}

DynamixelPacket regWriteRequest(DynamixelProtocol protocol, std::uint8_t id, std::uint16_t address,
                                std::span<const std::uint8_t> data)
{
    return request(id, DynamixelInstruction::RegWrite, addressed(protocol, address, data));
}

DynamixelPacket actionRequest(std::uint8_t id)
{
    return request(id, DynamixelInstruction::Action);
}

DynamixelPacket rebootRequest(std::uint8_t id)
{
    return request(id, DynamixelInstruction::Reboot);
}

DynamixelPacket syncWriteRequest(DynamixelProtocol protocol, std::uint16_t address, std::uint16_t count,
                                 std::span<const SyncWriteData> servos)
{
    Bytes bytes = addressed(protocol, address, number(protocol, count));
    for (const SyncWriteData& servo : servos) {
        assert(servo.data.size() == count);
        bytes.push_back(servo.id);
        append(bytes, servo.data);
    }
    return request(kBroadcastId, DynamixelInstruction::SyncWrite, std::move(bytes));
}

DynamixelPacket syncReadRequest(std::uint16_t address, std::uint16_t count, std::span<const std::uint8_t> ids)
{
    Bytes bytes = addressed(DynamixelProtocol::Two, address, number(DynamixelProtocol::Two, count));
    append(bytes, ids);
    return request(kBroadcastId, DynamixelInstruction::SyncRead, std::move(bytes));
}

std::vector<std::uint8_t> littleEndian(std::uint32_t value, int size)
{
    Bytes bytes;
    for (int i = 0; i < size; ++i)
        bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i) & 0xFF));
    return bytes;
}

std::uint32_t fromLittleEndian(std::span<const std::uint8_t> bytes)
{
    assert(bytes.size() <= 4);
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        value |= std::uint32_t{bytes[i]} << (8 * i);
    return value;
}

}  // namespace planewright
