// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string>

namespace planewright {

/// Appends the bytes of a number, the lowest first, on whatever machine.
template <class Number>
void appendLittleEndian(std::string& bytes, Number value)
{
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    if constexpr (std::endian::native == std::endian::big)
        std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

}  // namespace planewright
