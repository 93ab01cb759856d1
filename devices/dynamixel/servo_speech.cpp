// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/servo_speech.h"

#include "devices/dynamixel/packet_parser.h"

namespace planewright {

DialogueSpeech::Meaning ServoSpeech::meaningOf(std::span<const std::uint8_t> message) const
{
    Meaning meaning{std::string{message.begin(), message.end()}, false};
    for (const DynamixelProtocol protocol : {DynamixelProtocol::One, DynamixelProtocol::Two}) {
        const auto packets = PacketParser{protocol}.push(message);
        if (packets.size() != 1)
            continue;
        const auto instruction = static_cast<DynamixelInstruction>(packets.front().code);
        meaning.isQuestion = instruction == DynamixelInstruction::Ping || instruction == DynamixelInstruction::Read;
    }
    return meaning;
}

}  // namespace planewright
