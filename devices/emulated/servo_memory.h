// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "devices/emulated/servo_kind.h"

namespace planewright {

/// The control table of an emulated servo: what may be read, what may be written, and what is left when the power goes.
class ServoMemory {
public:
    explicit ServoMemory(const EmulatedServoKind& kind);

    /// Everything behind the first RAM address is as it is when the power comes; the torque limit is that of the
    /// EEPROM.
    void powerOn();

    std::uint32_t value(ServoRole role) const;
    std::int32_t signedValue(ServoRole role) const;
    bool has(ServoRole role) const;
    /// As the servo itself sets it: no rule stands in the way.
    void set(ServoRole role, std::uint32_t value);
    /// The value at an address, as if it had been written before.
    void preset(std::uint16_t address, std::uint32_t value);

    /// Bytes from an address on; empty where the table does not have all of them. In 1.0 a gap inside the table reads
    /// as 0.
    std::optional<std::vector<std::uint8_t>> read(std::uint16_t first, std::uint16_t count) const;

    enum class Refusal { None, Range, Limit, Length, Access };
    /// Whether bytes may be written from an address on, all or none.
    Refusal check(std::uint16_t first, std::span<const std::uint8_t> bytes) const;
    /// Writes bytes that check() has allowed. A locked EEPROM keeps what it has.
    void write(std::uint16_t first, std::span<const std::uint8_t> bytes);
    /// True where the value of a role lies in these bytes.
    bool touches(ServoRole role, std::uint16_t first, std::size_t count) const;

private:
    const ServoRule* rule(ServoRole role) const;
    std::uint32_t valueAt(const ServoRule& rule) const;
    void setAt(const ServoRule& rule, std::uint32_t value);
    Refusal checkValue(const ServoRule& rule, std::uint32_t value) const;

    const EmulatedServoKind& kind_;
    std::array<std::uint8_t, 256> bytes_{};
};

}  // namespace planewright
