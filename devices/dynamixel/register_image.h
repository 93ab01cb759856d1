// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "devices/dynamixel/control_table.h"

namespace planewright {

/// The bytes of a control table as far as they are known.
class RegisterImage {
public:
    static constexpr std::size_t kBytes = 256;

    /// Bytes from an address on; what lies beyond the table is left out.
    void store(std::uint16_t first, std::span<const std::uint8_t> bytes);
    std::span<const std::uint8_t> bytes(std::uint16_t first, std::size_t count) const;

    /// Values of a register; 0 where the table has none.
    std::uint32_t value(const ServoRegister& place) const;
    /// The same in two's complement.
    std::int32_t signedValue(const ServoRegister& place) const;

private:
    std::array<std::uint8_t, kBytes> bytes_{};
};

}  // namespace planewright
