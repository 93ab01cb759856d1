// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "devices/board/board_message.h"
#include "devices/emulated/emulated_board_rules.h"
#include "devices/emulated/emulated_board_servo.h"

namespace planewright {

/// What the program in an emulated control board does: resources/manual/board-protocol.md without its bytes, as a
/// function of time. Its caller asks for nothing out of order: moments never go back.
class EmulatedBoardFirmware {
public:
    using Time = std::chrono::nanoseconds;
    /// The first sync edge of the laser after a moment.
    using NextEdge = std::function<Time(Time)>;

    struct Setup {
        TiltMounting mounting;
        double startPitch = 0.0;
        MotorDynamics dynamics;
        std::array<std::uint8_t, 8> serial{};
        double clockDrift = 0.0;  ///< how much too fast its clock runs
        NextEdge nextEdge;        ///< empty: no sync wire
        Time bootAt{0};
    };
    explicit EmulatedBoardFirmware(Setup setup);

    /// An event and when it happened.
    struct Event {
        Time at;
        board::Message message;
    };

    /// Lets everything happen up to a moment.
    void advance(Time to);
    /// The next moment at which something will happen by itself; may be early.
    std::optional<Time> next() const;
    /// What has happened, in order.
    std::vector<Event> takeEvents();

    /// An undamaged frame of the host has come: some events wait for that.
    void hear(Time now);
    /// Does what is asked at a moment; the reply leaves it at another.
    board::Message answer(const board::Frame& request, Time now, Time sent);
    /// Bytes and frames that the link threw away since the reset.
    void setLosses(std::uint64_t bytes, std::uint64_t crcErrors);

    /// Starts anew, as by its own watchdog.
    void reset(Time now);
    /// Takes the heartbeats for missing, once: at once if it watches them, or when it does.
    void missHeartbeats() { missesHeartbeats_ = true; }

    /// The servo reports Overload, Overheat or Voltage, for kCauseLasts: so long nothing clears it.
    void raise(board::Fault code, Time now);
    static constexpr Time kCauseLasts = std::chrono::seconds{3};
    /// Somebody presses the button for emergencies, for kPressed.
    void pressButton(Time now);
    static constexpr Time kPressed = std::chrono::seconds{2};
    /// No sync edge comes any more.
    void loseSync() { setup_.nextEdge = {}; }

    /// From now on it tells positions that are so many counts too high.
    void setReadingError(int counts) { readingError_ = counts; }

    board::State state() const { return state_; }
    EmulatedBoardServo& servo() { return servo_; }
    const EmulatedBoardServo& servo() const { return servo_; }
    /// Its clock [µs].
    std::uint64_t clock(Time at) const;

private:
    /// A way to a goal.
    struct Motion {
        int goal = 0;
        double speed = 0.0;
        Time settle{0};
        Time deadline{0};
        int progressPosition = 0;
        Time progressAt{0};
        std::optional<Time> nearSince;
    };
    enum class SweepPhase { Going, Waiting, Capturing };
    struct SweepRun {
        board::Sweep plan;
        int done = 0;
        SweepPhase phase = SweepPhase::Going;
    };
    struct Capture {
        std::uint32_t slice = 0;
        Time edge{0};
        int position = 0;
        Time end{0};
        bool isOfSweep = false;
    };
    struct Waiting {
        std::uint32_t slice = 0;
        Time since{0};
    };

    // Requests.
    board::Message perform(const board::Hello& request, Time now);
    board::Message perform(const board::Heartbeat& request, Time now, Time sent);
    board::StatusReply status(Time now) const;
    board::Message perform(const board::SetConfig& request);
    board::Accepted perform(const board::Move& request, std::uint16_t seq, Time now);
    board::Accepted perform(const board::Sweep& request, std::uint16_t seq, Time now);
    void perform(const board::Arm& request, Time now);
    void stop(Time now);
    void stopInEmergency(Time now);
    void clearFault(Time now);
    /// Ends motion in order and goes to a state.
    void comeToRest(board::State next, Time now);

    // Time.
    bool isWatching() const;
    std::optional<Time> watchdogDue() const;
    std::optional<Time> edgesAwaitedSince() const;
    void tick(Time now);
    void onEdge(Time now);
    void endCapture(Time now);
    void goOnSweeping(Time now);
    void beginMotion(int goal, double speed, int settleMs, Time now);
    bool hasArrived(Time now);
    bool isStuck(Time now);
    bool hasPassedALimit(Time now);
    void arrive(Time now);
    void fault(board::Fault code, int detail, Time now);
    void emitEvent(const board::Message& message, Time now);
    /// What it tells of where the servo is.
    std::uint16_t position(Time at) const;

    Setup setup_;
    EmulatedBoardServo servo_;
    board::State state_ = board::State::Unarmed;
    board::Fault fault_ = board::Fault::None;
    board::Config config_;
    bool isGreeted_ = false;
    bool isConfigured_ = false;
    bool missesHeartbeats_ = false;
    bool isEstoppedByHost_ = false;  ///< the next ESTOP is the second one
    Time pressedUntil_{0};
    board::Fault cause_ = board::Fault::None;  ///< what the servo reports until `causeUntil_`
    Time causeUntil_{0};
    std::uint8_t resetCause_ = 0;
    int readingError_ = 0;
    std::uint64_t lostBytes_ = 0;
    std::uint64_t crcErrors_ = 0;

    Time now_{0};
    Time lastBeat_{0};
    Time positionDue_{0};
    std::uint16_t request_ = 0;  ///< what the present motion was asked for with
    Motion motion_;
    int startExcess_ = 0;  ///< how far outside its limits the motion began
    std::optional<SweepRun> sweep_;
    std::optional<Waiting> trigger_;
    Time sweepWaitsSince_{0};
    std::optional<Capture> capture_;
    std::optional<Event> heldBack_;  ///< until the host is heard
    std::vector<Event> events_;
};

}  // namespace planewright
