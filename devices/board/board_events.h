// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string_view>

#include "devices/board/board_state.h"

namespace planewright::board {

/// Events of NTB/1: what a board says without being asked. Fields as in board_requests.h; `atUs` is the board's clock.

/// A scan of the laser is over.
struct SliceEvent {
    static constexpr std::uint8_t kType = 0x90;
    static constexpr std::string_view kName = "SLICE";

    std::uint32_t slice = 0;  ///< its number
    std::uint64_t atUs = 0;   ///< the sync edge at which it began
    std::uint16_t pos = 0;    ///< then
    std::int16_t moved = 0;   ///< until its end
    State state = State::Unarmed;
    std::uint8_t err = 0;  ///< bit 0: `pos` is a guess; 1: `moved` is; 2: the edge came out of turn

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("slice", self.slice);
        visit("at_us", self.atUs);
        visit("pos", self.pos);
        visit("moved", self.moved);
        visit("state", self.state);
        visit("err", self.err);
    }
    bool operator==(const SliceEvent&) const = default;
};

struct PositionEvent {
    static constexpr std::uint8_t kType = 0x91;
    static constexpr std::string_view kName = "POSITION";

    std::uint64_t atUs = 0;
    std::uint16_t pos = 0;
    std::int16_t load = 0;  ///< as in StatusReply

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("at_us", self.atUs);
        visit("pos", self.pos);
        visit("load", self.load);
    }
    bool operator==(const PositionEvent&) const = default;
};

/// A motion has ended where it should.
struct ArrivedEvent {
    static constexpr std::uint8_t kType = 0x92;
    static constexpr std::string_view kName = "ARRIVED";

    std::uint64_t atUs = 0;
    std::uint16_t pos = 0;
    std::uint16_t goal = 0;
    std::uint16_t request = 0;  ///< sequence number of what asked for it

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("at_us", self.atUs);
        visit("pos", self.pos);
        visit("goal", self.goal);
        visit("request", self.request);
    }
    bool operator==(const ArrivedEvent&) const = default;
};

/// It stopped by itself.
struct FaultEvent {
    static constexpr std::uint8_t kType = 0x93;
    static constexpr std::string_view kName = "FAULT";

    std::uint64_t atUs = 0;
    Fault code = Fault::None;
    State state = State::Fault;  ///< that this has led to
    std::uint16_t pos = 0;
    std::uint16_t detail = 0;  ///< by the code

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("at_us", self.atUs);
        visit("code", self.code);
        visit("state", self.state);
        visit("pos", self.pos);
        visit("detail", self.detail);
    }
    bool operator==(const FaultEvent&) const = default;
};

/// It passed a limit, and stopped.
struct LimitEvent {
    static constexpr std::uint8_t kType = 0x94;
    static constexpr std::string_view kName = "LIMIT";

    std::uint64_t atUs = 0;
    std::uint16_t pos = 0;
    std::uint16_t limit = 0;
    std::uint8_t side = 0;  ///< 0: the low one; 1: the high one

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("at_us", self.atUs);
        visit("pos", self.pos);
        visit("limit", self.limit);
        visit("side", self.side);
    }
    bool operator==(const LimitEvent&) const = default;
};

}  // namespace planewright::board
