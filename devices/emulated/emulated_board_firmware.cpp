// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_board_firmware.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace planewright {

using namespace board;

namespace {

constexpr std::uint16_t kFirmware = 0x0100;
constexpr std::uint16_t kServoModel = 64;
constexpr std::uint32_t kTickHz = 2'000'000;
constexpr std::uint32_t kSpanMdeg = 300'000;
constexpr std::uint8_t kResetByWatchdog = 3;
constexpr std::uint16_t kSupply = 14'800;    // [mV]
constexpr std::uint16_t kLowSupply = 9'000;  // [mV]
constexpr std::int8_t kWarm = 38;            // [°C]
constexpr std::int8_t kHot = 82;             // [°C]
constexpr int kOverloadBit = 0x20;
constexpr std::uint32_t kCapabilities =
    static_cast<std::uint32_t>(Capability::SyncInput) | static_cast<std::uint32_t>(Capability::ContinuousSweep) |
    static_cast<std::uint32_t>(Capability::Load) | static_cast<std::uint32_t>(Capability::Voltage) |
    static_cast<std::uint32_t>(Capability::Temperature) | static_cast<std::uint32_t>(Capability::TorqueLimit);

}  // namespace

EmulatedBoardFirmware::EmulatedBoardFirmware(Setup setup)
    : setup_(std::move(setup)), servo_(setup_.mounting, setup_.startPitch, setup_.dynamics), now_(setup_.bootAt)
{
}

Message EmulatedBoardFirmware::answer(const Frame& request, Time now, Time sent)
{
    const BoardCircumstances circumstances{
        state_, isGreeted_, isConfigured_, trigger_.has_value(), config_, EmulatedBoardServo::kHighest};
    if (const auto nak = refusal(request, circumstances))
        return *nak;

    const auto nowIn = [&]<class Reply>(Reply reply) {
        reply.state = state_;
        reply.pos = position(now);
        return Message{reply};
    };
    const auto does = [&]<class T>(const T& what) -> Message {
        if constexpr (std::is_same_v<T, Hello>) {
            return perform(what, now);
        } else if constexpr (std::is_same_v<T, Heartbeat>) {
            return perform(what, now, sent);
        } else if constexpr (std::is_same_v<T, GetStatus>) {
            return status(now);
        } else if constexpr (std::is_same_v<T, SetConfig>) {
            return perform(what);
        } else if constexpr (std::is_same_v<T, GetConfig>) {
            return GetConfigReply{config_};
        } else if constexpr (std::is_same_v<T, Home>) {
            return HomeReply{perform(Move{config_.park, config_.parkSpeed, 1, 0}, request.seq, now)};
        } else if constexpr (std::is_same_v<T, Move>) {
            return MoveReply{perform(what, request.seq, now)};
        } else if constexpr (std::is_same_v<T, Sweep>) {
            return SweepReply{perform(what, request.seq, now)};
        } else if constexpr (std::is_same_v<T, Trigger>) {
            trigger_ = Waiting{what.slice, now};
            return TriggerReply{};
        } else if constexpr (std::is_same_v<T, Arm>) {
            perform(what, now);
            return nowIn(ArmReply{});
        } else if constexpr (std::is_same_v<T, ClearFault>) {
            clearFault(now);
            return nowIn(ClearFaultReply{});
        } else if constexpr (std::is_same_v<T, Stop>) {
            stop(now);
            return nowIn(StopReply{});
        } else if constexpr (std::is_same_v<T, Estop>) {
            stopInEmergency(now);
            return nowIn(EstopReply{});
        } else {
            return Nak{NakCode::UnknownType, request.type, 0};
        }
    };
    return std::visit(does, *toMessage(request));
}

Message EmulatedBoardFirmware::perform(const Hello&, Time now)
{
    const bool isLatched = state_ == State::Estopped || state_ == State::Fault;
    perform(Arm{0}, now);
    if (!isLatched)
        state_ = State::Unarmed;
    trigger_.reset();
    capture_.reset();
    isGreeted_ = true;
    positionDue_ = now;

    HelloReply reply;
    reply.proto = kVersion;
    reply.firmware = kFirmware;
    reply.serial = setup_.serial;
    reply.capabilities = kCapabilities;
    reply.servoModel = kServoModel;
    reply.tickHz = kTickHz;
    reply.highest = EmulatedBoardServo::kHighest;
    reply.middle = EmulatedBoardServo::kMiddle;
    reply.spanMdeg = kSpanMdeg;
    reply.reset = resetCause_;
    return reply;
}

Message EmulatedBoardFirmware::perform(const Heartbeat& request, Time now, Time sent)
{
    lastBeat_ = now;
    return HeartbeatReply{request.hostUs, clock(now), clock(sent), state_, fault_};
}

StatusReply EmulatedBoardFirmware::status(Time now) const
{
    StatusReply reply;
    reply.state = state_;
    reply.fault = fault_;
    reply.pos = position(now);
    reply.goal = static_cast<std::uint16_t>(servo_.goal());
    reply.load = static_cast<std::int16_t>(servo_.load(now));
    const Fault reported = now < causeUntil_ ? cause_ : Fault::None;
    reply.voltMv = reported == Fault::Voltage ? kLowSupply : kSupply;
    reply.tempC = reported == Fault::Overheat ? kHot : kWarm;
    reply.uptimeMs = static_cast<std::uint32_t>(clock(now) / 1000);
    reply.lostBytes = static_cast<std::uint32_t>(lostBytes_);
    reply.crcErrors = static_cast<std::uint32_t>(crcErrors_);
    return reply;
}

