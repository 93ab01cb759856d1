// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/servo_memory.h"

#include <algorithm>
#include <cassert>

#include "devices/dynamixel/requests.h"

namespace planewright {

namespace {

constexpr std::uint32_t kWatchdogBit = 255;  // it has bitten

std::int32_t inTwosComplement(std::uint32_t value, int size)
{
    if (size >= 4)
        return static_cast<std::int32_t>(value);
    const std::uint32_t sign = 1U << (8 * size - 1);
    return static_cast<std::int32_t>(value ^ sign) - static_cast<std::int32_t>(sign);
}

}  // namespace

ServoMemory::ServoMemory(const EmulatedServoKind& kind) : kind_(kind)
{
    for (const ServoRule& rule : kind_.rules)
        setAt(rule, rule.initial);
    powerOn();
}

void ServoMemory::powerOn()
{
    for (const ServoRule& rule : kind_.rules) {
        if (rule.address >= kind_.firstRam)
            setAt(rule, rule.initial);
    }
    if (has(ServoRole::TorqueLimit))
        set(ServoRole::TorqueLimit, value(ServoRole::MaxTorque));
}

const ServoRule* ServoMemory::rule(ServoRole role) const
{
    const auto found = std::find_if(kind_.rules.begin(), kind_.rules.end(),
                                    [&](const ServoRule& candidate) { return candidate.role == role; });
    return found == kind_.rules.end() ? nullptr : &*found;
}

bool ServoMemory::has(ServoRole role) const
{
    return rule(role) != nullptr;
}

std::uint32_t ServoMemory::value(ServoRole role) const
{
    const ServoRule* found = rule(role);
    return found == nullptr ? 0 : valueAt(*found);
}

std::int32_t ServoMemory::signedValue(ServoRole role) const
{
    const ServoRule* found = rule(role);
    return found == nullptr ? 0 : inTwosComplement(valueAt(*found), found->size);
}

void ServoMemory::set(ServoRole role, std::uint32_t value)
{
    if (const ServoRule* found = rule(role))
        setAt(*found, value);
}

void ServoMemory::preset(std::uint16_t address, std::uint32_t value)
{
    for (const ServoRule& rule : kind_.rules) {
        if (rule.address == address)
            setAt(rule, value);
    }
}

std::uint32_t ServoMemory::valueAt(const ServoRule& rule) const
{
    return fromLittleEndian(std::span{bytes_}.subspan(rule.address, rule.size));
}

void ServoMemory::setAt(const ServoRule& rule, std::uint32_t value)
{
    const std::vector<std::uint8_t> bytes = littleEndian(value, rule.size);
    std::copy(bytes.begin(), bytes.end(), bytes_.begin() + rule.address);
}

std::optional<std::vector<std::uint8_t>> ServoMemory::read(std::uint16_t first, std::uint16_t count) const
{
    if (count == 0 || first + count > kind_.end)
        return std::nullopt;
    const auto isDefined = [&](int address) {
        return std::any_of(kind_.rules.begin(), kind_.rules.end(), [&](const ServoRule& rule) {
            return address >= rule.address && address < rule.address + rule.size;
        });
    };
    for (int i = 0; i < count; ++i) {
        if (kind_.protocol == DynamixelProtocol::Two && !isDefined(first + i))
            return std::nullopt;
    }
    return std::vector<std::uint8_t>(bytes_.begin() + first, bytes_.begin() + first + count);
}

ServoMemory::Refusal ServoMemory::check(std::uint16_t first, std::span<const std::uint8_t> bytes) const
{
    if (bytes.empty() || first + bytes.size() > kind_.end)
        return kind_.protocol == DynamixelProtocol::One ? Refusal::Range : Refusal::Access;
    std::array<std::uint8_t, 256> after = bytes_;
    std::copy(bytes.begin(), bytes.end(), after.begin() + first);
    std::size_t covered = 0;
    for (const ServoRule& rule : kind_.rules) {
        const int begin = std::max<int>(rule.address, first);
        const int end = std::min<int>(rule.address + rule.size, first + static_cast<int>(bytes.size()));
        if (begin >= end)
            continue;
        covered += static_cast<std::size_t>(end - begin);
        if (!rule.isWritable)
            return Refusal::Access;
        if (kind_.protocol == DynamixelProtocol::Two && end - begin < rule.size)
            return Refusal::Length;
        const Refusal refusal = checkValue(rule, fromLittleEndian(std::span{after}.subspan(rule.address, rule.size)));
        if (refusal != Refusal::None)
            return refusal;
        const bool isProtected = kind_.protocol == DynamixelProtocol::Two && rule.address < kind_.firstRam;
        if (isProtected && value(ServoRole::TorqueEnable) != 0)
            return Refusal::Access;
    }
    return covered == bytes.size() ? Refusal::None : Refusal::Access;
}

ServoMemory::Refusal ServoMemory::checkValue(const ServoRule& rule, std::uint32_t value) const
{
    const std::int64_t number = rule.lowest < 0 ? inTwosComplement(value, rule.size) : std::int64_t{value};
    if (number < rule.lowest || number > rule.highest)
        return Refusal::Range;
    const std::int64_t low = this->value(ServoRole::LowestGoal);
    const std::int64_t high = this->value(ServoRole::HighestGoal);
    const bool isWheel = kind_.protocol == DynamixelProtocol::One && low == 0 && high == 0;
    if (rule.role == ServoRole::Goal && this->value(ServoRole::Watchdog) == kWatchdogBit)
        return Refusal::Range;
    if (rule.role == ServoRole::Goal && !isWheel && (number < low || number > high))
        return Refusal::Limit;
    return Refusal::None;
}

void ServoMemory::write(std::uint16_t first, std::span<const std::uint8_t> bytes)
{
    assert(check(first, bytes) == Refusal::None);
    const bool wasLocked = value(ServoRole::Lock) != 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const std::size_t address = first + i;
        if (!wasLocked || address >= kind_.firstRam)
            bytes_[address] = bytes[i];
    }
    if (wasLocked)
        set(ServoRole::Lock, 1);
}

bool ServoMemory::touches(ServoRole role, std::uint16_t first, std::size_t count) const
{
    const ServoRule* found = rule(role);
    return found != nullptr && found->address < first + count && first < found->address + found->size;
}

}  // namespace planewright
