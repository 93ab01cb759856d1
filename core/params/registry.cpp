// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/params/registry.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "core/params/parameter_rows.h"

namespace planewright {

namespace {

constexpr std::string_view unitName(Unit unit)
{
    switch (unit) {
        case Unit::Metre:
            return "m";
        case Unit::Angle:
            return "deg";
        default:
            return "";
    }
}

double toUserScale(Unit unit, double value)
{
    return unit == Unit::Angle ? toDegrees(value) : value;
}

double fromUserScale(Unit unit, double value)
{
    return unit == Unit::Angle ? degrees(value) : value;
}

/// Shortest text that reads back to nine significant digits.
std::string numberText(double value)
{
    char rounded[64];
    const auto roundedEnd = std::to_chars(rounded, rounded + sizeof rounded, value, std::chars_format::scientific, 8);
    double nine = 0.0;
    std::from_chars(rounded, roundedEnd.ptr, nine);
    char text[64];
    const auto textEnd = std::to_chars(text, text + sizeof text, nine);
    return {text, textEnd.ptr};
}

std::optional<double> readNumber(std::string_view text)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value + 0.0;  // -0 becomes 0
}

template <class Value>
std::vector<std::string_view> choicesOf()
{
    if constexpr (std::is_enum_v<Value>)
        return {ChoiceNames<Value>::names.begin(), ChoiceNames<Value>::names.end()};
    else if constexpr (std::is_same_v<Value, bool>)
        return {"false", "true"};
    else
        return {};
}

template <class Struct, class Value>
ParameterRow rowOf(const Parameter<Struct, Value>& parameter)
{
    // Ranges are written in degrees and kept in radians; the way back must not show 44.99999999999999.
    const auto shown = [&](double limit) { return *readNumber(numberText(toUserScale(parameter.unit, limit))); };
    return {parameter.key,
            parameter.unit,
            unitName(parameter.unit),
            shown(parameter.range.lowest),
            shown(parameter.range.highest),
            choicesOf<Value>(),
            parameter.symbol,
            parameter.meaning};
}

template <class Value>
std::string printValue(Unit unit, Value value)
{
    if constexpr (std::is_enum_v<Value> || std::is_same_v<Value, bool>)
        return std::string{choicesOf<Value>()[static_cast<std::size_t>(value)]};
    else
        return numberText(toUserScale(unit, static_cast<double>(value)));
}

std::string listOf(const std::vector<std::string_view>& words)
{
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i)
        list += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + std::string{words[i]};
    return list;
}

template <class Struct, class Value>
Result<void> setValue(const Parameter<Struct, Value>& parameter, Struct& target, std::string_view text)
{
    const ParameterRow row = rowOf(parameter);
    const auto refuse = [&] {
        return fail(ErrorCode::Usage, "parameter " + std::string{row.key} + ": '" + std::string{text} +
                                          "' is not allowed; give " + allowedValues(row));
    };
    if (!row.choices.empty()) {
        const auto word = std::find(row.choices.begin(), row.choices.end(), text);
        if (word == row.choices.end())
            return refuse();
        target.*(parameter.member) = static_cast<Value>(word - row.choices.begin());
        return {};
    }
    const auto number = readNumber(text);
    if (!number || *number < row.lowest || *number > row.highest)
        return refuse();
    if (row.unit == Unit::Count && *number != std::floor(*number))
        return refuse();
    target.*(parameter.member) = static_cast<Value>(fromUserScale(row.unit, *number));
    return {};
}

/// Calls visit(row, partOf) for every row of every part, in order; partOf(parameters) is the row's part.
template <class All, class Visitor>
void forEachParameter(Visitor visit)
{
    if constexpr (std::is_same_v<All, MappingParameters>) {
        const auto whole = [](auto& all) -> auto&
        {
            return all;
        };
        std::apply([&](const auto&... rows) { (visit(rows, whole), ...); }, rowsOf(MappingParameters{}));
    } else {
        const auto visitPart = [&]<class Part>(Part Parameters::*part) {
            const auto partOf = [part](auto& all) -> auto&
            {
                return all.*part;
            };
            std::apply([&](const auto&... rows) { (visit(rows, partOf), ...); }, rowsOf(Part{}));
        };
        std::apply([&](const auto... parts) { (visitPart(parts), ...); }, partsOfParameters());
    }
}

