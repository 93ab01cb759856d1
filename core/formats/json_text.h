// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

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

}  // namespace planewright
