// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "devices/dynamixel/byte_stuffing.h"
#include "devices/dynamixel/echo_filter.h"
#include "devices/dynamixel/packet_parser.h"
#include "devices/dynamixel/servo_checks.h"
#include "devices/dynamixel/servo_state.h"

// What must hold for any bytes: how they are cut changes no packet, no more than one packet is held, a packet that was
// found is written as it was read, and what its content is decoded to breaks nothing. The first byte says how to cut,
// and which model the servo is.

namespace {

using namespace planewright;

using Bytes = std::span<const std::uint8_t>;

void require(bool holds)
{
    if (!holds)
        std::abort();
}

void checkContent(DynamixelProtocol protocol, const DynamixelPacket& packet, const DynamixelModel& model)
{
    const std::optional<DynamixelStatus> status = statusOf(protocol, packet);
    if (!status)
        return;
    require(packetOf(protocol, *status) == packet);
    decodeStatusError(protocol, status->error);
    RegisterImage image;
    image.store(status->error, status->data);
    const ServoSettings settings = decodeSettings(model, image);
    require(settings.lowestGoal >= 0 && settings.highestGoal <= model.highestCount);
    decodeDrive(model, image);
    decodeState(model, image, false);
    reasonNotToMove(model, image);
}

void checkParser(DynamixelProtocol protocol, Bytes bytes, std::size_t cut, const DynamixelModel& model)
{
    PacketParser whole{protocol};
    const std::vector<DynamixelPacket> packets = whole.push(bytes);
    require(whole.held() <= PacketParser::kMostPacketBytes);

    PacketParser pieces{protocol};
    std::vector<DynamixelPacket> found;
    for (Bytes rest = bytes; !rest.empty();) {
        const Bytes piece = rest.first(std::min(cut, rest.size()));
        for (DynamixelPacket& packet : pieces.push(piece))
            found.push_back(std::move(packet));
        require(pieces.held() <= PacketParser::kMostPacketBytes);
        rest = rest.subspan(piece.size());
    }
    require(found == packets);
    require(pieces.damaged() == whole.damaged());

    for (const DynamixelPacket& packet : packets) {
        checkContent(protocol, packet, model);
        // Its parameters may be too many for a packet of ours: what was stuffed without need comes out shorter.
        if (protocol == DynamixelProtocol::One || packet.parameters.size() <= 380) {
            const std::vector<DynamixelPacket> again = PacketParser{protocol}.push(encodePacket(protocol, packet));
            require(again == std::vector{packet});
        }
    }
}

void checkStuffing(Bytes bytes)
{
    const std::vector<std::uint8_t> content{bytes.begin(), bytes.end()};
    require(unstuffed(stuffed(content)) == content);
}

/// Whatever comes behind it, an echo is taken out, and nothing else is.
void checkEcho(Bytes bytes, std::size_t cut)
{
    const std::size_t n = std::clamp<std::size_t>(cut, 1, bytes.size());
    EchoFilter filter{{bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n)}};
    std::vector<std::uint8_t> passed;
    for (const std::uint8_t& byte : bytes) {
        for (const std::uint8_t some : filter.push({&byte, 1}))
            passed.push_back(some);
    }
    require(filter.heardEcho());
    require(std::equal(passed.begin(), passed.end(), bytes.begin() + static_cast<std::ptrdiff_t>(n), bytes.end()));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size < 2)
        return 0;
    const std::size_t cut = 1 + data[0] % 32;
    const Bytes bytes{data + 1, size - 1};
    const DynamixelModel& model = dynamixelModels()[data[0] % dynamixelModels().size()];
    checkParser(DynamixelProtocol::One, bytes, cut, model);
    checkParser(DynamixelProtocol::Two, bytes, cut, model);
    checkStuffing(bytes);
    checkEcho(bytes, cut);
    return 0;
}
