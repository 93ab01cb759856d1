// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <string_view>

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

/// A number from its bytes, the lowest first; there must be as many as it has.
template <class Number>
Number readLittleEndian(std::string_view bytes)
{
    std::array<char, sizeof(Number)> raw{};
    std::copy_n(bytes.begin(), raw.size(), raw.begin());
    if constexpr (std::endian::native == std::endian::big)
        std::reverse(raw.begin(), raw.end());
    return std::bit_cast<Number>(raw);
}

}  // namespace planewright
