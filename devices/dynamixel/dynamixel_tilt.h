// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

#include "devices/dynamixel/motion_watch.h"
#include "devices/dynamixel/servo_angles.h"
#include "devices/dynamixel/servo_link.h"
#include "devices/dynamixel/servo_state.h"
#include "devices/tilt_unit.h"

namespace planewright {

/// How to find a servo, and what it carries.
struct DynamixelOptions {
    std::uint8_t id = 1;
    int baud = 57'142;                      ///< rate that the transport was opened with; used for times alone
    std::chrono::milliseconds latency{16};  ///< longest time that the adapter keeps bytes back
    bool dropEcho = false;                  ///< the adapter is known to send back what is sent to it
    TiltMounting mounting;
};

/// A Dynamixel servo of protocol 1.0 or 2.0 as a tilt unit, on a bus of its own.
///
/// Nothing that survives the servo's power is ever written. Every answer is looked at for alarms: with the first one
/// the motion ends, and nothing moves before recover() or arm(). What a servo may be asked for, is asked again twice
/// where it does not answer; then it counts as lost.
///
/// sample(): the moment of a measurement is known to half the time that the answer was late. While the servo moves, a
/// sample that is uncertain by more than 5 ms is not given. `moving` is true until the position has been at the goal in
/// three answers after one another.
class DynamixelTilt : public TiltUnit {
public:
    DynamixelTilt(std::unique_ptr<Transport> transport, const Clock& clock, const DynamixelOptions& options);

    Result<void> connect(const std::stop_token& stop) override;
    std::string identity() const override;
    double resolution() const override { return angles_.resolution(); }
    double lowest() const override { return angles_.lowestPitch(); }
    double highest() const override { return angles_.highestPitch(); }
    double fastest() const override { return angles_.fastest(); }
    double speedStep() const override { return angles_.speedOf(1); }
    double tolerance() const override { return settings_.tolerance * angles_.resolution(); }

    /// Torque on, where the servo stands. Errors (NeedsOperator): an alarm has turned it off: recover() first.
    Result<void> arm(const std::stop_token& stop) override;
    Result<void> moveTo(double pitch, double speed) override;
    double nearestPitch(double pitch) const override;
    Result<std::optional<TiltSample>> sample(std::chrono::nanoseconds deadline, const std::stop_token& stop) override;
    /// While samples come, its first request stops the motor, at the place where it is by the last sample and its
    /// speed; without, it asks for the position first.
    Result<void> hold() override;

    /// Turns a servo on again, where it stands, after an alarm has turned it off and its user has seen to the cause.
    /// Once after each connect(): what happens again has a cause that is still there. Moves nothing, and arm() is still
    /// needed. Errors (NeedsOperator): too warm, supply out of range, or the alarm is still there, with the numbers.
    Result<void> recover(const std::stop_token& stop) override;

    /// True from the beginning of a hold() to the end of an arm(), or to a connect(). Any thread.
    bool isHeld() const { return holds_ != holdsTakenBack_; }

    bool holdsItself() const override { return shared().torqueOn; }
    LinkHealth health() const override;
    std::vector<FaultRecord> takeLog() override { return link_.log().take(); }
    MotorState motor() const override;

private:
    using Time = std::chrono::nanoseconds;

    /// What other threads need for hold() and motor().
    struct Shared {
        const DynamixelModel* model = nullptr;  ///< empty before connect()
        ServoSettings settings;
        bool torqueOn = false;
        bool isTrusted = false;  ///< `state` may be relied on for where it is
        ServoState state;
        Time stateAt{0};
        int goal = 0;         ///< last one written
        std::string trouble;  ///< of the servo
        ErrorCode troubleCode = ErrorCode::DeviceLost;
        std::string lateness;  ///< of the line
    };

    // connect
    Result<void> findProtocol(const std::stop_token& stop);
    Result<const DynamixelModel*> findModel();
    Result<void> findAndLook(const std::stop_token& stop);
    Result<ServoReply> find(const std::stop_token& stop);
    Result<void> checkQuick(const std::stop_token& stop);
    Result<void> checkQuick(const ServoReply& reply) const;
    Result<ServoReply> readAll();
    Result<void> look(const ServoReply& reply);
    Result<void> stopWhatWasLeft();

    // Questions whose answers are looked at; `code` is that of a servo which does not answer.
    Result<ServoReply> need(Result<ServoReply> reply, ErrorCode code);
    Result<ServoDrive> readDrive();
    Result<ServoState> readState();
    Result<void> writeMotion(int goal, int speed);
    /// The nearest that the servo allows.
    Result<void> writeGoal(int goal);
    Result<void> writeRegister(const ServoRegister& place, std::uint32_t value);
    /// Any thread. Where the servo does not answer writes, reads what it has become.
    Result<ServoReply> write(const Shared& known, ServoRegion region, std::span<const std::uint8_t> bytes,
                             const HowToAsk& how);

    // arm and recover
    Result<void> standStill();
    Result<void> turnTorqueOn();
    Result<void> recoverOne();
    Result<void> recoverTwo(const std::stop_token& stop);

    // hold, from any thread
    std::optional<int> whereItIsNow(const Shared& known) const;
    Result<int> askWhereItIs(const Shared& known);

    // sample
    Result<std::optional<TiltSample>> judge(const ServoReply& reply);
    Result<void> checkForReset(Time now);
    Result<void> checkForJump(const ServoState& state, Time at);
    Result<bool> followMotion(const ServoState& state, Time at);
    bool isLate(const ServoReply& reply);

    // alarms and trouble
    Result<void> checkAlarm(const ServoReply& reply);
    tl::unexpected<Error> raiseAlarm(const ServoAlarm& alarm, const ServoReply& told);
    tl::unexpected<Error> disarm(ErrorCode code, std::string_view fault, const std::string& trouble,
                                 std::span<const std::uint8_t> bytes = {});
    std::string withNumbers(const std::string& what) const;

    Result<void> checkMayMove() const;
    void noteState(const ServoState& state, Time at, bool isTrusted);
    Shared shared() const;
    template <class Change>
    void share(Change change)
    {
        const std::scoped_lock lock(mutex_);
        change(shared_);
    }

    std::unique_ptr<Transport> transport_;
    const Clock& clock_;
    DynamixelOptions options_;
    ServoLink link_;

    // Of the one thread that calls.
    const DynamixelModel* model_ = nullptr;
    RegisterImage image_;
    ServoSettings settings_;
    ServoAngles angles_;
    std::optional<MotionWatch> watch_;
    int watchedGoal_ = 0;
    int watchedSpeed_ = 1;
    bool wasRetried_ = false;    ///< the motion that is watched
    unsigned watchedHolds_ = 0;  ///< holds before the motion that is watched
    double speedBound_ = 0.0;    ///< fastest that it can have turned since the last sample [counts/s]
    int failures_ = 0;           ///< tries of sample() without an answer, after one another
    bool mayHaveReset_ = false;  ///< it did not answer for a while
    bool wasRecovered_ = false;
    std::optional<ServoAlarm> lastAlarm_;  ///< that the servo has already been stopped for

    std::atomic<bool> isArmed_{false};
    std::atomic<unsigned> holds_{0};
    std::atomic<unsigned> holdsTakenBack_{0};

    mutable std::mutex mutex_;
    Shared shared_;
};

}  // namespace planewright
