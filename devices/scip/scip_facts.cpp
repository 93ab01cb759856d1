// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_facts.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "devices/scip/scip_encoding.h"

namespace planewright {

namespace {

std::string_view trimmed(std::string_view text)
{
    const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
    const std::size_t end = text.find_last_not_of(' ');
    return end == std::string_view::npos ? std::string_view{} : text.substr(begin, end - begin + 1);
}

template <class Number>
std::optional<Number> number(std::string_view text, int base = 10)
{
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (error != std::errc{} || end != text.data() + text.size() || text.empty())
        return std::nullopt;
    return value;
}

std::optional<std::uint32_t> readTime(std::string_view text)
{
    if (text.size() == 4)
        return fromScip(text);
    return text.size() == 6 ? number<std::uint32_t>(text, 16) : std::nullopt;
}

/// True where a text, in small letters, has one of the words.
template <std::size_t n>
bool hasOneOf(std::string_view text, const std::array<std::string_view, n>& words)
{
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

constexpr std::array<std::string_view, 3> kHealthyWords{"works well", "working normally", "no error"};
constexpr std::array<std::string_view, 4> kFaultyWords{"trouble", "malfunction", "error no", "abnormal"};

constexpr int kSlowestMotor = 60;  ///< turns a minute
constexpr int kFastestMotor = 60'000;
constexpr int kMostStepsPerTurn = 20'000;
constexpr int kMostStep = 9999;  ///< that a request can name
constexpr int kMostRange = (1 << 18) - 1;

}  // namespace

std::optional<std::string> scipField(const ScipReply& reply, std::string_view key)
{
    for (const ScipLine& line : reply.lines) {
        const std::string_view text = line.text;
        if (text.starts_with(key) && text.substr(key.size()).starts_with(':'))
            return std::string{trimmed(text.substr(key.size() + 1))};
    }
    return std::nullopt;
}

LaserIdentity readScipIdentity(const ScipReply& reply)
{
    const auto field = [&](std::string_view key) { return scipField(reply, key).value_or(""); };
    LaserIdentity identity;
    identity.vendor = field("VEND");
    identity.product = field("PROD");
    identity.firmware = field("FIRM");
    identity.protocol = field("PROT");
    identity.serial = field("SERI");
    return identity;
}

Result<LaserLimits> readScipLimits(const ScipReply& reply, const std::string& name)
{
    std::string wrong;
    const auto field = [&](std::string_view key, int least, int most) {
        const std::optional<std::string> text = scipField(reply, key);
        const std::optional<int> value = text ? number<int>(*text) : std::nullopt;
        if (value && *value >= least && *value <= most)
            return *value;
        wrong += (wrong.empty() ? "" : ", ") + std::string{key} + (text ? " = '" + *text + "'" : " missing");
        return least;
    };
    const int rangeMin = field("DMIN", 1, kMostRange);
    const int rangeMax = field("DMAX", rangeMin + 1, kMostRange);
    LaserLimits limits;
    limits.stepsPerTurn = field("ARES", 8, kMostStepsPerTurn);
    limits.firstStep = field("AMIN", 0, kMostStep);
    limits.lastStep = field("AMAX", limits.firstStep + 1, std::min(kMostStep, limits.firstStep + limits.stepsPerTurn));
    limits.frontStep = field("AFRT", limits.firstStep, limits.lastStep);
    const int turnsPerMinute = field("SCAN", kSlowestMotor, kFastestMotor);
    if (!scipField(reply, "MODL"))
        wrong += (wrong.empty() ? "" : ", ") + std::string{"MODL missing"};
    if (!wrong.empty())
        return fail(ErrorCode::NoDevice, name + ": the laser says impossible things of itself (" + wrong +
                                             "); switch its power off and on, then connect again");
    limits.rangeMin = 0.001 * rangeMin;
    limits.rangeMax = 0.001 * rangeMax;
    limits.period = std::chrono::nanoseconds{std::chrono::minutes{1}} / turnsPerMinute;
    return limits;
}

ScipState readScipState(const ScipReply& reply)
{
    ScipState state;
    if (const std::optional<std::string> time = scipField(reply, "TIME"))
        state.clock = readTime(*time);
    state.condition = scipField(reply, "STAT").value_or("");
    std::string words = state.condition;
    std::transform(words.begin(), words.end(), words.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    state.isHealthy = hasOneOf(words, kHealthyWords);
    state.isFaulty = !state.isHealthy && hasOneOf(words, kFaultyWords);
    return state;
}

}  // namespace planewright
