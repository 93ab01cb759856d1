// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <utility>

#include "devices/emulated/emulated_board_firmware.h"

/// What the firmware does by itself as time goes on.

namespace planewright {

using namespace board;

namespace {

using namespace std::chrono_literals;
using Time = EmulatedBoardFirmware::Time;

/// How often it looks after a motion.
constexpr Time kTick = 1ms;
constexpr Time kSyncPatience = 1s;
/// A motion may take so much longer than its way, and this.
constexpr int kMotionPatience = 3;
constexpr Time kMotionSlack = 500ms;

Time seconds(double value)
{
    return std::chrono::round<Time>(std::chrono::duration<double>(value));
}

}  // namespace

void EmulatedBoardFirmware::advance(Time to)
{
    for (auto moment = next(); moment && *moment <= to; moment = next()) {
        now_ = std::max(now_, *moment);
        if (const auto due = watchdogDue(); due && *due <= now_)
            fault(Fault::Watchdog, config_.heartbeatMs, now_);
        if (capture_ && capture_->end <= now_)
            endCapture(now_);
        if (const auto since = edgesAwaitedSince()) {
            if (setup_.nextEdge && setup_.nextEdge(*since) <= now_)
                onEdge(now_);
            else if (now_ >= *since + kSyncPatience)
                fault(Fault::NoSync, 0, now_);
        }
        if ((state_ == State::Moving || state_ == State::Sweeping) && now_ % kTick == 0ns)
            tick(now_);
        if (isGreeted_ && config_.positionHz > 0 && positionDue_ <= now_) {
            emitEvent(PositionEvent{clock(now_), position(now_), static_cast<std::int16_t>(servo_.load(now_))}, now_);
            positionDue_ += std::chrono::nanoseconds{1s} / config_.positionHz;
        }
    }
    now_ = std::max(now_, to);
}

std::optional<Time> EmulatedBoardFirmware::next() const
{
    std::optional<Time> first;
    const auto take = [&](Time moment) { first = std::min(first.value_or(moment), moment); };
    if (const auto due = watchdogDue())
        take(*due);
    if (capture_)
        take(capture_->end);
    if (const auto since = edgesAwaitedSince()) {
        take(*since + kSyncPatience);
        if (setup_.nextEdge)
            take(setup_.nextEdge(*since));
    }
    if (state_ == State::Moving || state_ == State::Sweeping)
        take((now_ / kTick + 1) * kTick);
    if (isGreeted_ && config_.positionHz > 0)
        take(positionDue_);
    return first;
}

std::vector<EmulatedBoardFirmware::Event> EmulatedBoardFirmware::takeEvents()
{
    return std::exchange(events_, {});
}

bool EmulatedBoardFirmware::isWatching() const
{
    return state_ == State::Armed || state_ == State::Moving || state_ == State::Sweeping;
}

std::optional<Time> EmulatedBoardFirmware::watchdogDue() const
{
    if (!isWatching())
        return std::nullopt;
    return missesHeartbeats_ ? now_ : lastBeat_ + std::chrono::milliseconds{config_.heartbeatMs};
}

/// Since when an edge is awaited for a slice; never while one is being taken.
std::optional<Time> EmulatedBoardFirmware::edgesAwaitedSince() const
{
    if (capture_)
        return std::nullopt;
    if (trigger_)
        return trigger_->since;
    if (sweep_ && sweep_->phase == SweepPhase::Waiting)
        return sweepWaitsSince_;
    return std::nullopt;
}

void EmulatedBoardFirmware::tick(Time now)
{
    if (hasPassedALimit(now)) {
        const bool isHigh = position(now) > config_.high;
        comeToRest(State::Stopped, now);
        emitEvent(LimitEvent{clock(now), position(now), isHigh ? config_.high : config_.low,
                             static_cast<std::uint8_t>(isHigh ? 1 : 0)},
                  now);
        return;
    }
    const bool isUnderWay = state_ == State::Moving || (sweep_ && sweep_->phase == SweepPhase::Going);
    if (!isUnderWay)
        return;
    if (hasArrived(now))
        arrive(now);
    else if (isStuck(now))
        fault(Fault::Stall, motion_.goal, now);
}

void EmulatedBoardFirmware::onEdge(Time now)
{
    const bool isOfSweep = !trigger_;
    const std::uint32_t slice =
        isOfSweep ? sweep_->plan.firstSlice + static_cast<std::uint32_t>(sweep_->done) : trigger_->slice;
    capture_ = Capture{slice, now, position(now), now + std::chrono::microseconds{config_.scanUs}, isOfSweep};
    trigger_.reset();
    if (!isOfSweep)
        return;
    sweep_->phase = SweepPhase::Capturing;
    if (sweep_->plan.mode == 1 && sweep_->done == 0) {
        const double turn = std::chrono::duration<double>(setup_.nextEdge(now) - now).count();
        servo_.goTo(sweep_->plan.last, std::min(sweep_->plan.step / turn, 1.0 * config_.topSpeed), now);
    }
}

void EmulatedBoardFirmware::endCapture(Time now)
{
    const Capture capture = *std::exchange(capture_, std::nullopt);
    emitEvent(SliceEvent{capture.slice, clock(capture.edge), static_cast<std::uint16_t>(capture.position),
                         static_cast<std::int16_t>(position(now) - capture.position), state_, 0},
              now);
    sweepWaitsSince_ = now;  // edges that came meanwhile belong to no slice
    if (capture.isOfSweep)
        goOnSweeping(now);
}

void EmulatedBoardFirmware::goOnSweeping(Time now)
{
    const Sweep& plan = sweep_->plan;
    if (++sweep_->done == plan.slices) {
        comeToRest(State::Armed, now);
        emitEvent(ArrivedEvent{clock(now), position(now), static_cast<std::uint16_t>(servo_.goal()), request_}, now);
        return;
    }
    if (plan.mode == 1) {
        sweep_->phase = SweepPhase::Waiting;
        return;
    }
    sweep_->phase = SweepPhase::Going;
    const int way = plan.last >= plan.first ? plan.step : -plan.step;
    beginMotion(plan.first + way * sweep_->done, plan.speed, plan.settleMs != 0 ? plan.settleMs : config_.settleMs,
                now);
}

void EmulatedBoardFirmware::beginMotion(int goal, double speed, int settleMs, Time now)
{
    const int from = servo_.position(now);
    const Time expected = seconds(std::abs(goal - from) / speed);
    motion_ = {
        goal, speed,       std::chrono::milliseconds{settleMs}, now + kMotionPatience * expected + kMotionSlack, from,
        now,  std::nullopt};
    startExcess_ = std::max({0, config_.low - from, from - config_.high});
    servo_.goTo(goal, speed, now);
}

bool EmulatedBoardFirmware::hasArrived(Time now)
{
    const bool isNear = std::abs(servo_.position(now) - motion_.goal) <= config_.tolerance && !servo_.isMoving(now);
    if (!isNear)
        motion_.nearSince.reset();
    else if (!motion_.nearSince)
        motion_.nearSince = now;
    return isNear && now - *motion_.nearSince >= motion_.settle;
}

bool EmulatedBoardFirmware::isStuck(Time now)
{
    if (const int here = servo_.position(now); here != motion_.progressPosition) {
        motion_.progressPosition = here;
        motion_.progressAt = now;
    }
    const Time patience = std::max<Time>(std::chrono::milliseconds{config_.stallMs}, seconds(3.0 / motion_.speed));
    return !motion_.nearSince && (now - motion_.progressAt >= patience || now >= motion_.deadline);
}

bool EmulatedBoardFirmware::hasPassedALimit(Time now)
{
    const int here = servo_.position(now);
    const int excess = std::max(config_.low - here, here - config_.high);
    return excess > config_.tolerance && excess > startExcess_;
}

void EmulatedBoardFirmware::arrive(Time now)
{
    if (state_ == State::Sweeping) {
        sweep_->phase = SweepPhase::Waiting;
        sweepWaitsSince_ = now;
        return;
    }
    state_ = State::Armed;
    emitEvent(ArrivedEvent{clock(now), position(now), static_cast<std::uint16_t>(motion_.goal), request_}, now);
}

void EmulatedBoardFirmware::fault(Fault code, int detail, Time now)
{
    const bool isOfTriggerOnly = code == Fault::NoSync && trigger_.has_value();
    if (code == Fault::Watchdog)
        missesHeartbeats_ = false;
    fault_ = code;
    if (isOfTriggerOnly)
        trigger_.reset();
    else if (state_ != State::Estopped)
        comeToRest(static_cast<int>(code) < 0x10 ? State::Stopped : State::Fault, now);
    const FaultEvent event{clock(now), code, state_, position(now), static_cast<std::uint16_t>(detail)};
    if (code == Fault::Watchdog)
        heldBack_ = Event{now, event};
    else
        emitEvent(event, now);
}

void EmulatedBoardFirmware::emitEvent(const Message& message, Time now)
{
    if (isGreeted_)
        events_.push_back({now, message});
}

}  // namespace planewright
