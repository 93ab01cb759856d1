// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/source_address.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <vector>

#include "devices/pacer.h"

namespace planewright {

namespace {

constexpr std::string_view kSimulation = "sim:";
constexpr std::string_view kReplay = "replay:";
/// Kinds that files are not taken for.
constexpr std::array<std::string_view, 5> kDevices{"usb:", "tcp:", "serial:", "dynamixel:", "board:"};

template <class Number>
bool reads(std::string_view text, Number& number)
{
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size();
}

/// Sets what one KEY=VALUE says; gives what is wrong with it, or nothing.
std::string takeOption(std::string_view option, SourceAddress& address)
{
    const std::size_t equals = std::min(option.find('='), option.size());
    const std::string_view key = option.substr(0, equals);
    const std::string value{option.substr(std::min(equals + 1, option.size()))};
    if (key == "seed" && address.kind == SourceAddress::Kind::Simulation) {
        if (!reads(value, address.seed))
            return "seed '" + value + "' is not a whole number from 0 to 18446744073709551615";
    } else if (key == "speed") {
        if (!reads(value, address.speed) || !isReplaySpeed(address.speed))
            return "speed '" + value + "' is not 0, as fast as possible, or a number from 0.01 to 1000";
    } else {
        return "there is no option '" + std::string{key} +
               "'; known: " + (address.kind == SourceAddress::Kind::Simulation ? "seed, speed" : "speed");
    }
    return {};
}

std::string takeOptions(std::string_view options, SourceAddress& address)
{
    std::vector<std::string_view> keys;
    while (!options.empty()) {
        const std::size_t end = std::min(options.find('&'), options.size());
        const std::string_view option = options.substr(0, end);
        options.remove_prefix(std::min(end + 1, options.size()));
        const std::string_view key = option.substr(0, option.find('='));
        if (std::find(keys.begin(), keys.end(), key) != keys.end())
            return "the option '" + std::string{key} + "' is given twice";
        keys.push_back(key);
        if (std::string problem = takeOption(option, address); !problem.empty())
            return problem;
    }
    return {};
}

}  // namespace

Result<SourceAddress> parseSourceAddress(const std::string& text)
{
    const auto refuse = [&](const std::string& why) { return fail(ErrorCode::Usage, "'" + text + "': " + why); };
    for (const std::string_view device : kDevices) {
        if (text.starts_with(device))
            return refuse("this version knows no scanners yet; give sim:SCENE, replay:FILE or a file");
    }
    SourceAddress address;
    std::string_view rest = text;
    if (rest.starts_with(kSimulation)) {
        address.kind = SourceAddress::Kind::Simulation;
        rest.remove_prefix(kSimulation.size());
    } else if (rest.starts_with(kReplay)) {
        address.kind = SourceAddress::Kind::Replay;
        rest.remove_prefix(kReplay.size());
    }
    if (address.kind != SourceAddress::Kind::File) {
        const std::size_t mark = rest.rfind('?');
        if (mark != std::string_view::npos) {
            if (const std::string problem = takeOptions(rest.substr(mark + 1), address); !problem.empty())
                return refuse(problem);
            rest = rest.substr(0, mark);
        }
    }
    if (rest.empty())
        return refuse(address.kind == SourceAddress::Kind::Simulation ? "give a scene, as in sim:corridor"
                                                                      : "give the name of a file");
    address.name = rest;
    return address;
}

}  // namespace planewright
