// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/params/parameters.h"

namespace planewright {

/// Appends a text as a JSON string; bytes that are not UTF-8 become U+FFFD.
void appendJsonText(std::string& json, std::string_view text);

/// Appends a number as formatNumber writes it; null for one that is not finite.
void appendJsonNumber(std::string& json, double value);

/// Appends all parameters as a JSON object, in the unit that people see: numbers, words of a choice, switches.
void appendJsonParameters(std::string& json, const Parameters& parameters);

/// The same with some parameters only, by their keys and in the order of the table.
void appendJsonParameters(std::string& json, const Parameters& parameters, std::span<const std::string_view> keys);

}  // namespace planewright
