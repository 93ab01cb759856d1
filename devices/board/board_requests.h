// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string_view>

namespace planewright::board {

/// Requests of NTB/1, in the order of their types. Each names its fields once, in the order of the wire, little endian
/// and without gaps: `fields` shows them to a visitor, which reads, writes or prints them. Positions are servo counts,
/// speeds counts a second.

/// Begins a session: the board tells who it is, stops, and counts events anew.
struct Hello {
    static constexpr std::uint8_t kType = 0x01;
    static constexpr std::string_view kName = "HELLO";

    template <class Self, class Visitor>
    static void fields(Self&, Visitor&&)
    {
    }
    bool operator==(const Hello&) const = default;
};

/// The host is alive, and what time it has.
struct Heartbeat {
    static constexpr std::uint8_t kType = 0x02;
    static constexpr std::string_view kName = "HEARTBEAT";

    std::uint64_t hostUs = 0;  ///< the host's clock [µs]

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("host_us", self.hostUs);
    }
    bool operator==(const Heartbeat&) const = default;
};

/// Asks for everything that can be shown.
struct GetStatus {
    static constexpr std::uint8_t kType = 0x03;
    static constexpr std::string_view kName = "GET_STATUS";

    template <class Self, class Visitor>
    static void fields(Self&, Visitor&&)
    {
    }
    bool operator==(const GetStatus&) const = default;
};

/// What a board holds to.
struct Config {
    std::uint16_t low = 0;  ///< limits that nothing may pass
    std::uint16_t high = 0;
    std::uint16_t topSpeed = 0;
    std::uint16_t park = 0;           ///< where HOME goes
    std::uint16_t parkSpeed = 0;      ///< how fast
    std::uint8_t tolerance = 2;       ///< how near is arrived
    std::uint8_t limp = 0;            ///< 1: torque goes off when it is disarmed
    std::uint16_t settleMs = 20;      ///< how long it stays near before it has settled
    std::uint16_t heartbeatMs = 150;  ///< without a heartbeat for this long it stops
    std::uint16_t stallMs = 300;      ///< without progress for this long it gives up
    std::uint16_t estopTorque = 300;  ///< after an emergency stop, in thousandths of all
    std::uint16_t scanUs = 18750;     ///< how long a scan takes from its sync edge
    std::uint8_t positionHz = 0;      ///< POSITION events a second, 0 to 200

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("low", self.low);
        visit("high", self.high);
        visit("top_speed", self.topSpeed);
        visit("park", self.park);
        visit("park_speed", self.parkSpeed);
        visit("tolerance", self.tolerance);
        visit("limp", self.limp);
        visit("settle_ms", self.settleMs);
        visit("heartbeat_ms", self.heartbeatMs);
        visit("stall_ms", self.stallMs);
        visit("estop_torque", self.estopTorque);
        visit("scan_us", self.scanUs);
        visit("position_hz", self.positionHz);
    }
    bool operator==(const Config&) const = default;
};

struct SetConfig : Config {
    static constexpr std::uint8_t kType = 0x04;
    static constexpr std::string_view kName = "SET_CONFIG";
    bool operator==(const SetConfig&) const = default;
};

struct GetConfig {
    static constexpr std::uint8_t kType = 0x05;
    static constexpr std::string_view kName = "GET_CONFIG";

    template <class Self, class Visitor>
    static void fields(Self&, Visitor&&)
    {
    }
    bool operator==(const GetConfig&) const = default;
};

/// Goes to where it is parked.
struct Home {
    static constexpr std::uint8_t kType = 0x10;
    static constexpr std::string_view kName = "HOME";

    template <class Self, class Visitor>
    static void fields(Self&, Visitor&&)
    {
    }
    bool operator==(const Home&) const = default;
};

/// Goes to a position.
struct Move {
    static constexpr std::uint8_t kType = 0x20;
    static constexpr std::string_view kName = "MOVE";

    std::uint16_t goal = 0;
    std::uint16_t speed = 0;
    std::uint8_t flags = 0;     ///< bit 0: ARRIVED comes when it has settled
    std::uint8_t settleMs = 0;  ///< 0: as configured

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("goal", self.goal);
        visit("speed", self.speed);
        visit("flags", self.flags);
        visit("settle_ms", self.settleMs);
    }
    bool operator==(const Move&) const = default;
};

/// Takes slices at equal steps, by itself.
struct Sweep {
    static constexpr std::uint8_t kType = 0x21;
    static constexpr std::string_view kName = "SWEEP";

    std::uint16_t first = 0;
    std::uint16_t last = 0;
    std::uint16_t step = 0;
    std::uint16_t slices = 0;      ///< how many
    std::uint8_t mode = 0;         ///< 0: stops for each; 1: goes on, one step a turn of the laser
    std::uint8_t settleMs = 0;     ///< 0: as configured
    std::uint16_t speed = 0;       ///< between stops, and to the first
    std::uint32_t firstSlice = 0;  ///< number of the first SLICE

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("first", self.first);
        visit("last", self.last);
        visit("step", self.step);
        visit("slices", self.slices);
        visit("mode", self.mode);
        visit("settle_ms", self.settleMs);
        visit("speed", self.speed);
        visit("first_slice", self.firstSlice);
    }
    bool operator==(const Sweep&) const = default;
};

/// Takes the angle at the next sync edge.
struct Trigger {
    static constexpr std::uint8_t kType = 0x22;
    static constexpr std::string_view kName = "TRIGGER";

    std::uint32_t slice = 0;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("slice", self.slice);
    }
    bool operator==(const Trigger&) const = default;
};

/// Allows motion, or ends that.
struct Arm {
    static constexpr std::uint8_t kType = 0x2C;
    static constexpr std::string_view kName = "ARM";

    std::uint8_t arm = 0;  ///< 1 or 0

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit)
    {
        visit("arm", self.arm);
    }
    bool operator==(const Arm&) const = default;
};

/// Ends ESTOPPED and FAULT where their cause is gone.
struct ClearFault {
    static constexpr std::uint8_t kType = 0x2D;
    static constexpr std::string_view kName = "CLEAR_FAULT";

    template <class Self, class Visitor>
    static void fields(Self&, Visitor&&)
    {
    }
    bool operator==(const ClearFault&) const = default;
};

/// Comes to rest and holds.
struct Stop {
    static constexpr std::uint8_t kType = 0x2E;
    static constexpr std::string_view kName = "STOP";

    template <class Self, class Visitor>
    static void fields(Self&, Visitor&&)
    {
    }
    bool operator==(const Stop&) const = default;
};

/// Comes to rest at once with little torque; a second one takes the torque away.
struct Estop {
    static constexpr std::uint8_t kType = 0x2F;
    static constexpr std::string_view kName = "ESTOP";

    template <class Self, class Visitor>
    static void fields(Self&, Visitor&&)
    {
    }
    bool operator==(const Estop&) const = default;
};

}  // namespace planewright::board
