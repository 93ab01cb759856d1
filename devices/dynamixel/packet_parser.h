// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "devices/dynamixel/packet.h"

namespace planewright {

/// Finds packets in whatever comes from a bus, piece by piece; how the bytes are cut makes no difference.
///
/// A packet counts only when its length is possible and its check is right; where one is not, the search goes on one
/// byte later, so that a damaged packet never takes a sound one with it. Holds at most kMostPacketBytes.
class PacketParser {
public:
    explicit PacketParser(DynamixelProtocol protocol) : protocol_(protocol) {}

    /// Longest packet of either protocol; a length that says more is a lie.
    static constexpr std::size_t kMostPacketBytes = 520;

    /// Packets that are complete with these bytes, in order.
    std::vector<DynamixelPacket> push(std::span<const std::uint8_t> bytes);

    /// Forgets a packet that has begun.
    void reset();

    /// What began like a packet and had a wrong check, since the parser was made.
    std::size_t damaged() const { return damaged_; }
    /// Bytes held for a packet that has begun.
    std::size_t held() const { return buffer_.size(); }

private:
    void takePackets(std::vector<DynamixelPacket>& packets);

    DynamixelProtocol protocol_;
    std::vector<std::uint8_t> buffer_;
    std::size_t damaged_ = 0;
};

}  // namespace planewright
