// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace planewright {

/// What a parameter's number counts; files and people see the unit's own scale (angles in degrees).
enum class Unit { None, Metre, Angle, Count, Choice, Switch };

/// Smallest and largest allowed value, in SI units.
struct Range {
    double lowest = 0.0;
    double highest = 0.0;
};

/// One row of the parameter table: everything that is ever said about a parameter.
template <class Struct, class Value>
struct Parameter {
    std::string_view key;
    Value Struct::*member;
    Unit unit;
    Range range;
    std::string_view symbol;
    std::string_view meaning;
};

template <class Struct, class Value>
Parameter(const char*, Value Struct::*, Unit, Range, const char*, const char*) -> Parameter<Struct, Value>;

/// The words of a choice, in the order of its enumerators.
template <class Enum>
struct ChoiceNames;

/// A value as the number that ranges are checked on: choices and switches by their place.
template <class Value>
constexpr double asNumber(Value value)
{
    return static_cast<double>(value);
}

/// True where the default of every row of a parameter struct lies within the row's range.
template <class Struct>
constexpr bool defaultsAreInRange()
{
    const Struct defaults;
    return std::apply(
        [&](const auto&... rows) {
            return ((asNumber(defaults.*(rows.member)) >= rows.range.lowest &&
                     asNumber(defaults.*(rows.member)) <= rows.range.highest) &&
                    ...);
        },
        rowsOf(defaults));
}

}  // namespace planewright
