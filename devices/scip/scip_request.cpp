// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_request.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace planewright {

namespace {

struct Command {
    std::string_view name;
    std::size_t digits;
};

constexpr std::size_t kStreamDigits = 4 + 4 + 2 + 1 + 2;
constexpr std::size_t kLatestDigits = 4 + 4 + 2;

// The longer names first: all others have two letters.
constexpr auto kCommands = std::to_array<Command>({
    {kScipSpeak2, 0},
    {"%SL", 0},
    {"%ST", 0},
    {"VV", 0},
    {"PP", 0},
    {"II", 0},
    {"BM", 0},
    {"QT", 0},
    {"RS", 0},
    {"RT", 0},
    {"RB", 0},
    {"TM", 1},
    {"SS", 6},
    {"CR", 2},
    {"HS", 1},
    {"DB", 2},
    {"MD", kStreamDigits},
    {"MS", kStreamDigits},
    {"ME", kStreamDigits},
    {"ND", kStreamDigits},
    {"NE", kStreamDigits},
    {"GD", kLatestDigits},
    {"GS", kLatestDigits},
    {"GE", kLatestDigits},
    {"HD", kLatestDigits},
    {"HE", kLatestDigits},
});

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// A number in exactly so many decimal digits.
std::string digits(int value, std::size_t width)
{
    std::string text = std::to_string(value);
    assert(value >= 0 && text.size() <= width);
    return std::string(width - text.size(), '0') + text;
}

/// Takes so many digits off a text of digits.
int takeNumber(std::string_view& text, std::size_t width)
{
    int value = 0;
    for (const char c : text.substr(0, width))
        value = 10 * value + (c - '0');
    text.remove_prefix(width);
    return value;
}

}  // namespace

std::string scipLineSpeed(int bitsPerSecond)
{
    return "SS" + digits(bitsPerSecond, 6);
}

std::string scipMotorSpeed(int speed)
{
    return "CR" + digits(speed, 2);
}

std::string scipSensitivity(bool high)
{
    return high ? "HS1" : "HS0";
}

std::string scipSimulatedFault(int number)
{
    return "DB" + digits(number, 2);
}

std::string withScipTag(std::string_view request, std::string_view tag)
{
    assert(isScipTag(tag));
    return std::string{request} + ';' + std::string{tag};
}

int ScipMeasurement::values() const
{
    return (last - first) / std::max(1, cluster) + 1;
}

std::string scipRequest(const ScipMeasurement& measurement)
{
    std::string text = measurement.command + digits(measurement.first, 4) + digits(measurement.last, 4) +
                       digits(measurement.cluster, 2);
    if (measurement.isStream())
        text += digits(measurement.interval, 1) + digits(measurement.count, 2);
    return text;
}

std::optional<ScipEcho> readScipEcho(std::string_view line)
{
    const auto* const command = std::find_if(kCommands.begin(), kCommands.end(),
                                             [&](const Command& known) { return line.starts_with(known.name); });
    if (command == kCommands.end())
        return std::nullopt;
    ScipEcho echo{line.substr(0, command->name.size()), line.substr(command->name.size()), {}};
    if (const std::size_t semicolon = echo.parameters.find(';'); semicolon != std::string_view::npos) {
        echo.tag = echo.parameters.substr(semicolon + 1);
        echo.parameters = echo.parameters.substr(0, semicolon);
        if (!isScipTag(echo.tag))
            return std::nullopt;
    }
    if (echo.parameters.size() > kStreamDigits + 3 ||
        !std::all_of(echo.parameters.begin(), echo.parameters.end(), isDigit))
        return std::nullopt;
    return echo;
}

std::optional<std::size_t> scipParameterLength(std::string_view command)
{
    const auto* const known =
        std::find_if(kCommands.begin(), kCommands.end(), [&](const Command& c) { return c.name == command; });
    return known == kCommands.end() ? std::nullopt : std::optional{known->digits};
}

std::optional<ScipMeasurement> readScipMeasurement(const ScipEcho& echo)
{
    const std::size_t length = scipParameterLength(echo.command).value_or(0);
    if ((length != kStreamDigits && length != kLatestDigits) || echo.parameters.size() != length ||
        !std::all_of(echo.parameters.begin(), echo.parameters.end(), isDigit))
        return std::nullopt;
    std::string_view rest = echo.parameters;
    ScipMeasurement measurement;
    measurement.command = echo.command;
    measurement.first = takeNumber(rest, 4);
    measurement.last = takeNumber(rest, 4);
    measurement.cluster = takeNumber(rest, 2);
    if (measurement.isStream()) {
        measurement.interval = takeNumber(rest, 1);
        measurement.count = takeNumber(rest, 2);
    }
    if (measurement.last < measurement.first)
        return std::nullopt;
    return measurement;
}

bool isScipTag(std::string_view text)
{
    const auto isAllowed = [](char c) {
        return isDigit(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
               std::string_view{" ._+@"}.find(c) != std::string_view::npos;
    };
    return !text.empty() && text.size() <= kScipTagLength && std::all_of(text.begin(), text.end(), isAllowed);
}

}  // namespace planewright
