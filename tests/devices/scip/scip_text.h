// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "devices/scip/scip_decoder.h"

namespace planewright {

// A twin of the codec in its plainest form, for tests: written from the specification alone, without the product's
// code.

inline std::span<const std::uint8_t> bytesOf(std::string_view text)
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

inline std::vector<ScipEvent> decode(std::string_view text)
{
    ScipDecoder decoder;
    return decoder.push(bytesOf(text));
}

template <class Event>
std::vector<Event> only(const std::vector<ScipEvent>& events)
{
    std::vector<Event> found;
    for (const ScipEvent& event : events) {
        if (const auto* const one = std::get_if<Event>(&event))
            found.push_back(*one);
    }
    return found;
}

inline char plainSum(std::string_view text)
{
    int sum = 0;
    for (const char c : text)
        sum = (sum + (c & 0xFF)) % 64;
    return static_cast<char>('0' + sum);
}

inline std::string plainNumber(std::uint32_t value, int characters)
{
    std::string text;
    for (int i = 0; i < characters; ++i, value /= 64)
        text.insert(text.begin(), static_cast<char>('0' + value % 64));
    return text;
}

inline std::string withPlainSum(const std::string& text)
{
    return text + plainSum(text);
}

/// Characters as lines of 64 and their sums, one by one.
inline std::string plainBlock(const std::string& payload)
{
    std::string lines;
    std::string line;
    for (const char c : payload) {
        line += c;
        if (line.size() == 64) {
            lines += withPlainSum(line) + '\n';
            line.clear();
        }
    }
    return line.empty() ? lines : lines + withPlainSum(line) + '\n';
}

inline std::string plainFrame(const std::string& echo, std::uint32_t stamp, const std::string& payload)
{
    return echo + "\n99b\n" + withPlainSum(plainNumber(stamp, 4)) + '\n' + plainBlock(payload) + '\n';
}

/// A scan of MD.
inline std::string plainScan(const std::string& echo, std::uint32_t stamp, const std::vector<std::uint32_t>& ranges)
{
    std::string payload;
    for (const std::uint32_t range : ranges)
        payload += plainNumber(range, 3);
    return plainFrame(echo, stamp, payload);
}

/// The numbers of three characters of a scan that is known to be whole.
inline std::vector<std::uint32_t> plainValues(std::string_view frame)
{
    for (int line = 0; line < 3; ++line)
        frame.remove_prefix(frame.find('\n') + 1);
    std::string payload;
    while (frame.front() != '\n') {
        const std::size_t end = frame.find('\n');
        payload += frame.substr(0, end - 1);
        frame.remove_prefix(end + 1);
    }
    std::vector<std::uint32_t> values;
    for (std::size_t at = 0; at + 2 < payload.size(); at += 3)
        values.push_back(static_cast<std::uint32_t>((payload[at] - '0') * 4096 + (payload[at + 1] - '0') * 64 +
                                                    (payload[at + 2] - '0')));
    return values;
}

}  // namespace planewright
