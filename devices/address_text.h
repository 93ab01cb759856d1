// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <charconv>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>

namespace planewright {

/// True where a text is a number of this type and nothing else.
template <class Number>
bool readsNumber(std::string_view text, Number& number)
{
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size();
}

/// Takes the options off an address: what stands behind the last '?', which goes, too. A name that has a '?' is given
/// with a '?' behind it.
std::string_view takeOptions(std::string_view& address);

/// Gives each KEY=VALUE of options that are joined by '&' to a function, which gives what is wrong with it, or nothing.
/// Gives the first of these, or that a key stands there twice, or nothing.
std::string readOptions(std::string_view options,
                        const std::function<std::string(std::string_view key, std::string_view value)>& take);

/// Reads HOST:PORT, where a host with colons stands in brackets. Gives what is wrong with it, or nothing. `lowestPort`
/// is 1, or 0 where that means any.
std::string readHostAndPort(std::string_view text, std::uint16_t lowestPort, std::string& host, std::uint16_t& port);

/// Reads a port by itself. Gives what is wrong with it, or nothing.
std::string readPort(std::string_view text, std::uint16_t lowestPort, std::uint16_t& port);

}  // namespace planewright
