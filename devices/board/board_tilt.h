// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "devices/board/board_link.h"
#include "devices/board/board_scale.h"
#include "devices/board/board_tracker.h"
#include "devices/tilt_unit.h"

namespace planewright {

/// How a control board is used.
struct BoardTiltOptions {
    TiltMounting mounting;
    BoardTiming timing;
    int positionRate = 200;                      ///< measured angles a second, 1 to 200
    int tolerance = 2;                           ///< counts: so near is arrived
    std::chrono::milliseconds settle{20};        ///< at rest for so long is settled
    std::chrono::milliseconds watchdog{150};     ///< without heartbeats for so long the board stops, 50 to 500
    std::chrono::microseconds scanTime{18'750};  ///< how long a scan of the laser takes from its sync edge
};

/// Slices at equal steps that the board takes by itself.
struct BoardSweep {
    double first = 0.0;  ///< φ [rad]
    double last = 0.0;
    double step = 0.0;  ///< φ from slice to slice, positive [rad]
    int slices = 0;
    double speed = 0.0;         ///< between stops, and to the first [rad/s]
    bool isContinuous = false;  ///< moves on while the laser scans
    std::uint32_t firstNumber = 0;
};

/// A tilt unit behind a control board that speaks NTB/1 (resources/manual/board-protocol.md).
///
/// The heartbeat goes out while a call waits; sample() must be called often while the motor is armed, since the board
/// stops the motor when none comes for `watchdog`. After everything that stops the motor but hold() and stop(),
/// sample() gives an error once that says why (NeedsOperator), and nothing moves until arm(); where the board is
/// ESTOPPED or in FAULT, arm() refuses until recover(). A hold() of this driver's own is taken back by arm().
///
/// sample() gives DeviceLost where no angle with a known moment has come for a second, or for three times the time
/// between two.
class BoardTilt : public TiltUnit {
public:
    BoardTilt(std::unique_ptr<Transport> transport, const Clock& clock, const BoardTiltOptions& options);

    Result<void> connect(const std::stop_token& stop) override;
    std::string identity() const override { return identity_; }
    double resolution() const override { return scale_.step(); }
    double lowest() const override { return scale_.lowest(); }
    double highest() const override { return scale_.highest(); }
    double fastest() const override { return scale_.fastest(); }
    double speedStep() const override { return scale_.step(); }
    double tolerance() const override { return options_.tolerance * scale_.step(); }
    Result<void> arm(const std::stop_token& stop) override;
    /// Errors (NeedsOperator): the board stays in FAULT, or its button for emergencies is still pressed.
    Result<void> recover(const std::stop_token& stop) override;
    Result<void> moveTo(double pitch, double speed) override;
    /// HOME, to the angle that the board was configured with when it was connected.
    Result<void> goHome() override;
    double nearestPitch(double pitch) const override { return scale_.pitch(scale_.nearest(pitch)); }
    Result<std::optional<TiltSample>> sample(std::chrono::nanoseconds deadline, const std::stop_token& stop) override;
    Result<void> stop() override;
    Result<void> hold() override;
    LinkHealth health() const override;
    std::vector<FaultRecord> takeLog() override { return link_.log().take(); }
    MotorState motor() const override;
    std::optional<std::chrono::nanoseconds> startedAt() const override { return startedAt_; }

    /// Notes the angle at the laser's next sync edge. Errors (Usage): one is being waited for, or there is no sync
    /// wire.
    Result<void> trigger(std::uint32_t number);
    /// Begins to take slices; sample() goes on meanwhile. Errors as those of moveTo().
    Result<void> sweep(const BoardSweep& plan);
    /// What has come since the last time, in order. A number that is missing was lost.
    std::vector<BoardSlice> takeSliceEvents() { return tracker_.takeSlices(); }

private:
    using Received = BoardLink::Received;

    tl::unexpected<Error> failure(ErrorCode code, const std::string& what) const;
    Result<void> notHeld() const;
    Result<Received> ask(const board::Message& request, const std::stop_token& stop);
    Result<Received> askUnlessHeld(const board::Message& request, const std::stop_token& stop);
    Result<void> greet(BoardLink::Patience patience, const std::stop_token& stop);
    Result<void> introduce(const board::HelloReply& board);
    Result<void> configure(const std::stop_token& stop);
    Result<void> compareClocks(const std::stop_token& stop);
    Result<void> learnFateOfHold(const std::stop_token& stop);
    Result<void> takeBackHold(const std::stop_token& stop);
    Result<board::StatusReply> readStatus(const std::stop_token& stop);
    board::StatusReply statusOf(const Received& answer);
    Result<void> mustNotWaitForAnybody(const std::stop_token& stop);
    Result<void> clear(const std::stop_token& stop);
    Result<void> sendArm(const std::stop_token& stop);
    Result<void> mayMove();
    Result<void> begin(const board::Message& motion, std::optional<int> goal);
    Result<int> countsOf(double pitch) const;
    Result<int> countsASecond(double speed) const;
    Result<void> drain();
    Result<void> askForStatus();
    Result<void> reportTrouble(const std::stop_token& stop);
    Result<void> mustGiveAngles();
    std::chrono::nanoseconds longestWithoutAngle() const;
    /// Passes on why the board is lost; nothing moves any more then.
    tl::unexpected<Error> lost(const Error& why);
    void publish();

    const BoardTiltOptions options_;
    const Clock& clock_;
    BoardLink link_;
    board::Scale scale_;
    std::string identity_ = "control board";
    board::HelloReply board_;
    bool isConnected_ = false;
    bool isConfigured_ = false;  ///< the board knows our limits
    BoardTracker tracker_;
    std::optional<std::chrono::nanoseconds> startedAt_;
    std::chrono::nanoseconds nextStatus_{0};
    std::optional<std::chrono::nanoseconds> waitsSince_;  ///< for an angle, in sample()

    std::atomic<bool> isHeld_{false};
    std::mutex holding_;                       ///< one at a time stops in an emergency, or ends that
    std::optional<BoardLink::Request> estop_;  ///< sent and not answered yet: only ever the same one again
    bool isStopped_ = false;                   ///< the board is ESTOPPED: one more ESTOP would make it limp
    bool isHeldByUs_ = false;                  ///< it is that by our own hold()

    mutable std::mutex shown_;
    MotorState shownMotor_;
    std::string trouble_;
    ErrorCode troubleCode_ = ErrorCode::DeviceLost;
    std::string notice_;
    std::uint64_t late_ = 0;
    std::uint64_t outOfOrder_ = 0;
};

}  // namespace planewright
