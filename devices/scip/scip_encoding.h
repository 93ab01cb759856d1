// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace planewright {

/// Characters of a full line of data, its sum not counted (SCIP 2.0, "block transfer").
inline constexpr std::size_t kScipLineLength = 64;

/// The check character of a text: the low six bits of the sum of its bytes, plus 0x30.
char scipSum(std::string_view text);

/// True where the last character of a line is the sum of those before it; a line of less than two has none.
bool endsWithScipSum(std::string_view line);

/// True for the characters that numbers are written in, '0' (0x30) to 'o' (0x6F).
constexpr bool isScipDigit(char c)
{
    return c >= 0x30 && c <= 0x6F;
}

/// A number in `characters` characters of six bits each, the highest first. It must fit.
std::string toScip(std::uint32_t value, int characters);

/// The number that one to five characters stand for; empty where one of them is none of the alphabet.
std::optional<std::uint32_t> fromScip(std::string_view characters);

/// A block of data as lines: 64 characters, their sum and a line feed, the last line shorter. Values straddle lines.
std::string toScipBlock(std::string_view payload);

}  // namespace planewright
