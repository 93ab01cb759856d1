// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "devices/board/board_requests.h"
#include "devices/board/board_state.h"

namespace planewright::board {

/// Replies of NTB/1: each has the type of its request with bit 6 set. Fields as in board_requests.h.

/// Who a board is.
struct HelloReply {
    static constexpr std::uint8_t kType = 0x41;
    static constexpr std::string_view kName = "HELLO reply";

    std::uint8_t proto = 0;      ///< version of the protocol
    std::uint16_t firmware = 0;  ///< high byte and low byte: "1.0"
    std::array<std::uint8_t, 8> serial{};
    std::uint32_t capabilities = 0;  ///< bits of Capability
    std::uint16_t servoModel = 0;
    std::uint32_t tickHz = 0;    ///< how finely its clock counts
    std::uint16_t highest = 0;   ///< position from 0 to this
    std::uint16_t middle = 0;    ///< the position that mounting speaks of
    std::uint32_t spanMdeg = 0;  ///< angle from 0 to `highest` [m°]
    std::uint8_t reset = 0;      ///< why it started: 0 power, 1 button, 2 voltage, 3 watchdog

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("proto", self.proto);
        visit("firmware", self.firmware);
        visit("serial", self.serial);
        visit("capabilities", self.capabilities);
        visit("servo_model", self.servoModel);
        visit("tick_hz", self.tickHz);
        visit("highest", self.highest);
        visit("middle", self.middle);
        visit("span_mdeg", self.spanMdeg);
        visit("reset", self.reset);
    }
    bool operator==(const HelloReply&) const = default;
};

/// What time the board has: with when the host sent and received, four stamps.
struct HeartbeatReply {
    static constexpr std::uint8_t kType = 0x42;
    static constexpr std::string_view kName = "HEARTBEAT reply";

    std::uint64_t hostUs = 0;      ///< as in the request
    std::uint64_t receivedUs = 0;  ///< when the request had come, board clock
    std::uint64_t sentUs = 0;      ///< when this left
    State state = State::Unarmed;
    Fault fault = Fault::None;  ///< the last

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("host_us", self.hostUs);
        visit("received_us", self.receivedUs);
        visit("sent_us", self.sentUs);
        visit("state", self.state);
        visit("fault", self.fault);
    }
    bool operator==(const HeartbeatReply&) const = default;
};

struct StatusReply {
    static constexpr std::uint8_t kType = 0x43;
    static constexpr std::string_view kName = "GET_STATUS reply";

    State state = State::Unarmed;
    Fault fault = Fault::None;  ///< the last
    std::uint16_t pos = 0;
    std::uint16_t goal = 0;
    std::int16_t load = 0;        ///< in thousandths of all; positive towards higher counts
    std::uint16_t voltMv = 0;     ///< 0: not known
    std::int8_t tempC = -128;     ///< −128: not known
    std::uint8_t servoError = 0;  ///< bits as the servo gave them
    std::uint32_t uptimeMs = 0;
    std::uint32_t lostBytes = 0;  ///< that it threw away
    std::uint32_t crcErrors = 0;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("state", self.state);
        visit("fault", self.fault);
        visit("pos", self.pos);
        visit("goal", self.goal);
        visit("load", self.load);
        visit("volt_mv", self.voltMv);
        visit("temp_c", self.tempC);
        visit("servo_error", self.servoError);
        visit("uptime_ms", self.uptimeMs);
        visit("lost_bytes", self.lostBytes);
        visit("crc_errors", self.crcErrors);
    }
    bool operator==(const StatusReply&) const = default;
};

/// What holds from now on.
struct SetConfigReply : Config {
    static constexpr std::uint8_t kType = 0x44;
    static constexpr std::string_view kName = "SET_CONFIG reply";
    bool operator==(const SetConfigReply&) const = default;
};

struct GetConfigReply : Config {
    static constexpr std::uint8_t kType = 0x45;
    static constexpr std::string_view kName = "GET_CONFIG reply";
    bool operator==(const GetConfigReply&) const = default;
};

/// It has begun.
struct Accepted {
    std::uint16_t pos = 0;         ///< where it is
    std::uint16_t expectedMs = 0;  ///< how long it will take without settling; 65535: longer

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("pos", self.pos);
        visit("expected_ms", self.expectedMs);
    }
    bool operator==(const Accepted&) const = default;
};

struct HomeReply : Accepted {
    static constexpr std::uint8_t kType = 0x50;
    static constexpr std::string_view kName = "HOME reply";
    bool operator==(const HomeReply&) const = default;
};

struct MoveReply : Accepted {
    static constexpr std::uint8_t kType = 0x60;
    static constexpr std::string_view kName = "MOVE reply";
    bool operator==(const MoveReply&) const = default;
};

struct SweepReply : Accepted {
    static constexpr std::uint8_t kType = 0x61;
    static constexpr std::string_view kName = "SWEEP reply";
    bool operator==(const SweepReply&) const = default;
};

struct TriggerReply {
    static constexpr std::uint8_t kType = 0x62;
    static constexpr std::string_view kName = "TRIGGER reply";

    template <class Self, class Visitor>
    static void fields(Self&, Visitor&&)
    {
    }
    bool operator==(const TriggerReply&) const = default;
};

/// The state that the request has led to.
struct NowIn {
    State state = State::Unarmed;
    std::uint16_t pos = 0;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("state", self.state);
        visit("pos", self.pos);
    }
    bool operator==(const NowIn&) const = default;
};

struct ArmReply : NowIn {
    static constexpr std::uint8_t kType = 0x6C;
    static constexpr std::string_view kName = "ARM reply";
    bool operator==(const ArmReply&) const = default;
};

struct ClearFaultReply : NowIn {
    static constexpr std::uint8_t kType = 0x6D;
    static constexpr std::string_view kName = "CLEAR_FAULT reply";
    bool operator==(const ClearFaultReply&) const = default;
};

struct StopReply : NowIn {
    static constexpr std::uint8_t kType = 0x6E;
    static constexpr std::string_view kName = "STOP reply";
    bool operator==(const StopReply&) const = default;
};

struct EstopReply : NowIn {
    static constexpr std::uint8_t kType = 0x6F;
    static constexpr std::string_view kName = "ESTOP reply";
    bool operator==(const EstopReply&) const = default;
};

/// Nothing was done.
struct Nak {
    static constexpr std::uint8_t kType = 0x7F;
    static constexpr std::string_view kName = "NAK";

    NakCode code = NakCode::UnknownType;
    std::uint8_t request = 0;  ///< type of the request
    std::uint8_t detail = 0;   ///< Length: the right one; Range: offset of the field; otherwise the state

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("code", self.code);
        visit("request", self.request);
        visit("detail", self.detail);
    }
    bool operator==(const Nak&) const = default;
};

}  // namespace planewright::board
