// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "core/types/angle_text.h"
#include "devices/dynamixel/dynamixel_tilt.h"
#include "devices/dynamixel/requests.h"

namespace planewright {

namespace {

using namespace std::chrono_literals;

// A sample of this age tells well enough where a moving servo is.
constexpr std::chrono::nanoseconds kFresh = 30ms;
// Speed of the way from where it stands to where it stands: never 0, which means as fast as possible.
constexpr int kSlowestSpeed = 1;
constexpr double kCooled = 10.0;  // [°C] below the limit
constexpr std::chrono::nanoseconds kRestart = 3s;
constexpr std::chrono::nanoseconds kBetweenPings = 50ms;

}  // namespace

Result<void> DynamixelTilt::arm(const std::stop_token& stop)
{
    if (model_ == nullptr)
        return fail(ErrorCode::Usage, link_.subject() + " is not connected");
    // A hold that comes from here on ends it.
    const unsigned holds = holds_;
    isArmed_ = false;
    watch_.reset();
    const auto isStopped = [&] { return stop.stop_requested() || holds != holds_; };
    const auto stopped = [&] { return fail(ErrorCode::Interrupted, link_.subject() + ": arming was stopped"); };
    if (auto done = standStill(); !done)
        return done;
    if (isStopped())
        return stopped();
    if (auto done = turnTorqueOn(); !done)
        return done;
    if (isStopped())
        return stopped();
    share([](Shared& shared) { shared.trouble.clear(); });
    speedBound_ = 0.0;
    mayHaveReset_ = false;
    holdsTakenBack_ = holds;
    isArmed_ = true;
    return {};
}

/// Goal := where it is, so that nothing jumps when the torque comes.
Result<void> DynamixelTilt::standStill()
{
    const Result<ServoState> state = readState();
    if (!state)
        return tl::unexpected(state.error());
    const Result<ServoDrive> drive = readDrive();
    if (!drive)
        return tl::unexpected(drive.error());
    if (drive->isShutDown)
        return disarm(ErrorCode::NeedsOperator, "servo-off",
                      withNumbers("was turned off by an alarm") + "; see to the cause, then recover it");
    const int goal = std::clamp(state->position, settings_.lowestGoal, settings_.highestGoal);
    if (std::abs(double(goal) - state->position) > settings_.tolerance)
        return fail(ErrorCode::NeedsOperator,
                    link_.subject() + " stands at " + degreesText(angles_.pitch(state->position), 1) +
                        ", beyond its own angle limits; turn it back by hand, then arm it again");
    if (model_->table->watchdog.exists() && settings_.firmware >= kFirmwareWithWatchdog) {
        if (auto written = writeRegister(model_->table->watchdog, 0); !written)
            return written;
    }
    if (auto written = writeRegister(model_->table->speed, kSlowestSpeed); !written)
        return written;
    return writeGoal(goal);
}

Result<void> DynamixelTilt::turnTorqueOn()
{
    if (auto written = writeRegister(model_->table->torqueEnable, 1); !written)
        return written;
    const Result<ServoDrive> drive = readDrive();
    if (!drive)
        return tl::unexpected(drive.error());
    if (!drive->torqueOn || drive->isShutDown)
        return disarm(ErrorCode::DeviceLost, "servo-no-torque",
                      withNumbers("does not turn its torque on") + "; check its supply");
    const int goal = shared().goal;
    if (drive->goal != goal)
        return disarm(ErrorCode::DeviceLost, "servo-other-goal",
                      "took " + std::to_string(drive->goal) + " for its goal and not " + std::to_string(goal) +
                          "; is another program moving it?");
    return {};
}

Result<void> DynamixelTilt::hold()
{
    ++holds_;
    const Shared known = shared();
    if (known.model == nullptr || !known.torqueOn)
        return {};
    std::optional<Error> deaf;
    int goal = known.goal;
    if (known.isTrusted) {
        if (const std::optional<int> now = whereItIsNow(known)) {
            goal = *now;
        } else if (const Result<int> asked = askWhereItIs(known)) {
            goal = *asked;
        } else {
            // It may hear although we do not.
            goal = known.state.position;
            deaf = asked.error();
        }
    }
    goal = std::clamp(goal, known.settings.lowestGoal, known.settings.highestGoal);
    share([&](Shared& shared) { shared.goal = goal; });
    const ServoRegister place = known.model->table->goal;
    const std::vector<std::uint8_t> bytes = littleEndian(static_cast<std::uint32_t>(goal), place.size);
    const Result<ServoReply> reply = write(known, {place.address, place.size}, bytes, {true, 3, {}});
    if (!reply)
        return tl::unexpected(reply.error());
    if (reply->answers == 0)
        return tl::unexpected(link_.failure(*reply, ErrorCode::DeviceLost));
    if (deaf)
        return tl::unexpected(*deaf);
    return {};
}

/// Where it is by its last sample and its speed then, no farther than its goal; empty where that was too long ago.
std::optional<int> DynamixelTilt::whereItIsNow(const Shared& known) const
{
    const Time age = clock_.now() - known.stateAt;
    if (age > kFresh)
        return std::nullopt;
    const double position = known.state.position;
    const double way = known.state.speed / known.model->countAngle * std::chrono::duration<double>(age).count();
    const auto [low, high] = std::minmax({position, double(known.goal)});
    return static_cast<int>(std::lround(std::clamp(position + way, low, high)));
}

Result<int> DynamixelTilt::askWhereItIs(const Shared& known)
{
    RegisterImage image;
    const Result<ServoReply> reply = link_.readState(*known.model->table, image, {true, 3, {}});
    if (!reply)
        return tl::unexpected(reply.error());
    if (reply->answers == 0)
        return tl::unexpected(link_.failure(*reply, ErrorCode::DeviceLost));
    return decodeState(*known.model, image, known.torqueOn).position;
}

Result<void> DynamixelTilt::recover(const std::stop_token& stop)
{
    if (model_ == nullptr)
        return fail(ErrorCode::Usage, link_.subject() + " is not connected");
    if (wasRecovered_)
        return fail(ErrorCode::NeedsOperator, link_.subject() +
                                                  " was recovered before, so that its cause is still there; "
                                                  "see to it, then connect again");
    const auto reply = need(link_.readState(*model_->table, image_), ErrorCode::DeviceLost);
    if (!reply)
        return tl::unexpected(reply.error());
    const ServoState state = decodeState(*model_, image_, false);
    noteState(state, reply->measured, true);
    const Result<ServoDrive> drive = readDrive();
    if (!drive)
        return tl::unexpected(drive.error());
    if (!drive->isShutDown && !decodeStatusError(model_->protocol, reply->status.error).hasAlarm) {
        share([](Shared& shared) { shared.trouble.clear(); });
        return {};
    }
    if (state.temperature >= settings_.temperatureLimit - kCooled)
        return disarm(ErrorCode::NeedsOperator, "servo-warm",
                      withNumbers("is too warm") + "; wait until it is below " +
                          fixedText(settings_.temperatureLimit - kCooled, 0) + " °C, then recover it again");
    if (state.voltage < settings_.lowestVoltage || state.voltage > settings_.highestVoltage)
        return disarm(ErrorCode::NeedsOperator, "servo-supply",
                      withNumbers("has a wrong supply") + "; see to it, then recover it again");
    wasRecovered_ = true;
    lastAlarm_.reset();
    Result<void> done = model_->protocol == DynamixelProtocol::One ? recoverOne() : recoverTwo(stop);
    if (!done)
        return done;
    // Any question tells whether the alarm is still there.
    if (const auto calm = readState(); !calm)
        return tl::unexpected(calm.error());
    share([](Shared& shared) { shared.trouble.clear(); });
    return {};
}

/// 1.0: an alarm has set the torque limit to 0. Goal := where it is comes first, while there is no torque.
Result<void> DynamixelTilt::recoverOne()
{
    if (auto done = writeRegister(model_->table->speed, kSlowestSpeed); !done)
        return done;
    if (auto done = writeGoal(shared().state.position); !done)
        return done;
    if (auto done = writeRegister(model_->table->torqueLimit, static_cast<std::uint32_t>(settings_.maxTorque)); !done)
        return done;
    return turnTorqueOn();
}

/// 2.0: only a restart ends the shutdown; the torque stays off until arm().
Result<void> DynamixelTilt::recoverTwo(const std::stop_token& stop)
{
    share([](Shared& shared) { shared.torqueOn = false; });
    if (auto done = link_.reboot(); !done)
        return done;
    const Time latest = clock_.now() + kRestart;
    for (;;) {
        if (auto done = link_.pause(kBetweenPings, stop); !done)
            return done;
        if (stop.stop_requested())
            return fail(ErrorCode::Interrupted, link_.subject() + ": recovering was stopped");
        const Result<ServoReply> reply = link_.ping();
        if (!reply)
            return tl::unexpected(reply.error());
        if (reply->kind == ServoReply::Kind::Answered)
            return {};
        if (clock_.now() > latest)
            return tl::unexpected(need(reply, ErrorCode::DeviceLost).error());
    }
}

}  // namespace planewright
