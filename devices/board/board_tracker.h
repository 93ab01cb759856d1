// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "devices/board/board_link.h"
#include "devices/board/board_scale.h"
#include "devices/tilt_unit.h"

namespace planewright {

/// A slice's angle, taken by the board at the laser's sync edge.
struct BoardSlice {
    std::uint32_t number = 0;
    std::chrono::nanoseconds at{0};  ///< the edge, host clock
    double pitch = 0.0;              ///< φ then [rad]
    double pitchAtEnd = 0.0;         ///< φ when the scan was over [rad]
    bool isSuspect = false;          ///< the board says that it guessed, or that the edge came out of turn
};

/// What stopped the motor, so that nothing moves any more until a person has looked.
struct BoardTrouble {
    std::string code;        ///< for the log: "board-overload"
    std::string text;        ///< goes on where "control board: " ends
    bool isLatched = false;  ///< the board is ESTOPPED or in FAULT, until that is cleared

    bool isEstop() const { return code == "board-estop"; }
};

/// What a board says, put together: where the motor is, whether it moves, what went wrong. Pure: messages in, state
/// out.
class BoardTracker {
public:
    using Time = std::chrono::nanoseconds;

    /// Begins anew with a board that has said hello. Arrivals farther from their goal than `tolerance` counts are
    /// troubles; samples that come later than `latest` after their moment are counted.
    void begin(const board::Scale& scale, int tolerance, Time latest);

    /// ARM 1 was answered by a message of this order; what came before says nothing about it.
    void setArmed(std::uint64_t order);
    void setDisarmed();
    bool isArmed() const { return isArmed_; }

    /// A motion was accepted by a message of this order: a MOVE to a goal, or a SWEEP without one.
    void setMoving(std::uint16_t seq, std::uint64_t order, std::optional<int> goal);

    void take(const BoardLink::Received& received);

    /// The next measured angle.
    std::optional<TiltSample> takeSample();
    std::vector<BoardSlice> takeSlices();
    /// What went wrong since the last time; the board is disarmed then. Empty: nothing.
    std::optional<BoardTrouble> takeTrouble();
    /// True once after the board has started anew.
    bool takeReset();

    const MotorState& motor() const { return motor_; }
    /// What goes wrong without stopping the motor; empty: nothing.
    const std::string& notice() const { return notice_; }
    std::uint64_t late() const { return late_; }
    std::uint64_t outOfOrder() const { return outOfOrder_; }

private:
    void takeOne(const board::HeartbeatReply& reply, const BoardLink::Received& received);
    void takeOne(const board::StatusReply& reply, const BoardLink::Received& received);
    void takeOne(const board::PositionEvent& event, const BoardLink::Received& received);
    void takeOne(const board::SliceEvent& event, const BoardLink::Received& received);
    void takeOne(const board::ArrivedEvent& event, const BoardLink::Received& received);
    void takeOne(const board::FaultEvent& event, const BoardLink::Received& received);
    void takeOne(const board::LimitEvent& event, const BoardLink::Received& received);
    void look(board::State state, board::Fault fault, std::uint64_t order);
    void arrive();
    void restart();
    void disarm(BoardTrouble why);

    board::Scale scale_;
    int tolerance_ = 0;
    Time latest_{0};
    bool isArmed_ = false;
    bool isMoving_ = false;
    bool isReset_ = false;
    std::uint64_t order_ = 0;       ///< of what last changed the board's state by our will
    std::uint64_t armedOrder_ = 0;  ///< of what armed it
    std::uint16_t motion_ = 0;
    std::optional<int> goal_;
    bool looksAtGoal_ = false;   ///< the next position must be the goal
    std::uint64_t boardUs_ = 0;  ///< its clock when the last heartbeat reached it
    std::uint32_t uptimeMs_ = 0;
    std::optional<int> lastPosition_;
    Time lastSampleAt_{0};
    std::deque<TiltSample> samples_;
    std::vector<BoardSlice> slices_;
    std::optional<BoardTrouble> trouble_;
    MotorState motor_;
    std::string notice_;
    std::uint64_t late_ = 0;
    std::uint64_t outOfOrder_ = 0;
};

}  // namespace planewright
