// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include <tl/expected.hpp>

#include "devices/board/board_events.h"
#include "devices/board/board_frame.h"
#include "devices/board/board_replies.h"
#include "devices/board/board_requests.h"

namespace planewright::board {

/// Any message of NTB/1.
using Message =
    std::variant<Hello, Heartbeat, GetStatus, SetConfig, GetConfig, Home, Move, Sweep, Trigger, Arm, ClearFault, Stop,
                 Estop, HelloReply, HeartbeatReply, StatusReply, SetConfigReply, GetConfigReply, HomeReply, MoveReply,
                 SweepReply, TriggerReply, ArmReply, ClearFaultReply, StopReply, EstopReply, Nak, SliceEvent,
                 PositionEvent, ArrivedEvent, FaultEvent, LimitEvent>;

/// The message as a frame.
Frame toFrame(std::uint16_t seq, const Message& message);

/// What a frame says; UnknownType or Length where it says nothing that is known here. Values may be anything.
tl::expected<Message, NakCode> toMessage(const Frame& frame);

/// Bytes of the payload of a type; empty for a type that is not known.
std::optional<std::size_t> payloadLength(std::uint8_t type);

/// One line for people: "MOVE seq=0002 goal=512 speed=100 flags=1 settle_ms=8". Numbers are decimal, but for the
/// sequence number and the serial, which are hexadecimal.
std::string toText(const Frame& frame);

/// The type of the reply to a request.
constexpr std::uint8_t replyType(std::uint8_t request)
{
    return request | 0x40;
}

/// How one field is written: "u16".
template <class T>
std::string fieldType()
{
    if constexpr (std::is_enum_v<T>)
        return fieldType<std::underlying_type_t<T>>();
    else if constexpr (std::is_integral_v<T>)
        return (std::is_signed_v<T> ? "i" : "u") + std::to_string(8 * sizeof(T));
    else
        return "u8[" + std::to_string(sizeof(T)) + "]";
}

}  // namespace planewright::board
