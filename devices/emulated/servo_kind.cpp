// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/servo_kind.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "core/types/angle.h"

namespace planewright {

namespace {

using Role = ServoRole;

constexpr double rpm(double turns)
{
    return turns * 2.0 * std::numbers::pi / 60.0;
}

constexpr ServoRule shown(std::uint16_t address, std::uint8_t size, std::uint32_t initial, Role role = Role::None)
{
    return {address, size, false, 0, 0, initial, role};
}

constexpr ServoRule set(std::uint16_t address, std::uint8_t size, std::int64_t lowest, std::int64_t highest,
                        std::uint32_t initial, Role role = Role::None)
{
    return {address, size, true, lowest, highest, initial, role};
}

constexpr auto kRulesRx64 = std::to_array<ServoRule>({
    shown(0, 2, 64),
    shown(2, 1, 24),
    set(3, 1, 0, 253, 1, Role::Id),
    set(4, 1, 0, 254, 34),
    set(5, 1, 0, 254, 250, Role::ReturnDelay),
    set(6, 2, 0, 1023, 0, Role::LowestGoal),
    set(8, 2, 0, 1023, 1023, Role::HighestGoal),
    set(11, 1, 0, 150, 80, Role::TemperatureLimit),
    set(12, 1, 50, 250, 60, Role::LowestVoltage),
    set(13, 1, 50, 250, 190, Role::HighestVoltage),
    set(14, 2, 0, 1023, 1023, Role::MaxTorque),
    set(16, 1, 0, 2, 2, Role::ReturnLevel),
    set(17, 1, 0, 127, 36),
    set(18, 1, 0, 127, 36, Role::Shutdown),
    set(24, 1, 0, 1, 0, Role::TorqueEnable),
    set(25, 1, 0, 1, 0),
    set(26, 1, 0, 254, 1),
    set(27, 1, 0, 254, 1),
    set(28, 1, 1, 254, 32),
    set(29, 1, 1, 254, 32),
    set(30, 2, 0, 1023, 0, Role::Goal),
    set(32, 2, 0, 1023, 0, Role::Speed),
    set(34, 2, 0, 1023, 1023, Role::TorqueLimit),
    shown(36, 2, 0, Role::Position),
    shown(38, 2, 0, Role::PresentSpeed),
    shown(40, 2, 0, Role::Load),
    shown(42, 1, 0, Role::Voltage),
    shown(43, 1, 0, Role::Temperature),
    shown(44, 1, 0, Role::Registered),
    shown(46, 1, 0, Role::Moving),
    set(47, 1, 0, 1, 0, Role::Lock),
    set(48, 2, 0, 1023, 32),
});

/// The same table, with the limits of a smaller servo.
constexpr auto makeRulesAx12()
{
    auto rules = kRulesRx64;
    for (ServoRule& rule : rules) {
        if (rule.address == 0)
            rule.initial = 12;
        if (rule.address == 4)
            rule.initial = 1;
        if (rule.role == Role::TemperatureLimit)
            rule.initial = 70;
        if (rule.role == Role::HighestVoltage)
            rule.initial = 140;
    }
    return rules;
}

constexpr auto kRulesAx12 = makeRulesAx12();

constexpr auto kRulesMx28 = std::to_array<ServoRule>({
    shown(0, 2, 29),
    shown(2, 1, 36),
    set(3, 1, 0, 253, 1, Role::Id),
    set(4, 1, 0, 254, 34),
    set(5, 1, 0, 254, 250, Role::ReturnDelay),
    set(6, 2, 0, 4095, 0, Role::LowestGoal),
    set(8, 2, 0, 4095, 4095, Role::HighestGoal),
    set(11, 1, 0, 99, 80, Role::TemperatureLimit),
    set(12, 1, 50, 160, 60, Role::LowestVoltage),
    set(13, 1, 50, 160, 160, Role::HighestVoltage),
    set(14, 2, 0, 1023, 1023, Role::MaxTorque),
    set(16, 1, 0, 2, 2, Role::ReturnLevel),
    set(17, 1, 0, 127, 36),
    set(18, 1, 0, 127, 36, Role::Shutdown),
    set(20, 2, 0, 65535, 0),
    set(22, 1, 1, 4, 1),
    set(24, 1, 0, 1, 0, Role::TorqueEnable),
    set(25, 1, 0, 1, 0),
    set(26, 1, 0, 254, 0),
    set(27, 1, 0, 254, 0),
    set(28, 1, 0, 254, 32),
    set(30, 2, 0, 4095, 0, Role::Goal),
    set(32, 2, 0, 1023, 0, Role::Speed),
    set(34, 2, 0, 1023, 1023, Role::TorqueLimit),
    shown(36, 2, 0, Role::Position),
    shown(38, 2, 0, Role::PresentSpeed),
    shown(40, 2, 0, Role::Load),
    shown(42, 1, 0, Role::Voltage),
    shown(43, 1, 0, Role::Temperature),
    shown(44, 1, 0, Role::Registered),
    shown(46, 1, 0, Role::Moving),
    set(47, 1, 0, 1, 0, Role::Lock),
    set(48, 2, 0, 1023, 0),
    shown(50, 2, 0, Role::Tick),
    set(73, 1, 0, 254, 0),
});

constexpr std::int64_t kPulses = 1'044'479;

constexpr auto kRulesXm430 = std::to_array<ServoRule>({
    shown(0, 2, 1020),
    shown(2, 4, 0),
    shown(6, 1, 45),
    set(7, 1, 0, 252, 1, Role::Id),
    set(8, 1, 0, 7, 1),
    set(9, 1, 0, 254, 250, Role::ReturnDelay),
    set(10, 1, 0, 5, 0),
    set(11, 1, 0, 16, 3, Role::OperatingMode),
    set(12, 1, 0, 255, 255),
    set(13, 1, 1, 2, 2),
    set(20, 4, -kPulses, kPulses, 0),
    set(24, 4, 0, 1023, 10),
    set(31, 1, 0, 100, 80, Role::TemperatureLimit),
    set(32, 2, 95, 160, 160, Role::HighestVoltage),
    set(34, 2, 95, 160, 95, Role::LowestVoltage),
    set(36, 2, 0, 885, 885),
    set(38, 2, 0, 1193, 1193),
    set(40, 4, 0, 32767, 32767),
    set(44, 4, 0, 1023, 350),
    set(48, 4, 0, 4095, 4095, Role::HighestGoal),
    set(52, 4, 0, 4095, 0, Role::LowestGoal),
    set(63, 1, 0, 63, 52, Role::Shutdown),
    set(64, 1, 0, 1, 0, Role::TorqueEnable),
    set(65, 1, 0, 1, 0),
    set(68, 1, 0, 2, 2, Role::ReturnLevel),
    shown(69, 1, 0, Role::Registered),
    shown(70, 1, 0, Role::HardwareError),
    set(76, 2, 0, 16383, 1920),
    set(78, 2, 0, 16383, 100),
    set(80, 2, 0, 16383, 0),
    set(82, 2, 0, 16383, 0),
    set(84, 2, 0, 16383, 800),
    set(88, 2, 0, 16383, 0),
    set(90, 2, 0, 16383, 0),
    set(98, 1, 0, 127, 0, Role::Watchdog),
    set(100, 2, -885, 885, 885),
    set(102, 2, -1193, 1193, 1193),
    set(104, 4, -350, 350, 350),
    set(108, 4, 0, 32767, 0),
    set(112, 4, 0, 32767, 0, Role::Speed),
    set(116, 4, 0, 4095, 0, Role::Goal),
    shown(120, 2, 0, Role::Tick),
    shown(122, 1, 0, Role::Moving),
    shown(123, 1, 0),
    shown(124, 2, 0),
    shown(126, 2, 0, Role::Load),
    shown(128, 4, 0, Role::PresentSpeed),
    shown(132, 4, 0, Role::Position),
    shown(136, 4, 0),
    shown(140, 4, 0),
    shown(144, 2, 0, Role::Voltage),
    shown(146, 1, 0, Role::Temperature),
});

constexpr DynamixelProtocol kOne = DynamixelProtocol::One;
constexpr DynamixelProtocol kTwo = DynamixelProtocol::Two;
constexpr double kPotentiometer = degrees(300.0) / 1023.0;
constexpr double kEncoder = degrees(360.0) / 4096.0;

constexpr auto kServoKinds = std::to_array<EmulatedServoKind>({
    {64, "RX-64", kOne, kRulesRx64, 24, 50, 1023, 512, kPotentiometer, rpm(0.111), rpm(64.0), 148, 1023, 64},
    {12, "AX-12", kOne, kRulesAx12, 24, 50, 1023, 512, kPotentiometer, rpm(0.111), rpm(59.0), 120, 1023, 96},
    {29, "MX-28", kOne, kRulesMx28, 24, 74, 4095, 2048, kEncoder, rpm(0.114), rpm(55.0), 120, 1023, 80},
    {1020, "XM430-W350", kTwo, kRulesXm430, 64, 147, 4095, 2048, kEncoder, rpm(0.229), rpm(46.0), 120, 1193, 60},
});

}  // namespace

std::span<const EmulatedServoKind> emulatedServoKinds()
{
    return kServoKinds;
}

const EmulatedServoKind* findEmulatedServoKind(std::uint16_t model)
{
    const auto found = std::find_if(kServoKinds.begin(), kServoKinds.end(),
                                    [&](const EmulatedServoKind& kind) { return kind.model == model; });
    return found == kServoKinds.end() ? nullptr : &*found;
}

std::string knownEmulatedServoKinds()
{
    std::string text;
    for (const EmulatedServoKind& kind : kServoKinds)
        text += (text.empty() ? "" : ", ") + std::string{kind.name} + " (" + std::to_string(kind.model) + ")";
    return text;
}

}  // namespace planewright
