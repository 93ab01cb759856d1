// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_board_rules.h"

#include <cmath>
#include <cstdlib>

namespace planewright {

namespace {

using namespace board;

/// Whether the state forbids a request; for ARM, that it is 1.
std::optional<NakCode> forbidden(std::uint8_t type, State state)
{
    const bool isMotion = type == Move::kType || type == Home::kType || type == Sweep::kType;
    const bool isArm = type == Arm::kType;
    if ((isMotion || isArm) && state == State::Estopped)
        return NakCode::Estopped;
    if ((isMotion || isArm) && state == State::Fault)
        return NakCode::State;
    if (isMotion && (state == State::Unarmed || state == State::Stopped))
        return NakCode::State;
    const bool isMoving = state == State::Moving && (type == SetConfig::kType || type == Sweep::kType);
    const bool isSweeping =
        state == State::Sweeping && (isMotion || type == SetConfig::kType || type == Trigger::kType);
    if (isMoving || isSweeping)
        return NakCode::Busy;
    return std::nullopt;
}

/// Offset of the first field that is out of range.
std::optional<std::uint8_t> wrongField(const Config& c, int highest)
{
    if (c.low >= c.high)
        return 0;
    if (c.high > highest)
        return 2;
    if (c.topSpeed == 0)
        return 4;
    if (c.park < c.low || c.park > c.high)
        return 6;
    if (c.parkSpeed == 0 || c.parkSpeed > c.topSpeed)
        return 8;
    if (c.tolerance < 1 || c.tolerance > 50)
        return 10;
    if (c.limp > 1)
        return 11;
    if (c.settleMs > 1000)
        return 12;
    if (c.heartbeatMs < 50 || c.heartbeatMs > 500)
        return 14;
    if (c.stallMs < 100 || c.stallMs > 5000)
        return 16;
    if (c.estopTorque < 100 || c.estopTorque > 1000)
        return 18;
    if (c.scanUs < 1000 || c.scanUs > 60000)
        return 20;
    if (c.positionHz > 200)
        return 22;
    return std::nullopt;
}

bool isWithin(int position, const Config& config)
{
    return position >= config.low && position <= config.high;
}

bool isSpeed(int speed, const Config& config)
{
    return speed >= 1 && speed <= config.topSpeed;
}

std::optional<std::uint8_t> wrongField(const Move& m, const Config& config)
{
    if (!isWithin(m.goal, config))
        return 0;
    if (!isSpeed(m.speed, config))
        return 2;
    if (m.flags > 1)
        return 4;
    return std::nullopt;
}

std::optional<std::uint8_t> wrongField(const Sweep& s, const Config& config)
{
    if (!isWithin(s.first, config))
        return 0;
    if (!isWithin(s.last, config))
        return 2;
    if (s.step == 0)
        return 4;
    if (s.slices == 0 || (s.slices - 1) * static_cast<std::int64_t>(s.step) > std::abs(s.last - s.first))
        return 6;
    if (s.mode > 1)
        return 8;
    if (!isSpeed(s.speed, config))
        return 10;
    return std::nullopt;
}

std::optional<std::uint8_t> wrongField(const Message& message, const BoardCircumstances& now)
{
    if (const auto* config = std::get_if<SetConfig>(&message))
        return wrongField(*config, now.highest);
    if (const auto* move = std::get_if<Move>(&message))
        return wrongField(*move, now.config);
    if (const auto* sweep = std::get_if<Sweep>(&message))
        return wrongField(*sweep, now.config);
    if (const auto* arm = std::get_if<Arm>(&message); arm != nullptr && arm->arm > 1)
        return 0;
    return std::nullopt;
}

bool isRequest(std::uint8_t type)
{
    return type < replyType(0);
}

bool needsHello(std::uint8_t type)
{
    return type == SetConfig::kType || type == Home::kType || type == Move::kType || type == Sweep::kType ||
           type == Trigger::kType || type == Arm::kType;
}

}  // namespace

std::optional<Nak> refusal(const Frame& request, const BoardCircumstances& now)
{
    const std::uint8_t type = request.type;
    const auto nak = [type](NakCode code, std::size_t detail) {
        return Nak{code, type, static_cast<std::uint8_t>(detail)};
    };
    const auto message = toMessage(request);
    if (!isRequest(type) || (!message && message.error() == NakCode::UnknownType))
        return nak(NakCode::UnknownType, 0);
    if (!message)
        return nak(NakCode::Length, payloadLength(type).value_or(0));

    const auto state = static_cast<std::size_t>(now.state);
    const auto* arm = std::get_if<Arm>(&*message);
    const bool disarms = arm != nullptr && arm->arm == 0;
    const std::optional<NakCode> byState = disarms ? std::nullopt : forbidden(type, now.state);
    if (byState == NakCode::Estopped)
        return nak(*byState, state);
    if (byState == NakCode::State || (needsHello(type) && !now.isGreeted) ||
        (arm != nullptr && !disarms && !now.isConfigured))
        return nak(NakCode::State, state);
    if (byState || (type == Trigger::kType && now.triggerWaits))
        return nak(NakCode::Busy, state);
    if (const auto field = wrongField(*message, now))
        return nak(NakCode::Range, *field);
    return std::nullopt;
}

}  // namespace planewright