Message EmulatedBoardFirmware::perform(const SetConfig& request)
{
    config_ = request;
    isConfigured_ = true;
    positionDue_ = now_;
    return SetConfigReply{config_};
}

Accepted EmulatedBoardFirmware::perform(const Move& request, std::uint16_t seq, Time now)
{
    const int settleMs = request.flags == 0 ? 0 : request.settleMs != 0 ? request.settleMs : config_.settleMs;
    request_ = seq;
    state_ = State::Moving;
    beginMotion(request.goal, request.speed, settleMs, now);
    const double ms = std::ceil(std::abs(request.goal - position(now)) * 1000.0 / request.speed);
    return {position(now), static_cast<std::uint16_t>(std::min(ms, 65535.0))};
}

Accepted EmulatedBoardFirmware::perform(const Sweep& request, std::uint16_t seq, Time now)
{
    request_ = seq;
    state_ = State::Sweeping;
    sweep_ = SweepRun{request};
    const int settleMs = request.settleMs != 0 ? request.settleMs : config_.settleMs;
    beginMotion(request.first, request.speed, settleMs, now);
    const double way = std::abs(request.first - position(now)) * 1000.0 / request.speed;
    const double slice = request.mode == 1 ? 25.0 : 50.0 + settleMs + request.step * 1000.0 / request.speed;
    return {position(now), static_cast<std::uint16_t>(std::min(std::ceil(way + request.slices * slice), 65535.0))};
}

void EmulatedBoardFirmware::perform(const Arm& request, Time now)
{
    const bool isMoving = state_ == State::Moving || state_ == State::Sweeping;
    if (request.arm == 1 && !isMoving) {
        servo_.brake(now);
        servo_.setTorque(1000);
        state_ = State::Armed;
        lastBeat_ = now;
    }
    if (request.arm == 1 || state_ == State::Estopped || state_ == State::Fault)
        return;
    comeToRest(State::Unarmed, now);
    if (config_.limp == 1)
        servo_.setTorque(0);
}

void EmulatedBoardFirmware::stop(Time now)
{
    if (state_ != State::Unarmed && state_ != State::Estopped && state_ != State::Fault)
        comeToRest(State::Stopped, now);
}

void EmulatedBoardFirmware::stopInEmergency(Time now)
{
    servo_.setTorque(std::exchange(isEstoppedByHost_, true) ? 0 : config_.estopTorque);
    comeToRest(State::Estopped, now);
}

/// Does what the first ESTOP does, and does not count for one.
void EmulatedBoardFirmware::pressButton(Time now)
{
    pressedUntil_ = now + kPressed;
    if (state_ != State::Estopped)
        servo_.setTorque(config_.estopTorque);
    comeToRest(State::Estopped, now);
}

void EmulatedBoardFirmware::clearFault(Time now)
{
    const bool isPressed = state_ == State::Estopped && now < pressedUntil_;
    const bool isThere = now < causeUntil_;
    if (isPressed || (isThere && state_ == State::Fault))
        return;
    fault_ = isThere ? cause_ : Fault::None;
    if (state_ == State::Estopped || state_ == State::Fault)
        state_ = isThere ? State::Fault : State::Unarmed;
    isEstoppedByHost_ = false;
}

void EmulatedBoardFirmware::raise(Fault code, Time now)
{
    cause_ = code;
    causeUntil_ = now + kCauseLasts;
    const int detail = code == Fault::Overload ? kOverloadBit : code == Fault::Overheat ? kHot : kLowSupply;
    fault(code, detail, now);
}

void EmulatedBoardFirmware::comeToRest(State next, Time now)
{
    servo_.brake(now);
    sweep_.reset();
    if (capture_ && capture_->isOfSweep)
        capture_.reset();
    state_ = next;
}

void EmulatedBoardFirmware::setLosses(std::uint64_t bytes, std::uint64_t crcErrors)
{
    lostBytes_ = bytes;
    crcErrors_ = crcErrors;
}

void EmulatedBoardFirmware::reset(Time now)
{
    comeToRest(State::Unarmed, now);
    trigger_.reset();
    capture_.reset();
    heldBack_.reset();
    fault_ = Fault::None;
    isEstoppedByHost_ = false;
    config_ = {};
    isGreeted_ = false;
    isConfigured_ = false;
    resetCause_ = kResetByWatchdog;
    setup_.bootAt = now;
}

void EmulatedBoardFirmware::hear(Time now)
{
    if (heldBack_)
        events_.push_back({now, std::exchange(heldBack_, std::nullopt)->message});
}

std::uint16_t EmulatedBoardFirmware::position(Time at) const
{
    return static_cast<std::uint16_t>(std::clamp(servo_.position(at) + readingError_, 0, EmulatedBoardServo::kHighest));
}

std::uint64_t EmulatedBoardFirmware::clock(Time at) const
{
    const double us = static_cast<double>((at - setup_.bootAt).count()) * (1.0 + setup_.clockDrift) / 1000.0;
    return us > 0.0 ? static_cast<std::uint64_t>(us) : 0;
}

}  // namespace planewright
