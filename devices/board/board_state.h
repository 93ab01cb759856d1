// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>

namespace planewright::board {

/// What a board is doing.
enum class State : std::uint8_t {
    Unarmed = 0,   ///< moves nothing until it is armed
    Armed = 1,     ///< holds, may move
    Moving = 2,    ///< on its way to a goal
    Sweeping = 3,  ///< takes the slices of a SWEEP
    Stopped = 4,   ///< was stopped and holds, until it is armed
    Estopped = 5,  ///< stopped in an emergency, until that is cleared
    Fault = 6,     ///< stopped by itself, until that is cleared
};
inline constexpr int kStates = 7;

/// Why a board stopped by itself. Below 0x10 it is Stopped then, and Fault from there on.
enum class Fault : std::uint8_t {
    None = 0x00,
    Watchdog = 0x01,  ///< no heartbeat in time
    NoSync = 0x02,    ///< no sync edge in time
    Stall = 0x10,
    ServoSilent = 0x11,
    Overload = 0x12,
    Overheat = 0x13,
    Voltage = 0x14,
    ServoRefused = 0x15,  ///< the servo took an instruction for wrong
    WheelMode = 0x16,     ///< the servo turns without end
    Jump = 0x17,          ///< the servo was away, or somewhere else at once
    Firmware = 0x18,
};

/// Why a board did not do what was asked.
enum class NakCode : std::uint8_t { UnknownType = 1, Length = 2, Range = 3, State = 4, Busy = 5, Estopped = 6 };

/// What a board can do: bits of HELLO's reply.
enum class Capability : std::uint32_t {
    SyncInput = 1U << 0,        ///< TRIGGER, SLICE, SWEEP
    ContinuousSweep = 1U << 1,  ///< SWEEP's mode 1
    Load = 1U << 2,             ///< measures the servo's load
    Voltage = 1U << 3,
    Temperature = 1U << 4,
    TorqueLimit = 1U << 5,  ///< an emergency stop lowers the torque
};

/// "ARMED".
std::string toText(State state);
/// "the motor did not get to its goal: something holds it".
std::string toText(Fault fault);
/// "board-overload": for the log.
std::string codeOf(Fault fault);
/// "a value is out of range".
std::string toText(NakCode code);
/// "RX-64", or "servo model 77" for one that has no name here.
std::string servoName(std::uint16_t model);

}  // namespace planewright::board
