// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_encoding.h"

#include <cassert>

namespace planewright {

char scipSum(std::string_view text)
{
    unsigned sum = 0;
    for (const char c : text)
        sum += static_cast<unsigned char>(c);
    return static_cast<char>((sum & 0x3FU) + 0x30U);
}

bool endsWithScipSum(std::string_view line)
{
    return line.size() >= 2 && line.back() == scipSum(line.substr(0, line.size() - 1));
}

std::string toScip(std::uint32_t value, int characters)
{
    assert(characters > 0 && characters <= 5 && value >> (6 * characters) == 0);
    std::string text(static_cast<std::size_t>(characters), '0');
    for (auto c = text.rbegin(); c != text.rend(); ++c, value >>= 6U)
        *c = static_cast<char>((value & 0x3FU) + 0x30U);
    return text;
}

std::optional<std::uint32_t> fromScip(std::string_view characters)
{
    if (characters.empty() || characters.size() > 5)
        return std::nullopt;
    std::uint32_t value = 0;
    for (const char c : characters) {
        if (!isScipDigit(c))
            return std::nullopt;
        value = (value << 6U) | static_cast<std::uint32_t>(c - 0x30);
    }
    return value;
}

std::string toScipBlock(std::string_view payload)
{
    std::string lines;
    lines.reserve(payload.size() + 2 * (payload.size() / kScipLineLength + 1));
    while (!payload.empty()) {
        const std::string_view line = payload.substr(0, kScipLineLength);
        lines += line;
        lines += scipSum(line);
        lines += '\n';
        payload.remove_prefix(line.size());
    }
    return lines;
}

}  // namespace planewright
