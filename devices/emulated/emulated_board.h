// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "devices/board/frame_parser.h"
#include "devices/emulated/emulated_board_firmware.h"
#include "devices/emulated/emulated_board_line.h"
#include "devices/emulated/emulated_device.h"

namespace planewright {

/// What an emulated control board is set up with.
struct EmulatedBoardSetup {
    TiltMounting mounting;    ///< zero, sign and scale; its limits come from the host
    double startPitch = 0.0;  ///< φ of the shaft at first [rad]
    MotorDynamics dynamics;
    std::array<std::uint8_t, 8> serial{'E', 'M', 'U', 'L', 'A', 'T', 'E', 'D'};
    double clockDrift = 50e-6;                           ///< how much too fast its clock runs
    EmulatedBoardFirmware::NextEdge nextEdge;            ///< sync edges of the laser; empty: no wire
    std::chrono::nanoseconds bootAt{0};                  ///< when its clock begins
    std::vector<FaultAt> faults;                         ///< kinds are those of boardFaultKinds()
    std::function<int(std::chrono::nanoseconds)> turns;  ///< of the laser since it first streamed; empty: none ever
    std::uint64_t seed = 1;
};

/// Sync edges at a moment and a whole number of periods before and after it.
EmulatedBoardFirmware::NextEdge edgesEvery(std::chrono::nanoseconds period, std::chrono::nanoseconds phase);

/// A control board with an RX-64 on it that speaks NTB/1 (resources/manual/board-protocol.md), byte for byte.
class EmulatedBoard : public EmulatedDevice {
public:
    using Time = std::chrono::nanoseconds;

    /// Errors (Usage): a fault that there is not.
    static Result<std::shared_ptr<EmulatedBoard>> make(const EmulatedBoardSetup& setup);

    void receive(std::span<const std::uint8_t> bytes, Time now) override;
    std::vector<EmulatedOutput> takeOutput(Time now) override;
    std::optional<Time> nextOutput() const override;
    bool isConnected(Time now) override;

    /// True φ of the laser, not rounded to counts [rad]. Moments in the past, of the last seconds, are fine.
    double pitchAt(Time at);

    board::State state() const { return firmware_.state(); }
    /// In thousandths of all; 0: limp.
    int torque() const { return firmware_.servo().torque(); }

private:
    EmulatedBoard(const EmulatedBoardSetup& setup, std::vector<std::pair<BoardFault, int>> faults);

    void advance(Time to);
    void hear(const EmulatedOutput& bytes);
    void answer(const board::Frame& request, Time now);
    void sendEvents();
    void beginFaults(Time now);
    void begin(BoardFault fault, Time now);

    EmulatedBoardFirmware firmware_;
    EmulatedBoardLine line_;
    board::FrameParser parser_;
    std::function<int(Time)> turns_;
    std::vector<std::pair<BoardFault, int>> pending_;  ///< faults and the turns at which they begin
    std::deque<EmulatedOutput> heard_;                 ///< bytes under way from the host
    std::uint16_t nextEvent_ = board::kFirstEvent;

    struct Answered {
        board::Frame request;
        board::Frame reply;
    };
    std::deque<Answered> answered_;
    bool isConnected_ = true;
};

}  // namespace planewright