template <class All>
std::vector<ParameterRow> rowsOfAll()
{
    std::vector<ParameterRow> all;
    forEachParameter<All>([&](const auto& row, const auto&) { all.push_back(rowOf(row)); });
    return all;
}

/// Nothing where there is no such key.
template <class All>
std::optional<Result<void>> setIfKnown(All& parameters, std::string_view key, std::string_view text)
{
    std::optional<Result<void>> result;
    forEachParameter<All>([&](const auto& row, const auto& partOf) {
        if (row.key == key)
            result = setValue(row, partOf(parameters), text);
    });
    return result;
}

template <class All>
std::string printKnown(const All& parameters, std::string_view key)
{
    std::string text;
    forEachParameter<All>([&](const auto& row, const auto& partOf) {
        if (row.key == key)
            text = printValue(row.unit, partOf(parameters).*(row.member));
    });
    assert(!text.empty());
    return text;
}

Result<void> refuseUnknown(std::string_view key)
{
    const std::string_view near = nearestKey(key);
    return fail(ErrorCode::Usage, "there is no parameter '" + std::string{key} + "'; " +
                                      (near.empty() ? "" : "did you mean " + std::string{near} + "? ") +
                                      "'planewright-cli params' lists all");
}

/// Key and value of an assignment.
Result<std::pair<std::string_view, std::string_view>> partsOf(std::string_view assignment)
{
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos)
        return fail(ErrorCode::Usage, "parameter '" + std::string{assignment} + "': write key=value");
    return std::pair{assignment.substr(0, equals), assignment.substr(equals + 1)};
}

/// Levenshtein's distance between two words.
std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row[b.size()];
}

}  // namespace

const std::vector<ParameterRow>& parameterRows()
{
    static const std::vector<ParameterRow> rows = rowsOfAll<Parameters>();
    return rows;
}

const std::vector<ParameterRow>& mappingRows()
{
    static const std::vector<ParameterRow> rows = rowsOfAll<MappingParameters>();
    return rows;
}

Result<void> setParameter(Parameters& parameters, std::string_view key, std::string_view text)
{
    if (auto known = setIfKnown(parameters, key, text))
        return *std::move(known);
    if (std::ranges::find(mappingRows(), key, &ParameterRow::key) != mappingRows().end())
        return fail(ErrorCode::Usage, "parameter " + std::string{key} +
                                          " is one of maps of several stops: 'planewright-cli map' takes it");
    return refuseUnknown(key);
}

Result<void> setParameter(Parameters& parameters, std::string_view assignment)
{
    return partsOf(assignment).and_then([&](const auto& parts) {
        return setParameter(parameters, parts.first, parts.second);
    });
}

Result<void> setParameter(MappingParameters& parameters, std::string_view assignment)
{
    return partsOf(assignment).and_then([&](const auto& parts) {
        auto known = setIfKnown(parameters, parts.first, parts.second);
        return known ? *std::move(known) : refuseUnknown(parts.first);
    });
}

std::string printParameter(const Parameters& parameters, std::string_view key)
{
    return printKnown(parameters, key);
}

std::string printParameter(const MappingParameters& parameters, std::string_view key)
{
    return printKnown(parameters, key);
}

std::string allowedValues(const ParameterRow& row)
{
    if (!row.choices.empty())
        return listOf(row.choices);
    const std::string unit = row.unitName.empty() ? "" : " " + std::string{row.unitName};
    return (row.unit == Unit::Count ? "a whole number from " : "a number from ") + numberText(row.lowest) + " to " +
           numberText(row.highest) + unit;
}

std::string_view nearestKey(std::string_view key)
{
    std::string_view nearest;
    std::size_t best = std::max<std::size_t>(3, key.size() / 3);
    if (key.size() > 100)
        return nearest;
    for (const auto* rows : {&parameterRows(), &mappingRows()}) {
        for (const ParameterRow& row : *rows) {
            const std::size_t distance = editDistance(key, row.key);
            if (distance < best) {
                best = distance;
                nearest = row.key;
            }
        }
    }
    return nearest;
}

}  // namespace planewright
