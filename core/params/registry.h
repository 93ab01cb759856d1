// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/params/mapping_parameters.h"
#include "core/params/parameter.h"
#include "core/params/parameters.h"
#include "core/types/error.h"

namespace planewright {

/// A row of the parameter table as text, for lists, dialogs and the manual.
struct ParameterRow {
    std::string_view key;
    Unit unit = Unit::None;
    std::string_view unitName;              ///< "m", "deg", "" for plain numbers, counts, choices and switches
    double lowest = 0.0;                    ///< in the unit people see
    double highest = 0.0;                   ///< in the unit people see
    std::vector<std::string_view> choices;  ///< the words of a choice; "false" and "true" of a switch
    std::string_view symbol;                ///< as in the paper, in ASCII; empty if it has none
    std::string_view meaning;
};

/// All rows of an extraction in the order in which people see them.
const std::vector<ParameterRow>& parameterRows();

/// Those of the map of several stops; their keys begin with kMappingPart.
const std::vector<ParameterRow>& mappingRows();
inline constexpr std::string_view kMappingPart = "map.";

/// Sets one parameter from text in the unit that people see. Errors (Usage) name the key, the value and what is
/// allowed.
Result<void> setParameter(Parameters& parameters, std::string_view key, std::string_view text);

/// Sets one parameter from `key=value`, as -P takes it.
Result<void> setParameter(Parameters& parameters, std::string_view assignment);
Result<void> setParameter(MappingParameters& parameters, std::string_view assignment);

/// A parameter's value as text in the unit that people see; setParameter reads it back. The key must exist.
std::string printParameter(const Parameters& parameters, std::string_view key);
std::string printParameter(const MappingParameters& parameters, std::string_view key);

/// What a parameter may be, for a sentence that begins with "give": "a number from 0 to 0.5 m", "ml or foot".
std::string allowedValues(const ParameterRow& row);

/// The key nearest in spelling, for messages about unknown keys; empty where none is near.
std::string_view nearestKey(std::string_view key);

}  // namespace planewright
