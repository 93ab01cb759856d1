// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/address_text.h"

#include <algorithm>
#include <vector>

namespace planewright {

std::string_view takeOptions(std::string_view& address)
{
    const std::size_t mark = address.rfind('?');
    if (mark == std::string_view::npos)
        return {};
    const std::string_view options = address.substr(mark + 1);
    address = address.substr(0, mark);
    return options;
}

std::string readOptions(std::string_view options,
                        const std::function<std::string(std::string_view key, std::string_view value)>& take)
{
    std::vector<std::string_view> keys;
    while (!options.empty()) {
        const std::size_t end = std::min(options.find('&'), options.size());
        const std::string_view option = options.substr(0, end);
        options.remove_prefix(std::min(end + 1, options.size()));
        const std::size_t equals = std::min(option.find('='), option.size());
        const std::string_view key = option.substr(0, equals);
        if (std::find(keys.begin(), keys.end(), key) != keys.end())
            return "the option '" + std::string{key} + "' is given twice";
        keys.push_back(key);
        if (std::string problem = take(key, option.substr(std::min(equals + 1, option.size()))); !problem.empty())
            return problem;
    }
    return {};
}

std::string readHostAndPort(std::string_view text, std::uint16_t lowestPort, std::string& host, std::uint16_t& port)
{
    const std::string_view all = text;
    if (text.starts_with('[')) {
        const std::size_t end = text.find(']');
        if (end == std::string_view::npos)
            return "the bracket of the host is not closed";
        host = text.substr(1, end - 1);
        text.remove_prefix(end + 1);
        if (host.find(':') == std::string::npos)
            return "in brackets stands a number with colons, as in [fe80::1]:10940";
    } else {
        const std::size_t colon = std::min(text.find(':'), text.size());
        host = text.substr(0, colon);
        text.remove_prefix(colon);
        if (!text.empty() && text.find(':', 1) != std::string_view::npos)
            return "put a host with colons into brackets, as in [" + std::string{all} + "]:10940";
    }
    if (host.empty())
        return "give a host and a port, as in 192.168.0.10:10940";
    if (!text.starts_with(':'))
        return "give a port, too, as in " + std::string{all} + ":10940";
    return readPort(text.substr(1), lowestPort, port);
}

std::string readPort(std::string_view text, std::uint16_t lowestPort, std::uint16_t& port)
{
    if (readsNumber(text, port) && port >= lowestPort)
        return {};
    return "port '" + std::string{text} + "' is not a whole number from " + std::to_string(lowestPort) + " to 65535";
}

}  // namespace planewright
