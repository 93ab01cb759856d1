// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/dynamixel_tilt.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/types/angle.h"
#include "core/types/angle_text.h"

namespace planewright {

namespace {

using namespace std::chrono_literals;

constexpr int kTries = 3;
// What a moment may be off by before an angle of a moving servo is worth nothing.
constexpr std::chrono::nanoseconds kMostUncertainty = 5ms;
// A position may differ by this from where the speed allows it: gears, and a push by hand.
constexpr double kJump = degrees(3.0);
constexpr double kSpeedSlack = 1.5;
// A servo that is asked more often than this cannot lose its power and come back unseen.
constexpr std::chrono::nanoseconds kUnseen = 100ms;

double secondsOf(std::chrono::nanoseconds time)
{
    return std::chrono::duration<double>(time).count();
}

}  // namespace

DynamixelTilt::DynamixelTilt(std::unique_ptr<Transport> transport, const Clock& clock, const DynamixelOptions& options)
    : transport_(std::move(transport)),
      clock_(clock),
      options_(options),
      link_(*transport_, clock, {options.id, options.baud, options.latency, options.dropEcho})
{
}

Result<void> DynamixelTilt::moveTo(double pitch, double speed)
{
    if (auto may = checkMayMove(); !may)
        return may;
    if (!std::isfinite(pitch) || !angles_.allows(pitch))
        return fail(ErrorCode::Usage, link_.subject() + ": the pitch " + degreesText(pitch, 1) +
                                          " is beyond the limits " + degreesText(lowest(), 1) + " to " +
                                          degreesText(highest(), 1));
    if (!(speed > 0.0 && speed <= fastest() * (1.0 + 1e-9)))
        return fail(ErrorCode::Usage, link_.subject() + ": the speed " + degreesText(speed, 1) +
                                          "/s is not between 0 and the limit " + degreesText(fastest(), 1) + "/s");
    if (auto sound = checkForReset(clock_.now()); !sound)
        return sound;
    const int from = shared().state.position;
    watchedGoal_ = angles_.nearestCount(pitch);
    watchedSpeed_ = angles_.speedValue(speed);
    watchedHolds_ = holds_;
    wasRetried_ = false;
    watch_.reset();
    if (auto written = writeMotion(watchedGoal_, watchedSpeed_); !written)
        return written;
    const double countsPerSecond = watchedSpeed_ * model_->speedUnit / model_->countAngle;
    speedBound_ = std::max(speedBound_, countsPerSecond);
    watch_.emplace(from, watchedGoal_, countsPerSecond, settings_.tolerance, clock_.now());
    return {};
}

double DynamixelTilt::nearestPitch(double pitch) const
{
    if (model_ == nullptr || !std::isfinite(pitch))
        return pitch;
    return angles_.pitch(angles_.nearestCount(pitch));
}

Result<std::optional<TiltSample>> DynamixelTilt::sample(Time deadline, const std::stop_token& stop)
{
    if (model_ == nullptr)
        return fail(ErrorCode::Usage, link_.subject() + " is not connected");
    while (clock_.now() < deadline && !stop.stop_requested()) {
        // One try at a time: a deadline ends the tries, and the next call goes on counting.
        Result<ServoReply> reply = link_.readState(*model_->table, image_, {false, 1, {}});
        const bool isAnswered = reply && reply->kind == ServoReply::Kind::Answered;
        if (reply && reply->answers == 0) {
            mayHaveReset_ = true;
            if (++failures_ < kTries)
                continue;
        }
        failures_ = 0;
        if (!isAnswered)
            return tl::unexpected(need(std::move(reply), ErrorCode::DeviceLost).error());
        Result<std::optional<TiltSample>> sample = judge(*reply);
        if (!sample || *sample)
            return sample;
    }
    return std::nullopt;
}

/// What an answer is worth: a sample, nothing where its moment is too uncertain, or an error.
Result<std::optional<TiltSample>> DynamixelTilt::judge(const ServoReply& reply)
{
    const ServoState state = decodeState(*model_, image_, shared().torqueOn);
    if (const auto sound = checkForReset(reply.measured); !sound)
        return tl::unexpected(sound.error());
    if (const auto sound = checkForJump(state, reply.measured); !sound)
        return tl::unexpected(sound.error());
    noteState(state, reply.measured, true);
    if (const auto sound = checkAlarm(reply); !sound)
        return tl::unexpected(sound.error());
    const Result<bool> moving = followMotion(state, reply.measured);
    if (!moving)
        return tl::unexpected(moving.error());
    if (isLate(reply) && (*moving || state.moving))
        return std::nullopt;
    return TiltSample{reply.measured, angles_.pitch(state.position), *moving, reply.uncertainty};
}

/// After silence, or where nobody asked: a servo whose power went and came has forgotten its torque.
Result<void> DynamixelTilt::checkForReset(Time now)
{
    const Shared known = shared();
    const bool wasUnseen = now - known.stateAt > kUnseen;
    if (!(std::exchange(mayHaveReset_, false) || wasUnseen) || !known.torqueOn)
        return {};
    const Result<ServoDrive> drive = readDrive();
    if (!drive)
        return tl::unexpected(drive.error());
    if (drive->torqueOn)
        return {};
    return disarm(ErrorCode::NeedsOperator, "servo-power-loss",
                  "has lost its power for a while: its torque is off, and its shaft may have "
                  "turned. Check its supply, arm it again and bring it home first");
}

/// A position that it cannot have turned to since the last sample.
Result<void> DynamixelTilt::checkForJump(const ServoState& state, Time at)
{
    const Shared known = shared();
    const double speed =
        std::exchange(speedBound_, watch_ ? watchedSpeed_ * model_->speedUnit / model_->countAngle : 0);
    const double distance = std::abs(double(state.position) - known.state.position);
    const double possible =
        kSpeedSlack * std::max(speed, speedBound_) * secondsOf(at - known.stateAt) + kJump / model_->countAngle;
    if (!isArmed_ || !known.isTrusted || distance <= possible)
        return {};
    mayHaveReset_ = true;
    if (auto sound = checkForReset(at); !sound)
        return sound;
    // What it says now is no place to hold at: it holds at the last one that could be true.
    writeGoal(known.state.position);
    noteState(known.state, known.stateAt, false);
    return disarm(ErrorCode::DeviceLost, "servo-jump",
                  "says that it has turned by " + degreesText(distance * model_->countAngle, 1) + " in " +
                      fixedText(1000.0 * secondsOf(at - known.stateAt), 0) +
                      " ms, which it cannot. Check its supply, its gear and its cable, then connect again");
}

/// True while it is on its way.
Result<bool> DynamixelTilt::followMotion(const ServoState& state, Time at)
{
    if (!isArmed_ || watchedHolds_ != holds_)
        watch_.reset();
    if (!watch_)
        return state.moving;
    const MotionWatch::Verdict verdict = watch_->look(state.position, state.moving, at);
    if (verdict != MotionWatch::Verdict::Stuck)
        return verdict == MotionWatch::Verdict::OnItsWay;
    if (!std::exchange(wasRetried_, true)) {
        const Result<void> written = writeMotion(watchedGoal_, watchedSpeed_);
        if (!written && written.error().code == ErrorCode::Interrupted)
            return state.moving;  // a hold came first
        if (!written)
            return tl::unexpected(written.error());
        const double countsPerSecond = watchedSpeed_ * model_->speedUnit / model_->countAngle;
        watch_.emplace(state.position, watchedGoal_, countsPerSecond, settings_.tolerance, clock_.now());
        return true;
    }
    watch_.reset();
    writeGoal(state.position);
    return disarm(ErrorCode::NeedsOperator, "servo-stuck",
                  withNumbers("is stuck: it was told twice to go to " + degreesText(angles_.pitch(watchedGoal_), 1) +
                              " and stands at " + degreesText(angles_.pitch(state.position), 1)) +
                      ". It holds there now; see what blocks it, then arm it again");
}

bool DynamixelTilt::isLate(const ServoReply& reply)
{
    const bool isLate = reply.uncertainty > kMostUncertainty;
    std::string lateness;
    if (isLate) {
        link_.countLate();
        lateness = link_.subject() + " answers " + fixedText(2000.0 * secondsOf(reply.uncertainty), 0) +
                   " ms late; set the latency timer of its adapter to 1 ms";
    }
    share([&](Shared& shared) { shared.lateness = std::move(lateness); });
    return isLate;
}

LinkHealth DynamixelTilt::health() const
{
    LinkHealth health = link_.health();
    const Shared known = shared();
    for (const std::string& worse : {known.lateness, known.trouble}) {
        if (!worse.empty())
            health.trouble = worse;
    }
    return health;
}

MotorState DynamixelTilt::motor() const
{
    const Shared known = shared();
    MotorState motor;
    if (known.model != nullptr) {
        motor.load = known.state.load;
        motor.voltage = known.state.voltage;
        motor.temperature = known.state.temperature;
    }
    motor.trouble = known.trouble;
    return motor;
}

Result<void> DynamixelTilt::checkMayMove() const
{
    if (model_ == nullptr)
        return fail(ErrorCode::Usage, link_.subject() + " is not connected");
    if (isHeld())
        return fail(ErrorCode::Interrupted, link_.subject() + " is held; arm it before it is to move");
    if (isArmed_)
        return {};
    const std::string trouble = shared().trouble;
    if (!trouble.empty())
        return fail(shared().troubleCode, trouble);
    return fail(ErrorCode::Usage, link_.subject() + " is not armed; nothing moves before");
}

void DynamixelTilt::noteState(const ServoState& state, Time at, bool isTrusted)
{
    share([&](Shared& shared) {
        shared.state = state;
        shared.stateAt = at;
        shared.isTrusted = isTrusted;
    });
}

DynamixelTilt::Shared DynamixelTilt::shared() const
{
    const std::scoped_lock lock(mutex_);
    return shared_;
}

}  // namespace planewright
