// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/requests.h"
#include "devices/emulated/servo_body.h"

namespace planewright {

namespace {

constexpr std::chrono::nanoseconds kReboot = std::chrono::milliseconds{300};

}  // namespace

std::uint8_t ServoBody::alarmByte() const
{
    if (kind_.protocol == DynamixelProtocol::Two)
        return alarm_.any() ? 0x80 : 0x00;
    return alarmBits(kind_.protocol, alarm_);
}

bool ServoBody::answers(const DynamixelPacket& request) const
{
    const std::uint32_t level = memory_.value(ServoRole::ReturnLevel);
    const auto instruction = static_cast<DynamixelInstruction>(request.code);
    if (instruction == DynamixelInstruction::Ping)
        return true;
    return request.id != kBroadcastId && level >= (instruction == DynamixelInstruction::Read ? 1U : 2U);
}

std::optional<DynamixelStatus> ServoBody::handle(const DynamixelPacket& request, Time now)
{
    if (!hasPower(now))
        return std::nullopt;
    wakeUp(now);
    refresh(now);
    DynamixelStatus status{id(), 0, {}};
    const bool isAnswered = answers(request);  // by what was set before
    const std::uint8_t error = perform(request, status, now);
    refresh(now);
    status.error = error | alarmByte();
    return isAnswered ? std::optional{status} : std::nullopt;
}

std::uint8_t ServoBody::unknownInstruction() const
{
    return kind_.protocol == DynamixelProtocol::One ? 0x40 : 0x02;
}

std::uint8_t ServoBody::errorOf(ServoMemory::Refusal refusal) const
{
    const bool isOne = kind_.protocol == DynamixelProtocol::One;
    switch (refusal) {
        case ServoMemory::Refusal::None:
            return 0;
        case ServoMemory::Refusal::Range:
            return isOne ? 0x08 : 0x04;
        case ServoMemory::Refusal::Limit:
            return isOne ? 0x02 : 0x06;
        case ServoMemory::Refusal::Length:
            return isOne ? 0x08 : 0x05;
        case ServoMemory::Refusal::Access:
            return isOne ? 0x08 : 0x07;
    }
    return 0;
}

std::uint8_t ServoBody::perform(const DynamixelPacket& request, DynamixelStatus& status, Time now)
{
    const std::size_t width = kind_.protocol == DynamixelProtocol::One ? 1 : 2;
    const std::span<const std::uint8_t> parameters{request.parameters};
    const bool hasAddress = parameters.size() > width;
    const auto address = static_cast<std::uint16_t>(fromLittleEndian(parameters.first(hasAddress ? width : 0)));
    switch (static_cast<DynamixelInstruction>(request.code)) {
        case DynamixelInstruction::Ping:
            return ping(status);
        case DynamixelInstruction::Read: {
            if (parameters.size() != 2 * width)
                return errorOf(ServoMemory::Refusal::Length);
            const auto count = static_cast<std::uint16_t>(fromLittleEndian(parameters.subspan(width)));
            const auto bytes = memory_.read(address, count);
            status.data = bytes.value_or(std::vector<std::uint8_t>{});
            return bytes ? std::uint8_t{0} : errorOf(ServoMemory::Refusal::Access);
        }
        case DynamixelInstruction::Write:
            return hasAddress ? write(address, parameters.subspan(width), now) : errorOf(ServoMemory::Refusal::Length);
        case DynamixelInstruction::RegWrite: {
            const auto refusal =
                hasAddress ? memory_.check(address, parameters.subspan(width)) : ServoMemory::Refusal::Length;
            if (refusal == ServoMemory::Refusal::None)
                registered_ = request;
            return errorOf(refusal);
        }
        case DynamixelInstruction::Action: {
            if (!registered_)
                return unknownInstruction();
            DynamixelPacket kept = *registered_;
            registered_.reset();
            kept.code = static_cast<std::uint8_t>(DynamixelInstruction::Write);
            return perform(kept, status, now);
        }
        case DynamixelInstruction::Reboot:
            return kind_.protocol == DynamixelProtocol::Two ? reboot(now) : unknownInstruction();
        case DynamixelInstruction::Status:
        case DynamixelInstruction::SyncRead:
        case DynamixelInstruction::SyncWrite:
            break;
    }
    return unknownInstruction();
}

std::uint8_t ServoBody::ping(DynamixelStatus& status)
{
    if (kind_.protocol == DynamixelProtocol::Two) {
        status.data = littleEndian(kind_.model, 2);
        status.data.push_back(memory_.read(6, 1)->front());
    }
    return 0;
}

std::optional<DynamixelStatus> ServoBody::readFor(std::uint16_t first, std::uint16_t count, Time now)
{
    if (!hasPower(now))
        return std::nullopt;
    wakeUp(now);
    refresh(now);
    DynamixelStatus status{id(), alarmByte(), {}};
    if (auto bytes = memory_.read(first, count))
        status.data = std::move(*bytes);
    else
        status.error |= errorOf(ServoMemory::Refusal::Access);
    return status;
}

void ServoBody::writeFor(std::uint16_t first, std::span<const std::uint8_t> bytes, Time now)
{
    if (!hasPower(now))
        return;
    wakeUp(now);
    write(first, bytes, now);
}

std::uint8_t ServoBody::write(std::uint16_t first, std::span<const std::uint8_t> bytes, Time now)
{
    const ServoMemory::Refusal refusal = memory_.check(first, bytes);
    if (refusal != ServoMemory::Refusal::None)
        return errorOf(refusal);
    memory_.write(first, bytes);
    const auto touches = [&](ServoRole role) { return memory_.touches(role, first, bytes.size()); };
    // 1.0: a goal brings the torque with it.
    if (kind_.protocol == DynamixelProtocol::One && touches(ServoRole::Goal))
        memory_.set(ServoRole::TorqueEnable, 1);
    if (touches(ServoRole::TorqueLimit) && memory_.value(ServoRole::TorqueLimit) != 0)
        isOverloaded_ = false;
    if (touches(ServoRole::Goal) || touches(ServoRole::Speed) || touches(ServoRole::TorqueEnable) ||
        touches(ServoRole::TorqueLimit) || touches(ServoRole::OperatingMode))
        drive(now);
    return 0;
}

std::uint8_t ServoBody::reboot(Time now)
{
    motor_.block(now);
    powerFrom_ = now + kReboot;
    wasReset_ = true;
    return 0;
}

}  // namespace planewright
